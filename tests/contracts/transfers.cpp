#include <Eigen/LU>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "models/boundaries/make_wall.hpp"
#include "models/catalogue.hpp"
#include "tests/support/elastic_scenes.hpp"

BOOST_AUTO_TEST_SUITE(transfers)

using namespace talus;
using namespace talus::support;

namespace {

/// Fifty steps; the largest difference between the momentum and what came in, over the largest sum m |v|.
template <int D>
double momentum_error(Simulation<D>& simulation) {
  Point<D> const before = momentum_of(simulation);
  double worst = 0, scale = scale_of(simulation);
  for (int step = 0; step < 50; ++step) {
    simulation.advance(forever);
    Point<D> in = before + simulation.momentum().gravity;
    for (Point<D> const& impulse : simulation.momentum().walls) in += impulse;
    scale = std::max(scale, scale_of(simulation));
    worst = std::max(worst, (momentum_of(simulation) - in).norm());
  }
  return worst / scale;
}

/// Two blocks that meet.
template <int D>
std::vector<Seed<D>> colliding() {
  Point<D> const size = Point<D>::Constant(3 * h);
  auto seeds = block<D>(Point<D>::Zero(), size, h, 2, density, 0.3, 3);
  Point<D> shift = Point<D>::Constant(0.7 * h);
  shift[0] = 3.4 * h;
  auto other = block<D>(shift, shift + size, h, 2, density, 0.3, 4);
  for (auto& seed : seeds) seed.v = Flow<D>().c + Point<D>::Unit(0);
  for (auto& seed : other) seed.v = Flow<D>().c - Point<D>::Unit(0);
  seeds.insert(seeds.end(), other.begin(), other.end());
  return seeds;
}

/// Tiny steps on a row of N cells that repeats, filled with a wave of velocity: 1 - the share that a step leaves.
template <class K, class T>
double loss(int N, typename T::Parameters const& transfer) {
  auto scene = elastic_scene<2, K, T, integrator::Usl>(transfer);
  scene.periods = {N / block_edge, 1};
  Simulation<2> simulation(std::move(scene));
  double const k = 2 * std::numbers::pi / (N * h);
  auto seeds = block<2>({0, 0}, {N * h, block_edge * h}, h, 4, density, 0, 1);
  for (auto& seed : seeds) {
    seed.v[0] = std::sin(k * seed.x[0]);
    seed.C(0, 0) = k * std::cos(k * seed.x[0]);
  }
  fill(simulation, seeds);
  auto const wave = [&] {
    auto const v = vectors(simulation, "velocity");
    double sum = 0;
    for (std::size_t p = 0; p < seeds.size(); ++p) sum += v[p][0] * seeds[p].v[0];
    return sum;
  };
  simulation.advance(1e-12);  // after which C_p, too, is what a step leaves of it
  double const before = wave();
  simulation.advance(2e-12);
  return 1 - wave() / before;
}

}  // namespace

// A few hundred roundings of numbers of order 1; what is wrong by a term is wrong by 1e-3 and more.
constexpr double round_off = 1e-12;

BOOST_AUTO_TEST_CASE(an_affine_transfer_passes_an_affine_velocity_on_as_it_is) {
  for_each_scheme([]<int D>(Scheme<D> const& scheme) {
    if (scheme.affine) {
      Flow<D> const flow;
      auto scene = scheme.scene();
      scene.gravity = Point<D>::Constant(-3);
      Simulation<D> simulation(std::move(scene));
      auto seeds = cloud<D>(6);
      for (auto& seed : seeds) {
        seed.v = flow(seed.x);
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j) seed.C(i, j) = flow.A(i, j);
      }
      fill(simulation, seeds);
      simulation.advance(forever);
      double const dt = simulation.last_step().dt;
      auto const x = vectors(simulation, "position"), v = vectors(simulation, "velocity");
      double worst = 0;
      for (std::size_t p = 0; p < seeds.size(); ++p) {
        Point<D> const moved = flow(seeds[p].x) - Point<D>::Constant(3 * dt);
        worst = std::max({worst, (v[p] - moved).norm(), (x[p] - seeds[p].x - dt * moved).norm()});
      }
      BOOST_TEST(worst < round_off);
      for (int k = 0; k < D * D; ++k)
        for (double const C : column(simulation, "affine_velocity", k))
          if (!(std::abs(C - flow.A(k / D, k % D)) < round_off / h)) BOOST_ERROR("C_p is not A");
      // L = A is what strained the material: eps = log((I + dt A)(I + dt A)^T)/2, so tr eps = log det(I + dt A).
      double const trace = std::log((Eigen::Matrix<double, D, D>::Identity() + dt * flow.A).determinant());
      auto sum = column(simulation, "elastic_strain", 0);
      for (int k = 1; k < D; ++k) {
        auto const next = column(simulation, "elastic_strain", k);
        for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += next[p];
      }
      for (double const s : sum)
        if (!(std::abs(s - trace) < round_off)) BOOST_ERROR("tr eps is " << s << " instead of " << trace);
    }
  });
}

BOOST_AUTO_TEST_CASE(every_kernel_finds_the_gradient_of_an_affine_velocity_of_the_nodes) {
  for_each_scheme([]<int D>(Scheme<D> const& scheme) {
    Flow<D> const flow;
    Simulation<D> simulation(scheme.scene());
    fill(simulation, cloud<D>(3));
    Stages<D> const& stages = *simulation.scene().stages;
    std::vector<NodeVector> arena(static_cast<std::size_t>(stages.arena_nodes * stages.told));
    std::vector<Matrix<Lanes, D>> gradients(static_cast<std::size_t>(simulation.particles().most_chunks_of_a_run()));
    Motion motion;
    double worst = 0;
    for (Run const& run : simulation.particles().runs()) {
      Batch<D> const batch =
          simulation.particles().batch(run, h, simulation.grid().particle_block(static_cast<std::size_t>(run.block)));
      for (int node = 0; node < stages.arena_nodes; ++node) {
        Point<D> x;
        for (int d = D - 1, rest = node; d >= 0; --d, rest /= scheme.arena_edge)
          x[d] = h * (batch.first[static_cast<std::size_t>(d)] + rest % scheme.arena_edge);
        // both velocities of a node: in the plane they share a vector
        for (int k = 0; k < 2; ++k)
          for (int d = 0; d < D; ++d)
            arena[static_cast<std::size_t>(node * stages.told + k % stages.told)].set(second_component<D> * k + d,
                                                                                      flow(x)[d]);
      }
      constexpr double dt = 0.125;
      if (scheme.remaps)
        stages.gather_again(batch, arena.data(), dt, gradients.data(), motion);
      else
        stages.gather(batch, arena.data(), dt, gradients.data(), motion);
      for (int p = 0; p < run.particles; ++p)
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j)
            worst = std::max(
                worst, std::abs(gradients[static_cast<std::size_t>(p / lanes)](i, j)[p % lanes] / dt - flow.A(i, j)));
    }
    BOOST_TEST(worst < round_off / h);
  });
}

BOOST_AUTO_TEST_CASE(colliding_blocks_keep_mass_and_momentum) {
  for_each_scheme([]<int D>(Scheme<D> const& scheme) {
    auto scene = scheme.scene();
    // The linear kernel drops momentum at nodes with less than its least mass: its bodies fill a space that repeats.
    bool const filled = scheme.has_mass_floor;
    if (filled) scene.periods.fill(2);
    Simulation<D> simulation(std::move(scene));
    Point<D> const size = Point<D>::Constant(2 * block_edge * h);
    auto seeds = filled ? block<D>(Point<D>::Zero(), size, h, 2, density, 0.2, 5) : colliding<D>();
    if (filled)
      for (auto& seed : seeds) seed.v[0] = 0.2 + 0.1 * std::sin(2 * std::numbers::pi * seed.x[1] / size[1]);
    fill(simulation, seeds);
    auto const mass = column(simulation, "mass");
    BOOST_TEST(momentum_error(simulation) < 1e-13);
    BOOST_TEST(column(simulation, "mass") == mass, boost::test_tools::per_element());
    BOOST_TEST(simulation.motion().gradient > 1e-3);  // 1/s: the bodies are at work; PIC smooths most away
  });
}

BOOST_AUTO_TEST_CASE(momentum_changes_by_what_gravity_and_walls_give) {
  for_each_scheme([]<int D>(Scheme<D> const& scheme) {
    if (!scheme.has_mass_floor) {
      auto scene = scheme.scene();
      scene.gravity = Point<D>::Constant(-5);
      wall::HalfSpace::Parameters floor, back;
      floor.normal = {0, 1, 0};
      back.normal = {1, 0.5, 0};
      scene.walls.push_back(make_wall<D, wall::HalfSpace, wall::Stick, wall::Fixed>("floor", floor, {}, {}));
      scene.walls.push_back(
          make_wall<D, wall::HalfSpace, wall::Coulomb, wall::Translation>("back", back, {}, {{0.5, 0, 0}, 0, 1}));
      Simulation<D> simulation(std::move(scene));
      fill(simulation, colliding<D>());
      BOOST_TEST(momentum_error(simulation) < 1e-13);
      BOOST_TEST(simulation.momentum().walls[0].norm() > 0);
      BOOST_TEST(simulation.momentum().walls[1].norm() > 0);
    }
  });
}

// Symplectic Euler: v += dt g, then x += dt v, so x = x_0 + v_0 t + g sum dt_n t_(n+1).
BOOST_AUTO_TEST_CASE(a_block_falls_as_the_step_has_it_and_lands_on_the_end) {
  for_each_scheme([]<int D>(Scheme<D> const& scheme) {
    constexpr double end = 0.123456789;
    auto scene = scheme.scene();
    Point<D> const g = Point<D>::Constant(-7), v_0 = Flow<D>().c;
    scene.gravity = g;
    Simulation<D> simulation(std::move(scene));
    auto seeds = cloud<D>(3);
    for (auto& seed : seeds) seed.v = v_0;
    fill(simulation, seeds);
    double sum = 0;
    while (simulation.time() < end) {
      simulation.advance(end);
      sum += simulation.last_step().dt * simulation.time();
    }
    BOOST_TEST(simulation.time() == end);
    BOOST_TEST(simulation.last_step().limiter == "end");
    BOOST_TEST(simulation.step_count() > 5);
    auto const x = vectors(simulation, "position"), v = vectors(simulation, "velocity");
    double worst = 0;
    for (std::size_t p = 0; p < seeds.size(); ++p)
      worst = std::max({worst, (x[p] - seeds[p].x - v_0 * end - g * sum).norm(), (v[p] - v_0 - g * end).norm()});
    BOOST_TEST(worst < round_off);
  });
}

// A wave of velocity sin kx on four particles a cell, without force. PIC filters it by the kernel's second moment:
// 1 - lambda = (p + 1)/12 (kh)^2, and with p = 1, whose moment depends on the place, by (1 + 1/(2 n^2)) of that for n
// particles a cell. The affine transfers pass linear fields, so what is lost is of fourth order; its coefficients were
// computed with a one-dimensional transfer of its own, which sums over particles and nodes with the kernels' formulas.
BOOST_AUTO_TEST_CASE(a_wave_loses_in_a_step_what_its_transfer_takes) {
  constexpr int N = 64;
  double const kh = 2 * std::numbers::pi / N, second = kh * kh, fourth = second * second;
  auto const share = boost::test_tools::tolerance(0.02);
  using namespace kernel;
  BOOST_TEST((loss<Linear, transfer::Pic>(N, {})) == 2.0 / 12 * (1 + 1.0 / 32) * second, share);
  BOOST_TEST((loss<Quadratic, transfer::Pic>(N, {})) == 3.0 / 12 * second, share);
  BOOST_TEST((loss<Cubic, transfer::Pic>(N, {})) == 4.0 / 12 * second, share);
  BOOST_TEST((loss<Quadratic, transfer::Flip>(N, {0.95})) == 0.05 * 3.0 / 12 * second, share);
  BOOST_TEST((loss<Quadratic, transfer::Apic>(N, {})) == 0.0237 * fourth, share);
  BOOST_TEST((loss<Cubic, transfer::Apic>(N, {})) == 0.0468 * fourth, share);
  BOOST_TEST((loss<Quadratic, transfer::Aflip>(N, {0.95})) == 0.00119 * fourth, share);
  BOOST_TEST((loss<Cubic, transfer::Aflip>(N, {0.95})) == 0.00237 * fourth, share);
}

BOOST_AUTO_TEST_CASE(without_force_flip_leaves_particles_their_velocity) {
  // v + (v_pic - v_pic) in another order: a unit in the last place of v_pic, which is at most 1.
  BOOST_TEST(std::abs(loss<kernel::Linear, transfer::Flip>(64, {1})) < 1e-15);
  BOOST_TEST(std::abs(loss<kernel::Quadratic, transfer::Flip>(64, {1})) < 1e-15);
  BOOST_TEST(std::abs(loss<kernel::Cubic, transfer::Flip>(64, {1})) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
