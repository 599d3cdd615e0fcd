#include "core/cli/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::cli {

namespace {

double interpolate(std::vector<double> const& x, std::vector<double> const& y, double at) {
  auto const after = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
  if (after < x.size() && x[after] == at) return y[after];
  if (after == 0 || after == x.size()) return std::numeric_limits<double>::quiet_NaN();
  double const share = (at - x[after - 1]) / (x[after] - x[after - 1]);
  return y[after - 1] + share * (y[after] - y[after - 1]);
}

}  // namespace

std::vector<Verdict> judge(std::vector<ExpectedValue> const& expected, io::Series const& series,
                           std::string const& where) {
  std::vector<Verdict> verdicts;
  std::vector<double> const* const time = series.find("time");
  for (ExpectedValue const& e : expected) {
    std::vector<double> const* const values = series.find(e.measure);
    if (values == nullptr || time == nullptr) {
      std::string names;
      for (auto const& column : series.columns) names += (names.empty() ? "" : ", ") + column.name;
      throw InputError("'" + e.measure + "' is no measure of this case; there are: " + names);
    }
    double const found = interpolate(*time, *values, e.time);
    verdicts.push_back({where, e, found, std::abs(found - e.value) <= e.tolerance});
  }
  return verdicts;
}

std::vector<ExpectedValue> before_end(std::vector<ExpectedValue> expected, double end) {
  std::erase_if(expected, [end](ExpectedValue const& e) { return e.time > end; });
  return expected;
}

std::string verdict_table(std::vector<Verdict> const& verdicts) {
  std::size_t where = 4, measure = 7;
  for (Verdict const& v : verdicts) {
    where = std::max(where, v.where.size());
    measure = std::max(measure, v.expected.measure.size());
  }
  bool const named = where > 4;
  std::string text =
      fmt::format("{:{}}{:{}}  {:>8}  {:>11}  {:>11}  {:>9}  {:>9}  verdict\n", named ? "case" : "",
                  named ? where + 2 : 0, "measure", measure, "time [s]", "expected", "found", "deviation", "allowed");
  for (Verdict const& v : verdicts) {
    double const scale = v.expected.value != 0 ? 100 / std::abs(v.expected.value) : 0;
    auto const percent = [&](double x) {
      return scale > 0 ? fmt::format("{:+.2f} %", x * scale) : fmt::format("{:.2e}", x);
    };
    text += fmt::format("{:{}}{:{}}  {:>8.3f}  {:>11.6g}  {:>11.6g}  {:>9}  {:>9}  {}\n", named ? v.where : "",
                        named ? where + 2 : 0, v.expected.measure, measure, v.expected.time, v.expected.value, v.found,
                        percent(v.found - v.expected.value), percent(v.expected.tolerance), v.passed ? "PASS" : "FAIL");
  }
  auto const passed = std::count_if(verdicts.begin(), verdicts.end(), [](Verdict const& v) { return v.passed; });
  return text + fmt::format("{} of {} expectations met\n", passed, verdicts.size());
}

nlohmann::json verdict_document(std::vector<Verdict> const& verdicts) {
  nlohmann::json list = nlohmann::json::array();
  for (Verdict const& v : verdicts) {
    nlohmann::json row{{"measure", v.expected.measure},     {"time", v.expected.time},
                       {"expected", v.expected.value},      {"found", v.found},
                       {"tolerance", v.expected.tolerance}, {"passed", v.passed},
                       {"because", v.expected.because}};
    if (!std::isfinite(v.found)) row["found_status"] = "nan";
    if (!v.where.empty()) row["case"] = v.where;
    list.push_back(std::move(row));
  }
  return list;
}

std::vector<Verdict> verdicts_of(nlohmann::json const& document) {
  std::vector<Verdict> list;
  for (nlohmann::json const& row : document)
    list.push_back(
        {row.value("case", ""),
         {row.at("measure").get<std::string>(), row.at("time").get<double>(), row.at("expected").get<double>(),
          row.at("tolerance").get<double>(), row.at("because").get<std::string>()},
         row.at("found").is_null() ? std::numeric_limits<double>::quiet_NaN() : row.at("found").get<double>(),
         row.at("passed").get<bool>()});
  return list;
}

nlohmann::json ledger_document(std::vector<Balance> const& balances) {
  nlohmann::json document = nlohmann::json::object();
  for (Balance const& balance : balances) {
    nlohmann::json& entry = document[balance.name];
    entry["unit"] = balance.unit;
    for (Balance::Term const& t : balance.terms) entry["terms"][t.name] = t.value;
    entry["residual"] = balance.residual;
    entry["relative_residual"] = balance.relative;
  }
  return document;
}

std::string ledger_lines(nlohmann::json const& summary) {
  std::string text;
  if (!summary.contains("ledgers")) return text;
  for (auto const& [name, ledger] : summary.at("ledgers").items()) {
    text += fmt::format("{:16}  closes to {:.1e} of its largest term\n", name,
                        ledger.at("relative_residual").get<double>());
    if (name != "energy") continue;
    for (auto const& [term, value] : ledger.at("terms").items())
      text +=
          fmt::format("  {:16}  {:>11.4g} {}\n", term, value.at(0).get<double>(), ledger.at("unit").get<std::string>());
  }
  return text;
}

}  // namespace talus::cli
