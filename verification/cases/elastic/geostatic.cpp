/// A soft column under its own weight, compressed to 0.66 of its height: Hencky's law in closed form
/// (verification/reference/hencky_column.hpp).
///
/// The particles begin at the exact places x(X) with the exact strain, and the scheme finds its own equilibrium: whenever
/// the kinetic energy falls, all velocities are set to zero, until a push no longer moves anything. What is measured is
/// how far that equilibrium is from the exact one. Spacing and particles are refined together.
///
/// "mirrored": two columns foot to foot, pulled towards the middle. That has no wall. "on a wall": one column on a slip
/// wall at a node; kernels reach below it, where there are no particles, so that the first node above it feels the
/// stress at the wall without its counterpart: an error of order 1 in h that stays near the wall.

#include <algorithm>
#include <cmath>

#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/reference/hencky_column.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"
#include "verification/suite/settle.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification {

namespace {

constexpr reference::HenckyColumn column_on_foot{1e5, 1500, 9.81, 10};

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
Column begun(Scheme const& scheme, int N, int n, bool mirrored) {
  auto const& exact = column_on_foot;
  double const h = exact.height / N, c = std::sqrt(exact.modulus / exact.density);
  Column column;
  std::vector<Seed<2>> seeds;
  Point<2> const low(0, mirrored ? -exact.height : 0);
  for (auto const& place : lattice<2>(low, {block_edge, mirrored ? 2 * N : N}, {1, n}, h)) {
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
  if (mirrored) {
    scene.body_force = std::make_unique<Inwards>(column.X);
  } else {
    scene.gravity = {0, -exact.gravity};
    wall::HalfSpace::Parameters floor;
    floor.normal = {0, 1};
    scene.walls.push_back(make_wall<2, wall::HalfSpace, wall::Slip, wall::Fixed>("floor", floor, {}, {}));
  }
  set_step(scene, 0.2 * h / c);
  column.simulation = begin(std::move(scene), seeds);
  return column;
}

/// Errors of place over the height and of stress over that at the foot, root mean square over particles.
Measured solved(Scheme const& scheme, int N, int n, bool mirrored) {
  auto const& exact = column_on_foot;
  Column const column = begun(scheme, N, n, mirrored);
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

void study(Findings& findings, Scheme const& scheme, bool mirrored) {
  constexpr int cells[] = {10, 20, 40};
  Refinement study;
  study.subject = scheme.name() + (mirrored ? ", mirrored" : ", on a wall");
  for (int const N : cells) study.spacings.push_back(column_on_foot.height / N);
  study.norms.resize(2);
  study.norms[0].name = "x over the height";
  study.norms[1].name = "stress over that at the foot";
  if (mirrored) study.norms[0].level = 1e-3;
  study.norms[0].order = mirrored ? 1.8 : 0.85;
  study.norms[0].because = mirrored ? "2 or more: at rest, smoothing by the lumped mass plays no part; 1e-3 at 40 cells"
                                    : "1: the wall's; 1e-3 at 40 cells is not reached";
  study.norms[1].because = "quadrature, and what is next to foot and top";
  study.solve = [&](std::size_t level) { return solved(scheme, cells[level], cells[level] / 5, mirrored); };
  refine(findings, study, "Column");
}

void run(Findings& findings) {
  auto const& exact = column_on_foot;
  findings
      .check("closed form", "height of the card M = 1e5, rho_0 = 1500, H = 10", exact.place(exact.height),
             about(6.6289627048, 1e-10), "computed apart, by quadrature of F")
      .unit = "m";
  for (std::string const kernel : {"quadratic", "cubic"})
    for (bool const mirrored : {true, false}) study(findings, {kernel, "flip"}, mirrored);
}

}  // namespace

Case const elastic_geostatic{"elastic/geostatic",
                             "A soft column under its own weight, at finite strain",
                             "closed form with Lambert's function",
                             "derived in verification/reference/hencky_column.hpp",
                             1,
                             60,
                             run};

}  // namespace talus::verification
