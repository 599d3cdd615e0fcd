#pragma once
/// Weights of the nodes about a particle, on one axis.
///
/// Each spline says how many nodes see a particle (`width`), how far the first of them lies behind it at least
/// (`behind`, in cells), its moment D_p/h^2 (`inertia`), and what weight and slope (per cell) each of its nodes has at
/// t in [0, 1), the place of the particle between one change of stencil and the next.
/// Source: uniform B-splines, segment by segment: de Boor (1978), A Practical Guide to Splines, ch. IX (not re-read).

namespace talus::naive {

/// Quadratic B-spline: C1, three nodes an axis.
struct Quadratic {
  static constexpr int width = 3;
  static constexpr double behind = 0.5, inertia = 1.0 / 4;

  static void evaluate(double t, double* weight, double* slope) {
    weight[0] = 0.5 * (1 - t) * (1 - t);
    weight[1] = 0.5 + t * (1 - t);
    weight[2] = 0.5 * t * t;
    slope[0] = t - 1;
    slope[1] = 1 - 2 * t;
    slope[2] = t;
  }
};

/// Cubic B-spline: C2, four nodes an axis.
struct Cubic {
  static constexpr int width = 4;
  static constexpr double behind = 1, inertia = 1.0 / 3;

  static void evaluate(double t, double* weight, double* slope) {
    double const t2 = t * t, t3 = t2 * t, s = 1 - t;
    weight[0] = s * s * s / 6;
    weight[1] = (4 - 6 * t2 + 3 * t3) / 6;
    weight[2] = (1 + 3 * t + 3 * t2 - 3 * t3) / 6;
    weight[3] = t3 / 6;
    slope[0] = -0.5 * s * s;
    slope[1] = 1.5 * t2 - 2 * t;
    slope[2] = 0.5 + t - 1.5 * t2;
    slope[3] = 0.5 * t2;
  }
};

}  // namespace talus::naive
