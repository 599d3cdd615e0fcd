#pragma once

#include <string_view>

#include "models/laws/parts/cone.hpp"
#include "models/laws/parts/rate_independent.hpp"

namespace talus::law {

using ConeRateIndependent = RateIndependent<ConeSlope>;

/// A cohesion that shear destroys.
struct DruckerPragerSoftening : Cone<SofteningCohesion, OpenGap, ConeRateIndependent> {
  static constexpr std::string_view name = "drucker_prager_softening",
                                    title = "Drucker–Prager with a cohesion that softens in shear",
                                    source = "Drucker & Prager (1952), doi:10.1090/qam/48291";
  using Cone::Cone;
};
/// Gaps close before load is borne.
struct DruckerPragerVolumeCorrected : Cone<ConstantCohesion, ClosingGap, ConeRateIndependent> {
  static constexpr std::string_view name = "drucker_prager_volume_corrected",
                                    title = "Drucker–Prager whose gaps close before they bear load",
                                    source = "Tampubolon et al. (2017), doi:10.1145/3072959.3073651";
  using Cone::Cone;
};
/// Both.
struct DruckerPragerSofteningVolumeCorrected : Cone<SofteningCohesion, ClosingGap, ConeRateIndependent> {
  static constexpr std::string_view
      name = "drucker_prager_softening_volume_corrected",
      title = "Drucker–Prager with a cohesion that softens in shear, whose gaps close before they bear load",
      source = "Tampubolon et al. (2017), doi:10.1145/3072959.3073651";
  using Cone::Cone;
};
static_assert(Law<DruckerPragerSoftening> && Law<DruckerPragerVolumeCorrected> &&
              Law<DruckerPragerSofteningVolumeCorrected>);

}  // namespace talus::law
