#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/errors.hpp"
#include "core/tensor.hpp"

namespace talus::wall {

/// A wall that moves at one velocity for a while: a gate that is drawn, a piston.
///
///   offset(t) = velocity min(max(t - start, 0), end - start)           (1)
///
/// velocity(t) is `velocity` for start <= t <= end, else 0.
struct Translation {
  static constexpr std::string_view name = "translation", title = "Constant velocity for a while";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  struct Parameters {
    Coordinates velocity{0, 0, 0};
    double start = 0, end = 1e9;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::velocity, "velocity", "w", "m/s", "velocity of the wall").per_axis().required(),
          parameter(&Parameters::start, "start", "t_0", "s", "when the wall begins to move"),
          parameter(&Parameters::end, "end", "t_1", "s", "when it stops; by default after any run")};
    }
    static std::optional<std::string> check(Parameters const& p) {
      if (!(p.start <= p.end)) return "the wall must not stop before it starts";
      return std::nullopt;
    }
  };

  template <int D>
  class In {
   public:
    /// Throws InputError where the end precedes the start or a coordinate is not finite.
    explicit In(Parameters const& p) : velocity_(to_point<D>(p.velocity)), start_(p.start), end_(p.end) {
      if (auto const wrong = Parameters::check(p)) throw InputError("translation: " + *wrong);
    }
    /// From the place in the document [m].
    [[nodiscard]] Point<D> offset(double t) const {
      return velocity_ * std::clamp(t - start_, 0.0, end_ - start_);  // (1)
    }
    /// [m/s]
    [[nodiscard]] Point<D> velocity(double t) const {
      return start_ <= t && t <= end_ ? velocity_ : Point<D>(Point<D>::Zero());
    }

   private:
    Point<D> velocity_;
    double start_, end_;
  };
};

}  // namespace talus::wall
