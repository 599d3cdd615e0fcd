#pragma once
/// Other programs, run without a shell.

#include <filesystem>
#include <string>
#include <vector>

namespace talus::bench {

/// A folder for what is needed for a moment; goes with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(ScratchFolder const&) = delete;
  ScratchFolder& operator=(ScratchFolder const&) = delete;
  ~ScratchFolder();
  [[nodiscard]] std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs words[0] with the rest as its arguments, on one thread, and waits. What it writes to standard output is in
/// `output`, the rest in `said`. `code` is -1 where there is no such program, 128 where it was killed.
struct Ran {
  int code;
  std::string output, said;
};
[[nodiscard]] Ran run_process(std::vector<std::string> words);

/// The program of that name beside this one.
[[nodiscard]] std::filesystem::path beside_this_program(std::string const& name);

}  // namespace talus::bench
