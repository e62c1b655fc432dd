// Ctrl-C: a command stops reading, removes half-written files, and then ends by the signal.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <exception>

namespace touchstone::cli {

/// Thrown where a command notices that it has to end.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// From now on SIGINT, SIGTERM and SIGHUP are noted. A write to a closed pipe, or beyond the size of a file that
/// `ulimit -f` allows, is an error instead of a signal.
void watch_for_signals();

/// Opens a read-only descriptor in place of each standard stream that the caller has closed.
void occupy_closed_descriptors();

/// Whether one of these signals has come.
bool interrupted() noexcept;

/// The same as a flag, for calls that take one to end early.
const std::atomic<bool>& interruption() noexcept;

/// @throws Interrupted
void throw_if_interrupted();

/// Ends the process by the signal that was noted.
[[noreturn]] void end_by_signal();

/// Ends it by this one.
[[noreturn]] void end_by_signal(int signal);

}  // namespace touchstone::cli
