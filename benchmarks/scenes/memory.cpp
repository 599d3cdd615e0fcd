#include "benchmarks/scenes/memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace talus::bench {

namespace {

/// A number of /proc/self/status [bytes].
std::int64_t status(std::string const& key) {
  std::ifstream lines("/proc/self/status");
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(key + ":")) return 1024 * std::stoll(line.substr(key.size() + 1));
  return 0;
}

}  // namespace

std::int64_t forget_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5\n";  // resets VmHWM; see proc(5)
  return status("VmRSS");
}

std::int64_t peak_since() {
  return status("VmHWM");
}

}  // namespace talus::bench
