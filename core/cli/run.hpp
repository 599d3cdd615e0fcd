#pragma once
/// A run under way: a composed case, its folder, and what is written when.

#include <optional>
#include <string>
#include <vector>

#include "core/cli/profile_files.hpp"
#include "core/cli/runner.hpp"
#include "core/cli/schedule.hpp"
#include "core/io/provenance.hpp"
#include "core/io/run_folder.hpp"

namespace talus::cli {

/// One run: what it holds open, and what it has written so far.
class Run {
 public:
  Run(Composed composed, io::RunFolder folder, RunOptions const& options)
      : composed_(std::move(composed)),
        folder_(std::move(folder)),
        options_(options),
        frame_times_{composed_.plan.frames_every},
        series_times_{composed_.plan.series_every},
        checkpoint_times_{composed_.plan.checkpoints_every},
        profile_times_{composed_.plan.profiles_every},
        start_(io::utc_now()) {
    for (Quantity const& q : experiment().quantities()) columns_.push_back({q.name, q.unit});
  }

  /// The run begins: empty series and profiles.
  void begin_new();
  /// It goes on from a checkpoint of the folder's case. Throws CheckpointError and leaves every file as it was.
  void take(io::Checkpoint const& saved);
  void write_provenance(std::vector<io::InputFile> inputs);
  /// Runs to the end, to a signal or to a failure of the computation. Throws FileError, which says how to go on.
  RunResult go();

 private:
  [[nodiscard]] Experiment& experiment() { return *composed_.experiment; }
  void write_outputs(bool last);
  void write_checkpoint();
  ExitCode step_to_the_end();
  ExitCode compute();
  [[nodiscard]] std::string way_on() const;
  RunResult finish(ExitCode code);
  [[nodiscard]] nlohmann::json summary(ExitCode code, std::vector<Verdict> const& verdicts);

  Composed composed_;
  io::RunFolder folder_;
  RunOptions options_;
  Schedule frame_times_, series_times_, checkpoint_times_, profile_times_;
  std::string start_;
  std::vector<io::SeriesColumn> columns_;
  std::optional<io::SeriesWriter> series_;
  ProfileFiles profiles_;
  std::vector<io::Frame> frames_;
  io::Provenance provenance_;
  std::string failure_;
  long first_step_ = 0;
  double wall_seconds_ = 0;
};

}  // namespace talus::cli
