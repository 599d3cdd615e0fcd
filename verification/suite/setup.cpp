#include "verification/suite/setup.hpp"

#include <chrono>
#include <cmath>
#include <limits>

#include "core/in_short.hpp"
#include "models/transfers/mode.hpp"

namespace talus::verification {

template <int D>
std::unique_ptr<Simulation<D>> begin(Scene<D> scene, std::vector<Seed<D>> const& seeds) {
  auto simulation = std::make_unique<Simulation<D>>(std::move(scene));
  Particles<D>& particles = simulation->particles();
  Layout const& layout = particles.layout();
  particles.allocate({Run{0, 0, 0, static_cast<int>(seeds.size())}}, 1);
  int const affine = layout.find(field::affine_velocity), strain = layout.find("elastic_strain");
  std::vector<std::pair<int, double>> start;
  simulation->scene().materials.front()->start(start);
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    auto const slot = static_cast<std::ptrdiff_t>(k);
    for (int i = 0; i < D; ++i) {
      particles.set(slot, layout.find(field::position) + i, seeds[k].x[i]);
      particles.set(slot, layout.find(field::velocity) + i, seeds[k].v[i]);
      for (int j = 0; affine >= 0 && j < D; ++j) particles.set(slot, affine + i * D + j, seeds[k].C(i, j));
    }
    for (std::size_t c = 0; c < seeds[k].strain.size(); ++c)
      particles.set(slot, strain + static_cast<int>(c), seeds[k].strain[c]);
    particles.set(slot, layout.find(field::mass), seeds[k].mass);
    particles.set(slot, layout.find(field::identity), double(k));
    for (auto const& [pack, value] : start) particles.set(slot, pack, value);
  }
  simulation->begin();
  return simulation;
}

template <int D>
void take_steps(Simulation<D>& simulation, long n, Cost& cost, std::function<void()> const& after_each) {
  double const dt = elastic_step(simulation.scene());
  auto const begun = std::chrono::steady_clock::now();
  for (long k = 0; k < n; ++k) {
    simulation.advance(std::numeric_limits<double>::infinity());
    if (simulation.last_step().dt != dt)
      throw RunError("a step of " + in_short(dt) + " s was cut to " + in_short(simulation.last_step().dt) +
                     " s, limited by: " + std::string(simulation.last_step().limiter));
    if (after_each) after_each();
  }
  cost.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  cost.steps += n;
  cost.particle_steps += double(n) * double(simulation.particles().count());
}

template <int D>
std::vector<Point<D>> lattice(Point<D> const& low, std::array<int, D> cells, std::array<int, D> per_axis,
                              double spacing) {
  long total = 1;
  for (std::size_t d = 0; d < D; ++d) total *= cells[d] * per_axis[d];
  std::vector<Point<D>> points;
  for (long k = 0; k < total; ++k) {
    Point<D> x = low;
    long rest = k;
    for (int d = D - 1; d >= 0; --d) {
      auto const own = static_cast<std::size_t>(d);
      long const count = long{cells[own]} * per_axis[own];
      x[d] += (double(rest % count) + 0.5) * spacing / per_axis[own];
      rest /= count;
    }
    points.push_back(x);
  }
  return points;
}

template <int D>
double root_mean_square(std::vector<Point<D>> const& errors) {
  double sum = 0;
  for (auto const& e : errors) sum += e.squaredNorm();
  return std::sqrt(sum / double(errors.size()));
}

double root_mean_square(std::vector<double> const& errors) {
  double sum = 0;
  for (double const e : errors) sum += e * e;
  return std::sqrt(sum / double(errors.size()));
}

template std::unique_ptr<Simulation<2>> begin<2>(Scene<2>, std::vector<Seed<2>> const&);
template std::unique_ptr<Simulation<3>> begin<3>(Scene<3>, std::vector<Seed<3>> const&);
template void take_steps<2>(Simulation<2>&, long, Cost&, std::function<void()> const&);
template void take_steps<3>(Simulation<3>&, long, Cost&, std::function<void()> const&);
template std::vector<Point<2>> lattice<2>(Point<2> const&, std::array<int, 2>, std::array<int, 2>, double);
template std::vector<Point<3>> lattice<3>(Point<3> const&, std::array<int, 3>, std::array<int, 3>, double);
template double root_mean_square<2>(std::vector<Point<2>> const&);
template double root_mean_square<3>(std::vector<Point<3>> const&);

}  // namespace talus::verification
