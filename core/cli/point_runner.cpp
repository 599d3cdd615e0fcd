#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/cli/runner.hpp"
#include "core/cli/stopping.hpp"
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

/// Thrown out of a path where a signal asked to stop.
struct StopAsked {};

/// A point that went its way, or part of it.
struct PointRun {
  std::string label, folder, failure;
  std::vector<nlohmann::json> at;
  std::vector<Quantity> quantities;
  std::vector<double> end;  ///< last row of the series
  bool stopped = false;     ///< by a signal

  /// Place of a column; none where the law of this run has no such quantity.
  [[nodiscard]] std::optional<std::size_t> column(std::string const& name) const {
    for (std::size_t k = 0; k < quantities.size(); ++k)
      if (quantities[k].name == name) return k;
    return {};
  }
};

/// What a point measures now. Throws RunError where a quantity is no number.
std::vector<double> measured(PointExperiment const& point, std::vector<Quantity> const& quantities) {
  std::vector<double> row = point.measure();
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!std::isfinite(row[k]))
      throw RunError(fmt::format("at t = {} s the {} is not finite; lead the point less far, or in shorter steps",
                                 point.time(), quantities[k].name));
  return row;
}

/// Leads the point of a case; its series is written as it goes, and ends where the point fails.
PointRun run_point_case(StudyCase const& study_case, fs::path const& root, std::string const& folder, bool quiet) {
  ComposedPoint composed = program().compose_point(study_case.document);
  if (!quiet)
    for (std::string const& warning : composed.warnings) fmt::print(stderr, "warning: {}\n", warning);
  fs::create_directories(root / folder);
  io::write_atomically(root / folder / "resolved.json", composed.resolved.dump(2) + "\n");
  PointRun run{study_case.label, folder, {}, study_case.values, composed.point->quantities(), {}, false};
  std::vector<io::SeriesColumn> columns;
  for (Quantity const& q : run.quantities) columns.push_back({q.name, q.unit});
  io::SeriesWriter series(root / folder / "series.csv", columns);
  auto const record = [&] {
    run.end = measured(*composed.point, run.quantities);
    series.append(run.end);
    if (stop_asked()) throw StopAsked();
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
  } catch (StopAsked const&) {
    run.stopped = true;
    fmt::print(stderr, "stopped by a signal; the rows so far are in {}\n", (root / folder).string());
  }
  return run;
}

/// A page for a picture, without curves yet; its labels are those of the first run that has both columns.
io::CurvePage page_of(StudyPlan const& plan, PointPicture const& p, bool ends, std::vector<PointRun> const& runs) {
  io::CurvePage page{(ends ? "end_" : "") + p.y + "_over_" + p.x, plan.title, p.x, p.y, ends, {}};
  for (PointRun const& run : runs) {
    auto const x = run.column(p.x), y = run.column(p.y);
    if (!x || !y) continue;
    page.x_label = fmt::format("{} ({})", p.x, run.quantities[*x].unit);
    page.y_label = fmt::format("{} ({})", p.y, run.quantities[*y].unit);
    break;
  }
  return page;
}

/// Pictures along the paths: a curve for each case that has both columns.
std::vector<io::CurvePage> path_pages(StudyPlan const& plan, std::vector<PointRun> const& runs) {
  std::vector<io::CurvePage> pages;
  for (PointPicture const& p : plan.pictures) {
    io::CurvePage page = page_of(plan, p, false, runs);
    for (PointRun const& run : runs)
      if (auto const x = run.column(p.x), y = run.column(p.y); x && y)
        page.curves.push_back({run.label, "../" + run.folder + "/series.csv", *x + 1, *y + 1});
    if (!page.curves.empty()) pages.push_back(std::move(page));
  }
  return pages;
}

/// The name of the curve that the end of a run belongs to: the value of the first axis.
std::string group_of(StudyPlan const& plan, PointRun const& run) {
  if (plan.axes.empty()) return {};
  std::string const& axis = plan.axes.front().path;
  return axis.substr(axis.find_last_of('/') + 1) + "=" + run.at.front().dump();
}

/// Pictures of the ends of the paths: a curve for each value of the first axis, of points in a file of its own.
std::vector<io::CurvePage> end_pages(StudyPlan const& plan, std::vector<PointRun> const& runs, fs::path const& plots) {
  std::vector<io::CurvePage> pages;
  for (PointPicture const& p : plan.ends) {
    io::CurvePage page = page_of(plan, p, true, runs);
    std::vector<std::pair<std::string, std::string>> groups;  // name, rows
    for (PointRun const& run : runs) {
      auto const x = run.column(p.x), y = run.column(p.y);
      if (!x || !y || run.end.empty()) continue;
      if (groups.empty() || groups.back().first != group_of(plan, run))
        groups.emplace_back(group_of(plan, run), fmt::format("{},{}\n", p.x, p.y));
      groups.back().second += fmt::format("{},{}\n", run.end[*x], run.end[*y]);
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
      std::string const file = fmt::format("{}_{:03}.csv", page.name, g);
      io::write_atomically(plots / file, groups[g].second);
      page.curves.push_back({groups[g].first, file, 1, 2});
    }
    if (!page.curves.empty()) pages.push_back(std::move(page));
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
  return io::run_gnuplot(plots, "pictures.gp", names);
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

}  // namespace

RunResult run_point(Document const& document, std::string_view given, RunOptions const& options) {
  StudyPlan const plan = program().study(document);
  std::string const start = io::utc_now();
  BegunStudy const study = begin_study(plan, document, given, options);
  std::vector<StudyCase> const& cases = study.cases;
  RunResult total;
  std::vector<PointRun> runs;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    runs.push_back(run_point_case(cases[k], options.folder, StudyFolder::case_folder(k), options.quiet));
    if (!runs.back().failure.empty()) total.code = computation_failed;
    if (runs.back().stopped) {
      total.code = stopped;
      break;
    }
    io::Series const series = io::read_series(options.folder / runs.back().folder / "series.csv");
    for (Verdict const& v : judge(expected_at(plan, cases[k]), series, cases[k].label)) total.verdicts.push_back(v);
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
