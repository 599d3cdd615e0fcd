#pragma once

#include <string_view>

#include "models/laws/parts/modified_cam_clay.hpp"

namespace talus::law {

using CamClayRateIndependent = RateIndependent<CriticalSlope>;

/// Rate-independent, without hardening.
struct CamClayPerfect : ModifiedCamClay<NoHardening, CamClayRateIndependent> {
  static constexpr std::string_view name = "cam_clay_perfect", title = "Modified Cam-Clay, perfectly plastic",
                                    source = "Roscoe & Burland (1968)";
  using ModifiedCamClay::ModifiedCamClay;
};
/// Rate-independent, exponential hardening.
struct CamClay : ModifiedCamClay<ExponentialHardening, CamClayRateIndependent> {
  static constexpr std::string_view name = "cam_clay", title = "Modified Cam-Clay, exponential hardening",
                                    source =
                                        "Roscoe & Burland (1968); Blatny, Gray & Gaume (2024), "
                                        "doi:10.1017/jfm.2024.643";
  using ModifiedCamClay::ModifiedCamClay;
};
/// Rate-independent, hardening by the hyperbolic sine.
struct CamClaySinh : ModifiedCamClay<HyperbolicSineHardening, CamClayRateIndependent> {
  static constexpr std::string_view name = "cam_clay_sinh", title = "Modified Cam-Clay, hyperbolic-sine hardening",
                                    source = "Gaume et al. (2018), doi:10.1038/s41467-018-05181-w";
  using ModifiedCamClay::ModifiedCamClay;
};
/// Exponential hardening that follows each step.
struct CamClayExplicit : ModifiedCamClay<Explicit<ExponentialHardening>, CamClayRateIndependent> {
  static constexpr std::string_view name = "cam_clay_explicit",
                                    title = "Modified Cam-Clay, exponential hardening after each step",
                                    source =
                                        "Roscoe & Burland (1968); Blatny, Gray & Gaume (2024), "
                                        "doi:10.1017/jfm.2024.643";
  using ModifiedCamClay::ModifiedCamClay;
};
/// Hardening by the hyperbolic sine that follows each step.
struct CamClaySinhExplicit : ModifiedCamClay<Explicit<HyperbolicSineHardening>, CamClayRateIndependent> {
  static constexpr std::string_view name = "cam_clay_sinh_explicit",
                                    title = "Modified Cam-Clay, hyperbolic-sine hardening after each step",
                                    source = "Gaume et al. (2018), doi:10.1038/s41467-018-05181-w";
  using ModifiedCamClay::ModifiedCamClay;
};
static_assert(Law<CamClayPerfect> && Law<CamClay> && Law<CamClaySinh> && Law<CamClayExplicit> &&
              Law<CamClaySinhExplicit>);

}  // namespace talus::law
