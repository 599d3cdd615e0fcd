#pragma once
/// Signals that ask the program to stop: SIGINT, SIGTERM and, of a terminal that is closed, SIGHUP.

namespace talus::cli {

/// From now on such a signal is noted, and does not end the program. One that is ignored stays so (nohup). Called before
/// anything is written, so that no signal finds a folder half made.
void note_stop_signals();

/// Whether one has come.
[[nodiscard]] bool stop_asked();

}  // namespace talus::cli
