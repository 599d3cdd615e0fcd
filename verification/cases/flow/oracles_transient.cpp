/// Layers that start or slow down on a slope: CVODE against IDA, which has the plastic shear rate as an unknown of its
/// own, grids against each other, and both against the steady solutions where they end.

#include <fmt/format.h>

#include "verification/reference/flow/compressible_layer.hpp"
#include "verification/reference/flow/interpolated.hpp"
#include "verification/reference/flow/layer.hpp"
#include "verification/reference/flow/motion.hpp"
#include "verification/reference/flow/motion_cells.hpp"
#include "verification/reference/rate_laws.hpp"
#include "verification/suite/agreement.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::flow_oracles_transient {

namespace {

using namespace reference::flow;
using reference::flow::Motion, reference::flow::Snapshot;

constexpr double tolerance = 1e-10;

/// Of u, over the largest u.
double distance(std::vector<Snapshot> const& a, std::vector<Snapshot> const& b) {
  double most = 0, size = 0;
  for (std::size_t t = 0; t < a.size(); ++t)
    for (std::size_t k = 0; k < a[t].u.size(); ++k) {
      most = std::max(most, std::abs(a[t].u[k] - b[t].u[k]));
      size = std::max(size, std::abs(b[t].u[k]));
    }
  return most / size;
}

void draw(Findings& findings, std::string const& name, std::vector<Snapshot> const& cvode,
          std::vector<Snapshot> const& ida) {
  Plot plot{"Layer in motion: " + name, "u [m/s]", "y [m]", false, false, {}};
  for (std::size_t t = 0; t < cvode.size(); t += 2) {
    plot.curves.push_back({fmt::format("IDA, t = {} s", ida[t].t), ida[t].u, ida[t].y, true});
    Curve curve{fmt::format("CVODE, t = {} s", cvode[t].t), {}, {}, false};
    for (std::size_t k = 0; k < cvode[t].u.size(); k += 5)
      curve.x.push_back(cvode[t].u[k]), curve.y.push_back(cvode[t].y[k]);
    plot.curves.push_back(curve);
  }
  findings.plots.push_back(std::move(plot));
}

/// Both integrators with n cells; returns the extrapolation from n, 2 n and 4 n.
ExtrapolatedMotion compare(Findings& findings, std::string const& name, Motion const& motion, int n,
                           std::vector<double> const& times, double space) {
  auto const cvode = motion_by_cvode(motion, n, times, tolerance), ida = motion_by_ida(motion, n, times, tolerance);
  agree(findings, name, "u by CVODE from IDA, over the largest", distance(cvode, ida), 1e-6);
  auto best = extrapolated_motion(motion, n, times, 1e-9);
  findings.check(name, fmt::format("u extrapolated from {} and {} cells, from {} and {} [m/s]", 2 * n, 4 * n, n, 2 * n),
                 best.error, at_most(space), "what is left of the error of the grid");
  findings.note(name, fmt::format("u extrapolated from that of {} cells [m/s]", 4 * n), best.correction);
  for (auto const& at : best.at) findings.note(name, fmt::format("u_h at {} s [m/s]", at.t), at.surface_speed());
  draw(findings, name, cvode, ida);
  return best;
}

std::vector<double> const slowing{0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5};

Motion slowing_layer(Motion::Volume volume, double strength_ratio, double beta) {
  double const slope = beta > 0 ? 32 : 28;
  return {glass_beads(40, beta), radians(slope), 0.05, volume, [](double Y) { return 80 * Y; }, true, strength_ratio};
}

void incompressible(Findings& findings) {
  auto const motion = slowing_layer(Motion::Volume::incompressible, 1, 0);
  compare(findings, "slowing down at 28 degrees", motion, 100, slowing, 1e-6);
  auto const late = extrapolated_motion(motion, 100, {40.0}, 1e-10).at.back();
  Layer const layer{motion.fluid, motion.slope, motion.h_0};
  double most = 0;
  for (std::size_t k = 1; k < late.u.size(); ++k)
    most = std::max(most, std::abs(late.u[k] - bagnold_speed(layer, late.Y[k])) / bagnold_surface_speed(layer));
  agree(findings, "slowing down at 28 degrees", "u at 40 s from the steady solution", most, 1e-6);
  agree(findings, "slowing down at 28 degrees", "mean u at 40 s from the steady solution",
        apart(late.mean_speed(), 0.6 * bagnold_surface_speed(layer)), 1e-6);
  auto const between = [&](double y) { return interpolated(late.y, late.u, y); };
  auto const exact = [&](double y) { return bagnold_speed(layer, y); };
  agree(findings, "slowing down at 28 degrees", "u at 40 s between the nodes from the steady solution",
        apart(between, exact, places(0, layer.h, 173)), 1e-6);
}

/// What the layer takes of the law, against the rate equations of material points, at strengths around the critical
/// one.
void law(Findings& findings) {
  double flow = 0, volume = 0;
  for (double const beta : {0.0, 0.1}) {
    auto const motion = slowing_layer(Motion::Volume::hardening, 1, beta);
    Fluid const& f = motion.fluid;
    auto const rates = reference::cam_clay_mu_i(f.elastic, beta, f.hardening, f.friction);
    MotionCells const cells(motion, 10);
    for (double const eps : {-0.05, -0.04, -0.03})
      for (double const mu : {0.4, 0.5, 0.7}) {
        auto const here = cells.local(2, eps);
        double const q = mu * here.S, found = cells.plastic_rate(here, -q);
        auto const expected = rates.flow({here.p, q, eps}, {0, q});
        flow = std::max(flow, apart(-found, 2 * q * expected.shear));
        volume = std::max(volume, apart(cells.volume_rate(here, -q, found), expected.volume));
      }
  }
  agree(findings, "the law at a stress", "plastic shear rate from that of material points", flow, 1e-12);
  agree(findings, "the law at a stress", "plastic volume rate from that of material points", volume, 1e-12);
}

/// The elastic layer's limit has a code of its own: inertia and the law are in it, and no elasticity.
void rigid(Findings& findings) {
  for (double const beta : {0.0, 0.1}) {
    auto motion = slowing_layer(Motion::Volume::incompressible, 1, beta);
    std::string const name = fmt::format("slowing down at {} degrees, beta {}", beta > 0 ? 32 : 28, beta);
    auto const limit = rigid_motion(motion, 100, slowing, tolerance);
    findings.note(name, "u from that without elasticity, over the largest, E = 1 MPa",
                  distance(motion_by_cvode(motion, 100, slowing, tolerance), limit));
    motion.fluid.elastic.E = 1e9;
    agree(findings, name, "u from that without elasticity, over the largest, E = 1 GPa",
          distance(motion_by_cvode(motion, 100, slowing, tolerance), limit), 1e-6);
  }
}

void compressible(Findings& findings) {
  auto const motion = slowing_layer(Motion::Volume::critical, 1, 0);
  compare(findings, "slowing down at 28 degrees, compressible", motion, 100, slowing, 1e-6);
  auto const late = extrapolated_motion(motion, 100, {40.0}, 1e-10).at.back();
  auto const steady = small_shear_profile({motion.fluid, motion.slope, motion.h_0}, {});
  agree(findings, "slowing down at 28 degrees, compressible", "u_h at 40 s from the steady solution",
        apart(late.surface_speed(), steady.surface_speed), 1e-6);
  agree(findings, "slowing down at 28 degrees, compressible", "h at 40 s from the steady solution",
        apart(late.y.back(), steady.h), 1e-6);
  auto const loose = slowing_layer(Motion::Volume::hardening, 1.3, 0);
  compare(findings, "slowing down at 28 degrees, from 1.3 of the critical strength", loose, 100, slowing, 1e-6);
  auto const critical = motion_by_cvode(motion, 100, {3.5}, tolerance).back();
  auto const hardening = motion_by_cvode(loose, 100, {3.5}, tolerance).back();
  double most = 0;
  for (std::size_t k = 0; k < critical.p_c.size(); ++k) most = std::max(most, apart(hardening.p_c[k], critical.p_c[k]));
  findings.check("slowing down at 28 degrees, from 1.3 of the critical strength", "p_c at 3.5 s from the critical one",
                 most, at_most(1e-6), "the state of critical strength is reached after a shear of some 1/xi");
}

void from_rest(Findings& findings) {
  Motion const motion{glass_beads(32.76, 0),      radians(24), 0.028, Motion::Volume::incompressible,
                      [](double) { return 0.0; }, true};
  std::vector<double> const times{0.1, 0.3, 0.7, 1.0, 1.5, 2.0, 2.5};
  compare(findings, "from rest at 24 degrees", motion, 50, times, 1e-6);
}

void run(Findings& findings) {
  law(findings);
  incompressible(findings);
  rigid(findings);
  compressible(findings);
  compare(findings, "slowing down at 32 degrees, beta 0.1", slowing_layer(Motion::Volume::incompressible, 1, 0.1), 100,
          slowing, 1e-6);
  from_rest(findings);
}

}  // namespace

Case const the_case{"flow/oracles_transient",
                    "Reference solutions of layers in motion against each other",
                    "CVODE, IDA, refined grids, steady solutions",
                    "model: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; its reduction derived",
                    1,
                    60,
                    run};

}  // namespace talus::verification::flow_oracles_transient
