/// The error of quadrature: what force nodes feel from a stress that is the same everywhere, where the particles' lattice
/// does not fit the grid. With n particles a cell and the lattice at o,
///
///   e(o) = 1/n sum_p N'(x_p),  x_p = o + p/n          force over stress and face of a cell                         (1)
///
/// has the Fourier series sum_j 2 pi i n j (sin(pi n j)/(pi n j))^(p + 1) exp(2 pi i n j o). It is zero for whole n; for
/// n = 3/2, 5/2, ... the sums over odd j are those of a square wave, a triangle wave and its integral:
///
///   max_o e = 1/n (degree 1),  1/(2 n^2) (degree 2),  1/(8 n^3) (degree 3)                                        (2)
///
/// This bounds what stress can be worth with particles off the lattice, however fine the grid.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification {

namespace {

constexpr double strain = 0.01, dt = 1e-3;  // h = 1, density 1, E = 1, nu = 0
constexpr int cells = 24;

/// 24 cells along x, 4 along y, one particle across each; they begin at the offset o.
std::vector<Seed<2>> strip(double n, double offset) {
  std::vector<Seed<2>> seeds;
  for (int p = 0; p < std::lround(cells * n); ++p)
    for (int row = 0; row < block_edge; ++row) {
      Seed<2> seed;
      seed.x = {offset + p / n, row + 0.5};
      seed.mass = 1 / n;
      seed.strain = {strain, 0, 0};
      seeds.push_back(seed);
    }
  return seeds;
}

/// Largest |(1)| of the nodes far from the ends, from what the solver scatters.
double largest_force(std::string const& kernel, double n, double offset) {
  auto scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>({kernel, "pic"}, 1, 1, {1, 0});
  scene.periods = {0, 1};
  auto const simulation = begin(std::move(scene), strip(n, offset));
  Stages<2> const& stages = *simulation->scene().stages;
  auto& particles = simulation->particles();
  std::vector<Load<2>> loads(static_cast<std::size_t>(particles.most_chunks_of_a_run()));
  int const edge = static_cast<int>(std::lround(std::sqrt(stages.arena_nodes)));
  std::map<long, double> force;  // by column of nodes
  for (Run const& run : particles.runs()) {
    auto const batch = particles.batch(run, 1, simulation->grid().particle_block(static_cast<std::size_t>(run.block)));
    std::vector<NodeVector> arena(static_cast<std::size_t>(stages.arena_nodes * stages.summed));
    simulation->scene().materials.front()->load(batch, false, loads.data());
    stages.scatter(batch, loads.data(), dt, arena.data());
    for (int node = 0; node < stages.arena_nodes; ++node)
      force[std::lround(batch.first[0]) + node / edge] +=
          arena[static_cast<std::size_t>((node + 1) * stages.summed - 1)][0] / (dt * strain * block_edge);
  }
  double most = 0;
  for (int i = 8; i < cells - 8; ++i) most = std::max(most, std::abs(force[i]));
  return most;
}

void run(Findings& findings) {
  for (std::string const kernel : {"linear", "quadratic", "cubic"}) {
    int const degree = Scheme{kernel, "pic"}.degree();
    Curve found{kernel, {}, {}, false};
    for (double const n : {1.5, 2.0, 2.5, 3.5, 4.0}) {
      double most = 0;
      for (int k = 0; k < 8; ++k) most = std::max(most, largest_force(kernel, n, (k + 1e-9 * (degree == 1)) / (8 * n)));
      bool const fits = n == std::floor(n);
      double const law = fits ? 0 : degree == 1 ? 1 / n : degree == 2 ? 1 / (2 * n * n) : 1 / (8 * n * n * n);
      findings.check(fmt::format("{}, {} a cell", kernel, n), "largest force less (2)", std::abs(most - law),
                     at_most(1e-12), fits ? "the lattice fits: no force" : "(2), worst of eight offsets");
      if (fits) continue;
      found.x.push_back(n);
      found.y.push_back(most);
    }
    if (findings.plots.empty())
      findings.plots.push_back({"Force under uniform stress", "particles a cell", "force over stress", true, true, {}});
    findings.plots.front().curves.push_back(found);
  }
}

}  // namespace

Case const transfer_quadrature{"transfer/quadrature",
                               "Force under uniform stress where particles do not fit the grid",
                               "the law of the error of quadrature, in closed form",
                               "derived in the case's file",
                               0,
                               5,
                               run};

}  // namespace talus::verification
