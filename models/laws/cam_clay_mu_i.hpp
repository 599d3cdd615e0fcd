#pragma once

#include <string_view>

#include "models/laws/parts/modified_cam_clay.hpp"

namespace talus::law {

/// The mu(I) rheology on the Cam-Clay ellipse, as published: volume first, then shear.
struct CamClayMuI : ModifiedCamClay<ExponentialHardening, MuI> {
  static constexpr std::string_view name = "cam_clay_mu_i_two_stage",
                                    title = "Critical-state mu(I) rheology, two-stage map, exponential hardening",
                                    source = "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643";
  using ModifiedCamClay::ModifiedCamClay;
};
/// The same with hardening by the hyperbolic sine.
struct CamClayMuISinh : ModifiedCamClay<HyperbolicSineHardening, MuI> {
  static constexpr std::string_view name = "cam_clay_mu_i_two_stage_sinh",
                                    title = "Critical-state mu(I) rheology, two-stage map, hyperbolic-sine hardening",
                                    source =
                                        "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; hardening: Gaume "
                                        "et al. (2018), doi:10.1038/s41467-018-05181-w";
  using ModifiedCamClay::ModifiedCamClay;
};
/// The same with exponential hardening that follows each step.
struct CamClayMuIExplicit : ModifiedCamClay<Explicit<ExponentialHardening>, MuI> {
  static constexpr std::string_view name = "cam_clay_mu_i_two_stage_explicit",
                                    title =
                                        "Critical-state mu(I) rheology, two-stage map, exponential hardening after "
                                        "each step",
                                    source = "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643";
  using ModifiedCamClay::ModifiedCamClay;
};
/// The same with hardening by the hyperbolic sine that follows each step.
struct CamClayMuISinhExplicit : ModifiedCamClay<Explicit<HyperbolicSineHardening>, MuI> {
  static constexpr std::string_view name = "cam_clay_mu_i_two_stage_sinh_explicit",
                                    title =
                                        "Critical-state mu(I) rheology, two-stage map, hyperbolic-sine hardening "
                                        "after each step",
                                    source =
                                        "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; hardening: Gaume "
                                        "et al. (2018), doi:10.1038/s41467-018-05181-w";
  using ModifiedCamClay::ModifiedCamClay;
};
static_assert(Law<CamClayMuI> && Law<CamClayMuISinh> && Law<CamClayMuIExplicit> && Law<CamClayMuISinhExplicit>);

}  // namespace talus::law
