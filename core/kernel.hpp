#pragma once
/// What a kernel is: the weight with which a particle sees the nodes around it, along one axis.
///
/// In D dimensions the weight is the product over the axes. With xi = x/h (h: node spacing) the particle sees the nodes
/// base, ..., base + width - 1, where base = floor(xi - base_shift); f = xi - base is all that weights and slopes need.

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>

#include "core/config/parameters.hpp"
#include "core/scalar.hpp"

namespace talus {

namespace detail {
template <class K, class T>
concept WeighsWith = requires(T f, std::array<T, static_cast<std::size_t>(K::width)>& values) {
  { K::weights(f, values) } -> std::same_as<void>;
  { K::slopes(f, values) } -> std::same_as<void>;
};
}  // namespace detail

/// A kernel says what it is (name, title, source, degree, width), how it places its nodes (base_shift), and gives for
/// numbers and packs alike the weights N_i [1] and their slopes dN_i/dxi [1] (the gradient is slopes / h).
///
/// inertia [1]: D_p = inertia h^2 I is the second moment of the weights that an affine transfer divides by; 0 where it
/// depends on the particle's place and is singular at nodes, so that no affine transfer may use the kernel.
///
/// sharpness [1]: the largest q = sum_i N_i'^2 / max(N_i, mass_floor) over the places in a cell, which bounds the time
/// step by the frequency of a particle with no neighbour. mass_floor [1]: least mass of a node, in masses of a
/// particle, that internal forces accelerate; above 0 only where q would have no bound.
template <class K>
concept Kernel = requires {
  { K::name } -> std::convertible_to<std::string_view>;
  { K::title } -> std::convertible_to<std::string_view>;
  { K::source } -> std::convertible_to<std::string_view>;
  { K::degree } -> std::convertible_to<int>;
  { K::width } -> std::convertible_to<int>;
  { K::base_shift } -> std::convertible_to<double>;
  { K::inertia } -> std::convertible_to<double>;
  { K::sharpness } -> std::convertible_to<double>;
  { K::mass_floor } -> std::convertible_to<double>;
  requires Described<typename K::Parameters>;
  requires K::degree >= 1 && K::width == K::degree + 1;
}
&&detail::WeighsWith<K, double>&& detail::WeighsWith<K, Lanes>;

}  // namespace talus
