#pragma once

#include <string_view>

#include "models/laws/parts/hardening_flow_map.hpp"
#include "models/laws/parts/modified_cam_clay.hpp"

namespace talus::law {

/// The mu(I) rheology on the Cam-Clay ellipse with the flow rule of published computations: HardeningFlowMap has the
/// difference. All else is as in CamClayMuI.
struct CamClayMuIHardeningFlow : ModifiedCamClay<ExponentialHardening, MuI, TwoStage<HardeningFlowMap>> {
  static constexpr std::string_view name = "cam_clay_mu_i_two_stage_hardening_flow",
                                    title = "Critical-state mu(I) rheology, two-stage map, flow along the hardening",
                                    source =
                                        "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, as computed in 2023";
  using ModifiedCamClay::ModifiedCamClay;
};
static_assert(Law<CamClayMuIHardeningFlow>);

}  // namespace talus::law
