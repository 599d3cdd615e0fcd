/// The granular dam break on 22 degrees, coarse, with parameters over decades.
///
/// Stiffness: the grains' stiffness is a number that nobody knows and that must not matter. Over five decades of E the
/// centre of mass stays within 1 % of where it goes with the stiffest; the steps follow the bound,
///
///   steps ~ end/dt ~ sqrt(E)                                                                                      (1)
///
/// Two things besides stiffness depend on E and are left out: a blend alpha < 1 takes its share of the finest motions in
/// every step, and there are more steps (with the shipped 0.95 the heap stays behind, which is noted), and the flow
/// rule of the shipped law depends on p_c/K. So alpha is 1 and flow associated. Grains of 1e5 Pa are soft: pressures of
/// 2 kPa are no longer small.
///
/// Hardening xi and first strength p_c^0 over decades: every run comes to its end with its ledger closed, or stops with a
/// message that names a particle; nothing in between.
///
/// Source: problem: Mangeney et al. (2010), doi:10.1029/2009JF001462.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/errors.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/dam_break.hpp"

namespace talus::verification::stability_stiff_dam_break {

namespace {

constexpr double end = 0.3;  // [s]
constexpr int cells = 10;    // in the height of the heap

Document with(std::string const& member, double value) {
  Document document = dam_break(cells, 2);
  set_value(document, "/materials/0/law/type=cam_clay_mu_i_two_stage");
  set_value(document, "/transfer/alpha=1");
  set_value(document, fmt::format("/materials/0/law/{}={}", member, value));
  return document;
}

/// Steps that the bound foretells.
double foretold(Document const& document) {
  return end / program().compose(document).experiment->explain().first_step.dt;
}

/// Runs with these moduli. blend: alpha.
void stiffen(std::vector<double> const& moduli, double blend, Curve& centre, Curve& steps, std::vector<Cost>& costs) {
  for (double const young : moduli) {
    Document document = with("young_modulus", young);
    set_value(document, R"(/output/ledger={"type": "none"})");
    set_value(document, fmt::format("/transfer/alpha={}", blend));
    costs.emplace_back();
    centre.x.push_back(young);
    centre.y.push_back(run_to(document, end, {"centre_of_mass_x"}, costs.back()).values[0]);
    steps.x.push_back(young);
    steps.y.push_back(foretold(document));
  }
}

void over_stiffness(Findings& findings) {
  Curve centre{"alpha = 1"}, blended{"alpha = 0.95"}, steps{"steps"}, bound{"foretold by (1)", {}, {}, true}, ignored;
  std::vector<Cost> costs, others;
  stiffen({1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11}, 1, centre, bound, costs);
  stiffen({1e5, 1e6, 1e7, 1e8}, 0.95, blended, ignored, others);
  steps.x = centre.x;
  for (Cost const& cost : costs) steps.y.push_back(double(cost.steps));
  for (std::size_t k = 0; k < costs.size(); ++k) {
    std::string const subject = fmt::format("E = {:.0e} Pa", centre.x[k]),
                      what = fmt::format("centre of mass at {} s over the one with the stiffest grains", end);
    double const share = centre.y[k] / centre.y.back();
    if (centre.x[k] < 1e6)
      findings.note(subject, what, share, "soft grains", costs[k]);
    else
      findings.check(subject, what, share, about(1, 0.01), "stiffness must not matter", costs[k]);
    findings.check(subject, "steps over those that the bound foretells", steps.y[k] / bound.y[k], about(1, 0.01),
                   "nothing else limits the step");
    findings.check(subject, "steps over sqrt(E), over that of the stiffest",
                   steps.y[k] / steps.y.back() / std::sqrt(centre.x[k] / centre.x.back()), about(1, 0.01), "(1)");
  }
  for (std::size_t k = 0; k < others.size(); ++k)
    findings.note(fmt::format("E = {:.0e} Pa, alpha = 0.95", blended.x[k]),
                  "centre of mass over the one with the stiffest grains and alpha = 1", blended.y[k] / centre.y.back(),
                  "what a blend takes in every step", others[k]);
  findings.plots.push_back({fmt::format("Dam break over stiffness: centre of mass at {} s", end),
                            "E [Pa]",
                            "centre of mass [m]",
                            true,
                            false,
                            {centre, blended}});
  findings.plots.push_back({"Dam break over stiffness: cost", "E [Pa]", "steps", true, true, {steps, bound}});
}

/// A run that ends has a closed ledger; one that fails says which particle failed.
void varied(Findings& findings, Curve& curve, std::string const& member, double value) {
  std::string const subject = fmt::format("{} = {:g}", member, value);
  Cost cost;
  try {
    Ran const ran = run_to(with(member, value), end, {"centre_of_mass_x"}, cost);
    double worst = 0;
    for (Balance const& balance : ran.balances) worst = std::max(worst, std::abs(balance.relative));
    findings.check(subject, "largest residual of the ledger at the end", worst, at_most(1e-10),
                   "the run came to its end", cost);
    findings.note(subject, fmt::format("centre of mass at {} s", end), ran.values[0]).unit = "m";
    curve.x.push_back(value);
    curve.y.push_back(ran.values[0]);
  } catch (RunError const& error) {
    std::string const message = error.what();
    findings.check(subject, "stopped with the name of a particle (1: yes)",
                   message.find("particle") != message.npos ? 1 : 0, about(1, 0), message.substr(0, message.find('\n')),
                   cost);
  }
}

void over_decades(Findings& findings, std::string const& member, std::string const& label,
                  std::vector<double> const& values) {
  Curve curve{member};
  for (double const value : values) varied(findings, curve, member, value);
  findings.plots.push_back(
      {"Dam break over " + member, label, fmt::format("centre of mass at {} s [m]", end), true, false, {curve}});
}

/// An elastic heap at twice the bound.
void too_long_a_step(Findings& findings) {
  Document document = dam_break(cells, 2);
  set_value(document, R"(/materials/0/law={"type": "hencky", "young_modulus": 1e6, "poisson_ratio": 0.3})");
  set_value(document, "/time/safety=2");
  Cost cost;
  std::string message;
  try {
    [[maybe_unused]] Ran const ran = run_to(document, end, {}, cost);
  } catch (RunError const& error) {
    message = error.what();
  }
  findings.check("elastic heap at twice the bound of the step", "stopped with the name of a particle (1: yes)",
                 message.find("particle") != message.npos ? 1 : 0, about(1, 0), message.substr(0, message.find('\n')),
                 cost);
}

void run(Findings& findings) {
  over_stiffness(findings);
  over_decades(findings, "xi", "xi [1]", {0.5, 5, 50, 500, 5000});
  over_decades(findings, "p_c0", "p_c0 [Pa]", {1e-2, 1, 1e2, 1e4, 1e6});
  too_long_a_step(findings);
}

}  // namespace

Case const the_case{"stability/stiff_dam_break",
                    "The dam break with stiffness, hardening and strength over decades",
                    "itself with stiffer grains; the bound of the step; the ledger",
                    "Mangeney et al. (2010), doi:10.1029/2009JF001462",
                    2,
                    120,
                    run};

}  // namespace talus::verification::stability_stiff_dam_break
