#include "verification/suite/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/errors.hpp"

namespace talus::verification {

namespace {

constexpr std::array<std::string_view, 6> words{"pass", "fail", "floored", "omitted", "noted", "error"};

/// Four digits, as short as they can be written.
std::string digits(double value) {
  return fmt::format("{:.4g}", value);
}

}  // namespace

Result result_of(Case const& facts) {
  return {std::string(facts.id), std::string(facts.title), std::string(facts.truth), std::string(facts.source),
          facts.tier};
}

Totals totals(Findings const& findings) {
  Totals all{};
  for (Row const& row : findings.rows) ++all[static_cast<std::size_t>(row.verdict)];
  return all;
}

Totals totals(std::vector<Result> const& results) {
  Totals all{};
  for (Result const& result : results) {
    Totals const some = totals(result.findings);
    for (std::size_t k = 0; k < all.size(); ++k) all[k] += some[k];
  }
  return all;
}

bool is_green(Verdict verdict) {
  return verdict == Verdict::pass || verdict == Verdict::omitted || verdict == Verdict::noted;
}

bool is_green(Totals const& all) {
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k] > 0 && !is_green(static_cast<Verdict>(k))) return false;
  return true;
}

std::string_view word_of(Verdict verdict) {
  return words[static_cast<std::size_t>(verdict)];
}

Verdict verdict_named(std::string_view word) {
  auto const found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) throw InputError("'" + std::string(word) + "' is no verdict");
  return static_cast<Verdict>(found - words.begin());
}

std::string interval_text(Interval const& uncertainty) {
  if (!uncertainty.low || !uncertainty.high) return "";
  return fmt::format("[{:.3g}, {:.3g}]", *uncertainty.low, *uncertainty.high);
}

std::string allowed_text(Interval const& allowed) {
  if (allowed.low && allowed.high) return digits(*allowed.low) + " … " + digits(*allowed.high);
  if (allowed.low) return "≥ " + digits(*allowed.low);
  return allowed.high ? "≤ " + digits(*allowed.high) : "";
}

std::string value_text(double value, std::string_view unit) {
  return unit == "1" || unit.empty() ? digits(value) : digits(value) + " " + std::string(unit);
}

std::string duration_text(double seconds) {
  if (seconds < 0.095) return fmt::format("{:.2f} s", seconds);
  if (seconds < 59.5) return fmt::format("{:.{}f} s", seconds, seconds < 9.95 ? 1 : 0);
  auto const s = static_cast<long>(std::llround(seconds));
  if (s < 3600) return fmt::format("{}:{:02}", s / 60, s % 60);
  return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace talus::verification
