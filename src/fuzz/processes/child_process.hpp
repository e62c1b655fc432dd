// A process that runs somebody else's code: held at arm's length, never left behind.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace touchstone::fuzz {

/// Runs code in a forked process of its own session, with every descriptor closed but those it is given, nothing to
/// read on standard input, standard output thrown away, standard error kept (its last words), no core dumps, default
/// signal handling and a limit on its memory. It dies with the thread that started it (Linux) and with this object, and
/// so does every process that it has started, daemons included (Linux; elsewhere those of its process group).
class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;

  struct Setup {
    int input = -1;            ///< its standard input; -1: /dev/null
    int output = -1;           ///< its standard output; -1: /dev/null
    int spare = -1;            ///< a further descriptor that stays open
    std::uint64_t memory = 0;  ///< bytes of address space beyond the parent's; 0: no limit
  };

  /// Forks and calls `run` in the child, which ends with status 0 when `run` returns. In a program with several
  /// threads, `run` must be careful: only the calling thread lives on in the child. @throws Error when no process can
  /// be made
  ChildProcess(const Setup& setup, const std::function<void()>& run);

  /// Kills it and whatever it has started, and waits for it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Whether it has ended; does not wait.
  bool ended();

  /// Waits until it has ended or the deadline is over. @returns whether it has ended
  bool wait_until(Clock::time_point deadline);

  /// Ends it by force.
  void kill();

  /// Whether it has ended with exit status 0.
  bool succeeded() const noexcept { return status_ == 0; }

  /// How it ended: "signal 11 (Segmentation fault)", "exit status 3"; and then its last words, if any.
  std::string story();

  /// The last line of its standard error that holds anything, cut after 200 bytes; control characters are escaped.
  std::string last_words();

  /// Reads what it has written to standard error; call it now and then, or a child that says much waits for a reader.
  void drain();

  /// Where its standard error can be waited for: readable when there is something to drain. -1 once it is closed.
  int errors() const noexcept { return errors_ended_ ? -1 : errors_; }

 private:
  void reap(int options);

  pid_t pid_ = -1;             ///< the supervisor's (Linux), which ends as the process does
  std::optional<int> status_;  ///< as waitpid gives it, once it has ended
  int errors_ = -1;            ///< our end of its standard error
  bool errors_ended_ = false;  ///< nobody can write there any more
  std::string tail_;
};

/// Both ends are closed on exec. @throws Error
struct Pipe {
  int read = -1;
  int write = -1;

  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_read() noexcept;
  void close_write() noexcept;
};

/// @throws Error
void set_nonblocking(int descriptor);

/// For a child process that runs somebody else's library: the parent's functions that run at exit belong to the parent,
/// and a library that calls exit() must not run them here.
void leave_at_exit();

/// Closes every descriptor from `first` on.
void close_from(int first);

}  // namespace touchstone::fuzz
