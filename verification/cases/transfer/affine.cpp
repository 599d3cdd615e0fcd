/// An affine velocity v = A x + c, A not symmetric, through one whole step of an affine transfer:
///
///   a cloud anywhere, under gravity:      v_p = A x_p + c + dt g,  C_p = A,  strain of I + dt A                   (1)
///   inside a lattice, body force B X + b:  v_p = (A + dt B) x_p + c + dt b,  C_p = A + dt B                      (2)
///
/// and eps = 1/2 ln(F F^T), F = I + dt A or I + dt (A + dt B). (1) holds because affine weights sum to x_i; (2), where
/// particles lie evenly around each node that is looked at. (2) tells a C_p of the velocities after the forces from one
/// of those before.

#include <cmath>
#include <random>

#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/reference/linear_algebra.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::transfer_affine {

namespace {

constexpr double h = 0.25, density = 1000, dt = 0.01;

template <int D>
using Square = Eigen::Matrix<double, D, D>;

/// gradient x + offset; sheared, turned and stretched, nothing alike.
template <int D>
struct Affine {
  Square<D> gradient;
  Point<D> offset;
  explicit Affine(double shift) {
    for (int i = 0; i < D; ++i) {
      offset[i] = 0.3 - 0.4 * i + shift;
      for (int j = 0; j < D; ++j) gradient(i, j) = std::sin(1 + 2.3 * i + 5.1 * j + shift);
    }
  }
  Point<D> operator()(Point<D> const& x) const { return gradient * x + offset; }
};

template <int D>
class AffineForce final : public BodyForce<D> {
 public:
  AffineForce(Affine<D> field, std::vector<Point<D>> places) : field_(field), places_(std::move(places)) {}
  [[nodiscard]] Point<D> acceleration(long id, double) const override {
    return field_(places_[static_cast<std::size_t>(id)]);
  }

 private:
  Affine<D> field_;
  std::vector<Point<D>> places_;
};

/// Largest distance from (1) or (2) of v dt, C dt and the strain, over particles of which `counts` is true.
template <class Kinematics>
double distance(Simulation<Kinematics::dimension> const& simulation,
                std::vector<Point<Kinematics::dimension>> const& places, Square<Kinematics::dimension> const& gradient,
                Point<Kinematics::dimension> const& offset, auto const& counts) {
  constexpr int D = Kinematics::dimension;
  using Strain = Symmetric<double, typename Kinematics::Shape>;
  Square<D> const F = Square<D>::Identity() + dt * gradient;
  Square<D> const strain = 0.5 * reference::logarithm(F * F.transpose());
  auto const v = vectors(simulation, "velocity"), x = vectors(simulation, "position");
  double worst = 0;
  for (std::size_t p = 0; p < places.size(); ++p) {
    if (!counts(places[p])) continue;
    Point<D> const moved = gradient * places[p] + offset;
    worst = std::max({worst, (v[p] - moved).norm(), (x[p] - places[p] - dt * moved).norm()});
  }
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      auto const C = column(simulation, "affine_velocity", i * D + j);
      auto const eps = column(simulation, "elastic_strain", Strain::index(i, j));
      for (std::size_t p = 0; p < places.size(); ++p)
        if (counts(places[p]))
          worst = std::max({worst, h * std::abs(C[p] - gradient(i, j)), std::abs(eps[p] - strain(i, j))});
    }
  return worst;
}

template <class Kinematics>
std::unique_ptr<Simulation<Kinematics::dimension>> begun(Scheme const& scheme,
                                                         Affine<Kinematics::dimension> const& flow,
                                                         std::vector<Point<Kinematics::dimension>> const& places,
                                                         auto const& add) {
  constexpr int D = Kinematics::dimension;
  Scene<D> scene = scene_of<Kinematics, law::Hencky>(scheme, h, density, {1e4, 0.3});
  add(scene);
  set_step(scene, dt);
  std::vector<Seed<D>> seeds;
  for (Point<D> const& x : places) {
    Seed<D> seed;
    seed.x = x;
    seed.v = flow(x);
    seed.C = flow.gradient;
    seed.mass = 10;
    seeds.push_back(seed);
  }
  return begin(std::move(scene), seeds);
}

/// (1)
template <class Kinematics>
double through_cloud(Scheme const& scheme, Cost& cost) {
  constexpr int D = Kinematics::dimension;
  std::vector<Point<D>> places(300);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in(-1.0, 1.0);
  for (auto& x : places)
    for (int d = 0; d < D; ++d) x[d] = in(random);
  Affine<D> const flow(0);
  Point<D> const g = Point<D>::Constant(-3);
  auto const simulation = begun<Kinematics>(scheme, flow, places, [&](Scene<D>& scene) { scene.gravity = g; });
  take_steps(*simulation, 1, cost);
  return distance<Kinematics>(*simulation, places, flow.gradient, flow.offset + dt * g,
                              [](auto const&) { return true; });
}

/// (2)
template <class Kinematics>
double inside_lattice(Scheme const& scheme, Cost& cost) {
  constexpr int D = Kinematics::dimension;
  std::array<int, D> cells, per_axis;
  cells.fill(18);
  per_axis.fill(D == 2 ? 2 : 1);
  auto const places = lattice<D>(Point<D>::Constant(-9 * h), cells, per_axis, h);
  Affine<D> const flow(0), force(2);
  auto const simulation = begun<Kinematics>(scheme, flow, places, [&](Scene<D>& scene) {
    scene.body_force = std::make_unique<AffineForce<D>>(force, places);
  });
  take_steps(*simulation, 1, cost);
  // in MUSL, nodes 3 cells away from particles 5 cells away, from nodes 7 cells away, which particles surround
  return distance<Kinematics>(*simulation, places, flow.gradient + dt * force.gradient, flow.offset + dt * force.offset,
                              [](Point<D> const& x) { return x.cwiseAbs().maxCoeff() < h; });
}

template <class Kinematics>
void both(Findings& findings, Scheme const& scheme, std::string const& where) {
  Cost cloud, inside;
  double const off_cloud = through_cloud<Kinematics>(scheme, cloud);
  findings.check(scheme.name() + ", " + where, "v, C h and strain of a cloud", off_cloud, at_most(1e-12),
                 "exact; numbers of order 1", cloud);
  double const off_inside = inside_lattice<Kinematics>(scheme, inside);
  findings.check(scheme.name() + ", " + where, "the same after an affine force", off_inside, at_most(1e-12),
                 "exact; a C of the velocities before the force is off by dt |B| h = 2e-3", inside);
}

void run(Findings& findings) {
  for (std::string const integrator : {"usl", "musl"})
    for (Scheme const& scheme : all_schemes(integrator)) {
      if (!scheme.affine()) continue;
      both<kinematics::PlaneStrain>(findings, scheme, "2-D");
      both<kinematics::Solid>(findings, scheme, "3-D");
    }
  findings.omit("pic, flip", "v of a cloud", "they pass uniform velocities alone");
}

}  // namespace

Case const the_case{"transfer/affine",
                    "An affine velocity passes an affine transfer unchanged, gravity and force included",
                    "exact, by the completeness of the weights",
                    "Jiang et al. (2015), doi:10.1145/2766996 (abstract read); derived in the case's file",
                    0,
                    5,
                    run};

}  // namespace talus::verification::transfer_affine
