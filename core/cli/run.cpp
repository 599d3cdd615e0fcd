#include "core/cli/run.hpp"

#include <fmt/format.h>

#include <chrono>

#include "core/cli/stopping.hpp"
#include "core/io/hash.hpp"
#include "core/io/machine.hpp"
#include "core/io/pictures.hpp"
#include "core/io/progress.hpp"
#include "core/parallel.hpp"

namespace talus::cli {

void Run::begin_new() {
  series_.emplace(folder_.series(), columns_);
  profiles_.begin(folder_, experiment());
}

void Run::write_provenance(std::vector<io::InputFile> inputs) {
  provenance_ = {options_.command_line, thread_count(), composed_.plan.seed, std::move(inputs), start_, ""};
  folder_.write("provenance.json", io::provenance_document(provenance_));
}

/// Reads all of it before any file is touched.
void Run::take(io::Checkpoint const& saved) {
  experiment().restore(saved);
  frame_times_.done = saved.value<std::int64_t>("frames_due");
  series_times_.done = saved.value<std::int64_t>("series_due");
  checkpoint_times_.done = saved.value<std::int64_t>("checkpoints_due");
  profile_times_.done = saved.value<std::int64_t>("profiles_due");
  auto const& times = saved.value<std::vector<double>>("frame_times");
  auto const& files = saved.value<std::vector<std::string>>("frame_files");
  if (times.size() != files.size()) throw CheckpointError("its lists of frames differ in length");
  for (std::size_t k = 0; k < times.size(); ++k) frames_.push_back({times[k], files[k]});
  auto const series_rows = saved.value<std::int64_t>("series_rows");
  auto const& profile_rows = saved.value<std::vector<std::int64_t>>("profile_rows");
  series_.emplace(folder_.series(), columns_, series_rows);
  profiles_.resume(folder_, experiment(), profile_rows);
}

/// What is due now. `last`: the end, of which everything is kept that is not there yet.
void Run::write_outputs(bool last) {
  double const t = experiment().time();
  if (series_times_.due(t) || last) {
    series_->append(experiment().measure());
    series_times_.mark(t);
  }
  if (profile_times_.due(t) || last) {
    profiles_.append(experiment());
    profile_times_.mark(t);
  }
  if (frame_times_.due(t) || (last && (frames_.empty() || frames_.back().time != t))) {
    folder_.add_frame(experiment().frame(), frames_);
    frame_times_.mark(t);
  }
  if (checkpoint_times_.due(t) || last) {
    checkpoint_times_.mark(t);
    write_checkpoint();
  }
}

void Run::write_checkpoint() {
  io::Checkpoint saved = experiment().checkpoint();
  std::vector<double> times;
  std::vector<std::string> files;
  for (io::Frame const& frame : frames_) {
    times.push_back(frame.time);
    files.push_back(frame.file);
  }
  saved.values["frames_due"] = frame_times_.done;
  saved.values["series_due"] = series_times_.done;
  saved.values["checkpoints_due"] = checkpoint_times_.done;
  saved.values["profiles_due"] = profile_times_.done;
  saved.values["frame_times"] = times;
  saved.values["frame_files"] = files;
  saved.values["series_rows"] = series_->rows();
  saved.values["profile_rows"] = profiles_.rows();
  saved.values["case"] = composed_.resolved.dump();
  saved.values["build"] = io::build_line();
  series_->sync();
  profiles_.sync();
  io::write_checkpoint(folder_.checkpoints(), saved, 2);
  folder_.write_status({io::Outcome::running, std::nullopt, experiment().time(), experiment().steps()});
}

ExitCode Run::step_to_the_end() {
  double const end = composed_.plan.end;
  std::optional<io::Progress> progress;
  if (!options_.quiet)
    progress.emplace(experiment().time(), std::min(end, options_.until), io::ProgressOutput::standard_error());
  auto const particles = static_cast<std::int64_t>(experiment().particles());
  write_outputs(false);
  while (experiment().time() < end) {
    if (experiment().time() >= options_.until || stop_asked()) {
      write_checkpoint();
      return stop_asked() ? stopped : done;
    }
    experiment().advance(end);
    write_outputs(experiment().time() >= end);
    if (progress)
      progress->update(experiment().time(), experiment().steps(), particles * (experiment().steps() - first_step_));
  }
  if (progress) progress->finish();
  return done;
}

nlohmann::json Run::summary(ExitCode code, std::vector<Verdict> const& verdicts) {
  nlohmann::json document;
  document["title"] = composed_.plan.title;
  document["exit_code"] = static_cast<int>(code);
  document["finished"] = experiment().time() >= composed_.plan.end;
  document["time"] = experiment().time();
  document["steps"] = experiment().steps();
  document["particles"] = experiment().particles();
  document["sorts"] = experiment().sorts();
  document["wall_seconds"] = wall_seconds_;
  auto const work =
      static_cast<double>(experiment().steps() - first_step_) * static_cast<double>(experiment().particles());
  document["particle_steps_per_second"] = wall_seconds_ > 0 ? work / wall_seconds_ : 0.0;
  document["peak_memory_bytes"] = io::peak_memory();
  if (!failure_.empty()) {
    document["failure"] = failure_;
    return document;
  }
  document["state_hash"] = io::state_hash(experiment().state());
  std::vector<double> const values = experiment().measure();
  for (std::size_t k = 0; k < values.size(); ++k) document["measures"][columns_[k].name] = values[k];
  if (auto const balances = experiment().balances(); !balances.empty()) document["ledgers"] = ledger_document(balances);
  document["expectations"] = verdict_document(verdicts);
  return document;
}

RunResult Run::finish(ExitCode code) {
  RunResult result;
  bool const finished = experiment().time() >= composed_.plan.end;
  if (code == done && finished) {
    result.verdicts =
        judge(before_end(composed_.plan.expect, composed_.plan.end), io::read_series(folder_.series()), "");
    for (Verdict const& v : result.verdicts)
      if (!v.passed) code = expectation_failed;
  }
  result.code = code;
  result.summary = summary(code, result.verdicts);
  folder_.write("summary.json", result.summary);
  provenance_.end = io::utc_now();
  folder_.write("provenance.json", io::provenance_document(provenance_));
  if (options_.pictures && code != computation_failed) {
    std::string trouble;
    try {
      trouble = io::draw_pictures(folder_.path());
    } catch (FileError const& error) {
      trouble = error.what();
    }
    if (!trouble.empty() && !options_.quiet) fmt::print(stderr, "no pictures: {}\n", trouble);
  }
  io::Outcome const outcome = code == computation_failed ? io::Outcome::failed
                              : finished                 ? io::Outcome::done
                                                         : io::Outcome::stopped;
  folder_.write_status({outcome, static_cast<int>(code), experiment().time(), experiment().steps()});
  return result;
}

ExitCode Run::compute() {
  first_step_ = experiment().steps();
  auto const begun = std::chrono::steady_clock::now();
  ExitCode code = done;
  try {
    code = step_to_the_end();
  } catch (RunError const& error) {
    failure_ = error.what();
    code = computation_failed;
    folder_.log(failure_);
    fmt::print(stderr, "\nthe computation failed: {}\nthe last good state is in {}\n", failure_,
               folder_.checkpoints().string());
  }
  wall_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return code;
}

/// For a user who has mended what kept a file from being written.
std::string Run::way_on() const {
  bool const saved = !io::checkpoints_in(folder_.checkpoints()).empty();
  return fmt::format("nothing that was complete is lost: once this is mended, 'talus resume {}' goes on {}",
                     folder_.path().string(), saved ? "from the last checkpoint" : "from the beginning");
}

RunResult Run::go() {
  try {
    return finish(compute());
  } catch (FileError const& error) {
    throw FileError(fmt::format("{}\n{}", error.what(), way_on()));
  }
}

}  // namespace talus::cli
