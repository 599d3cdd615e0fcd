#include <fmt/format.h>

#include <algorithm>

#include "core/io/columns.hpp"
#include "verification/report/report.hpp"

namespace talus::verification {

namespace {

/// The verdict in capitals, in its colour.
std::string shouted(Verdict verdict, bool colour) {
  std::string word(word_of(verdict));
  for (char& c : word) c = static_cast<char>(c - 'a' + 'A');
  if (!colour) return word;
  int const code = is_green(verdict) ? 32 : verdict == Verdict::floored ? 33 : 31;
  return fmt::format("\033[{}m{}\033[0m", code, word);
}

/// The worst that a case has.
Verdict verdict_of(Totals const& all) {
  for (Verdict const verdict : {Verdict::error, Verdict::fail, Verdict::floored})
    if (count(all, verdict) > 0) return verdict;
  return Verdict::pass;
}

/// "12/14 passed", and how many were not judged.
std::string passed_text(Totals const& all) {
  std::size_t asked = 0;
  for (Verdict const verdict : {Verdict::pass, Verdict::fail, Verdict::floored, Verdict::error})
    asked += count(all, verdict);
  auto text = fmt::format("{:>3}/{:<3} passed", count(all, Verdict::pass), asked);
  for (Verdict const verdict : {Verdict::noted, Verdict::omitted})
    if (count(all, verdict) > 0) text += fmt::format(", {} {}", count(all, verdict), word_of(verdict));
  return text;
}

/// What was found of a row, in one line: "order of u = 1.2 [1.1, 1.3], asked ≥ 1.85".
std::string found_text(Row const& row) {
  if (row.verdict == Verdict::omitted || row.verdict == Verdict::error) return row.measure;
  auto text = row.measure + " = " + value_text(row.found, row.unit);
  if (auto const interval = interval_text(row.uncertainty); !interval.empty()) text += " " + interval;
  if (auto const allowed = allowed_text(row.allowed); !allowed.empty()) text += ", asked " + allowed;
  return text;
}

std::string line_of(Row const& row, bool colour) {
  return fmt::format("      {}  {}: {}{}\n", shouted(row.verdict, colour), row.subject, found_text(row),
                     row.because.empty() ? "" : " (" + row.because + ")");
}

/// Every row of a case in columns; `changes` are those of the case, or none.
std::string table_of(Result const& result, std::vector<Change const*> const& changes) {
  std::vector<std::vector<std::string>> rows{
      {"", "", "found", "95 %", "asked", changes.empty() ? "" : "against", "why"}};
  for (std::size_t k = 0; k < result.findings.rows.size(); ++k) {
    Row const& row = result.findings.rows[k];
    bool const measured = row.verdict != Verdict::omitted && row.verdict != Verdict::error;
    rows.push_back({row.subject + ": " + row.measure,
                    is_green(row.verdict) ? std::string(word_of(row.verdict)) : shouted(row.verdict, false),
                    measured ? value_text(row.found, row.unit) : "", interval_text(row.uncertainty),
                    allowed_text(row.allowed), k < changes.size() ? change_text(*changes[k]) : "", row.because});
  }
  if (rows.size() == 1) return "";
  return io::columns(rows, "llrrrr");
}

std::vector<Change const*> changes_of(Report const& report, std::string const& id) {
  std::vector<Change const*> changes;
  if (report.against)
    for (Change const& change : report.against->changes)
      if (change.id == id) changes.push_back(&change);
  return changes;
}

/// Rows whose verdict has changed, new ones, and what is gone; how many values have changed.
std::string against_text(Comparison const& against) {
  auto text = fmt::format("\nAgainst {} (version {}, {}):\n", against.folder, against.version, against.start);
  std::size_t moved = 0;
  for (Change const& change : against.changes) {
    auto const what = fmt::format("{}  {}: {}", change.id, change.subject, change.measure);
    moved += !change.is_new() && !change.vanished() && change_text(change) != "same" ? 1 : 0;
    if (change.verdict_changed())
      text += fmt::format("  {} -> {}  {} ({} -> {})\n", word_of(*change.earlier_verdict), word_of(*change.verdict),
                          what, value_text(change.earlier, change.unit), value_text(change.found, change.unit));
    else if (change.is_new() || change.vanished())
      text += fmt::format("  {}  {}\n", change_text(change), what);
  }
  for (std::string const& id : against.not_run) text += fmt::format("  not run now  {}\n", id);
  return text + fmt::format("  {} value{} changed; -v shows each\n", moved, moved == 1 ? " has" : "s have");
}

}  // namespace

std::string totals_text(Report const& report) {
  auto const all = totals(report.results);
  std::size_t rows = 0;
  std::string parts;
  for (auto const& [verdict, word] : {std::pair{Verdict::pass, "passed"},
                                      {Verdict::fail, "failed"},
                                      {Verdict::floored, "floored"},
                                      {Verdict::error, "with an error"},
                                      {Verdict::omitted, "omitted"},
                                      {Verdict::noted, "noted"}}) {
    rows += count(all, verdict);
    if (count(all, verdict) > 0) parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", count(all, verdict), word);
  }
  return fmt::format("{} row{}: {}; {} case{} in {}", rows, rows == 1 ? "" : "s", parts.empty() ? "none" : parts,
                     report.results.size(), report.results.size() == 1 ? "" : "s", duration_text(report.seconds));
}

std::string text_of(Report const& report, bool all, bool colour) {
  std::size_t width = 0;
  for (Result const& result : report.results) width = std::max(width, result.id.size());
  std::string text;
  for (Result const& result : report.results) {
    auto const counts = totals(result.findings);
    Verdict const verdict = verdict_of(counts);
    text += fmt::format("{:<{}}  {}{:<{}}  {}  {:>7}\n", result.id, width, shouted(verdict, colour), "",
                        7 - word_of(verdict).size(), fmt::format("{:<36}", passed_text(counts)),
                        duration_text(result.seconds));
    if (all)
      text += table_of(result, changes_of(report, result.id));
    else
      for (Row const& row : result.findings.rows)
        if (!is_green(row.verdict)) text += line_of(row, colour);
  }
  if (report.against) text += against_text(*report.against);
  bool const green = is_green(totals(report.results));
  return text + fmt::format("\n{}  {}\n", shouted(green ? Verdict::pass : Verdict::fail, colour), totals_text(report));
}

}  // namespace talus::verification
