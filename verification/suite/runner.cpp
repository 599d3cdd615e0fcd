#include "verification/suite/runner.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <numeric>

#include "core/config/json.hpp"
#include "core/errors.hpp"
#include "core/io/files.hpp"
#include "core/parallel.hpp"
#include "verification/suite/document.hpp"

namespace talus::verification {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

double seconds(timeval const& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

/// That a process has computed, in all its threads [s].
double computed_by(pid_t process) {
  clockid_t clock{};
  timespec used{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &used) != 0) return 0;
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

void add_error(Findings& findings, std::string reason) {
  findings.rows.push_back(
      {.subject = "the case", .measure = "ends", .verdict = Verdict::error, .because = std::move(reason)});
}

Findings found_by(Case const& one) {
  Findings findings;
  try {
    one.run(findings);
  } catch (std::exception const& error) {
    add_error(findings, error.what());
  } catch (...) {
    add_error(findings, "it threw something that is no std::exception");
  }
  return findings;
}

/// The child's life: it never returns into the parent's code, however it ends, and flushes nothing of the parent's.
[[noreturn]] void live(Case const& one, int pipe, bool alone) noexcept {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (int const signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGINT, SIGTERM, SIGHUP})
    std::signal(signal, SIG_DFL);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  if (!alone) set_thread_count(1);
  std::string const text = document_of(found_by(one)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string_view left = text;
  while (!left.empty()) {
    auto const written = ::write(pipe, left.data(), left.size());
    if (written < 0 && errno != EINTR) break;
    left.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, written)));
  }
  _exit(left.empty() ? 0 : 1);
}

/// A case that is running.
struct Child {
  std::size_t place;  ///< of the case in the list
  pid_t process;
  io::Descriptor pipe;
  Clock::time_point begin;
  std::string said = {};
  bool stopped = false;
};

class Runner {
 public:
  Runner(std::span<Case const* const> cases, RunOptions const& options) : cases_(cases), options_(options) {
    for (Case const* one : cases) results_.push_back(result_of(*one));
    waiting_.resize(cases.size());
    std::iota(waiting_.rbegin(), waiting_.rend(), std::size_t{0});
    // the longest first, so that none is left to run alone at the end; the next is taken from the back
    if (options.jobs > 1)
      std::stable_sort(waiting_.begin(), waiting_.end(),
                       [&](std::size_t a, std::size_t b) { return cases[a]->budget < cases[b]->budget; });
  }

  std::vector<Result> run() {
    while (!waiting_.empty() || !running_.empty()) {
      if (!interrupted_ && options_.interrupted && options_.interrupted()) abandon();
      while (!waiting_.empty() && running_.size() < static_cast<std::size_t>(std::max(1, options_.jobs))) start();
      listen();
    }
    return std::move(results_);
  }

 private:
  void start() {
    std::size_t const place = waiting_.back();
    waiting_.pop_back();
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw io::file_error("cannot make", "a pipe");
    io::Descriptor read(ends[0]), write(ends[1]);
    std::fflush(nullptr);
    pid_t const process = fork();
    if (process < 0) throw io::file_error("cannot make", "a process");
    if (process == 0) live(*cases_[place], write.number(), options_.jobs <= 1);
    running_.push_back({place, process, std::move(read), Clock::now()});
  }

  /// Ends what runs, and begins nothing more.
  void abandon() {
    interrupted_ = true;
    for (std::size_t const place : waiting_)
      add_error(results_[place].findings, "not begun: the suite was stopped by a signal");
    waiting_.clear();
    for (Child& child : running_) {
      stop(child);
    }
  }

  static void stop(Child& child) {
    child.stopped = true;
    kill(child.process, SIGKILL);
  }

  /// Waits until a child says something or has taken too long, or a signal comes.
  void listen() {
    std::vector<pollfd> open;
    double left = 3600;
    for (Child const& child : running_) {
      open.push_back({child.pipe.number(), POLLIN, 0});
      if (!child.stopped) left = std::min(left, time_left(child));
    }
    if (poll(open.data(), open.size(), static_cast<int>(1000 * std::max(0., left)) + 1) < 0) return;
    for (std::size_t k = running_.size(); k-- > 0;) {
      Child& child = running_[k];
      if (open[k].revents != 0 && !hear(child)) {
        end(child);
        running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(k));
      } else if (!child.stopped && time_left(child) <= 0) {
        stop(child);
      }
    }
  }

  /// Until a case is stopped: it may compute for its allowance, and wait for a processor that others use.
  [[nodiscard]] double time_left(Child const& child) const {
    double const allowed = options_.patience * cases_[child.place]->budget, passed = seconds_since(child.begin);
    return std::min(patience_with_waiting * allowed - passed,
                    std::max(allowed - passed, allowed - computed_by(child.process)));
  }

  /// Takes what is in the pipe; false at its end.
  static bool hear(Child& child) {
    std::array<char, 65536> buffer;
    auto const size = ::read(child.pipe.number(), buffer.data(), buffer.size());
    if (size > 0) child.said.append(buffer.data(), static_cast<std::size_t>(size));
    return size > 0 || (size < 0 && errno == EINTR);
  }

  void end(Child& child) {
    int status = 0;
    rusage used{};
    while (wait4(child.process, &status, 0, &used) < 0 && errno == EINTR) continue;
    Result& result = results_[child.place];
    result.seconds = seconds_since(child.begin);
    result.processor_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
    result.peak_memory = std::int64_t{1024} * used.ru_maxrss;
    auto const document = json_of(child.said);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && !document.is_discarded())
      result.findings = findings_of(document);
    else
      add_error(result.findings, reason(child, status));
    Findings& found = result.findings;
    if (found.rows.empty() && found.plots.empty() && found.work.empty()) add_error(found, "it found nothing");
    if (options_.finished) options_.finished(result, waiting_.size() + running_.size() - 1);
  }

  [[nodiscard]] std::string reason(Child const& child, int status) const {
    double const budget = cases_[child.place]->budget;
    if (interrupted_) return "the suite was stopped by a signal before its end";
    if (child.stopped)
      return fmt::format("stopped: it may compute for {} s, {} times its budget of {} s", options_.patience * budget,
                         options_.patience, budget);
    if (WIFSIGNALED(status))
      return fmt::format("killed by signal {}: {}", WTERMSIG(status), strsignal(WTERMSIG(status)));
    return fmt::format("the process ended with code {} and told nothing", WEXITSTATUS(status));
  }

  std::span<Case const* const> cases_;
  RunOptions const& options_;
  std::vector<Result> results_;
  std::vector<std::size_t> waiting_;  ///< the next one at the back
  std::vector<Child> running_;
  bool interrupted_ = false;
};

}  // namespace

std::vector<Result> run_cases(std::span<Case const* const> cases, RunOptions const& options) {
  return Runner(cases, options).run();
}

}  // namespace talus::verification
