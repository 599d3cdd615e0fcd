#pragma once
/// The fields that several laws keep or derive.

#include <string_view>

#include "core/fields.hpp"

namespace talus::field {

inline constexpr struct PlasticVolumetricStrain : ScalarField {
  static constexpr std::string_view name = "plastic_volumetric_strain", symbol = "eps_V^P", unit = "1",
                                    meaning = "plastic part of ln J, positive in dilation";
} plastic_volumetric_strain;

inline constexpr struct PlasticShearStrain : ScalarField {
  static constexpr std::string_view name = "plastic_shear_strain", symbol = "eps_dev^P", unit = "1",
                                    meaning = "norm of the plastic deviatoric strain, summed over the steps";
} plastic_shear_strain;

inline constexpr struct CompressiveStrength : ScalarField {
  static constexpr std::string_view name = "compressive_strength", symbol = "p_c", unit = "Pa",
                                    meaning = "pressure of isotropic yield";
} compressive_strength;

inline constexpr struct Friction : ScalarField {
  static constexpr std::string_view name = "friction", symbol = "mu", unit = "1",
                                    meaning = "friction coefficient of the material";
} friction;

inline constexpr struct ShearRate : ScalarField {
  static constexpr std::string_view name = "shear_rate", symbol = "gamma_S", unit = "1/s",
                                    meaning = "plastic shear rate sqrt(2 D' : D'), |du/dy| in simple shear";
} shear_rate;

inline constexpr struct InertialNumber : ScalarField {
  static constexpr std::string_view name = "inertial_number", symbol = "I", unit = "1",
                                    meaning =
                                        "d gamma_S sqrt(rho_s / (p + beta p_c)): shear rate over the rate of "
                                        "rearrangement of grains";
} inertial_number;

}  // namespace talus::field
