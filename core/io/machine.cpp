#include "core/io/machine.hpp"

#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <string_view>

namespace talus::io {

namespace {

/// What stands behind the first of `separators` in the file's first line that begins with `key`; empty without one.
std::string entry_of(char const* file, std::string_view key, char separator) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    auto const at = line.find(separator);
    if (!line.starts_with(key) || at == line.npos) continue;
    auto const first = line.find_first_not_of(" \"", at + 1), last = line.find_last_not_of(" \"");
    return first == line.npos ? "" : line.substr(first, last - first + 1);
  }
  return "";
}

}  // namespace

std::string cpu_model() {
  auto const model = entry_of("/proc/cpuinfo", "model name", ':');
  utsname system{};
  uname(&system);
  return model.empty() ? system.machine : model;
}

std::string operating_system() {
  auto const distribution = entry_of("/etc/os-release", "PRETTY_NAME", '=');
  utsname system{};
  uname(&system);
  auto const kernel = std::string(system.sysname) + " " + system.release;
  return distribution.empty() ? kernel : distribution + ", " + kernel;
}

std::map<std::string, std::string> thread_environment() {
  constexpr std::array<std::string_view, 3> prefixes{"OMP_", "GOMP_", "KMP_"};
  std::map<std::string, std::string> found;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    std::string_view const text(*entry);
    auto const equals = text.find('=');
    if (equals == text.npos) continue;
    for (auto const prefix : prefixes)
      if (text.starts_with(prefix)) found.emplace(text.substr(0, equals), text.substr(equals + 1));
  }
  return found;
}

std::int64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

}  // namespace talus::io
