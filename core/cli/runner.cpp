#include "core/cli/runner.hpp"

#include <fmt/format.h>

#include "core/cli/run.hpp"
#include "core/cli/show.hpp"
#include "core/cli/stopping.hpp"
#include "core/io/files.hpp"
#include "core/io/hash.hpp"
#include "core/parallel.hpp"

namespace talus::cli {

namespace fs = std::filesystem;

namespace {

/// The case of a run's folder. Throws CheckpointError where a kill came before it was written.
Document case_in(fs::path const& folder) {
  fs::path const file = folder / "resolved.json";
  if (!fs::exists(file))
    throw CheckpointError(
        fmt::format("there is nothing to resume in {}: the run was stopped before it began; run its "
                    "document again with --force",
                    folder.string()));
  return load(file.string(), {});
}

/// Throws CheckpointError where a checkpoint is of another case than the folder.
void require_same_case(io::Checkpoint const& saved, nlohmann::json const& resolved) {
  auto const held = parse(saved.value<std::string>("case"), "its case").value;
  auto const changes = nlohmann::json::diff(resolved, held);
  if (changes.empty()) return;
  nlohmann::json::json_pointer const pointer(changes[0]["path"].get<std::string>());
  auto const at_pointer = [&](nlohmann::json const& from) {
    return from.contains(pointer) ? from[pointer].dump() : std::string("not given");
  };
  throw CheckpointError(fmt::format("it is of another case than resolved.json beside it: {} is {} there, {} here",
                                    pointer.to_string(), at_pointer(held), at_pointer(resolved)));
}

/// Calls f; puts `before` what it finds wrong with the newest checkpoint, and behind it what a user can do.
template <class F>
void with_advice(std::vector<fs::path> const& checkpoints, std::string const& before, F const& f) {
  try {
    f();
  } catch (CheckpointError const& error) {
    auto const way = checkpoints.size() > 1 ? "go on from " + checkpoints[checkpoints.size() - 2].filename().string()
                                            : std::string("begin anew");
    throw CheckpointError(fmt::format("{}{}\nnothing was changed; to {}, move {} away and resume again", before,
                                      error.what(), way, checkpoints.back().string()));
  }
}

void warn_of_another_build(io::Checkpoint const& saved, RunOptions const& options) {
  std::string const here = io::build_line();
  auto const found = saved.values.find("build");
  auto const* text = found == saved.values.end() ? nullptr : std::get_if<std::string>(&found->second);
  std::string const there = text != nullptr ? *text : "that is not known";
  if (there != here && !options.quiet)
    fmt::print(stderr, "warning: the checkpoint was written by another build, {}; this is {}: the bits may differ\n",
               there, here);
}

}  // namespace

RunResult run_case(Document const& document, std::string_view given, RunOptions const& options) {
  note_stop_signals();
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
  note_stop_signals();
  if (options.threads > 0) set_thread_count(options.threads);
  io::RunFolder folder = io::RunFolder::open(options.folder);
  Document const document = case_in(options.folder);
  auto const checkpoints = io::checkpoints_in(folder.checkpoints());
  std::string const unusable =
      checkpoints.empty() ? "" : fmt::format("the checkpoint {} cannot be used: ", checkpoints.back().string());
  io::Checkpoint saved;
  if (!checkpoints.empty()) {
    with_advice(checkpoints, "", [&] { saved = io::read_checkpoint(checkpoints.back()); });
    with_advice(checkpoints, unusable, [&] { require_same_case(saved, document.value); });
    warn_of_another_build(saved, options);
  }
  Composed composed = program().compose(document);
  composed.resolved = document.value;  // checkpoints keep the case as it was given
  Run run(std::move(composed), std::move(folder), options);
  if (checkpoints.empty())  // it was stopped before it wrote one
    run.begin_new();
  else
    with_advice(checkpoints, unusable, [&] { run.take(saved); });
  run.write_provenance({{"case.json", io::sha256(io::read_file(options.folder / "case.json"))}});
  return run.go();
}

}  // namespace talus::cli
