#pragma once
/// What an integrator is: the order of the stages of a step.
///
/// All are symplectic Euler: velocities step with the stress of the old positions, positions with the new velocities.
/// With velocities understood at half steps this is the leapfrog, of order 2; understood at whole steps, of order 1.

#include <concepts>
#include <string_view>

#include "core/config/parameters.hpp"

namespace talus {

/// remaps: the moved particles are mapped to the nodes once more, and the velocity gradient is taken from there.
template <class I>
concept Integrator = Described<typename I::Parameters> && requires {
  { I::name } -> std::convertible_to<std::string_view>;
  { I::title } -> std::convertible_to<std::string_view>;
  { I::source } -> std::convertible_to<std::string_view>;
  { I::remaps } -> std::convertible_to<bool>;
};

}  // namespace talus
