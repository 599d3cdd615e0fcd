#pragma once

#include <string_view>

#include "core/law.hpp"
#include "models/laws/parts/elastic.hpp"
#include "models/laws/parts/hencky.hpp"

namespace talus::law {

/// Elastic solid, linear in the logarithmic strain:  tau = lambda tr(eps) I + 2 G eps.
///
/// Source: Hencky (1928), Z. tech. Phys. 9, 215-220; Anand (1979), doi:10.1115/1.3424532.
struct Hencky : Elastic<HenckyElasticity> {
  static constexpr std::string_view name = "hencky", title = "Elastic, linear in the logarithmic strain",
                                    source = "Hencky (1928); Anand (1979), doi:10.1115/1.3424532";
  using Elastic::Elastic;
};
static_assert(Law<Hencky>);

}  // namespace talus::law
