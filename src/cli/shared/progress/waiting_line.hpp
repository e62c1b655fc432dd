// A line on a terminal that tells what a command waits for, and for how long.
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "cli/shared/progress/progress_line.hpp"

namespace touchstone::cli {

/// While something takes longer than `patience`, a thread draws the line "TEXT, 12 s". Where standard error is no
/// terminal, or no thread can be started, nothing is drawn. Other lines are written only between end() and begin().
class WaitingLine {
 public:
  using Clock = std::chrono::steady_clock;

  explicit WaitingLine(Clock::duration patience = std::chrono::seconds(1));
  ~WaitingLine();
  WaitingLine(const WaitingLine&) = delete;
  WaitingLine& operator=(const WaitingLine&) = delete;

  /// From now on the command waits for `text`.
  void begin(std::string text);

  /// It waits no longer. The line is wiped when this returns.
  void end();

 private:
  void draw();

  Clock::duration patience_;
  std::mutex mutex_;  ///< of all below but the thread
  std::condition_variable changed_;
  ProgressLine line_;
  std::string text_;  ///< empty: nothing is waited for
  Clock::time_point since_;
  bool finished_ = false;
  std::thread thread_;
};

}  // namespace touchstone::cli
