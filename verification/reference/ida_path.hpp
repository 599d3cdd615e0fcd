#pragma once

#include <vector>

#include "verification/reference/path.hpp"

namespace talus::reference {

/// The entry l(row, column) of the velocity gradient is unknown: it is such that the stress component of the same place
/// changes at `stress_rate` [Pa/s] from its value at the start of the segment (0: it is held).
struct HeldStress {
  int row, column;
  double stress_rate;
};

/// A velocity gradient l [1/s], of which some entries are replaced by stresses, for a duration [s].
struct MixedSegment {
  double duration;
  Matrix l;
  std::vector<HeldStress> held;
};
using MixedPath = std::vector<MixedSegment>;

/// As cvode_path, under mixed control. The system in y (7 coordinates) and the unknown rates r is of index 1, as the
/// stress is differentiated:
///
///   0 = y' - f(y, l(r)),   0 = tau_k'(y, y') - stress_rate_k                                                      (1)
///
/// solved by IDA; IDACalcIC finds r and y' at the start of every phase. Whether a segment starts elastic or plastic is
/// judged with the r of an elastic response.
///
/// Throws std::runtime_error with SUNDIALS' message where it gives up.
/// Source: Hindmarsh et al. (2005), doi:10.1145/1089014.1089020.
[[nodiscard]] std::vector<Row> ida_path(RateLaw const&, State const& start, MixedPath const&,
                                        std::vector<double> const& times);

/// Simple shear l_xy [1/s] without strain along x and z, tau_yy held.
[[nodiscard]] MixedPath direct_shear(double shear_rate, double duration);
/// Compression along y at the rate `rate` [1/s] > 0, tau_xx and tau_zz held. Pre: normals = 3.
[[nodiscard]] MixedPath triaxial_compression(double rate, double duration);
/// Compression along y without strain along x and z.
[[nodiscard]] MixedPath oedometer(double rate, double duration);
/// Simple shear l_xy at constant volume.
[[nodiscard]] MixedPath undrained_shear(double shear_rate, double duration);
/// Compression at the rate -tr D = `rate`, the same along all `normals` axes.
[[nodiscard]] MixedPath isotropic_path(double rate, int normals, double duration);

}  // namespace talus::reference
