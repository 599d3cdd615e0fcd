#include "core/cli/stopping.hpp"

#include <csignal>
#include <initializer_list>

namespace talus::cli {

namespace {

volatile std::sig_atomic_t stop_signal = 0;

extern "C" void note_signal(int number) {
  stop_signal = number;
}

}  // namespace

void note_stop_signals() {
  for (int const number : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(number, note_signal) == SIG_IGN) std::signal(number, SIG_IGN);
}

bool stop_asked() {
  return stop_signal != 0;
}

}  // namespace talus::cli
