#include "models/documents.hpp"

#include <nlohmann/json.hpp>

#include "models/compose.hpp"

namespace talus {

namespace {

/// Reads a P whose space is that of the kinematics at `space`, and gathers what its table cannot say.
template <class P>
P read_with_space(Document const& document, Reader& reader, std::string const& space) {
  nlohmann::json::json_pointer const pointer(space);
  if (document.value.is_object() && document.value.contains(pointer) && document.value[pointer].is_string())
    reader.dimension = dimension_of_kinematics(document.value[pointer].get<std::string>());
  return read<P>(document.value, reader);
}

void check_tag(std::string const& found, std::string_view tag, Reader& reader) {
  if (found != tag) reader.refuse("/schema", "'" + found + "'", std::string(tag));
}

/// Adds what the consistency check finds, with the pointer put behind `base`.
void add_inconsistencies(Case const& values, std::string const& base, Reader& reader) {
  for (std::string const& text : inconsistencies(values)) {
    auto const colon = text.find(": ");
    std::string const pointer = base + text.substr(0, colon);
    reader.refuse(pointer, text.substr(colon + 2), {});
  }
}

/// Every expectation names a value for each axis.
template <class Entry>
void check_places(std::vector<Entry> const& expect, std::size_t axes, Reader& reader) {
  for (std::size_t k = 0; k < expect.size(); ++k)
    if (expect[k].at.size() != axes)
      reader.refuse("/expect/" + std::to_string(k) + "/at", std::to_string(expect[k].at.size()) + " values",
                    "one for each of the " + std::to_string(axes) + " axes");
}

void check_leads(PointCase const& values, PointExperiment const& point, Reader& reader) {
  for (std::size_t s = 0; s < values.path.size(); ++s)
    for (int c = 0; c < 6; ++c) {
      auto const& lead = *values.path[s].leads()[static_cast<std::size_t>(c)];
      bool rests = false;
      lead.visit([&]<class Q>(std::type_identity<Q>, typename Q::Parameters const& p) {
        Control const control = Q::control(p, 1);
        rests = !control.of_stress && control.rate == 0;
      });
      if (!point.leads(c) && !rests)
        reader.refuse("/path/" + std::to_string(s) + "/" + std::string(component_names[static_cast<std::size_t>(c)]),
                      "'" + std::string(lead.name()) + "'", "nothing: there is no such component in this kinematics");
    }
}

/// Measures that pictures and expectations name are columns of the series.
void check_columns(PointCase const& values, PointExperiment const& point, Reader& reader) {
  std::string names;
  std::vector<std::string> known;
  for (Quantity const& q : point.quantities()) {
    known.push_back(q.name);
    names += (names.empty() ? "" : ", ") + q.name;
  }
  auto const check = [&](std::string const& pointer, std::string const& name) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      reader.refuse(pointer, "'" + name + "'", "a column of the series: " + names);
  };
  auto const check_pictures = [&](std::string const& list, std::vector<PictureEntry> const& pictures) {
    for (std::size_t k = 0; k < pictures.size(); ++k) {
      check("/" + list + "/" + std::to_string(k) + "/x", pictures[k].x);
      check("/" + list + "/" + std::to_string(k) + "/y", pictures[k].y);
    }
  };
  check_pictures("pictures", values.pictures);
  check_pictures("ends", values.ends);
  for (std::size_t k = 0; k < values.expect.size(); ++k)
    check("/expect/" + std::to_string(k) + "/measure", values.expect[k].measure);
}

}  // namespace

Case read_case(Document const& document, Reader& reader) {
  Case values = read_with_space<Case>(document, reader, "/kinematics/type");
  if (reader.mistakes.empty()) add_inconsistencies(values, "", reader);
  if (reader.mistakes.empty()) add_suspicions(values, "", reader);
  return values;
}

Study read_study(Document const& document, Reader& reader) {
  Study values = read_with_space<Study>(document, reader, "/base/kinematics/type");
  if (!reader.mistakes.empty()) return values;
  check_tag(values.schema, Study::tag, reader);
  Case base = values.base;
  for (StudyExpectationEntry const& entry : values.expect) base.expect.push_back(entry);
  add_inconsistencies(base, "/base", reader);
  if (reader.mistakes.empty()) add_suspicions(values.base, "/base", reader);
  check_places(values.expect, values.axes.size(), reader);
  return values;
}

PointCase read_point(Document const& document, Reader& reader) {
  PointCase values = read_with_space<PointCase>(document, reader, "/kinematics/type");
  if (!reader.mistakes.empty()) return values;
  check_tag(values.schema, PointCase::tag, reader);
  auto const point = compose(values);
  check_leads(values, *point, reader);
  check_columns(values, *point, reader);
  check_places(values.expect, values.axes.size(), reader);
  return values;
}

std::unique_ptr<PointExperiment> compose(PointCase const& document) {
  std::unique_ptr<PointExperiment> point;
  document.kinematics.visit([&]<class K>(std::type_identity<K>, auto const&) {
    auto material = document.law->material(K::name, "point", 1);
    point = std::make_unique<MaterialPoint<K::dimension>>(
        std::get<std::unique_ptr<Material<K::dimension>>>(std::move(material)),
        Symmetric<double, typename K::Shape>::size);
  });
  return point;
}

std::vector<Segment> path_of(PointCase const& document) {
  std::vector<Segment> path;
  for (SegmentEntry const& entry : document.path) {
    Segment segment{entry.name, entry.duration, static_cast<int>(entry.steps), {}};
    for (std::size_t c = 0; c < 6; ++c)
      entry.leads()[c]->visit([&]<class Q>(std::type_identity<Q>, typename Q::Parameters const& p) {
        segment.controls[c] = Q::control(p, entry.duration);
      });
    path.push_back(segment);
  }
  return path;
}

}  // namespace talus
