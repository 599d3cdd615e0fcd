#pragma once
/// Materials and strain paths for the truths of verification/reference.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "verification/reference/path.hpp"

namespace talus::verification {

inline double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

/// Glass beads; strengths in Pa.
inline reference::Elasticity elastic(int normals) {
  return {1e6, 0.3, normals};
}
inline reference::MuI glass() {
  return {tangent(20.9), tangent(32.76), 0.279, 2.5e-3, 2500};
}
inline reference::ExponentialStrength soft() {
  return {100, 50};
}

/// The isotropic state of that pressure [Pa].
inline reference::State under_pressure(reference::Elasticity const& e, double p) {
  reference::Matrix eps = -p / (e.K() * e.normals) * reference::Matrix::Identity();
  if (e.normals == 2) eps(2, 2) = 0;
  return {eps, 0};
}

/// A path of at most 5 ms at rates of the order of 10/s, and the pressure it starts from.
struct StrainPath {
  std::string name;
  int normals;
  double p;
  reference::Path path;
};

/// `isotropic`: the deviatoric part of the isotropic path is that much of it. The viscous laws are not defined at the
/// cap itself, where S = 0.
inline std::vector<StrainPath> strain_paths(double isotropic) {
  using reference::velocity_gradient;
  double const d = 10 * isotropic, t = 5e-3;
  return {
      {"simple shear at constant volume", 2, 60, {{t, velocity_gradient(0, 0, 0, 10), 0}}},
      {"shear and compression", 3, 20, {{t, velocity_gradient(0, -3, 0, 10), 0}}},
      {"isotropic compression", 3, 90, {{t / 5, velocity_gradient(-10 - d, -10, -10 + d, 0), 0}}},
      {"pure shear and extension", 2, 60, {{t, velocity_gradient(5.5, -4.5, 0, 0), 0}}},
      {"triaxial compression", 3, 30, {{t, velocity_gradient(3, -10, 3, 0), 0}}},
      {"shear whose axes turn", 3, 60, {{t, velocity_gradient(5, -5, 0, 0), 200}}},
  };
}

/// Eight times, the last of them the end.
inline std::vector<double> eighths(double duration) {
  std::vector<double> times;
  for (int k = 1; k < 8; ++k) times.push_back(duration * k / 8);
  times.push_back(duration);
  return times;
}

/// The largest difference of stress and strength between two histories, over the largest of p_c, |p| and q.
inline double difference(std::vector<reference::Row> const& a, std::vector<reference::Row> const& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    double const size = std::max({a[k].p_c, std::abs(a[k].p), a[k].q}),
                 gap = (a[k].tau - b[k].tau).cwiseAbs().maxCoeff();
    double const strength = std::abs(a[k].p_c - b[k].p_c);
    if (!(gap < size && strength < size)) return std::numeric_limits<double>::infinity();  // or not a number
    most = std::max({most, gap / size, strength / size});
  }
  return most;
}

}  // namespace talus::verification
