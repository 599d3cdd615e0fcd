#include "core/io/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>

#include "core/io/files.hpp"

namespace talus::io {

namespace {

/// What the new process does before it becomes gnuplot: enter the folder, read nothing, write to the log.
class FileActions {
 public:
  FileActions(std::filesystem::path const& folder, std::string const& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&actions_, 1, 2);
  }
  FileActions(FileActions const&) = delete;
  FileActions& operator=(FileActions const&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  [[nodiscard]] posix_spawn_file_actions_t const* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

}  // namespace

std::string run_gnuplot(std::filesystem::path const& folder, std::string const& script,
                        std::vector<std::string> const& pictures) {
  auto const log = std::filesystem::path(script).replace_extension(".log").string();
  std::string program = "gnuplot", without_user_settings = "-d", name = script;
  std::array<char*, 4> arguments{program.data(), without_user_settings.data(), name.data(), nullptr};
  FileActions const actions(folder, log);
  pid_t process = 0;
  int const error = posix_spawnp(&process, program.c_str(), actions.get(), nullptr, arguments.data(), environ);
  if (error == ENOENT) return "gnuplot is not installed (Debian: gnuplot-nox)";
  if (error != 0) return "gnuplot cannot be started: " + std::generic_category().message(error);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return fmt::format("gnuplot failed; see {}", (folder / log).string());
  for (std::string const& picture : pictures) {
    std::error_code trouble;
    std::filesystem::rename(folder / (picture + ".tmp"), folder / picture, trouble);
    if (trouble) throw FileError("cannot put in place " + (folder / picture).string() + ": " + trouble.message());
  }
  return "";
}

std::string gnuplot_string(std::string_view text) {
  std::string quoted = "'";
  for (char const c : text) {
    bool const control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    if (c == '\'' || c == '`')
      quoted += "''";  // one apostrophe
    else
      quoted += control ? ' ' : c;
  }
  return quoted + "'";
}

}  // namespace talus::io
