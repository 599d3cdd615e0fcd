#include "verification/suite/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/suite/order.hpp"

namespace talus::verification {

namespace {

/// An order that far above the one asked for is not yet that of the limit.
constexpr double surprising = 0.5;

void expect_sound(Refinement const& study) {
  auto const& h = study.spacings;
  if (h.size() < 2) throw std::logic_error(study.subject + ": a refinement takes two spacings or more");
  for (std::size_t k = 0; k < h.size(); ++k)
    if (!(h[k] > 0) || (k > 0 && !(h[k] < h[k - 1])))
      throw std::logic_error(study.subject + ": spacings are positive and fall");
}

std::vector<Measured> solved(Refinement const& study) {
  std::vector<Measured> levels;
  for (std::size_t k = 0; k < study.spacings.size(); ++k) {
    levels.push_back(study.solve(k));
    if (levels.back().errors.size() != study.norms.size())
      throw std::logic_error(
          fmt::format("{}: {} errors for {} norms", study.subject, levels.back().errors.size(), study.norms.size()));
  }
  return levels;
}

/// "1/128" where the spacing is one over a whole number, "0.003" else.
std::string spacing_text(double h) {
  double const inverse = std::round(1 / h);
  bool const whole = inverse >= 2 && inverse < 1e5 && std::abs(inverse * h - 1) < 1e-12;
  return whole && inverse != 10 && inverse != 100 && inverse != 1000 ? fmt::format("1/{:.0f}", inverse)
                                                                     : fmt::format("{:.3g}", h);
}

void add_reason(Row& row, std::string const& reason) {
  row.because += (row.because.empty() ? "" : "; ") + reason;
}

Row& add_row(Findings& findings, Refinement const& study, Norm const& norm, std::string measure, double found,
             Interval allowed, Cost const& cost) {
  bool const asked = allowed.low || allowed.high;
  return asked ? findings.check(study.subject, std::move(measure), found, allowed, norm.because, cost)
               : findings.note(study.subject, std::move(measure), found, norm.because, cost);
}

/// The order's row. What is floored is told as such, whether an order was asked for or not.
void add_order(Findings& findings, Refinement const& study, Norm const& norm, std::vector<double> const& errors,
               Cost const& cost) {
  bool const asked = norm.order == norm.order;
  Interval const allowed{asked ? std::optional(norm.order) : std::nullopt, norm.most_order};
  double const found = pairwise_orders(study.spacings, errors).back();
  Row& row = add_row(findings, study, norm, "order of " + norm.name, found, allowed, cost);
  if (auto const slope = fitted_slope(study.spacings, errors)) row.uncertainty = slope->interval;
  auto const fit = fitted_floor(study.spacings, errors);
  bool const floored = fit && fit->floored();
  if (row.verdict == Verdict::fail && asked && !(found >= norm.order) && floored) row.verdict = Verdict::floored;
  if (floored && row.verdict != Verdict::pass)
    add_reason(row, fmt::format("errors approach {:.2g}, {:.0f} % of the finest, at order {:.2f}", fit->floor,
                                100 * fit->floor / fit->finest, fit->order));
  if (asked && found > norm.order + surprising)
    add_reason(row, "pre-asymptotic: more than is asked for by over " + fmt::format("{}", surprising));
}

void add_level(Findings& findings, Refinement const& study, Norm const& norm, double error, Cost const& cost) {
  auto measure = fmt::format("error of {} at {} = {}", norm.name, study.variable, spacing_text(study.spacings.back()));
  Interval const allowed{{}, norm.level};
  add_row(findings, study, norm, std::move(measure), error, allowed, cost).unit = norm.unit;
}

Curve guide(int order, std::vector<double> const& spacings, double at_coarsest) {
  Curve line{fmt::format("order {}", order), spacings, {}, true};
  for (double const h : spacings) line.y.push_back(at_coarsest * std::pow(h / spacings.front(), order));
  return line;
}

/// The plot of that norm, with its guides where it is new; they begin at half of the first curve's coarsest error.
Plot& plot_of(Findings& findings, Refinement const& study, Norm const& norm, std::string const& title,
              double coarsest) {
  std::string const full = title + ": " + norm.name;
  for (Plot& plot : findings.plots)
    if (plot.title == full) return plot;
  Plot plot{full,
            fmt::format("{} [{}]", study.variable, study.variable_unit),
            fmt::format("error of {} [{}]", norm.name, norm.unit),
            true,
            true,
            {}};
  if (coarsest > 0 && std::isfinite(coarsest))
    for (int const order : {1, 2}) plot.curves.push_back(guide(order, study.spacings, 0.5 * coarsest));
  return findings.plots.emplace_back(std::move(plot));
}

}  // namespace

void refine(Findings& findings, Refinement const& study, std::string const& plot_title) {
  expect_sound(study);
  auto const levels = solved(study);
  Cost all;
  for (Measured const& level : levels) all += level.cost;
  for (std::size_t k = 0; k < study.norms.size(); ++k) {
    Norm const& norm = study.norms[k];
    std::vector<double> errors;
    for (Measured const& level : levels) errors.push_back(level.errors[k]);
    add_order(findings, study, norm, errors, all);
    add_level(findings, study, norm, errors.back(), levels.back().cost);
    plot_of(findings, study, norm, plot_title, errors.front())
        .curves.push_back({study.subject, study.spacings, errors, false});
  }
}

}  // namespace talus::verification
