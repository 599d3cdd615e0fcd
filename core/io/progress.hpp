#pragma once
/// How far a run is: one line that is drawn again and again on a terminal, plain lines elsewhere.

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace talus::io {

/// Where progress goes and what may be done there.
struct ProgressOutput {
  int descriptor = 2;
  bool terminal = false, colour = false;

  /// Standard error as it is: a line that is redrawn only on a terminal (not TERM=dumb), colour only without NO_COLOR.
  [[nodiscard]] static ProgressOutput standard_error();
};

/// How far a run is. Times of the simulation in s: where this process began, where the run ends, what is reached;
/// `elapsed` [s] is the time spent on it, `particle_steps` the particles moved in all steps of this process.
struct ProgressState {
  double start = 0, end = 0, time = 0;
  std::int64_t step = 0, particle_steps = 0;
  double elapsed = 0;
};

/// "t = 0.25 / 1 s   1200 steps   8.1 M particle-steps/s   ETA 0:42", with the share done before it.
[[nodiscard]] std::string progress_text(ProgressState const& state);

/// The same behind a bar, at most `width` characters (without the codes that colour it).
[[nodiscard]] std::string progress_line(ProgressState const& state, int width, bool colour);

/// Shows progress; cheap enough to be told of every step.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// Simulated time [s] from which this process goes on, and at which the run ends.
  Progress(double start, double end, ProgressOutput output, Clock::time_point now = Clock::now());

  /// Time [s] and steps reached, particles moved in all steps of this process. Draws ten times a second on a terminal,
  /// every five seconds elsewhere.
  void update(double time, std::int64_t step, std::int64_t particle_steps, Clock::time_point now = Clock::now());

  /// A line of its own, above the progress.
  void say(std::string_view line);

  /// Draws the last state and ends the line.
  void finish(Clock::time_point now = Clock::now());

 private:
  void draw(Clock::time_point now);
  void put(std::string_view text) const;

  ProgressOutput output_;
  ProgressState state_;
  Clock::time_point begun_, next_;
};

}  // namespace talus::io
