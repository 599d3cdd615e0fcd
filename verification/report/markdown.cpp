#include <fmt/format.h>

#include "verification/report/report.hpp"

namespace talus::verification {

namespace {

/// Text as it may stand in a cell of a table.
std::string cell(std::string const& text) {
  std::string result;
  for (char const c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '_' || c == '`' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string bold_unless_green(Verdict verdict) {
  auto const word = std::string(word_of(verdict));
  return is_green(verdict) ? word : "**" + word + "**";
}

std::string seconds_text(double seconds) {
  return seconds > 0 ? fmt::format("{:.2g}", seconds) : "";
}

/// The name that a heading gets as the target of a link.
std::string anchor(std::string const& heading) {
  std::string result;
  for (char const c : heading) {
    if (c == ' ') result += '-';
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-') result += c;
    if (c >= 'A' && c <= 'Z') result += static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string summary_of(Report const& report) {
  std::string text = "| case | what | tier | rows | not green | time [s] |\n|---|---|---|---|---|---|\n";
  for (Result const& r : report.results) {
    auto const all = totals(r.findings);
    auto const red = count(all, Verdict::fail) + count(all, Verdict::floored) + count(all, Verdict::error);
    text += fmt::format("| [{}](#{}) | {} | {} | {} | {} | {} |\n", r.id, anchor(r.id), cell(r.title), r.tier,
                        r.findings.rows.size(), red == 0 ? "" : fmt::format("**{}**", red), seconds_text(r.seconds));
  }
  return text;
}

std::string section_of(Result const& result, Comparison const* against) {
  auto text = fmt::format("\n## {}\n\n{}. Compared with: {}. Source: {}. File: `verification/cases/{}.cpp`.\n\n",
                          result.id, cell(result.title), cell(result.truth), cell(result.source), result.id);
  text += fmt::format(
      "| subject | measure | found | 95 % | asked | verdict |{} time [s] | why "
      "|\n|---|---|---|---|---|---|{}---|---|\n",
      against != nullptr ? " against |" : "", against != nullptr ? "---|" : "");
  std::vector<Change const*> changes;
  if (against != nullptr)
    for (Change const& change : against->changes)
      if (change.id == result.id) changes.push_back(&change);
  for (std::size_t k = 0; k < result.findings.rows.size(); ++k) {
    Row const& row = result.findings.rows[k];
    bool const measured = row.verdict != Verdict::omitted && row.verdict != Verdict::error;
    text += fmt::format("| {} | {} | {} | {} | {} | {} |{} {} | {} |\n", cell(row.subject), cell(row.measure),
                        measured ? value_text(row.found, row.unit) : "", interval_text(row.uncertainty),
                        allowed_text(row.allowed), bold_unless_green(row.verdict),
                        k < changes.size() ? " " + change_text(*changes[k]) + " |" : "", seconds_text(row.cost.seconds),
                        cell(row.because));
  }
  return text;
}

/// What of an earlier run is no longer there.
std::string lost_of(Comparison const& against) {
  auto text = fmt::format("\n## Against an earlier run\n\n`{}`, version {}, {}.\n\n", against.folder, against.version,
                          against.start);
  for (Change const& change : against.changes)
    if (change.verdict_changed() || change.is_new() || change.vanished())
      text += fmt::format("- {}, {}, {}: {}\n", change.id, cell(change.subject), cell(change.measure),
                          change.verdict_changed() ? fmt::format("{} became {}", word_of(*change.earlier_verdict),
                                                                 bold_unless_green(*change.verdict))
                                                   : change_text(change));
  for (std::string const& id : against.not_run) text += fmt::format("- {}: not run now\n", id);
  return text;
}

/// ", commit 0123456789", and whether anything was changed since; nothing where git does not tell.
std::string commit_of(nlohmann::json const& build) {
  auto const git = build.find("git");
  if (git == build.end() || !git->is_object() || !git->contains("commit")) return "";
  bool const changed = git->value("dirty", false);
  return ", commit " + git->at("commit").get<std::string>().substr(0, 10) + (changed ? " with changes" : "");
}

}  // namespace

std::string markdown_of(Report const& report) {
  auto const& build = report.provenance.at("build");
  auto text = fmt::format("# Verification\n\nMade by `talus verify`, version {}{}, {}, {}. {}.\n\n",
                          report.provenance.at("version").get<std::string>(), commit_of(build),
                          build.at("compiler").get<std::string>(),
                          report.provenance.at("machine").at("cpu").get<std::string>(), totals_text(report));
  text +=
      "Verdicts: *pass*, *fail*; *floored*: an order was asked for where the error no longer falls; *omitted*: not "
      "run, for "
      "the reason given; *noted*: nothing is asked; *error*: the case did not come to its end.\n\n";
  text += summary_of(report);
  for (Result const& result : report.results) text += section_of(result, report.against ? &*report.against : nullptr);
  return report.against ? text + lost_of(*report.against) : text;
}

}  // namespace talus::verification
