#pragma once

#include <string_view>

#include "models/laws/parts/duvaut_lions.hpp"
#include "models/laws/parts/modified_cam_clay.hpp"
#include "models/laws/parts/perzyna.hpp"

namespace talus::law {

/// Perzyna's overstress in shear alone, after the volume: as the peers have it.
struct CamClayPerzyna : ModifiedCamClay<ExponentialHardening, Perzyna<CriticalSlope>> {
  static constexpr std::string_view name = "cam_clay_perzyna",
                                    title = "Viscous Cam-Clay after Perzyna, two-stage map, exponential hardening",
                                    source = "Perzyna (1966), doi:10.1016/S0065-2156(08)70009-7";
  using ModifiedCamClay::ModifiedCamClay;
};
/// Duvaut and Lions, in volume and shear.
struct CamClayDuvautLions : ModifiedCamClay<ExponentialHardening, DuvautLions<CriticalSlope>> {
  static constexpr std::string_view name = "cam_clay_duvaut_lions",
                                    title = "Viscous Cam-Clay after Duvaut and Lions, exponential hardening",
                                    source =
                                        "Duvaut & Lions (1972); Simo, Kennedy & Govindjee (1988), "
                                        "doi:10.1002/nme.1620261003";
  using ModifiedCamClay::ModifiedCamClay;
};
static_assert(Law<CamClayPerzyna> && Law<CamClayDuvautLions>);

}  // namespace talus::law
