// The progress of a long command: one line on standard error, which is drawn only when that is a terminal.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace touchstone::cli {

class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;

  /// It is drawn once in `pause` at most, and not before the first of them is over.
  explicit ProgressLine(Clock::duration pause = std::chrono::milliseconds(50));
  ~ProgressLine();  ///< wipes the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Draws `text()` in place of the line, unless it is too early. `text` is called only when the line is drawn. Call
  /// this from one thread at a time.
  void draw(const std::function<std::string()>& text);

  /// Wipes the line until it is drawn again, so that other lines may follow.
  void wipe();

  double seconds() const noexcept;                    ///< since construction
  bool visible() const noexcept { return visible_; }  ///< whether standard error is a terminal

 private:
  Clock::duration pause_;
  bool visible_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_ = start_;
};

/// "[######..................]" for a quarter; a fraction outside [0, 1] counts as the nearer end.
std::string progress_bar(double fraction);

/// A function that draws the current task and the fraction of the whole work that is done: "42 %  drawing". The
/// function throws Interrupted. `line` must outlive it.
std::function<void(std::string_view task, double fraction)> draw_fraction_on(ProgressLine& line);

}  // namespace touchstone::cli
