#pragma once
/// What a kinematics is: the dimension of the motion, and the shape that strain and stress take in it.
///
/// The strain measure is the elastic logarithmic (Hencky) strain in all of them (core/log_strain.hpp).

#include <concepts>
#include <string_view>

#include "core/config/parameters.hpp"
#include "core/tensor.hpp"

namespace talus {

template <class K>
concept Kinematics = Described<typename K::Parameters> && requires {
  { K::name } -> std::convertible_to<std::string_view>;
  { K::title } -> std::convertible_to<std::string_view>;
  { K::source } -> std::convertible_to<std::string_view>;
  requires K::dimension == K::Shape::plane;
  requires K::Shape::normals >= K::dimension;
};

}  // namespace talus
