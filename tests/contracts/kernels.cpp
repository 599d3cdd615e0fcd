#include <algorithm>
#include <array>
#include <boost/math/special_functions/cardinal_b_spline.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "core/dual.hpp"
#include "core/kernel.hpp"
#include "models/catalogue.hpp"
#include "tests/contracts/wrong_kernels.hpp"

BOOST_AUTO_TEST_SUITE(kernels)

using namespace talus;
using namespace talus::wrong_kernels;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// A kernel at one place: the first node, and weight and slope of the nodes from there.
template <class K>
struct At {
  double xi, f;
  int base;
  std::array<double, static_cast<std::size_t>(K::width)> w{}, g{};

  explicit At(double place) : xi(place), base(static_cast<int>(std::floor(place - K::base_shift))) {
    f = xi - base;
    K::weights(f, w);
    K::slopes(f, g);
  }
  /// Weight of a node that may lie outside the stencil.
  [[nodiscard]] double weight(int node) const { return value(w, node); }
  [[nodiscard]] double slope(int node) const { return value(g, node); }
  /// sum_i v_i (x_i - x_p)^power
  [[nodiscard]] double moment(std::array<double, static_cast<std::size_t>(K::width)> const& v, int power) const {
    double sum = 0;
    for (int k = 0; k < K::width; ++k) sum += v[static_cast<std::size_t>(k)] * std::pow(k - f, power);
    return sum;
  }

 private:
  [[nodiscard]] double value(auto const& values, int node) const {
    int const k = node - base;
    return k < 0 || k >= K::width ? 0 : values[static_cast<std::size_t>(k)];
  }
};

/// Nodes and cell middles with their neighbours among the doubles, places all over some cells, and cells far away.
std::vector<double> places() {
  std::vector<double> all;
  for (int half = -6; half <= 6; ++half) {
    double const x = 0.5 * half;
    for (double const y : {x, std::nextafter(x, -10.0), std::nextafter(x, 10.0), x - 1e-9, x + 1e-9}) all.push_back(y);
  }
  for (int k = 0; k < 4001; ++k) all.push_back(-3 + 6 * k / 4000.0);
  std::size_t const near = all.size();
  for (std::size_t k = 0; k < near; k += 7) all.push_back(1e6 + all[k]);
  return all;
}

/// How far a kernel is, at worst, from each identity that a B-spline of its degree fulfils.
struct Defects {
  double unity = 0, first_moment = 0, inertia = 0, slope_sum = 0, slope_moment = 0, derivative = 0, oracle = 0,
         negative = 0;
  [[nodiscard]] double worst() const {
    return std::max({unity, first_moment, inertia, slope_sum, slope_moment, derivative, oracle, negative});
  }
};

template <class K>
Defects defects() {
  Defects worst;
  auto const raise = [](double& most, double value) { most = std::max(most, std::isnan(value) ? INFINITY : value); };
  for (double const place : places()) {
    At<K> const at(place);
    raise(worst.unity, std::abs(at.moment(at.w, 0) - 1));
    raise(worst.first_moment, std::abs(at.moment(at.w, 1)));
    if (K::degree >= 2) raise(worst.inertia, std::abs(at.moment(at.w, 2) - K::inertia));
    raise(worst.slope_sum, std::abs(at.moment(at.g, 0)));
    raise(worst.slope_moment, std::abs(at.moment(at.g, 1) - 1));
    std::array<Dual<1>, static_cast<std::size_t>(K::width)> dual;
    K::weights(Dual<1>::variable(at.f, 0), dual);
    for (std::size_t k = 0; k < dual.size(); ++k) {
      raise(worst.derivative, std::abs(dual[k].derivative(0) - at.g[k]));
      raise(worst.negative, -at.w[k]);
    }
    for (int node = at.base - 2; node < at.base + K::width + 2; ++node) {
      double const exact = boost::math::cardinal_b_spline<static_cast<unsigned>(K::degree)>(at.xi - node);
      raise(worst.oracle, std::abs(at.weight(node) - exact));
    }
  }
  return worst;
}

/// Calls f(a kernel) for every kernel of the catalogue.
template <class F>
void for_each_kernel(F f) {
  for_each_type(catalogue::Kernels{}, [&](auto type) {
    using K = typename decltype(type)::type;
    BOOST_TEST_CONTEXT("kernel " << K::name) {
      f(K{});
    }
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_kernel_of_the_catalogue_fulfils_the_concept) {
  for_each_kernel([]<class K>(K) {
    static_assert(Kernel<K>);
    BOOST_TEST(!K::name.empty());
    BOOST_TEST(!K::source.empty());
  });
}

BOOST_AUTO_TEST_CASE(weights_are_a_partition_of_unity) {
  // width rounded terms of at most 3/4: half an ulp of 1 each and of their sum
  for_each_kernel([]<class K>(K) { BOOST_TEST(defects<K>().unity <= 2 * eps); });
}

BOOST_AUTO_TEST_CASE(weights_reproduce_linear_functions) {
  for_each_kernel([]<class K>(K) { BOOST_TEST(defects<K>().first_moment <= 1e-14); });
}

BOOST_AUTO_TEST_CASE(second_moment_is_the_stated_inertia_wherever_the_particle_is) {
  for_each_kernel([]<class K>(K) {
    if constexpr (K::degree >= 2) {
      BOOST_TEST(K::inertia == (K::degree + 1) / 12.0, boost::test_tools::tolerance(eps));
      BOOST_TEST(defects<K>().inertia <= 1e-14);
    } else {
      BOOST_TEST(K::inertia == 0);
      At<K> const node(2.0), middle(2.5);  // f (1 - f): singular at nodes
      BOOST_TEST(node.moment(node.w, 2) == 0);
      BOOST_TEST(middle.moment(middle.w, 2) == 0.25);
    }
  });
}

BOOST_AUTO_TEST_CASE(slopes_sum_to_zero_and_give_the_slope_of_a_line) {
  for_each_kernel([]<class K>(K) {
    BOOST_TEST(defects<K>().slope_sum <= 1e-14);
    BOOST_TEST(defects<K>().slope_moment <= 1e-14);
  });
}

BOOST_AUTO_TEST_CASE(slopes_are_the_derivative_of_the_weights) {
  for_each_kernel([]<class K>(K) { BOOST_TEST(defects<K>().derivative <= 1e-14); });
}

BOOST_AUTO_TEST_CASE(weights_are_those_of_the_cardinal_b_spline_and_vanish_outside_the_stencil) {
  for_each_kernel([]<class K>(K) { BOOST_TEST(defects<K>().oracle <= 1e-13); });
}

BOOST_AUTO_TEST_CASE(no_weight_is_negative_but_for_the_rounding_of_the_base) {
  // floor(xi - 1) may round up by an ulp, 4e-16 here; the cubic weight beyond is then -(4e-16)^3/6
  for_each_kernel([]<class K>(K) { BOOST_TEST(defects<K>().negative <= 1e-45); });
}

BOOST_AUTO_TEST_CASE(second_moment_of_a_product_of_kernels_is_isotropic) {
  for_each_kernel([]<class K>(K) {
    if constexpr (K::degree >= 2) {
      for (double const shift : {0.0, 0.25, 0.5, 0.9}) {
        std::array<At<K>, 3> const at{At<K>(0.3 + shift), At<K>(1.7 + shift), At<K>(-2.2 + shift)};
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) {
            double sum = 0;
            for (int node = 0; node < K::width * K::width * K::width; ++node) {
              std::array<int, 3> const k{node % K::width, node / K::width % K::width, node / K::width / K::width};
              auto const arm = [&](int d) { return k[std::size_t(d)] - at[std::size_t(d)].f; };
              double weight = 1;
              for (std::size_t d = 0; d < 3; ++d) weight *= at[d].w[std::size_t(k[d])];
              sum += weight * arm(i) * arm(j);
            }
            BOOST_TEST(std::abs(sum - (i == j ? K::inertia : 0)) <= 1e-14);
          }
        }
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(weights_and_slopes_are_continuous_where_the_stencil_moves_on) {
  for_each_kernel([]<class K>(K) {
    for (int cell = -3; cell <= 3; ++cell) {
      double const edge = cell + K::base_shift;
      At<K> const left(std::nextafter(edge, -10.0)), right(std::nextafter(edge, 10.0));
      BOOST_TEST(At<K>(edge - 1e-9).base + 1 == At<K>(edge + 1e-9).base);
      for (int node = right.base - 2; node <= right.base + K::width; ++node) {
        BOOST_TEST(std::abs(left.weight(node) - right.weight(node)) <= 16 * eps);  // slope <= 1, 2 ulp of 4 at most
        if (K::degree >= 2) BOOST_TEST(std::abs(left.slope(node) - right.slope(node)) <= 32 * eps);  // curvature <= 2
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(a_pack_gives_the_same_as_its_lanes) {
  for_each_kernel([]<class K>(K) {
    Lanes f;
    for (int lane = 0; lane < lanes; ++lane) f.set(lane, K::base_shift + lane / 8.0 + 0.05);
    std::array<Lanes, static_cast<std::size_t>(K::width)> w, g;
    K::weights(f, w);
    K::slopes(f, g);
    for (int lane = 0; lane < lanes; ++lane) {
      At<K> const at(f[lane]);
      for (std::size_t k = 0; k < w.size(); ++k) {
        BOOST_TEST(std::abs(w[k][lane] - at.w[k]) <= 2 * eps);  // a fused multiply-add may round once less
        BOOST_TEST(std::abs(g[k][lane] - at.g[k]) <= 2 * eps);
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(sharpness_is_the_largest_sum_of_squared_slopes_over_weights) {
  for_each_kernel([]<class K>(K) {
    double most = 0;
    for (int k = 0; k <= 100000; ++k) {
      At<K> const at(K::base_shift + 1e-7 + (1 - 2e-7) * k / 100000.0);
      double q = 0;
      for (std::size_t i = 0; i < at.w.size(); ++i) q += at.g[i] * at.g[i] / std::max(at.w[i], K::mass_floor);
      most = std::max(most, q);
    }
    BOOST_TEST(most <= K::sharpness * (1 + 1e-9));
    BOOST_TEST(most >= K::sharpness * (1 - 1e-4));  // the scan may miss the peak by 1e-5 of a cell
  });
}

BOOST_AUTO_TEST_CASE(planted_defects_are_seen) {
  BOOST_TEST(defects<BaseOffByOne>().oracle > 0.1);
  BOOST_TEST(defects<Truncated>().unity > 0.1);
  BOOST_TEST(defects<SlopeWithoutSign>().slope_sum > 0.1);
  BOOST_TEST(defects<SlopeWithoutSign>().derivative > 0.1);
  BOOST_TEST(defects<SlopeReversed>().slope_moment > 0.1);
  BOOST_TEST(defects<InertiaOfCubic>().inertia > 0.05);
  BOOST_TEST(defects<Mirrored>().first_moment > 0.1);
  BOOST_TEST(defects<Mirrored>().unity <= 1e-14);  // which the partition of unity alone would have missed
  BOOST_TEST(defects<kernel::Cubic>().worst() <= 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
