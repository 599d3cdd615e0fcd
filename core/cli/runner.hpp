#pragma once
/// Running a case into its folder: steps, series, frames, checkpoints, signals, summary.

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/cli/exit_codes.hpp"
#include "core/cli/program.hpp"
#include "core/cli/study_cases.hpp"
#include "core/cli/study_folder.hpp"
#include "core/cli/verdict.hpp"

namespace talus::cli {

struct RunOptions {
  std::filesystem::path folder;
  bool force = false, quiet = false, pictures = true;
  double until = std::numeric_limits<double>::infinity();
  int threads = 0;  ///< 0: as many as the machine offers
  std::vector<std::string> command_line;
};

struct RunResult {
  ExitCode code = done;
  std::vector<Verdict> verdicts;
  nlohmann::json summary;
};

/// Runs a case into a new folder. `given`: the bytes of the document as the user wrote it. Throws InputError,
/// FileError.
[[nodiscard]] RunResult run_case(Document const& document, std::string_view given, RunOptions const& options);

/// Goes on with the run in a folder, from its newest checkpoint; from the beginning where there is none yet. Throws
/// InputError, FileError, CheckpointError; the last leaves the folder as it was.
[[nodiscard]] RunResult resume_case(RunOptions const& options);

/// Runs every case of a study into sub-folders, judges its expectations, writes results.json and results.csv.
[[nodiscard]] RunResult run_study(Document const& document, std::string_view given, RunOptions const& options);

/// Goes on with the study in a folder: cases that ended are taken as they are, the one that was stopped is resumed, the
/// others are run. Throws InputError, FileError, CheckpointError.
[[nodiscard]] RunResult resume_study(RunOptions const& options);

/// Leads a material point along its path, for every combination of its axes; judges its expectations, writes
/// results.json, provenance.json and pictures. Throws InputError, FileError.
[[nodiscard]] RunResult run_point(Document const& document, std::string_view given, RunOptions const& options);

/// A study that may run.
struct BegunStudy {
  StudyFolder folder;
  std::vector<StudyCase> cases;
};

/// The cases of a study without mistakes, and its folder, with the document as given in it. Throws InputError with every
/// mistake, FileError.
[[nodiscard]] BegunStudy begin_study(StudyPlan const& plan, Document const& document, std::string_view given,
                                     RunOptions const& options);

}  // namespace talus::cli
