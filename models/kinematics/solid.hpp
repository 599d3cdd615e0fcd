#pragma once

#include <string_view>
#include <tuple>

#include "core/tensor.hpp"

namespace talus::kinematics {

/// Three dimensions: d_s = 3, p = -tr(tau)/3, K = lambda + 2 G/3.
///
/// A slab between two frictionless walls across z moves as plane_strain does.
///
/// Source: de Souza Neto, Perić & Owen (2008), doi:10.1002/9780470694626 (logarithmic strain; not re-read).
struct Solid {
  static constexpr std::string_view name = "solid", title = "Three dimensions",
                                    source = "de Souza Neto, Perić & Owen (2008), doi:10.1002/9780470694626";
  static constexpr int dimension = 3;
  using Shape = shape::Solid;
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
};

}  // namespace talus::kinematics
