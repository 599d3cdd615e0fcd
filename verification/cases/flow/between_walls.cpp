/// Steady flow between rough walls that mirror: plane shear with and without gravity, and down a vertical chute. The walls hold the volume, so that
/// the pressure is an outcome: the reference is that of the pressure across the flow that was found, its mean over the
/// inner slices.
///
/// Source: GDR MiDi (2004), doi:10.1140/epje/i2003-10153-0; verification/reference/flow/confined.hpp.

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "verification/reference/flow/confined.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/flow_profile.hpp"

namespace talus::verification::flow_between_walls {

namespace {

using namespace reference::flow;

std::vector<std::string> const changes{R"(/materials/0/law/type="cam_clay_mu_i_two_stage")",
                                       R"(/bodies/0/seeding={"type": "lattice", "per_axis": 3})",
                                       R"(/walls/0/contact={"type": "mirrored_stick"})",
                                       R"(/walls/1/contact={"type": "mirrored_stick"})",
                                       "/output/stations=[]",
                                       "/expect=[]"};

double inner_mean(std::vector<double> const& values) {
  return std::accumulate(values.begin() + 2, values.end() - 2, 0.0) / (slices - 4);
}

void plane_shear(Findings& findings) {
  constexpr double speed = 1, gap = 0.05;
  Cost cost;
  auto from_rest = changes;
  from_rest.emplace_back("/bodies/0/velocity/gradient=[[0, 0], [0, 0]]");
  FlowProfile const flow = mean_of(profiles_of("plane_shear.json", from_rest, evenly(1.8, 2, 20), cost));
  double off = 0;
  for (std::size_t s = 0; s < slices; ++s) off = std::max(off, std::abs(flow.u[s] / speed - flow.y[s] / gap));
  PlaneShear const exact{glass_beads(40, 0), inner_mean(flow.normal_stress), speed, gap};
  findings.check("plane shear from rest", "largest |u/V - y/H| of a slice", off, at_most(0.01),
                 "1 % of the plate's speed", cost);
  findings.check("plane shear from rest", "shear stress over that of the pressure found",
                 inner_mean(flow.shear_stress) / exact.shear_stress(), about(1, 0.02), "2 %");
  findings.plots.push_back({"Plane shear: u over y",
                            "y [m]",
                            "u [m/s]",
                            false,
                            false,
                            {Curve{"slices", flow.y, flow.u}, Curve{"exact", {0, gap}, {0, speed}, true}}});
}

/// The plate's load is what the pressure found leaves over at the plate.
void plate_on_bed(Findings& findings) {
  constexpr double speed = 0.5, gap = 0.05;
  Fluid const fluid = glass_beads(40, 0);
  Cost cost;
  FlowProfile const flow = mean_of(profiles_of("plane_shear_gravity.json", changes, evenly(3, 4, 20), cost));
  double load = 0;
  for (std::size_t s = 2; s < slices - 2; ++s)
    load += (flow.normal_stress[s] - fluid.density * gravity * (gap - flow.y[s])) / (slices - 4);
  PlateOnBed const exact{fluid, load};
  double const T = exact.shear_stress(speed), depth = exact.depth(T);
  findings.check("plane shear with gravity", "shear stress over that of the load found",
                 inner_mean(flow.shear_stress) / T, about(1, 0.02), "2 %", cost);
  ShearFlow const sheared = exact.flow(T);
  std::vector<double> y, u;
  for (int k = 0; k < 200; ++k) {
    double const at = gap * (k + 0.5) / 200;
    y.push_back(at);
    u.push_back(gap - at < depth ? speed_by_quadrature(sheared, gap - at) : 0);
  }
  findings.check("plane shear with gravity", "error of the profile", profile_error(flow, sliced(y, u)), at_most(0.05),
                 "5 %");
  findings.note("plane shear with gravity", "exact depth of the flow over the gap", depth / gap);
  findings.plots.push_back({"Plane shear with gravity: u over y",
                            "y [m]",
                            "u [m/s]",
                            false,
                            false,
                            {Curve{"slices", flow.y, flow.u}, Curve{"exact", y, u, true}}});
}

/// Its shear zones are a fifth of the gap each.
void chute(Findings& findings) {
  Plot plot{"Vertical chute: u over y", "y [m]", "u [m/s]"};
  for (int const cells : {16, 32, 64}) {
    double const width = 0.04, h = width / cells;
    auto finer = changes;
    for (std::string const& change : {fmt::format("/grid/spacing={}", h), fmt::format("/grid/periods=[{}, 0]", 8 * h),
                                      fmt::format("/bodies/0/shape/max=[{}, {}]", 8 * h, width / 2)})
      finer.push_back(change);
    Cost cost;
    FlowProfile const flow = mean_of(profiles_of("vertical_chute.json", finer, evenly(1.5, 2, 10), cost));
    VerticalChute const exact{glass_beads(40, 0), inner_mean(flow.normal_stress), width / 2};
    double const plug = flow.u[slices / 2] / exact.speed(0);
    std::string const measure = fmt::format("speed of the plug over that of the pressure found, {} cells", cells);
    if (cells < 64)
      findings.note("vertical chute", measure, plug, "of the gap", cost);
    else
      findings.check("vertical chute", measure, plug, about(1, 0.01), "1 %", cost);
    plot.curves.push_back({fmt::format("{} cells", cells), flow.y, flow.u});
    if (cells < 64) continue;
    std::vector<double> y, u;
    for (double const at : evenly(-exact.half_width, exact.half_width, 200)) {
      y.push_back(at);
      u.push_back(exact.speed(std::abs(at)));
    }
    plot.curves.push_back({"exact", y, u, true});
  }
  findings.plots.push_back(plot);
}

void run(Findings& findings) {
  plane_shear(findings);
  plate_on_bed(findings);
  chute(findings);
}

}  // namespace

Case const the_case{"flow/between_walls",
                    "Plane shear with and without gravity, and flow down a vertical chute",
                    "closed forms of verification/reference/flow/confined.hpp",
                    "GDR MiDi (2004), doi:10.1140/epje/i2003-10153-0",
                    2,
                    600,
                    run};

}  // namespace talus::verification::flow_between_walls
