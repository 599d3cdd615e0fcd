#include "core/io/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace talus::io {

namespace {

using namespace std::chrono_literals;

constexpr std::string_view clear_line = "\r\033[K", green = "\033[32m", plain = "\033[0m";

double share_done(ProgressState const& s) {
  return s.end > s.start ? std::clamp((s.time - s.start) / (s.end - s.start), 0.0, 1.0) : 1.0;
}

/// "8.1 M": three digits and a prefix.
std::string short_number(double value) {
  constexpr std::string_view prefixes[] = {"", " k", " M", " G", " T"};
  std::size_t k = 0;
  for (; value >= 999.5 && k + 1 < std::size(prefixes); ++k) value /= 1000;
  return fmt::format("{:.{}f}{}", value, value < 9.95 && k > 0 ? 1 : 0, prefixes[k]);
}

/// "0:42", "1:02:03".
std::string duration(double seconds) {
  auto const s = static_cast<std::int64_t>(std::ceil(seconds));
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

std::string remaining(double done, double elapsed) {
  if (done >= 1) return "took " + duration(elapsed);
  constexpr double thousand_hours = 3.6e6;
  double const left = elapsed * (1 - done) / done;  // infinite or NaN before the first progress
  return "ETA " + (left < thousand_hours ? duration(left) : "--:--");
}

int width_of(int descriptor) {
  winsize size{};
  bool const known = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

bool is_set(char const* variable) {
  auto const* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

ProgressOutput ProgressOutput::standard_error() {
  auto const* type = std::getenv("TERM");
  bool const terminal = isatty(2) != 0 && type != nullptr && std::string_view(type) != "dumb";
  return {2, terminal, terminal && !is_set("NO_COLOR")};
}

std::string progress_text(ProgressState const& state) {
  auto const rate = state.elapsed > 0 ? static_cast<double>(state.particle_steps) / state.elapsed : 0.0;
  auto const done = share_done(state);
  return fmt::format("{:3.0f} %   t = {:.4g} / {:.4g} s   {} steps   {} particle-steps/s   {}", std::floor(100 * done),
                     state.time, state.end, state.step, short_number(rate), remaining(done, state.elapsed));
}

std::string progress_line(ProgressState const& state, int width, bool colour) {
  auto const text = progress_text(state);
  constexpr int narrowest = 8, widest = 30;
  int const room = std::min(widest, width - static_cast<int>(text.size()) - 3);
  if (room < narrowest) return text.substr(0, static_cast<std::size_t>(std::max(0, width)));
  auto const full = static_cast<int>(share_done(state) * room);
  return fmt::format("[{}{:=<{}}{}{: <{}}] {}", colour ? green : "", "", full, colour ? plain : "", "", room - full,
                     text);
}

Progress::Progress(double start, double end, ProgressOutput output, Clock::time_point now)
    : output_(output),
      state_{.start = start, .end = end, .time = start},
      begun_(now),
      next_(output.terminal ? now : now + 5s) {}

void Progress::update(double time, std::int64_t step, std::int64_t particle_steps, Clock::time_point now) {
  state_.time = time;
  state_.step = step;
  state_.particle_steps = particle_steps;
  if (now >= next_) draw(now);
}

void Progress::say(std::string_view line) {
  put(fmt::format("{}{}\n", output_.terminal ? clear_line : "", line));
  if (output_.terminal) next_ = {};  // draw the line again at once
}

void Progress::finish(Clock::time_point now) {
  draw(now);
  if (output_.terminal) put("\n");
}

void Progress::draw(Clock::time_point now) {
  next_ = now + (output_.terminal ? Clock::duration(100ms) : Clock::duration(5s));
  state_.elapsed = std::chrono::duration<double>(now - begun_).count();
  if (output_.terminal) {
    int const width = width_of(output_.descriptor) - 1;  // a full line would wrap
    put(fmt::format("{}{}", clear_line, progress_line(state_, width, output_.colour)));
  } else {
    put(progress_text(state_) + "\n");
  }
}

/// A closed or full output is no reason to stop a run.
void Progress::put(std::string_view text) const {
  while (!text.empty()) {
    auto const written = ::write(output_.descriptor, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace talus::io
