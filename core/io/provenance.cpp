#include "core/io/provenance.hpp"

#include <fmt/core.h>
#include <hdf5.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/build_info.hpp"
#include "core/io/machine.hpp"

namespace talus::io {

namespace {

nlohmann::json build_document() {
  namespace built = build_info;
  return {{"compiler", built::compiler},
          {"flags", built::compiler_flags},
          {"type", built::build_type},
          {"instruction_set", built::instruction_set},
          {"git", {{"commit", built::git_commit}, {"dirty", built::git_dirty}, {"diff", built::git_diff}}}};
}

/// As compiled; HDF5 as it is linked.
nlohmann::json library_document() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return {{"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                        NLOHMANN_JSON_VERSION_PATCH)},
          {"HDF5", fmt::format("{}.{}.{}", major, minor, release)},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
          {"CLI11", CLI11_VERSION}};
}

}  // namespace

std::string build_line() {
  namespace built = build_info;
  return fmt::format("talus {} ({}{}), {}, {}, {}", built::version, built::git_commit,
                     built::git_dirty ? ", changed" : "", built::compiler, built::build_type, built::instruction_set);
}

nlohmann::json provenance_document(Provenance const& run) {
  nlohmann::json inputs = nlohmann::json::array();
  for (auto const& input : run.inputs) inputs.push_back({{"name", input.name}, {"sha256", input.sha256}});
  nlohmann::json end;
  if (!run.end.empty()) end = run.end;
  return {{"schema", "talus/provenance/1"},
          {"version", build_info::version},
          {"build", build_document()},
          {"libraries", library_document()},
          {"machine",
           {{"cpu", cpu_model()},
            {"processors", std::thread::hardware_concurrency()},
            {"operating_system", operating_system()}}},
          {"environment", thread_environment()},
          {"threads", run.threads},
          {"seed", run.seed},
          {"command_line", run.command_line},
          {"inputs", inputs},
          {"start", run.start},
          {"end", end}};
}

}  // namespace talus::io
