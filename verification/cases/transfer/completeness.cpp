/// What every kernel must fulfil at every place in a cell, on nodes and edges and next to them:
///
///   sum_i N_i = 1,  sum_i N_i (x_i - x) = 0,  sum_i N'_i = 0,  sum_i N'_i (x_i - x) = 1                        (1)
///   sum_i N_i (x_i - x)^2 = (p + 1) h^2/12     for degrees p >= 2                                               (2)
///
/// and, as an oracle of its own, the recursion of Cox and de Boor. The rows "in the solver" ask (1) of what the
/// solver's transfer gives its nodes from one particle, so that the choice of nodes is asked, too.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/type_list.hpp"
#include "models/catalogue_kernels.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/reference/lattice_modes.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::transfer_completeness {

namespace {

/// Multiples of half a cell, with their neighbours among the numbers, and places between.
std::vector<double> places() {
  std::vector<double> all;
  for (int half = -8; half <= 8; ++half) {
    double const x = 0.5 * half, far = std::numeric_limits<double>::max();
    for (double const near : {x, std::nextafter(x, -far), std::nextafter(x, far), x - 1e-8, x + 1e-8})
      all.push_back(near);
  }
  for (int k = 0; k < 2000; ++k) all.push_back(-4 + k * 0.00401);
  return all;
}

struct Worst {
  double unity = 0, linear = 0, slope = 0, inertia = 0, oracle = 0;
};

/// Of the kernel alone.
template <class K>
Worst of_kernel() {
  Worst worst;
  for (double const x : places()) {
    int const base = static_cast<int>(std::floor(x - K::base_shift));
    std::array<double, static_cast<std::size_t>(K::width)> N{}, slope{};
    K::weights(x - base, N);
    K::slopes(x - base, slope);
    double unity = -1, linear = 0, inertia = -(K::degree + 1) / 12.0, slopes = 0, gradient = -1;
    for (int k = 0; k < K::width; ++k) {
      auto const own = static_cast<std::size_t>(k);
      double const lever = base + k - x;
      unity += N[own];
      linear += N[own] * lever;
      inertia += N[own] * lever * lever;
      slopes += slope[own];
      gradient += slope[own] * lever;
      worst.oracle = std::max(worst.oracle, std::abs(N[own] - reference::cardinal_spline(K::degree, -lever)));
      if (K::degree > 1)  // that of degree 1 jumps at nodes
        worst.oracle =
            std::max(worst.oracle, std::abs(slope[own] - reference::cardinal_spline_slope(K::degree, -lever)));
    }
    worst.unity = std::max(worst.unity, std::abs(unity));
    worst.linear = std::max(worst.linear, std::abs(linear));
    worst.slope = std::max({worst.slope, std::abs(slopes), std::abs(gradient)});
    if (K::degree > 1) worst.inertia = std::max(worst.inertia, std::abs(inertia));
  }
  return worst;
}

/// Of what the nodes get from one particle of mass 1 at (x, 0.3), along the first axis; h = 1.
Worst of_solver(std::string const& kernel) {
  Worst worst;
  for (double const x : places()) {
    Seed<2> seed;
    seed.x = {x, 0.3};
    seed.mass = 1;
    auto const simulation =
        begin(scene_of<kinematics::PlaneStrainReduced, law::Hencky>({kernel, "flip"}, 1, 1, {1, 0}), std::vector{seed});
    Stages<2> const& stages = *simulation->scene().stages;
    Run const& run = simulation->particles().runs().front();
    auto const batch =
        simulation->particles().batch(run, 1, simulation->grid().particle_block(static_cast<std::size_t>(run.block)));
    std::vector<NodeVector> arena(static_cast<std::size_t>(stages.arena_nodes * stages.summed));
    stages.scatter_momentum(batch, arena.data());
    int const edge = static_cast<int>(std::lround(std::sqrt(stages.arena_nodes)));
    double unity = -1, linear = 0;
    for (int node = 0; node < stages.arena_nodes; ++node) {
      double const mass = arena[static_cast<std::size_t>(node)][2];
      unity += mass;
      linear += mass * (batch.first[0] + node / edge - x);
    }
    worst.unity = std::max(worst.unity, std::abs(unity));
    worst.linear = std::max(worst.linear, std::abs(linear));
  }
  return worst;
}

void run(Findings& findings) {
  Interval const bar = at_most(1e-14);
  for_each_type(catalogue::Kernels{}, [&]<class K>(std::type_identity<K>) {
    std::string const name(K::name);
    Worst const kernel = of_kernel<K>(), solver = of_solver(name);
    std::string const why = "an identity; a few roundings of numbers of order 1";
    findings.check(name, "sum N - 1", kernel.unity, bar, why);
    findings.check(name, "sum N (x_i - x)", kernel.linear, bar, why);
    findings.check(name, "sum N' and sum N' (x_i - x) - 1", kernel.slope, bar, why);
    if (K::degree > 1) findings.check(name, "second moment - (p + 1)/12", kernel.inertia, bar, why);
    findings.check(name, "distance from the recursion", kernel.oracle, bar, why);
    findings.check(name, "sum N - 1, in the solver", solver.unity, bar, why);
    findings.check(name, "sum N (x_i - x), in the solver", solver.linear, bar, why);
  });
}

}  // namespace

Case const the_case{"transfer/completeness",
                    "Weights sum to one and reproduce linear fields, everywhere in a cell",
                    "identities of B-splines; the recursion of Cox and de Boor",
                    "de Boor (1972), doi:10.1016/0021-9045(72)90080-9",
                    0,
                    5,
                    run};

}  // namespace talus::verification::transfer_completeness
