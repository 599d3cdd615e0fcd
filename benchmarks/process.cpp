#include "benchmarks/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "core/io/files.hpp"

namespace talus::bench {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "talus-bench-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw io::file_error("cannot make", name);
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Ran run_process(std::vector<std::string> words) {
  ScratchFolder const scratch;
  auto const out = (scratch.path() / "out").string(), said = (scratch.path() / "said").string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  int const error = posix_spawnp(&process, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return {-1, "", words.front() + " is not installed"};
  if (error != 0) return {-1, "", std::generic_category().message(error)};
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, io::read_file(out), io::read_file(said)};
}

fs::path beside_this_program(std::string const& name) {
  return fs::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace talus::bench
