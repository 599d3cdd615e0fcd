/// Simple shear that speeds up, of a material with a history, in every scheme: every particle goes through what a single
/// material point goes through.
///
///   x = X + gamma(t) (Y - Y_0),   gamma = rate t + 1/2 growth t^2,   b_x = growth (Y - Y_0)              (1)
///
/// The stress is uniform, whatever the law, so that it needs no balance (Div P = 0) and the law no closed form. Rows of
/// particles slide along the grid and stay commensurate with it: the sums over particles are exact for any kernel, a
/// linear velocity passes every transfer, and what is left is rounding. With the same steps the point's stress is the
/// particles'.
///
/// The strip is periodic along x and so tall that nothing of its free ends reaches the middle: in a step news travels
/// p + 1 nodes at most. It starts under isotropic pressure.
///
/// Source: derived here; of the path of laws see Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643.

#include <array>
#include <cmath>
#include <limits>

#include "core/material_point.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::manufactured_affine {

namespace {

constexpr double h = 0.01, dt = 1e-5, density = 1500;
constexpr double rate = 150, growth = 2.5e5;  ///< [1/s], [1/s^2]: 12 % of shear in the end
constexpr int steps = 40, cells = 344, n = 2;
constexpr double middle = 0.5 * cells * h, squeeze = -4e-3;

class Push final : public BodyForce<2> {
 public:
  explicit Push(std::vector<Point<2>> places) : places_(std::move(places)) {}
  [[nodiscard]] Point<2> acceleration(long id, double) const override {
    return {growth * (places_[static_cast<std::size_t>(id)][1] - middle), 0};
  }

 private:
  std::vector<Point<2>> places_;
};

/// Shear rate between step k and the next; the body force of the steps before has been added.
double rate_after(int k) {
  return rate + growth * dt * (k - 0.5);
}

/// The single point, squeezed in one elastic step, then sheared: its stress in the end.
template <class Law>
Components6 point_stress(typename Law::Parameters const& law) {
  using Kinematics = kinematics::PlaneStrain;
  MaterialPoint<2> point(make_material<Kinematics, Law>("only", density, law),
                         Symmetric<double, Kinematics::Shape>::size);
  point.step({squeeze, squeeze, 0, 0, 0, 0}, {}, dt);
  for (int k = 1; k <= steps; ++k) point.step({0, 0, 0, dt * rate_after(k), 0, 0}, {}, dt * (k + 1));
  return point.stress();
}

template <class Law>
std::unique_ptr<Simulation<2>> sheared(Scheme const& scheme, typename Law::Parameters const& law, Cost& cost) {
  using Kinematics = kinematics::PlaneStrain;
  Scene<2> scene = scene_of<Kinematics, Law>(scheme, h, density, law);
  scene.periods = {1, 0};
  auto const places = lattice<2>(Point<2>::Zero(), {4, cells}, {n, n}, h);
  scene.body_force = std::make_unique<Push>(places);
  set_step(scene, dt);
  std::vector<Seed<2>> seeds;
  double const squeezed = std::log1p(squeeze);
  for (Point<2> const& X : places) {
    Seed<2> seed{X, {rate_after(0) * (X[1] - middle), 0}, density * h * h / (n * n)};
    seed.C(0, 1) = rate_after(0);
    seed.strain = {squeezed, squeezed, 0, 0};
    seeds.push_back(seed);
  }
  auto simulation = begin(std::move(scene), seeds);
  take_steps(*simulation, steps, cost);
  return simulation;
}

/// Largest distance of a particle's stress near the middle from that of the point, and the least plastic strain there.
struct Comparison {
  double off = 0, least_plastic = std::numeric_limits<double>::infinity();
};

template <class Law>
Comparison compared(Simulation<2> const& simulation, Law const& law, Components6 const& truth) {
  std::array<std::vector<double>, 4> strain;
  for (int c = 0; c < 4; ++c) strain[static_cast<std::size_t>(c)] = column(simulation, "elastic_strain", c);
  auto const plastic = column(simulation, "plastic_volumetric_strain");
  auto const x = vectors(simulation, "position");
  Comparison found;
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (std::abs(x[p][1] - middle) > 4 * h) continue;
    Symmetric<double, shape::PlaneStrain> eps;
    for (int c = 0; c < 4; ++c) eps[c] = strain[static_cast<std::size_t>(c)][p];
    auto const tau = law.stress(eps);
    for (int c = 0; c < 4; ++c) found.off = std::max(found.off, std::abs(tau[c] - truth[static_cast<std::size_t>(c)]));
    found.least_plastic = std::min(found.least_plastic, std::abs(plastic[p]));
  }
  return found;
}

template <class Law>
void compare(Findings& findings, typename Law::Parameters law) {
  law.p_c0 = 2e4;
  Components6 const truth = point_stress<Law>(law);
  double const scale = std::hypot(truth[0], truth[1], truth[3]);
  for (Scheme const& scheme : all_schemes()) {
    Cost cost;
    auto const simulation = sheared<Law>(scheme, law, cost);
    auto const found = compared(*simulation, Law(law), truth);
    std::string const subject = scheme.name() + ", " + std::string(Law::name);
    findings.check(subject, "stress off that of a point", found.off / scale, at_most(1e-10),
                   "a commensurate lattice: rounding", cost);
    findings.check(subject, "least plastic volume strain", found.least_plastic, {1e-4, 1},
                   "without yielding there is no history");
  }
}

void run(Findings& findings) {
  compare<law::CamClay>(findings, {});
  compare<law::CamClayMuI>(findings, {});
}

}  // namespace

Case const the_case{"manufactured/affine",
                    "Simple shear that speeds up, of a material with a history",
                    "a material point on the same path with the same steps",
                    "derived in the case's file",
                    1,
                    20,
                    run};

}  // namespace talus::verification::manufactured_affine
