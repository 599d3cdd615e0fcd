#include "verification/reference/hencky_column.hpp"

#include <gsl/gsl_sf_lambert.h>

namespace talus::reference {

double HenckyColumn::log_stretch(double X) const {
  return -gsl_sf_lambert_W0(density * gravity * (height - X) / modulus);
}

double HenckyColumn::place(double X) const {
  auto const from_top = [this](double at) {
    double const W = -log_stretch(at);
    return W + W * W / 2;
  };
  return modulus / (density * gravity) * (from_top(0) - from_top(X));
}

}  // namespace talus::reference
