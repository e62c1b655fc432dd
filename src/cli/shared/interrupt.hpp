// Ctrl-C: stop reading, remove what was half written, and then end as the signal says.
// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

namespace touchstone::cli {

/// Thrown in the place where a command notices that it shall end.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// From now on SIGINT, SIGTERM and SIGHUP are noted, and a write to a closed pipe is an error rather than a signal.
void watch_for_signals();

/// Gives standard streams that the caller has closed a descriptor that nothing can be written to.
void occupy_closed_descriptors();

/// Whether one of them has come.
bool interrupted() noexcept;

/// @throws Interrupted
void throw_if_interrupted();

/// Ends the process by the signal that was noted.
[[noreturn]] void end_by_signal();

}  // namespace touchstone::cli
