#pragma once
/// A refinement study: one problem solved on finer and finer spacings, the order at which its errors fall, and the rows
/// and curves that tell of it.
///
///   Refinement study{.subject = "quadratic, apic",
///                    .spacings = {1. / 16, 1. / 32, 1. / 64, 1. / 128},
///                    .norms = {{.name = "u", .unit = "m", .order = 1.85, .level = 2e-5, .because = "lumped mass: 2"},
///                              {.name = "v", .unit = "m/s", .because = "not asked: pre-asymptotic"}},
///                    .solve = [&](std::size_t level) { return Measured{{error_u, error_v}, cost}; }};
///   refine(findings, study, "Vortex");
///
/// adds for each norm the rows "order of u" and "error of u at h = 1/128", and the curve "quadratic, apic" to the plot
/// "Vortex: u". A study of a time step sets `.variable = "dt", .variable_unit = "s"`.

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "verification/suite/findings.hpp"

namespace talus::verification {

/// One way to measure the error, and what is asked of it.
struct Norm {
  std::string name = {};                                    ///< "u"
  std::string unit = "1";                                   ///< of the error
  double order = std::numeric_limits<double>::quiet_NaN();  ///< least order of the last pair; NaN: nothing is asked
  std::optional<double> most_order = {};                    ///< where more would be wrong, too
  std::optional<double> level = {};                         ///< most that the error on the finest spacing may be
  std::string because = {};                                 ///< where order and level come from
};

/// What solving on one spacing gave: an error a norm, in the order of the norms, and what it took.
struct Measured {
  std::vector<double> errors = {};
  Cost cost = {};
};

struct Refinement {
  std::string subject = {};           ///< what was varied: "quadratic, apic"
  std::vector<double> spacings = {};  ///< falling, two or more; with fewer than three no uncertainty is told
  std::vector<Norm> norms = {};
  std::function<Measured(std::size_t level)> solve = {};  ///< solves on spacings[level]
  std::string variable = "h", variable_unit = "m";        ///< what is refined
};

/// Solves on every spacing and adds to `findings`, for each norm:
/// - the row "order of NAME": found is the order between the two finest spacings, its uncertainty the 95 % interval of
///   the slope over all of them. Where it is missed and the errors approach a floor (order.hpp), it is floored and does
///   not fail. An order more than 0.5 above the one asked for is told as pre-asymptotic in `because`.
/// - the row "error of NAME at h = ..." on the finest spacing, checked where there is a level, else noted.
/// - a curve in the plot "PLOT_TITLE: NAME", which is made with guides of order 1 and 2 where it is not there yet.
/// The order's row bears the cost of all spacings, the error's that of the finest.
/// Throws std::logic_error where spacings do not fall or `solve` gives another number of errors than norms; and what
/// `solve` throws.
void refine(Findings& findings, Refinement const& study, std::string const& plot_title);

}  // namespace talus::verification
