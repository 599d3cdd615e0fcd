#pragma once
/// Two independent solutions of the same equations: how far they are apart.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "verification/suite/findings.hpp"

namespace talus::verification {

/// |found/expected - 1|.
[[nodiscard]] inline double apart(double found, double expected) {
  return std::abs(found / expected - 1);
}

/// The largest of |f(x) - g(x)| over the largest |g(x)|.
template <class F, class G>
[[nodiscard]] double apart(F const& f, G const& g, std::vector<double> const& places) {
  double most = 0, size = 0;
  for (double const x : places) most = std::max(most, std::abs(f(x) - g(x))), size = std::max(size, std::abs(g(x)));
  return most / size;
}

/// n places, evenly from a to b with both ends.
[[nodiscard]] inline std::vector<double> places(double a, double b, int n) {
  std::vector<double> list;
  for (int k = 0; k < n; ++k) list.push_back(a + (b - a) * k / (n - 1));
  return list;
}

/// f over places, to be drawn as x over f(x): profiles have their height upwards.
template <class F>
[[nodiscard]] Curve profile(std::string name, F const& f, std::vector<double> const& heights, bool guide) {
  Curve curve{std::move(name), {}, {}, guide};
  for (double const y : heights) curve.x.push_back(f(y)), curve.y.push_back(y);
  return curve;
}

/// A row for the distance of two solutions.
inline void agree(Findings& findings, std::string const& subject, std::string const& measure, double distance,
                  double bar) {
  findings.check(subject, measure, distance, at_most(bar), "independent solutions of the same equations");
}

}  // namespace talus::verification
