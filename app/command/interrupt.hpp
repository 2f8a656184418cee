// Ctrl+C while a command works: what is half-written goes away, then the program dies of the
// signal, as whoever started it expects.
#pragma once

namespace hs::command {

/// A closed pipe and a file grown too large become errors of the write they happen in.
void ignore_failed_writes();

/// From here on SIGINT, SIGTERM and SIGHUP only ask the work to stop; a second one ends it.
void stop_on_signals();

/// Whether the work was asked to stop.
[[nodiscard]] bool stop_requested();

/// Dies of the signal that asked to stop, if there was one.
void die_of_signal();

} // namespace hs::command
