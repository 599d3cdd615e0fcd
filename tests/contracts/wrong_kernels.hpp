#pragma once
/// Kernels with a defect each: the concept or the contracts must see it.

#include <array>
#include <string_view>

#include "core/kernel.hpp"
#include "models/kernels/cubic.hpp"
#include "models/kernels/quadratic.hpp"

namespace talus::wrong_kernels {

// What the concept must refuse.
struct WithoutSlopes : kernel::Quadratic {
  template <Scalar T>
  static void slopes(T f, std::array<T, width>& g) = delete;
};
struct TooWide : kernel::Quadratic {
  static constexpr int width = 4;
};
struct WithoutBase : kernel::Quadratic {
  static constexpr std::string_view base_shift = "1/2";
};
struct OnlyForNumbers : kernel::Quadratic {
  static void weights(double f, std::array<double, width>& w) { Quadratic::weights(f, w); }
};
struct WithoutParameters : kernel::Quadratic {
  using Parameters = int;
};
static_assert(!Kernel<WithoutSlopes> && !Kernel<TooWide> && !Kernel<WithoutBase> && !Kernel<OnlyForNumbers> &&
              !Kernel<WithoutParameters> && !Kernel<int>);

// What the concept cannot see, and the contracts must.
struct BaseOffByOne : kernel::Quadratic {
  static constexpr double base_shift = 1.5;
};
struct Truncated : kernel::Cubic {
  template <Scalar T>
  static void weights(T f, std::array<T, width>& w) {
    Cubic::weights(f, w);
    w[3] = T(0.0);
  }
};
struct SlopeWithoutSign : kernel::Quadratic {
  template <Scalar T>
  static void slopes(T f, std::array<T, width>& g) {
    Quadratic::slopes(f, g);
    for (T& slope : g) slope = abs(slope);
  }
};
struct SlopeReversed : kernel::Cubic {
  template <Scalar T>
  static void slopes(T f, std::array<T, width>& g) {
    Cubic::slopes(f, g);
    for (T& slope : g) slope = -slope;
  }
};
struct InertiaOfCubic : kernel::Quadratic {
  static constexpr double inertia = 1.0 / 3.0;
};
struct Mirrored : kernel::Quadratic {
  template <Scalar T>
  static void weights(T f, std::array<T, width>& w) {
    Quadratic::weights(T(T(2.0) - f), w);
  }
};
static_assert(Kernel<BaseOffByOne> && Kernel<Truncated> && Kernel<SlopeWithoutSign> && Kernel<SlopeReversed> &&
              Kernel<InertiaOfCubic> && Kernel<Mirrored>);

}  // namespace talus::wrong_kernels
