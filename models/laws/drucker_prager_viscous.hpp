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
/// Perzyna's and mu(I) with gaps that close before the material bears load. Not the relaxation of Duvaut and Lions: it
/// leaves a part of each opening at the tip, which a gap that is given back in every step would count again.
struct DruckerPragerVolumeCorrectedPerzyna : Cone<ConstantCohesion, ClosingGap, Perzyna<ConeSlope>> {
  static constexpr std::string_view
      name = "drucker_prager_volume_corrected_perzyna",
      title = "Viscous Drucker–Prager after Perzyna, volume corrected",
      source =
          "Drucker & Prager (1952), doi:10.1090/qam/48291; Perzyna (1966), doi:10.1016/S0065-2156(08)70009-7; "
          "Tampubolon et al. (2017), doi:10.1145/3072959.3073651";
  using Cone::Cone;
};
struct DruckerPragerVolumeCorrectedMuI : Cone<ConstantCohesion, ClosingGap, MuI> {
  static constexpr std::string_view name = "drucker_prager_volume_corrected_mu_i",
                                    title = "mu(I) rheology on the Drucker–Prager cone, volume corrected",
                                    source =
                                        "Jop, Forterre & Pouliquen (2006), doi:10.1038/nature04801; "
                                        "Tampubolon et al. (2017), doi:10.1145/3072959.3073651";
  using Cone::Cone;
};
static_assert(Law<DruckerPragerVolumeCorrectedPerzyna> && Law<DruckerPragerVolumeCorrectedMuI>);
static_assert(Law<DruckerPragerPerzyna> && Law<DruckerPragerDuvautLions> && Law<DruckerPragerMuI>);

}  // namespace talus::law
