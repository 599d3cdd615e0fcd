#pragma once
/// What a transfer is: which velocity a particle shows the nodes, and how it takes theirs over.
///
///   to the nodes    v_p + C_p (x_i - x_p)   affine, or v_p alone                              (1)
///   from the nodes  v_p <- alpha (v_p + sum_i w_ip (v_i - v_i^old)) + (1 - alpha) v_pic       (2)
///
/// with v_pic = sum_i w_ip v_i. Particles move with v_pic whatever alpha is. (1) is the mode, (2) the blend: their four
/// corners are PIC, FLIP, APIC and AFLIP.

#include <concepts>
#include <cstddef>
#include <string_view>

#include "core/config/parameters.hpp"
#include "core/fields.hpp"

namespace talus {

/// A transfer states its mode (affine, and the fields that it keeps of a particle for that) and its blend: incremental
/// where the velocity of the nodes before the step is needed, alpha [1] in [0, 1], 0 where it is not.
template <class T>
concept Transfer = Described<typename T::Parameters> && std::constructible_from<T, typename T::Parameters const&> &&
    requires(T const transfer) {
  { T::name } -> std::convertible_to<std::string_view>;
  { T::title } -> std::convertible_to<std::string_view>;
  { T::source } -> std::convertible_to<std::string_view>;
  { T::affine } -> std::convertible_to<bool>;
  { T::incremental } -> std::convertible_to<bool>;
  { T::State::count } -> std::convertible_to<std::size_t>;
  { transfer.alpha } -> std::convertible_to<double>;
};

}  // namespace talus
