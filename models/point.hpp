#pragma once
/// The document of a material point: one law, led along a path of motion and stress, varied along axes.

#include "models/catalogue_controls.hpp"
#include "models/study.hpp"

namespace talus {

struct SegmentEntry {
  using Lead = Choice<catalogue::Controls>;
  static Lead at_rest() { return Lead::of<control::Strain>(); }

  std::string name;
  double duration = 1;
  std::int64_t steps = 100;
  Lead xx = at_rest(), yy = at_rest(), zz = at_rest(), xy = at_rest(), xz = at_rest(), yz = at_rest();
  static constexpr auto table() {
    return std::tuple{
        parameter(&SegmentEntry::name, "name", "what the segment is called").required(),
        parameter(&SegmentEntry::duration, "duration", "t", "s", "how long it lasts", positive).required(),
        parameter(&SegmentEntry::steps, "steps", "n", "1", "steps of equal length", closed(1, 1e8)).required(),
        parameter(&SegmentEntry::xx, "xx", "what leads the first normal component"),
        parameter(&SegmentEntry::yy, "yy", "what leads the second normal component"),
        parameter(&SegmentEntry::zz, "zz", "what leads the third normal component; not in the plane"),
        parameter(&SegmentEntry::xy, "xy", "what leads simple shear along x, in planes across y"),
        parameter(&SegmentEntry::xz, "xz", "what leads simple shear along x, in planes across z; not in the plane"),
        parameter(&SegmentEntry::yz, "yz", "what leads simple shear along y, in planes across z; not in the plane")};
  }
  [[nodiscard]] std::array<Lead const*, 6> leads() const { return {&xx, &yy, &zz, &xy, &xz, &yz}; }
};

/// One column of the series over another.
struct PictureEntry {
  std::string x, y;
  static constexpr auto table() {
    return std::tuple{parameter(&PictureEntry::x, "x", "column of the series along the abscissa").required(),
                      parameter(&PictureEntry::y, "y", "column of the series along the ordinate").required()};
  }
};

struct PointExpectationEntry : Expectation {
  std::vector<AnyValue> at;
  static constexpr auto table() {
    return std::tuple_cat(Expectation::table(), std::tuple{parameter(&PointExpectationEntry::at, "at",
                                                                     "value of each axis, in the order of the axes")});
  }
};

/// What a material point goes through.
struct PointCase {
  std::string schema, title;
  std::vector<std::string> cite;
  Choice<catalogue::Kinematics> kinematics;
  OpenChoice<ChosenLaw> law;
  std::vector<SegmentEntry> path;
  std::vector<AxisEntry> axes;
  std::vector<PictureEntry> pictures{
      {"pressure", "shear_stress"}, {"strain_xy", "stress_xy"}, {"strain_xy", "volume_strain"}};
  std::vector<PictureEntry> ends;
  std::vector<PointExpectationEntry> expect;

  static constexpr std::string_view tag = "talus/point/1";
  static constexpr auto table() {
    return std::tuple{
        parameter(&PointCase::schema, "schema", "kind and version of the document: talus/point/1").required(),
        parameter(&PointCase::title, "title", "one line on what the point goes through").required(),
        parameter(&PointCase::cite, "cite", "DOIs of the work that the study stands on"),
        parameter(&PointCase::kinematics, "kinematics", "space, and the shape of strain and stress in it").required(),
        parameter(&PointCase::law, "law", "constitutive law").required(),
        parameter(&PointCase::path, "path", "segments, one after another").required().sized(1),
        parameter(&PointCase::axes, "axes", "what is varied, in this document; every combination is run"),
        parameter(&PointCase::pictures, "pictures", "what is drawn along the path"),
        parameter(&PointCase::ends, "ends",
                  "what is drawn of the ends of the paths, a curve for each value of the "
                  "first axis"),
        parameter(&PointCase::expect, "expect", "what the point should give; a miss ends with exit code 5")};
  }
};

}  // namespace talus
