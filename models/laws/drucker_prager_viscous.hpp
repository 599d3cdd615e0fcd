#pragma once

#include <string_view>

#include "models/laws/parts/cone.hpp"
#include "models/laws/parts/duvaut_lions.hpp"
#include "models/laws/parts/mu_i.hpp"
#include "models/laws/parts/perzyna.hpp"

namespace talus::law {

/// With Perzyna's overstress.
struct DruckerPragerPerzyna : Cone<ConstantCohesion, OpenGap, Perzyna<ConeSlope>> {
  static constexpr std::string_view
      name = "drucker_prager_perzyna",
      title = "Viscous Drucker–Prager after Perzyna",
      source = "Drucker & Prager (1952), doi:10.1090/qam/48291; Perzyna (1966), doi:10.1016/S0065-2156(08)70009-7";
  using Cone::Cone;
};
/// With the relaxation of Duvaut and Lions.
struct DruckerPragerDuvautLions : Cone<ConstantCohesion, OpenGap, DuvautLions<ConeSlope>> {
  static constexpr std::string_view name = "drucker_prager_duvaut_lions",
                                    title = "Viscous Drucker–Prager after Duvaut and Lions",
                                    source = "Drucker & Prager (1952), doi:10.1090/qam/48291; Duvaut & Lions (1972)";
  using Cone::Cone;
};
/// The mu(I) rheology at constant volume: the law of Jop et al., with elasticity and cohesion.
struct DruckerPragerMuI : Cone<ConstantCohesion, OpenGap, MuI> {
  static constexpr std::string_view name = "drucker_prager_mu_i", title = "mu(I) rheology on the Drucker–Prager cone",
                                    source = "Jop, Forterre & Pouliquen (2006), doi:10.1038/nature04801";
  using Cone::Cone;
};
static_assert(Law<DruckerPragerPerzyna> && Law<DruckerPragerDuvautLions> && Law<DruckerPragerMuI>);

}  // namespace talus::law
