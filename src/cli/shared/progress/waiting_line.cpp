// SPDX-License-Identifier: MIT
#include "cli/shared/progress/waiting_line.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace touchstone::cli {

WaitingLine::WaitingLine(Clock::duration patience) : patience_(patience) {
  if (!line_.visible()) return;
  try {
    thread_ = std::thread([this] { draw(); });
  } catch (const std::system_error&) {  // a limit of threads: the work goes on without the line
  }
}

WaitingLine::~WaitingLine() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void WaitingLine::begin(std::string text) {
  const std::lock_guard lock(mutex_);
  text_ = std::move(text);
  since_ = Clock::now();
}

void WaitingLine::end() {
  const std::lock_guard lock(mutex_);
  text_.clear();
  line_.wipe();
}

void WaitingLine::draw() {
  constexpr auto kPause = std::chrono::milliseconds(250);
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, kPause, [this] { return finished_; })) {
    const Clock::duration waited = Clock::now() - since_;
    if (text_.empty() || waited < patience_) continue;
    line_.draw([&] {
      return fmt::format("{}, {} s", text_, std::chrono::duration_cast<std::chrono::seconds>(waited).count());
    });
  }
}

}  // namespace touchstone::cli
