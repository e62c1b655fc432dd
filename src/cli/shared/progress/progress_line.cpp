// SPDX-License-Identifier: MIT
#include "cli/shared/progress/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"

namespace touchstone::cli {
namespace {

constexpr const char* kWipe = "\r\033[K";  // to the start of the line, and erase to its end

}  // namespace

ProgressLine::ProgressLine(Clock::duration pause) : pause_(pause), visible_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() { wipe(); }

void ProgressLine::wipe() {
  if (drawn_) print_error(kWipe);
  drawn_ = false;
}

void ProgressLine::draw(const std::function<std::string()>& text) {
  const auto now = Clock::now();
  if (!visible_ || now - last_drawn_ < pause_) return;
  last_drawn_ = now;
  drawn_ = true;
  print_error(kWipe + text());
}

double ProgressLine::seconds() const noexcept { return std::chrono::duration<double>(Clock::now() - start_).count(); }

std::string progress_bar(double fraction) {
  constexpr std::size_t kWidth = 24;
  const auto filled = static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * kWidth);
  std::string bar = "[";
  bar.append(filled, '#').append(kWidth - filled, '.');
  return bar + "]";
}

std::function<void(std::string_view, double)> draw_fraction_on(ProgressLine& line) {
  return [&line](std::string_view task, double fraction) {
    throw_if_interrupted();
    line.draw([&] { return fmt::format("{:3.0f} %  {}", 100 * fraction, task); });
  };
}

}  // namespace touchstone::cli
