#include "core/cli/runner.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>

#include "core/cli/profile_files.hpp"
#include "core/cli/schedule.hpp"
#include "core/io/hash.hpp"
#include "core/io/machine.hpp"
#include "core/io/pictures.hpp"
#include "core/io/progress.hpp"
#include "core/io/provenance.hpp"
#include "core/io/run_folder.hpp"
#include "core/parallel.hpp"

namespace talus::cli {

namespace {

volatile std::sig_atomic_t stop_signal = 0;

extern "C" void note_signal(int number) {
  stop_signal = number;
}

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

  void begin_new() {
    series_.emplace(folder_.series(), columns_);
    profiles_.begin(folder_, experiment());
  }

  void take(io::Checkpoint const& saved) {
    experiment().restore(saved);
    frame_times_.done = saved.value<std::int64_t>("frames_due");
    series_times_.done = saved.value<std::int64_t>("series_due");
    checkpoint_times_.done = saved.value<std::int64_t>("checkpoints_due");
    profile_times_.done = saved.value<std::int64_t>("profiles_due");
    auto const& times = saved.value<std::vector<double>>("frame_times");
    auto const& files = saved.value<std::vector<std::string>>("frame_files");
    for (std::size_t k = 0; k < times.size(); ++k) frames_.push_back({times[k], files[k]});
    series_.emplace(folder_.series(), columns_, saved.value<std::int64_t>("series_rows"));
    profiles_.resume(folder_, experiment(), saved.value<std::vector<std::int64_t>>("profile_rows"));
  }

  void write_provenance(std::vector<io::InputFile> inputs) {
    provenance_ = {options_.command_line, thread_count(), composed_.plan.seed, std::move(inputs), start_, ""};
    folder_.write("provenance.json", io::provenance_document(provenance_));
  }

  RunResult go();

 private:
  [[nodiscard]] Experiment& experiment() { return *composed_.experiment; }
  void write_outputs(bool last);
  void write_checkpoint();
  ExitCode step_to_the_end();
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
    if (experiment().time() >= options_.until || stop_signal != 0) {
      write_checkpoint();
      return stop_signal != 0 ? stopped : done;
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
  io::Outcome const outcome = code == computation_failed ? io::Outcome::failed
                              : finished                 ? io::Outcome::done
                                                         : io::Outcome::stopped;
  folder_.write_status({outcome, static_cast<int>(code), experiment().time(), experiment().steps()});
  if (options_.pictures && code != computation_failed) {
    std::string trouble;
    try {
      trouble = io::draw_pictures(folder_.path());
    } catch (FileError const& error) {
      trouble = error.what();
    }
    if (!trouble.empty() && !options_.quiet) fmt::print(stderr, "no pictures: {}\n", trouble);
  }
  return result;
}

RunResult Run::go() {
  stop_signal = 0;
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
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
  return finish(code);
}

}  // namespace

RunResult run_case(Document const& document, std::string_view given, RunOptions const& options) {
  if (options.threads > 0) set_thread_count(options.threads);
  Composed composed = program().compose(document);
  if (!options.quiet)
    for (std::string const& warning : composed.warnings) fmt::print(stderr, "warning: {}\n", warning);
  io::RunFolder folder = io::RunFolder::create(options.folder, options.force);
  folder.write("case.json", given);
  folder.write("resolved.json", composed.resolved);
  Run run(std::move(composed), std::move(folder), options);
  run.write_provenance({{document.name, io::sha256(given)}});
  run.begin_new();
  return run.go();
}

RunResult resume_case(RunOptions const& options) {
  if (options.threads > 0) set_thread_count(options.threads);
  io::RunFolder folder = io::RunFolder::open(options.folder);
  auto const checkpoints = io::checkpoints_in(folder.checkpoints());
  if (checkpoints.empty()) throw CheckpointError("there is no checkpoint in " + folder.checkpoints().string());
  io::Checkpoint const saved = io::read_checkpoint(checkpoints.back());
  Composed composed = program().compose(parse(saved.value<std::string>("case"), "resolved.json"));
  Run run(std::move(composed), std::move(folder), options);
  std::string const given = io::read_file(options.folder / "case.json");
  run.write_provenance({{"case.json", io::sha256(given)}});
  run.take(saved);
  return run.go();
}

}  // namespace talus::cli
