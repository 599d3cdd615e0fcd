#pragma once
/// Trial states of 24 decades, and the tally of what a return map makes of them.

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/roots.hpp"
#include "tests/support/law_states.hpp"

namespace talus::support {

/// States a law: TALUS_HOSTILE_STATES, or 40000.
inline long hostile_states() {
  char const* const asked = std::getenv("TALUS_HOSTILE_STATES");
  return asked == nullptr ? 40000 : std::atol(asked);
}

/// A step to try: trial stress [Pa], plastic volumetric strain before it [1], length [s].
struct Trial {
  double p, q, eps_V, dt;
};

/// What was seen of all states.
struct Tally {
  explicit Tally(std::string_view law) : name(law) {}

  std::string name;
  long tried = 0, plastic = 0, not_finite = 0, outside = 0, off = 0, elsewhere = 0;
  long steep = 0, off_steep = 0;
  double worst = 0, judge = 0, worst_steep = 0;
  int most_iterations = 0;
  Trial worst_at{};
  std::string worst_corner;

  /// `steep`: the strength changes more than a hundredfold over a change of pressure of its own size. The rounding of
  /// the plastic strain that a particle stores is then worth more than 1e-14 of the strength, and near the cap half the
  /// digits of that are left of the shear stress: these states have a bar of their own.
  void error(double e, Trial const& trial, std::string const& corner, bool is_steep = false) {
    if (is_steep) {
      ++steep, worst_steep = std::max(worst_steep, e), off_steep += e <= 1e-10 ? 0 : 1;
      return;
    }
    if (!(e <= worst)) worst = e, worst_at = trial, worst_corner = corner;
    off += e <= 1e-10 ? 0 : 1;
  }
  [[nodiscard]] std::string text() const {
    std::ostringstream line;
    line << name << ": " << tried << " states, " << plastic << " plastic; not finite " << not_finite
         << ", inadmissible " << outside << ", error above 1e-10: " << off << ", on another root: " << elsewhere
         << "; largest error " << worst << " at p " << worst_at.p << " q " << worst_at.q << " eps_V " << worst_at.eps_V
         << " dt " << worst_at.dt << " " << worst_corner << "; error of the judge " << judge;
    if (steep > 0)
      line << "; where the strength is steep " << steep << " states, error above 1e-10: " << off_steep << ", largest "
           << worst_steep;
    if (most_iterations > 0) line << "; at most " << most_iterations << " evaluations";
    return line.str();
  }
  void check() const {
    BOOST_TEST_MESSAGE(text());
    BOOST_TEST_CONTEXT(text()) {
      BOOST_TEST(plastic > tried / 10);
      BOOST_TEST(not_finite == 0);
      BOOST_TEST(outside == 0);
      BOOST_TEST(off == 0);
      BOOST_TEST(worst_steep < 1e-5);
      BOOST_TEST(judge < 1e-14);
      BOOST_TEST(most_iterations < 2 * root_iteration_limit);
    }
  }
};

/// Stresses of 24 decades about `unit` [Pa]; one state in ten lies at tip, apex, cap, on an axis, or a digit beside it.
class TrialSampler {
 public:
  explicit TrialSampler(unsigned seed)
      : stress_(1e-12, 1e12, seed), strain_(1e-12, 0.5, seed + 1), time_(1e-9, 1e3, seed + 2) {}

  template <class Strength>
  Trial next(double unit, double beta, Strength const& strength) {
    Trial t{unit * stress_.signed_(), unit * stress_.positive(), strain_.signed_(), time_.positive()};
    double const p_c = strength(t.eps_V), apex = 0.5 * (1 - beta) * p_c;
    switch (static_cast<int>(60 * stress_.unit())) {
      case 0:
        t.q = 0;
        break;
      case 1:
        t.p = apex;
        break;
      case 2:
        t.p = std::nextafter(apex, 1e300);
        break;
      case 3:
        t.p = -beta * p_c;
        break;
      case 4:
        t.p = p_c;
        break;
      case 5:
        t.p = 0;
        break;
      default:
        break;
    }
    return t;
  }

 private:
  LogUniform stress_, strain_, time_;
};

}  // namespace talus::support
