#include "verification/suite/resting_column.hpp"

#include <cmath>

#include "models/boundaries/contacts/mirrored_slip.hpp"
#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/settle.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification {

namespace {

/// Gravity towards y = 0, by the sign of the unloaded place.
class Inwards final : public BodyForce<2> {
 public:
  explicit Inwards(std::vector<double> X) : X_(std::move(X)) {}
  [[nodiscard]] Point<2> acceleration(long id, double) const override {
    return {0, X_[static_cast<std::size_t>(id)] > 0 ? -column_on_foot.gravity : column_on_foot.gravity};
  }

 private:
  std::vector<double> X_;
};

struct Column {
  std::vector<double> X;  ///< unloaded place of each particle
  std::unique_ptr<Simulation<2>> simulation;
};

/// N cells in the unloaded height, n particles a cell.
Column begun(Scheme const& scheme, int N, int n, Foot foot) {
  bool const twin = foot == Foot::twin;
  auto const& exact = column_on_foot;
  double const h = exact.height / N, c = std::sqrt(exact.modulus / exact.density);
  Column column;
  std::vector<Seed<2>> seeds;
  Point<2> const low(0, twin ? -exact.height : 0);
  for (auto const& place : lattice<2>(low, {block_edge, twin ? 2 * N : N}, {1, n}, h)) {
    double const X = place[1], side = X < 0 ? -1 : 1;
    Seed<2> seed;
    seed.x = {place[0], side * exact.place(side * X)};
    seed.mass = exact.density * h * h / n;
    seed.strain = {0, exact.log_stretch(side * X), 0};
    seeds.push_back(seed);
    column.X.push_back(X);
  }
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, h, exact.density, {exact.modulus, 0});
  scene.periods = {1, 0};
  if (twin) {
    scene.body_force = std::make_unique<Inwards>(column.X);
  } else {
    scene.gravity = {0, -exact.gravity};
    wall::HalfSpace::Parameters floor;
    floor.normal = {0, 1};
    scene.walls.push_back(foot == Foot::mirror
                              ? make_wall<2, wall::HalfSpace, wall::MirroredSlip, wall::Fixed>("floor", floor, {}, {})
                              : make_wall<2, wall::HalfSpace, wall::Slip, wall::Fixed>("floor", floor, {}, {}));
  }
  set_step(scene, 0.2 * h / c);
  column.simulation = begin(std::move(scene), seeds);
  return column;
}

}  // namespace

Measured solved_column(Scheme const& scheme, int N, int n, Foot foot) {
  auto const& exact = column_on_foot;
  Column const column = begun(scheme, N, n, foot);
  Measured measured;
  settle(*column.simulation, 25 * N * 5, measured.cost);
  auto const y = verification::column(*column.simulation, "position", 1);
  auto const strain = verification::column(*column.simulation, "elastic_strain", 1);
  std::vector<double> place, stress;
  for (std::size_t p = 0; p < y.size(); ++p) {
    double const side = column.X[p] < 0 ? -1 : 1, X = side * column.X[p];
    place.push_back((y[p] - side * exact.place(X)) / exact.height);
    stress.push_back((strain[p] - exact.log_stretch(X)) / exact.log_stretch(0));
  }
  measured.errors = {root_mean_square(place), root_mean_square(stress)};
  return measured;
}

}  // namespace talus::verification
