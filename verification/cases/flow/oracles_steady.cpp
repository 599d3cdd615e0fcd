/// Steady layers of a granular fluid down a slope: the reference solutions against each other, before anything is
/// compared with them. Closed form, GSL's quadrature, CVODE and KINSOL, of which the last knows the law as q(gamma) and
/// the others as gamma(q).

#include <fmt/format.h>

#include <cmath>

#include "verification/reference/flow/compressible_layer.hpp"
#include "verification/reference/flow/layer.hpp"
#include "verification/reference/flow/plugged_layer.hpp"
#include "verification/suite/agreement.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::flow_oracles_steady {

namespace {

using namespace reference::flow;

constexpr double bar = 1e-9;

void bagnold(Findings& findings, std::string const& name, Layer const& layer, bool drawn) {
  auto const flow = bagnold_flow(layer);
  auto const exact = [&](double y) { return bagnold_speed(layer, y); };
  auto const quadrature = [&](double y) { return speed_by_quadrature(flow, y); };
  auto const kinsol = [&](double y) { return speed_by_kinsol(flow, y); };
  auto const all = places(0, layer.h, 11);
  agree(findings, name, "u by quadrature from closed form", apart(quadrature, exact, all), bar);
  agree(findings, name, "u by CVODE from closed form",
        apart([&](double y) { return speed_by_cvode(flow, y); }, exact, all), bar);
  agree(findings, name, "u by KINSOL from closed form", apart(kinsol, exact, all), bar);
  if (!drawn) return;
  auto const fine = places(0, layer.h, 41);
  findings.plots.push_back({"Bagnold layer: " + name,
                            "u [m/s]",
                            "y [m]",
                            false,
                            false,
                            {profile("closed form", exact, fine, true), profile("KINSOL", kinsol, all, false)}});
}

void cohesion(Findings& findings) {
  for (double const slope : {26.0, 30.0, 32.0}) {
    Fluid const fluid = glass_beads(40, 0);
    double const exact = largest_cohesion(radians(slope), fluid.friction.mu_1);
    agree(findings, fmt::format("beads to 40 degrees, {} degrees", slope), "largest cohesion by root from closed form",
          apart(largest_cohesion_by_root(fluid, radians(slope)), exact), bar);
    Layer layer{glass_beads(40, exact * (1 + 1e-6)), radians(slope), 0.05};
    agree(findings, fmt::format("beads to 40 degrees, {} degrees", slope), "u_h with a little more cohesion [m/s]",
          bagnold_surface_speed(layer), 0);
  }
}

void plug(Findings& findings, double beta, double kept) {
  PluggedLayer const layer{{glass_beads(40, beta), radians(32), 0.05}, kept};
  std::string const name = fmt::format("beta {}, {} Pa kept, 32 degrees", beta, kept);
  double const expected = layer.plug_speed(speed_by_quadrature);
  agree(findings, name, "plug's depth by root from closed form", apart(layer.plug_depth_by_root(), layer.plug_depth()),
        bar);
  agree(findings, name, "plug's speed by CVODE from quadrature", apart(layer.plug_speed(speed_by_cvode), expected),
        bar);
  agree(findings, name, "plug's speed by KINSOL from quadrature", apart(layer.plug_speed(speed_by_kinsol), expected),
        bar);
  double const y = layer.layer.h - layer.critical_depth();
  agree(findings, name, "u below the kept strength by quadrature from Bagnold's",
        apart(speed_by_quadrature(layer.below_kept(), y), bagnold_speed(layer.layer, y)), bar);
}

double distance(CompressibleProfile const& a, CompressibleProfile const& b) {
  double most = std::max({apart(a.h, b.h), apart(a.surface_speed, b.surface_speed), apart(a.mean_speed, b.mean_speed),
                          apart(a.mean_ratio, b.mean_ratio), apart(a.solid_fraction, b.solid_fraction)});
  for (std::size_t k = 0; k < a.at.size(); ++k)
    most = std::max({most, apart(a.at[k].y, b.at[k].y), apart(a.at[k].u, b.at[k].u)});
  return most;
}

/// Y at which q is mu_1 S of the kept strength, with p from p = J N by bisection and not by Lambert's function.
double plug_edge_by_root(CompressiblePluggedLayer const& plugged) {
  Fluid const& fluid = plugged.layer.fluid;
  double const loose = std::pow(fluid.hardening.p_c0 / plugged.kept, 1 / fluid.hardening.xi);
  auto const pressure = [&](double Y) {
    double const N = plugged.layer.normal_stress(Y);
    return root([&](double p) { return p - loose * std::exp(-p / fluid.elastic.K()) * N; }, 0, 2 * N);
  };
  auto const excess = [&](double Y) {
    double const p = pressure(Y), S = p < plugged.kept ? fluid.size(p, plugged.kept) : 0;
    return p * std::tan(plugged.layer.slope) - fluid.friction.mu_1 * S;
  };
  return root(excess, 0, plugged.layer.h_0 * (1 - 1e-6));
}

/// The compressible layer with a plug: three ways; and against what it becomes without change of volume, and without plug.
void compressible_plug(Findings& findings, double beta, double kept) {
  CompressiblePluggedLayer const layer{{glass_beads(40, beta), radians(32), 0.05}, kept};
  std::string const name = fmt::format("compressible, beta {}, {} Pa kept, 32 degrees", beta, kept);
  double const expected = layer.speed(speed_by_quadrature, 0.05);
  agree(findings, name, "plug's speed by CVODE from quadrature", apart(layer.speed(speed_by_cvode, 0.05), expected),
        bar);
  agree(findings, name, "plug's speed by KINSOL from quadrature", apart(layer.speed(speed_by_kinsol, 0.05), expected),
        bar);
  double const begin = layer.plug_begin();
  agree(findings, name, "height of the plug's edge by CVODE from quadrature",
        apart(speed_by_cvode({0, begin, [&](double Y) { return layer.stretch(Y); }, {}}, begin * (1 - 1e-12)),
              layer.height(begin * (1 - 1e-12))),
        bar);
  agree(findings, name, "plug's edge by root from closed form", apart(plug_edge_by_root(layer), begin), bar);
  CompressiblePluggedLayer stiff = layer;
  stiff.layer.fluid.elastic.E = 1e16, stiff.layer.fluid.hardening.xi = 1e12;
  PluggedLayer const rigid{{stiff.layer.fluid, radians(32), 0.05}, kept};
  double const below_plug = bagnold_speed(rigid.layer, 0.05 - rigid.plug_depth());
  agree(findings, name, "plug's speed from Bagnold's, xi = 1e12, E = 1e16 Pa",
        apart(stiff.speed(speed_by_quadrature, 0.05), below_plug), bar);
  CompressiblePluggedLayer const loose{layer.layer, 0};
  auto const closed = small_shear_profile(layer.layer, {0.03});
  agree(findings, name, "u and y without plug from closed form",
        std::max(apart(loose.speed(speed_by_quadrature, 0.03), closed.at[0].u),
                 apart(loose.height(0.03), closed.at[0].y)),
        bar);
}

Curve curve(std::string name, CompressibleProfile const& profile, bool guide) {
  Curve curve{std::move(name), {}, {}, guide};
  for (auto const& place : profile.at) curve.x.push_back(place.u), curve.y.push_back(place.y);
  return curve;
}

void compressible(Findings& findings, std::string const& name, CompressibleLayer layer, bool drawn) {
  auto const Y = places(0.025 * layer.h_0, 0.975 * layer.h_0, 20);
  auto const exact = profile_by_quadrature(layer, Y), kinsol = profile_by_kinsol(layer, Y);
  auto const small = small_shear_profile(layer, Y);
  std::string const subject = "compressible, " + name;
  agree(findings, subject, "y, u and means by CVODE from quadrature", distance(profile_by_cvode(layer, Y), exact), bar);
  agree(findings, subject, "y, u and means by KINSOL from quadrature", distance(kinsol, exact), bar);
  double const shear = exact.mean_ratio * layer.normal_stress(0) / layer.fluid.elastic.G();
  double const margin = exact.mean_ratio * (1 / (exact.mean_ratio - layer.fluid.ratio(0)) + 1);
  findings.check(subject, "the same in closed form for small shear from quadrature", distance(small, exact),
                 at_most(shear * (1 + margin)),
                 "to first order in q/G; the distance from where flow stops magnifies it");
  findings.note(subject, "h/h_0", exact.h / layer.h_0);
  findings.note(subject, "mean phi", exact.solid_fraction);
  findings.note(subject, "u_h over that of the incompressible layer",
                exact.surface_speed / bagnold_surface_speed({layer.fluid, layer.slope, layer.h_0}));
  layer.fluid.elastic.E = 1e14;
  agree(findings, subject, "the same in closed form for small shear from quadrature, E = 1e14 Pa",
        distance(small_shear_profile(layer, Y), profile_by_quadrature(layer, Y)), bar);
  if (drawn)
    findings.plots.push_back({"Compressible layer: " + name,
                              "u [m/s]",
                              "y [m]",
                              false,
                              false,
                              {curve("quadrature", exact, true), curve("KINSOL", kinsol, false),
                               curve("closed form for small shear", small, false)}});
}

void run(Findings& findings) {
  for (double const slope : {22.0, 24.0, 28.0, 32.0})
    bagnold(findings, fmt::format("beads to 32.76 degrees, {} degrees", slope),
            {glass_beads(32.76, 0), radians(slope), 0.1 - 0.003 * slope}, slope == 24);
  for (double const beta : {0.0, 0.1, 0.2})
    bagnold(findings, fmt::format("beads to 40 degrees, 32 degrees, beta {}", beta),
            {glass_beads(40, beta), radians(32), 0.05}, false);
  cohesion(findings);
  for (double const beta : {0.0, 0.1, 0.2})
    for (double const kept : {100.0, 400.0}) plug(findings, beta, kept);
  for (double const beta : {0.0, 0.1, 0.2}) compressible_plug(findings, beta, 200);
  compressible(findings, "24 degrees", {glass_beads(32.76, 0), radians(24), 0.028}, false);
  compressible(findings, "28 degrees", {glass_beads(40, 0), radians(28), 0.05}, true);
  compressible(findings, "32 degrees, beta 0.1", {glass_beads(40, 0.1), radians(32), 0.05}, false);
}

}  // namespace

Case const the_case{
    "flow/oracles_steady",
    "Reference solutions of steady layers against each other",
    "closed form, quadrature by GSL, CVODE, KINSOL",
    "Bagnold (1954), doi:10.1098/rspa.1954.0186; GDR MiDi (2004), doi:10.1140/epje/i2003-10153-0; Blatny, Gray & Gaume "
    "(2024), doi:10.1017/jfm.2024.643; with cohesion and volume derived",
    0,
    10,
    run};

}  // namespace talus::verification::flow_oracles_steady
