#include "verification/suite/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/errors.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/reference/stability/bisection.hpp"
#include "verification/reference/stability/regular.hpp"

namespace talus::verification {

namespace {

constexpr double small = 1e-9;  ///< strains, and velocities over wave speeds, that begin

template <class Kinematics>
Scene<Kinematics::dimension> scene_with(ElasticScheme const& elastic) {
  return scene_of<Kinematics, law::Hencky>(elastic.scheme, elastic.spacing, elastic.density,
                                           {elastic.young, elastic.poisson});
}

/// The particles of the lattice with random velocities.
template <int D>
std::vector<Seed<D>> disturbed(ElasticScheme const& elastic, PeriodicLattice const& lattice) {
  std::mt19937_64 source(7);
  std::uniform_real_distribution<double> velocity(-1, 1);
  double const h = elastic.spacing, scale = small * h / elastic.unit();
  Point<D> low;
  std::array<int, D> cells, per_axis;
  for (std::size_t d = 0; d < D; ++d) {
    low[static_cast<int>(d)] = lattice.offset[d] * h;
    cells[d] = PeriodicLattice::cells;
    per_axis[d] = lattice.per_axis;
  }
  std::vector<Seed<D>> seeds;
  for (auto const& x : talus::verification::lattice<D>(low, cells, per_axis, h)) {
    Seed<D> seed;
    seed.x = x;
    for (int d = 0; d < D; ++d) seed.v[d] = scale * velocity(source);
    seed.mass = elastic.density * std::pow(h / lattice.per_axis, D);
    seeds.push_back(seed);
  }
  return seeds;
}

template <class Kinematics>
bool grows(ElasticScheme const& elastic, PeriodicLattice const& lattice, double step, Cost& cost) {
  constexpr int D = Kinematics::dimension;
  Scene<D> scene = scene_with<Kinematics>(elastic);
  scene.periods.fill(PeriodicLattice::cells / block_edge);
  set_step(scene, step * elastic.unit());
  auto const simulation = begin(std::move(scene), disturbed<D>(elastic, lattice));
  double first = 0;
  try {
    take_steps(*simulation, 5, cost, [&] { first = std::max(first, simulation->motion().gradient); });
    for (int taken = 5; taken < 2000; taken += 15) {
      take_steps(*simulation, 15, cost);
      if (!(simulation->motion().gradient < unstable_growth * first)) return true;
    }
  } catch (RunError const&) {
    return true;
  }
  return false;
}

/// Largest entry of each particle's strain.
template <int D>
std::vector<double> strains(Simulation<D> const& simulation) {
  std::vector<double> most(simulation.particles().count(), 0.0);
  for (int c = 0; c < simulation.scene().strain_size; ++c) {
    auto const entry = column(simulation, "elastic_strain", c);
    for (std::size_t p = 0; p < most.size(); ++p) most[p] = std::max(most[p], std::abs(entry[p]));
  }
  return most;
}

/// One particle at each offset, the cells that they lie in apart by more than two supports.
template <int D>
std::vector<Seed<D>> apart(ElasticScheme const& elastic, std::vector<Point<D>> const& offsets, int strain_size) {
  constexpr int gap = 8, row = 32;
  std::mt19937_64 source(11);
  std::uniform_real_distribution<double> strain(0.5 * small, small);
  std::vector<Seed<D>> seeds;
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    Seed<D> seed;
    seed.x = offsets[k];
    seed.x[0] += gap * double(k % row);
    seed.x[1] += gap * double(k / row);
    seed.x *= elastic.spacing;
    seed.mass = elastic.density * std::pow(elastic.spacing / 2, D);
    for (int c = 0; c < strain_size; ++c) seed.strain.push_back(strain(source));
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace

reference::Transfer transfer_of(Scheme const& scheme) {
  bool const incremental = scheme.transfer == "flip" || scheme.transfer == "aflip";
  return {scheme.degree(), scheme.affine(), incremental ? scheme.alpha : 0, scheme.integrator == "musl"};
}

template <class Kinematics>
double isolated_bound(ElasticScheme const& elastic) {
  auto scene = scene_with<Kinematics>(elastic);
  scene.limits.safety = 1;
  return elastic_step(scene) / elastic.unit();
}

template <class Kinematics>
double measured_limit(ElasticScheme const& elastic, PeriodicLattice const& lattice, Cost& cost) {
  double const bound = isolated_bound<Kinematics>(elastic);
  return reference::largest_where_true([&](double step) { return !grows<Kinematics>(elastic, lattice, step, cost); },
                                       0.5 * bound, 8 * bound, 0.005);
}

template <class Kinematics>
double predicted_limit(ElasticScheme const& elastic, PeriodicLattice const& lattice) {
  return reference::longest_step(
      {Kinematics::dimension, lattice.per_axis, lattice.offset, elastic.poisson, PeriodicLattice::cells},
      transfer_of(elastic.scheme));
}

template <class Kinematics>
PeriodicLattice worst_lattice(ElasticScheme const& elastic, int per_axis) {
  constexpr int parts = 16;
  PeriodicLattice worst;
  double shortest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < parts; ++k) {
    double const offset = (k + 0.01) / (parts * per_axis);  // not exactly where a node drops out of the support
    PeriodicLattice const lattice{per_axis, {offset, offset, offset}};
    double const limit = predicted_limit<Kinematics>(elastic, lattice);
    if (limit < shortest) shortest = limit, worst = lattice;
  }
  return worst;
}

template <class Kinematics>
std::vector<double> isolated_growth(ElasticScheme const& elastic,
                                    std::vector<Point<Kinematics::dimension>> const& offsets, double step, int steps,
                                    Cost& cost) {
  constexpr int D = Kinematics::dimension;
  Scene<D> scene = scene_with<Kinematics>(elastic);
  set_step(scene, step * elastic.unit());
  auto const seeds = apart<D>(elastic, offsets, scene.strain_size);
  auto const simulation = begin(std::move(scene), seeds);
  auto const first = strains(*simulation);
  std::vector<double> growth(offsets.size(), 0.0);
  for (int taken = 0; taken < steps; ++taken) {
    take_steps(*simulation, 1, cost);
    auto const now = strains(*simulation);
    for (std::size_t p = 0; p < growth.size(); ++p) growth[p] = std::max(growth[p], now[p] / first[p]);
    if (*std::max_element(growth.begin(), growth.end()) > 1e-5 / small) break;
  }
  return growth;
}

template <class Kinematics>
std::vector<double> isolated_limits(ElasticScheme const& elastic,
                                    std::vector<Point<Kinematics::dimension>> const& offsets, Cost& cost) {
  double const unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> limits(offsets.size(), unknown);
  double step = 0.9 * isolated_bound<Kinematics>(elastic);
  for (int rung = 0; rung < 150; step *= 1.01) {
    std::vector<Point<Kinematics::dimension>> left;
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < offsets.size(); ++k)
      if (std::isnan(limits[k])) left.push_back(offsets[k]), numbers.push_back(k);
    if (left.empty()) break;
    auto const growth = isolated_growth<Kinematics>(elastic, left, step, 600, cost);
    bool cut = false;
    for (std::size_t k = 0; k < left.size(); ++k) {
      if (growth[k] > unstable_growth) limits[numbers[k]] = step / 1.01;
      cut = cut || growth[k] > unstable_growth;
    }
    if (cut)
      step /= 1.01;  // once more without those that grow
    else
      ++rung;
  }
  return limits;
}

template double isolated_bound<kinematics::PlaneStrainReduced>(ElasticScheme const&);
template double isolated_bound<kinematics::PlaneStrain>(ElasticScheme const&);
template double isolated_bound<kinematics::Solid>(ElasticScheme const&);
template double measured_limit<kinematics::PlaneStrainReduced>(ElasticScheme const&, PeriodicLattice const&, Cost&);
template double measured_limit<kinematics::Solid>(ElasticScheme const&, PeriodicLattice const&, Cost&);
template double predicted_limit<kinematics::PlaneStrainReduced>(ElasticScheme const&, PeriodicLattice const&);
template double predicted_limit<kinematics::Solid>(ElasticScheme const&, PeriodicLattice const&);
template PeriodicLattice worst_lattice<kinematics::PlaneStrainReduced>(ElasticScheme const&, int);
template std::vector<double> isolated_growth<kinematics::PlaneStrainReduced>(ElasticScheme const&,
                                                                             std::vector<Point<2>> const&, double, int,
                                                                             Cost&);
template std::vector<double> isolated_growth<kinematics::PlaneStrain>(ElasticScheme const&,
                                                                      std::vector<Point<2>> const&, double, int, Cost&);
template std::vector<double> isolated_growth<kinematics::Solid>(ElasticScheme const&, std::vector<Point<3>> const&,
                                                                double, int, Cost&);
template std::vector<double> isolated_limits<kinematics::PlaneStrainReduced>(ElasticScheme const&,
                                                                             std::vector<Point<2>> const&, Cost&);
template std::vector<double> isolated_limits<kinematics::Solid>(ElasticScheme const&, std::vector<Point<3>> const&,
                                                                Cost&);

}  // namespace talus::verification
