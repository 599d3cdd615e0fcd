#pragma once
/// Elastic scenes of every kernel, transfer and integrator, clouds and flows to fill them with, and their momentum.

#include <boost/test/unit_test.hpp>
#include <limits>
#include <type_traits>
#include <vector>

#include "models/catalogue.hpp"
#include "tests/support/scenes.hpp"

namespace talus::support {

inline constexpr double h = 0.1, density = 1000, forever = std::numeric_limits<double>::infinity();
inline law::Hencky::Parameters const soft{1e5, 0.3};

template <int D>
using KinematicsOf = std::conditional_t<D == 2, kinematics::PlaneStrain, kinematics::Solid>;

template <int D, class K, class T, class I>
Scene<D> elastic_scene(typename T::Parameters const& transfer = {}) {
  return support::scene_of<KinematicsOf<D>, law::Hencky, K, T, I>(h, density, soft, transfer);
}

/// A kernel, a transfer and an integrator that fit together, by what tests ask of them.
template <int D>
struct Scheme {
  bool affine;          ///< the transfer
  bool remaps;          ///< the integrator
  bool has_mass_floor;  ///< the kernel
  int arena_edge;       ///< nodes along an edge of a block's arena
  Scene<D> (*scene)();  ///< an elastic one
};

template <int D, class K, class T, class I>
Scheme<D> scheme_of() {
  return {T::affine, I::remaps, K::mass_floor > 0, arena_edge<K>, [] { return elastic_scene<D, K, T, I>(); }};
}

/// Calls f(scheme) for all that there are in two and three dimensions.
template <class F>
void for_each_scheme(F const& f) {
  for_each_type(catalogue::Kernels{}, [&]<class K>(std::type_identity<K>) {
    for_each_type(catalogue::Transfers{}, [&]<class T>(std::type_identity<T>) {
      for_each_type(catalogue::Integrators{}, [&]<class I>(std::type_identity<I>) {
        if constexpr (fit_together<K, T>) BOOST_TEST_CONTEXT(K::name << ", " << T::name << ", " << I::name) {
            f(scheme_of<2, K, T, I>());
            f(scheme_of<3, K, T, I>());
          }
      });
    });
  });
}

/// v = A x + c with an A that has no symmetry.
template <int D>
struct Flow {
  Eigen::Matrix<double, D, D> A;
  Point<D> c;
  Flow() {
    for (int i = 0; i < D; ++i) {
      c[i] = 0.3 - 0.2 * i;
      for (int j = 0; j < D; ++j) A(i, j) = 0.4 * i - 0.7 * j + 0.1 * (i + 2) * (j + 1) - 0.25;
    }
  }
  [[nodiscard]] Point<D> operator()(Point<D> const& x) const { return A * x + c; }
};

/// A cloud that lies across blocks and both signs of the coordinates.
template <int D>
std::vector<Seed<D>> cloud(int cells) {
  Point<D> const low = Point<D>::Constant(-1.5 * h);
  return support::block<D>(low, low + Point<D>::Constant(cells * h), h, 2, density, 0.45, 11);
}

template <int D>
Point<D> momentum_of(Simulation<D> const& simulation) {
  auto const m = support::column(simulation, "mass");
  auto const v = support::vectors(simulation, "velocity");
  Point<D> sum = Point<D>::Zero();
  for (std::size_t k = 0; k < m.size(); ++k) sum += m[k] * v[k];
  return sum;
}
/// sum m |v|: what round-off is measured by.
template <int D>
double scale_of(Simulation<D> const& simulation) {
  auto const m = support::column(simulation, "mass");
  auto const v = support::vectors(simulation, "velocity");
  double sum = 0;
  for (std::size_t k = 0; k < m.size(); ++k) sum += m[k] * v[k].norm();
  return sum;
}

}  // namespace talus::support
