/// The order of particles after a sort, against a stable sort of all of them by block, material and cell, each block
/// found by itself: after small and large drifts, with axes that repeat, with several materials.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>

#include "core/particles.hpp"

namespace talus {

namespace {

constexpr double h = 0.01, base_shift = 0.5;

/// What a particle is sorted by, where it is then, and its number.
template <int D>
struct Expected {
  std::uint64_t key;
  std::int32_t material;
  int cell;
  std::array<double, D> x;
  double number;
};

/// Particles in random places, of several materials, and what is known of them by number.
template <int D>
class Crowd {
 public:
  Crowd(unsigned seed, int count, int materials, BlockIndex<D> periods)
      : random_(seed), grid_(periods), particles_(layout()) {
    std::vector<Run> runs;
    std::ptrdiff_t chunk = 0;
    for (int m = 0; m < materials; ++m) {
      runs.push_back({0, m, chunk, count / materials});
      chunk += runs.back().chunks();
    }
    particles_.allocate(runs, 1);
    int number = 0;
    particles_.for_each([&](std::ptrdiff_t slot, int) {
      for (int d = 0; d < D; ++d) particles_.move(slot, d, h * uniform(-9, 9));
      particles_.set(slot, particles_.layout().find(field::mass), 100.0 + number);
      particles_.set(slot, particles_.layout().find(field::identity), number++);
    });
  }

  /// Moves every particle by up to so many cells along each axis.
  void drift(double cells) {
    particles_.for_each([&](std::ptrdiff_t slot, int) {
      for (int d = 0; d < D; ++d) particles_.move(slot, d, h * uniform(-cells, cells));
    });
  }

  /// Sorts; compares order, places, masses and empty lanes with what is expected.
  void sort_and_compare() {
    auto const expected = this->expected();
    particles_.sort(grid_, h, base_shift);
    std::size_t k = 0;
    std::size_t wrong = expected.size() == particles_.count() ? 0 : 1;
    for (Run const& run : particles_.runs()) {
      auto const key = grid_.particle_keys().at(static_cast<std::size_t>(run.block));
      for (int lane = 0; lane < run.chunks() * lanes; ++lane) {
        std::ptrdiff_t const slot = run.first_chunk * lanes + lane;
        double const mass = particles_.get(slot, particles_.layout().find(field::mass));
        if (lane >= run.particles) {
          wrong += mass != 0;
          continue;
        }
        Expected<D> const& e = expected.at(k++);
        wrong += e.key != key || e.material != run.material || e.number != double(particles_.identity(slot)) ||
                 mass != 100.0 + e.number;
        for (int d = 0; d < D; ++d)
          wrong += std::abs(particles_.position(slot, d) - e.x[static_cast<std::size_t>(d)]) > 1e-15;
      }
    }
    BOOST_TEST(wrong == 0u);
    BOOST_TEST(k == expected.size());
    for (std::size_t b = 0; b < grid_.particle_blocks(); ++b)
      BOOST_TEST(particles_.first_run(b) < particles_.first_run(b + 1));  // no block without particles
  }

 private:
  static Layout layout() {
    Layout all(D, 3);
    all.unite(Fields<field::Position, field::Velocity, field::Mass, field::Identity>{});
    return all;
  }
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }

  [[nodiscard]] std::vector<Expected<D>> expected() const {
    std::vector<Expected<D>> all;
    particles_.for_each([&](std::ptrdiff_t slot, int material) {
      Expected<D> e{0, material, 0, {}, double(particles_.identity(slot))};
      BlockIndex<D> place{};
      for (int d = 0; d < D; ++d) {
        auto const at = static_cast<std::size_t>(d);
        double const x = particles_.position(slot, d), base = std::floor(x / h - base_shift + 0.5);
        place[at] = static_cast<std::int32_t>(std::floor(base / block_edge));
        e.cell = e.cell * block_edge + (static_cast<int>(base) - block_edge * place[at]);
        int const period = grid_.periods()[at], periods = period == 0 ? 0 : int(std::floor(double(place[at]) / period));
        place[at] -= periods * period;
        e.x[at] = x - periods * period * block_edge * h;
      }
      e.key = key_of<D>(place);
      all.push_back(e);
    });
    std::stable_sort(all.begin(), all.end(), [](auto const& a, auto const& b) {
      return std::tie(a.key, a.material, a.cell) < std::tie(b.key, b.material, b.cell);
    });
    return all;
  }

  std::mt19937_64 random_;
  BlockGrid<D> grid_;
  Particles<D> particles_;
};

template <int D>
void go(BlockIndex<D> periods) {
  unsigned seed = 1;
  for (int const materials : {1, 3})
    for (int const count : {3, 200}) {
      Crowd<D> crowd(seed++, count, materials, periods);
      for (double const cells : {0.0, 0.5, 0.5, 0.0, 3.0, 0.5, 30.0, 0.5}) {
        crowd.drift(cells);
        crowd.sort_and_compare();
      }
    }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(particle_sort)

BOOST_AUTO_TEST_CASE(particles_lie_by_block_material_and_cell_and_else_as_they_were) {
  go<2>({0, 0});
  go<3>({0, 0, 0});
}

BOOST_AUTO_TEST_CASE(an_axis_may_repeat_after_one_block_or_more) {
  for (int const period : {1, 2, 3, 5}) {
    go<2>({period, 0});
    go<2>({2, period});
    go<3>({0, period, 3});
  }
}

BOOST_AUTO_TEST_CASE(a_particle_that_is_nowhere_stops_the_sort_and_nothing_is_lost) {
  for (double const nowhere : {std::nan(""), 1e300, double(4 * farthest_block) * h}) {
    Layout layout(2, 3);
    layout.unite(Fields<field::Position, field::Velocity, field::Mass, field::Identity>{});
    Particles<2> particles(layout);
    BlockGrid<2> grid;
    particles.allocate({Run{0, 0, 0, 20}}, 1);
    particles.for_each(
        [&](std::ptrdiff_t slot, int) { particles.set(slot, layout.find(field::identity), double(slot)); });
    particles.sort(grid, h, base_shift);
    particles.set(7, layout.find(field::position), nowhere);
    BOOST_CHECK_THROW(particles.sort(grid, h, base_shift), RunError);
    particles.set(7, layout.find(field::position), 0.1);
    particles.sort(grid, h, base_shift);
    std::vector<long> numbers;
    particles.for_each([&](std::ptrdiff_t slot, int) { numbers.push_back(particles.identity(slot)); });
    std::sort(numbers.begin(), numbers.end());
    std::vector<long> all(20);
    std::iota(all.begin(), all.end(), 0);
    BOOST_TEST(numbers == all, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_particle_that_creeps_out_of_the_space_that_can_be_addressed_stops_the_sort) {
  Layout layout(2, 3);
  layout.unite(Fields<field::Position, field::Velocity, field::Mass, field::Identity>{});
  Particles<2> particles(layout);
  BlockGrid<2> grid;
  particles.allocate({Run{0, 0, 0, 1}}, 1);
  particles.move(0, 0, 4.0 * (farthest_block - 2) - 0.25);
  particles.sort(grid, 1, base_shift);
  particles.move(0, 0, 0.5);
  BOOST_CHECK_THROW(particles.sort(grid, 1, base_shift), RunError);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace talus
