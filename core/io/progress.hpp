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

/// What a run is about to do: its name, its particles, the time [s] and the steps that are behind it already, and the
/// time [s] at which it ends.
struct ProgressPlan {
  std::string title;
  std::int64_t particles = 0;
  double start = 0, end = 0;
  std::int64_t first_step = 0;
  bool quiet = false;
};

/// How far it is: time [s] and steps reached, and the time [s] that has been spent on it.
struct ProgressState {
  double time = 0;
  std::int64_t step = 0;
  double elapsed = 0;
};

/// "t = 0.25 / 1 s   1200 steps   8.1 M particle-steps/s   ETA 0:42", with the share done before it.
[[nodiscard]] std::string progress_text(ProgressPlan const& plan, ProgressState const& state);

/// The same behind a bar, at most `width` characters (without the codes that colour it).
[[nodiscard]] std::string progress_line(ProgressPlan const& plan, ProgressState const& state, int width, bool colour);

/// Shows progress; cheap enough to be told of every step. Writes nothing where the plan says quiet.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Progress(ProgressPlan plan, ProgressOutput output = ProgressOutput::standard_error(),
                    Clock::time_point now = Clock::now());

  /// Time [s] and steps reached. Draws ten times a second on a terminal, every five seconds elsewhere.
  void update(double time, std::int64_t step, Clock::time_point now = Clock::now());

  /// A line of its own, above the progress.
  void say(std::string_view line);

  /// Draws the last state and ends the line.
  void finish(Clock::time_point now = Clock::now());

 private:
  void draw(Clock::time_point now);
  void put(std::string_view text) const;

  ProgressPlan plan_;
  ProgressOutput output_;
  ProgressState state_;
  Clock::time_point begun_, next_;
};

}  // namespace talus::io
