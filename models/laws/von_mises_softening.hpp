#pragma once

#include <string_view>

#include "models/laws/parts/cylinder.hpp"
#include "models/laws/parts/duvaut_lions.hpp"
#include "models/laws/parts/perzyna.hpp"
#include "models/laws/parts/rate_independent.hpp"

namespace talus::law {

/// Rate-independent.
struct VonMisesSoftening : Cylinder<RateIndependent<UnitSlope>> {
  static constexpr std::string_view name = "von_mises_softening",
                                    title = "Von Mises, softening, with a tension cut-off", source = "von Mises (1913)";
  using Cylinder::Cylinder;
};
/// With Perzyna's overstress.
struct VonMisesPerzyna : Cylinder<Perzyna<UnitSlope>> {
  static constexpr std::string_view name = "von_mises_perzyna",
                                    title = "Viscous von Mises after Perzyna, softening, with a tension cut-off",
                                    source = "von Mises (1913); Perzyna (1966), doi:10.1016/S0065-2156(08)70009-7";
  using Cylinder::Cylinder;
};
/// With the relaxation of Duvaut and Lions.
struct VonMisesDuvautLions : Cylinder<DuvautLions<UnitSlope>> {
  static constexpr std::string_view
      name = "von_mises_duvaut_lions",
      title = "Viscous von Mises after Duvaut and Lions, softening, with a tension cut-off",
      source = "von Mises (1913); Duvaut & Lions (1972); Simo, Kennedy & Govindjee (1988), doi:10.1002/nme.1620261003";
  using Cylinder::Cylinder;
};
static_assert(Law<VonMisesSoftening> && Law<VonMisesPerzyna> && Law<VonMisesDuvautLions>);

}  // namespace talus::law
