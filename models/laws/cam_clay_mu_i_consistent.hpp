#pragma once

#include <string_view>

#include "models/laws/parts/modified_cam_clay.hpp"

namespace talus::law {

/// The mu(I) rheology on the Cam-Clay ellipse, volume and shear in one solve: its transients converge with dt.
struct CamClayMuIConsistent : ModifiedCamClay<ExponentialHardening, MuI, Consistent> {
  static constexpr std::string_view name = "cam_clay_mu_i_consistent",
                                    title = "Critical-state mu(I) rheology, coupled map, exponential hardening",
                                    source =
                                        "after Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; the coupled map "
                                        "is derived here";
  using ModifiedCamClay::ModifiedCamClay;
};
/// The same with hardening by the hyperbolic sine.
struct CamClayMuIConsistentSinh : ModifiedCamClay<HyperbolicSineHardening, MuI, Consistent> {
  static constexpr std::string_view
      name = "cam_clay_mu_i_consistent_sinh",
      title = "Critical-state mu(I) rheology, coupled map, hyperbolic-sine hardening",
      source =
          "after Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; hardening: Gaume "
          "et al. (2018), doi:10.1038/s41467-018-05181-w; the coupled map is derived here";
  using ModifiedCamClay::ModifiedCamClay;
};
static_assert(Law<CamClayMuIConsistent> && Law<CamClayMuIConsistentSinh>);

}  // namespace talus::law
