#pragma once
/// What the program can tell of the machine that it runs on.

#include <cstdint>
#include <map>
#include <string>

namespace talus::io {

/// The processor's model, as /proc/cpuinfo has it; else the kind of machine (x86_64, ...).
[[nodiscard]] std::string cpu_model();

/// The distribution and the kernel's name and release.
[[nodiscard]] std::string operating_system();

/// The environment variables that steer OpenMP: OMP_*, GOMP_*, KMP_*.
[[nodiscard]] std::map<std::string, std::string> thread_environment();

/// The most memory that the process has held so far [bytes].
[[nodiscard]] std::int64_t peak_memory();

}  // namespace talus::io
