// How far a long command is: one line on standard error, only when that is a terminal.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string_view>

namespace touchstone::cli {

class ShareLine {
 public:
  ShareLine();
  /// Wipes the line out.
  ~ShareLine();
  ShareLine(const ShareLine&) = delete;
  ShareLine& operator=(const ShareLine&) = delete;

  /// Says what is being done and which share of all is done, ten times a second at most. @throws Interrupted
  void operator()(std::string_view what, double share);

 private:
  const bool visible_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace touchstone::cli
