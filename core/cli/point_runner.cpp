#include <fmt/format.h>

#include <map>

#include "core/cli/runner.hpp"
#include "core/cli/study_cases.hpp"
#include "core/io/curve_page.hpp"
#include "core/io/files.hpp"
#include "core/io/gnuplot.hpp"
#include "core/io/hash.hpp"
#include "core/io/provenance.hpp"
#include "core/io/series.hpp"

namespace talus::cli {

namespace {

namespace fs = std::filesystem;

/// A point that went its way, or part of it.
struct PointRun {
  std::string label, folder, failure;
  std::vector<nlohmann::json> at;
  std::vector<Quantity> quantities;
  std::vector<double> end;  ///< last row of the series

  [[nodiscard]] std::size_t column(std::string const& name) const {
    std::size_t k = 0;
    while (quantities[k].name != name) ++k;
    return k;
  }
};

/// Leads the point of a case; its series is written as it goes, and ends where the point fails.
PointRun run_point_case(StudyCase const& study_case, fs::path const& root, std::string const& folder, bool quiet) {
  ComposedPoint composed = program().compose_point(study_case.document);
  if (!quiet)
    for (std::string const& warning : composed.warnings) fmt::print(stderr, "warning: {}\n", warning);
  fs::create_directories(root / folder);
  io::write_atomically(root / folder / "resolved.json", composed.resolved.dump(2) + "\n");
  PointRun run{study_case.label, folder, {}, study_case.values, composed.point->quantities(), {}};
  std::vector<io::SeriesColumn> columns;
  for (Quantity const& q : run.quantities) columns.push_back({q.name, q.unit});
  io::SeriesWriter series(root / folder / "series.csv", columns);
  auto const record = [&] {
    run.end = composed.point->measure();
    series.append(run.end);
  };
  try {
    record();
    for (Segment const& segment : composed.path) {
      try {
        follow(*composed.point, segment, record);
      } catch (RunError const& error) {
        throw RunError("segment '" + segment.name + "': " + error.what());
      }
    }
  } catch (RunError const& error) {
    run.failure = error.what();
    fmt::print(stderr, "{}the computation failed: {}\n", run.label.empty() ? "" : run.label + ": ", run.failure);
  }
  return run;
}

std::string label_of(Quantity const& q) {
  return fmt::format("{} ({})", q.name, q.unit);
}

/// Pictures along the paths: a curve for each case.
std::vector<io::CurvePage> path_pages(StudyPlan const& plan, std::vector<PointRun> const& runs) {
  std::vector<io::CurvePage> pages;
  PointRun const& any = runs.front();
  for (PointPicture const& p : plan.pictures) {
    std::size_t const x = any.column(p.x), y = any.column(p.y);
    io::CurvePage page{p.y + "_over_" + p.x,        plan.title, label_of(any.quantities[x]),
                       label_of(any.quantities[y]), false,      {}};
    for (PointRun const& run : runs)
      page.curves.push_back({run.label, "../" + run.folder + "/series.csv", x + 1, y + 1});
    pages.push_back(std::move(page));
  }
  return pages;
}

/// Pictures of the ends of the paths: a curve for each value of the first axis, whose rows are in a file of its own.
std::vector<io::CurvePage> end_pages(StudyPlan const& plan, std::vector<PointRun> const& runs, fs::path const& plots) {
  if (plan.ends.empty()) return {};
  PointRun const& any = runs.front();
  std::vector<std::pair<std::string, std::string>> groups;  // label, rows
  for (PointRun const& run : runs) {
    std::string const axis = plan.axes.empty() ? "" : plan.axes.front().path;
    std::string const label =
        plan.axes.empty() ? "" : axis.substr(axis.find_last_of('/') + 1) + "=" + run.at.front().dump();
    if (groups.empty() || groups.back().first != label) groups.emplace_back(label, "# last rows\n");
    std::string row;
    for (double const value : run.end) row += fmt::format("{}{}", row.empty() ? "" : ",", value);
    groups.back().second += row + "\n";
  }
  std::vector<io::CurvePage> pages;
  for (PointPicture const& p : plan.ends) {
    std::size_t const x = any.column(p.x), y = any.column(p.y);
    io::CurvePage page{"end_" + p.y + "_over_" + p.x, plan.title, label_of(any.quantities[x]),
                       label_of(any.quantities[y]),   true,       {}};
    for (std::size_t g = 0; g < groups.size(); ++g) {
      std::string const file = fmt::format("ends_{:03}.csv", g);
      io::write_atomically(plots / file, groups[g].second);
      page.curves.push_back({groups[g].first, file, x + 1, y + 1});
    }
    pages.push_back(std::move(page));
  }
  return pages;
}

/// Draws into `plots`; returns why there are no pictures, or nothing.
std::string draw(StudyPlan const& plan, std::vector<PointRun> const& runs, fs::path const& plots) {
  fs::create_directories(plots);
  std::vector<io::CurvePage> pages = path_pages(plan, runs);
  for (io::CurvePage& page : end_pages(plan, runs, plots)) pages.push_back(std::move(page));
  std::string script;
  std::vector<std::string> names;
  for (auto const& format : io::picture_formats())
    for (io::CurvePage const& page : pages) {
      script += io::curve_script(page, format);
      names.push_back(page.name + "." + format.extension);
    }
  if (names.empty()) return {};
  io::write_atomically(plots / "pictures.gp", script);
  std::string trouble = io::run_gnuplot(plots, "pictures.gp");
  if (trouble.empty())
    for (std::string const& name : names) fs::rename(plots / (name + ".tmp"), plots / name);
  return trouble;
}

nlohmann::json results_of(std::vector<PointRun> const& runs) {
  nlohmann::json results = nlohmann::json::array();
  for (PointRun const& run : runs) {
    nlohmann::json row{{"at", run.at}, {"folder", run.folder}};
    for (std::size_t k = 0; k < run.end.size(); ++k) row["end"][run.quantities[k].name] = run.end[k];
    if (!run.failure.empty()) row["failure"] = run.failure;
    results.push_back(std::move(row));
  }
  return results;
}

std::vector<Verdict> judge_case(StudyPlan const& plan, StudyCase const& study_case, fs::path const& folder) {
  std::vector<ExpectedValue> expected;
  for (StudyExpectation const& e : plan.expect)
    if (e.at == study_case.values) expected.push_back(e.expected);
  return judge(expected, io::read_series(folder / "series.csv"), study_case.label);
}

}  // namespace

RunResult run_point(Document const& document, std::string_view given, RunOptions const& options) {
  StudyPlan const plan = program().study(document);
  std::string const start = io::utc_now();
  std::vector<StudyCase> const cases = begin_study(plan, document, given, options);
  RunResult total;
  std::vector<PointRun> runs;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    runs.push_back(run_point_case(cases[k], options.folder, fmt::format("cases/case_{:03}", k), options.quiet));
    if (!runs.back().failure.empty()) total.code = computation_failed;
    for (Verdict const& v : judge_case(plan, cases[k], options.folder / runs.back().folder))
      total.verdicts.push_back(v);
  }
  for (Verdict const& v : total.verdicts)
    if (!v.passed && total.code == done) total.code = expectation_failed;
  total.summary = {
      {"title", plan.title}, {"cases", results_of(runs)}, {"expectations", verdict_document(total.verdicts)}};
  io::write_atomically(options.folder / "results.json", total.summary.dump(2) + "\n");
  io::Provenance const provenance{options.command_line, 1, 0, {{document.name, io::sha256(given)}}, start,
                                  io::utc_now()};
  io::write_atomically(options.folder / "provenance.json", io::provenance_document(provenance).dump(2) + "\n");
  if (options.pictures) {
    std::string const trouble = draw(plan, runs, options.folder / "plots");
    if (!trouble.empty() && !options.quiet) fmt::print(stderr, "no pictures: {}\n", trouble);
  }
  return total;
}

}  // namespace talus::cli
