/// Forces on nodes keep the sums and first moments of what they come from, for any cloud of particles:
///
///   sum_i f_i = sum_p m_p b_p,   sum_i f_i x_i^T = sum_p m_p b_p x_p^T     of a body force                        (1)
///   sum_i f_i = 0,               sum_i f_i x_i^T = -sum_p V_p^0 tau_p      of stress                               (2)
///
/// by sum N = 1, sum N x_i = x, sum grad N = 0 and sum grad N x_i^T = I. Nodes are not looked at: APIC hands their
/// momentum and its first moment to the particles in full,
///
///   sum_p m_p (v_p x_p^T + D_p C_p) = sum_i m_i v_i x_i^T,   with v_p, C_p after, x_p before the step.             (3)
///
/// Under a stress that is the same everywhere, particles on a commensurate lattice that repeats give no force at all.

#include <cmath>
#include <random>

#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::transfer_force_moment {

namespace {

constexpr double h = 0.25, density = 1000, dt = 1e-3, E = 1e5, nu = 0.3;
constexpr double G = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));

template <int D>
using Square = Eigen::Matrix<double, D, D>;

template <int D>
class Given final : public BodyForce<D> {
 public:
  explicit Given(std::vector<Point<D>> values) : values_(std::move(values)) {}
  [[nodiscard]] Point<D> acceleration(long id, double) const override { return values_[static_cast<std::size_t>(id)]; }

 private:
  std::vector<Point<D>> values_;
};

/// A cloud at rest, each particle with a mass, a strain and a body force of its own.
template <class Kinematics>
struct Cloud {
  static constexpr int D = Kinematics::dimension;
  using Strain = Symmetric<double, typename Kinematics::Shape>;
  std::vector<Seed<D>> seeds;
  std::vector<Point<D>> force;
  Square<D> virial = Square<D>::Zero();  ///< sum V tau

  Cloud() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> in(-1.0, 1.0);
    for (int p = 0; p < 200; ++p) {
      Seed<D> seed;
      Strain strain;
      Point<D> b;
      for (int d = 0; d < D; ++d) seed.x[d] = in(random);
      for (int d = 0; d < D; ++d) b[d] = 10 * in(random);
      for (int k = 0; k < Strain::size; ++k) strain[k] = 0.1 * in(random);
      seed.mass = 2 + in(random);
      seed.strain.assign(strain.entries.begin(), strain.entries.end());
      double volume_change = 0;
      for (int k = 0; k < Strain::normals; ++k) volume_change += strain[k];
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          virial(i, j) += seed.mass / density * (2 * G * strain(i, j) + (i == j ? lambda * volume_change : 0));
      seeds.push_back(seed);
      force.push_back(b);
    }
  }
};

/// Largest distance of the sums after a step from (1) or (2), over the largest of their terms.
template <class Kinematics>
double distance(Scheme const& scheme, Cloud<Kinematics> const& cloud, bool pushed, Cost& cost) {
  constexpr int D = Kinematics::dimension;
  Scene<D> scene = scene_of<Kinematics, law::Hencky>(scheme, h, density, {E, nu});
  if (pushed) scene.body_force = std::make_unique<Given<D>>(cloud.force);
  set_step(scene, dt);
  auto seeds = cloud.seeds;
  for (auto& seed : seeds)
    if (pushed) seed.strain.clear();
  auto const simulation = begin(std::move(scene), seeds);
  take_steps(*simulation, 1, cost);

  double const inertia = (scheme.degree() + 1) * h * h / 12;
  Point<D> sum = Point<D>::Zero();
  Square<D> first = Square<D>::Zero(), exact = pushed ? Square<D>(Square<D>::Zero()) : Square<D>(-cloud.virial);
  auto const v = vectors(*simulation, "velocity");
  double scale = 0;
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    double const mass = seeds[p].mass;
    sum += mass / dt * v[p];
    first += mass / dt * v[p] * seeds[p].x.transpose();
    scale += mass / dt * v[p].norm();
    if (!pushed) continue;
    sum -= mass * cloud.force[p];
    exact += mass * cloud.force[p] * seeds[p].x.transpose();
  }
  for (int k = 0; k < D * D; ++k) {
    auto const C = column(*simulation, "affine_velocity", k);
    for (std::size_t p = 0; p < seeds.size(); ++p) first(k / D, k % D) += seeds[p].mass / dt * inertia * C[p];
  }
  return std::max(sum.norm(), (first - exact).norm()) / scale;
}

/// Largest speed after a step under a stress that is the same everywhere, over what one particle's stress alone would
/// give a node in it.
double speed_of_lattice(Scheme const& scheme, Cost& cost) {
  using Kinematics = kinematics::PlaneStrain;
  Scene<2> scene = scene_of<Kinematics, law::Hencky>(scheme, h, density, {E, nu});
  scene.periods = {2, 2};
  set_step(scene, dt);
  std::vector<Seed<2>> seeds;
  for (auto const& x : lattice<2>({0, 0}, {8, 8}, {2, 3}, h)) {
    Seed<2> seed;
    seed.x = x;
    seed.mass = density * h * h / 6;
    seed.strain = {0.02, -0.03, 0.01, 0.015};
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  take_steps(*simulation, 1, cost);
  double most = 0;
  for (auto const& v : vectors(*simulation, "velocity")) most = std::max(most, v.norm());
  return most / (dt * E * 0.03 / (h * density));
}

template <class Kinematics>
void of_cloud(Findings& findings, Scheme const& scheme, std::string const& where) {
  Cloud<Kinematics> const cloud;
  for (bool const pushed : {true, false}) {
    Cost cost;
    double const off = distance(scheme, cloud, pushed, cost);
    findings.check(scheme.name() + ", " + where, pushed ? "sum and moment, body force" : "sum and moment, stress", off,
                   at_most(1e-12), "exact for any cloud; rounding of sums over 200 particles", cost);
  }
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes()) {
    if (scheme.transfer == "apic") {
      of_cloud<kinematics::PlaneStrain>(findings, scheme, "2-D");
      of_cloud<kinematics::Solid>(findings, scheme, "3-D");
    }
    Cost cost;
    double const speed = speed_of_lattice(scheme, cost);
    findings.check(scheme.name(), "speed under uniform stress", speed, at_most(1e-13),
                   "contributions cancel; rounding of each", cost);
  }
}

}  // namespace

Case const the_case{"transfer/force_moment",
                    "Forces on nodes keep sum and first moment of body force and stress",
                    "exact, by the completeness of weights and gradients",
                    "derived in the case's file",
                    0,
                    5,
                    run};

}  // namespace talus::verification::transfer_force_moment
