// SPDX-License-Identifier: MIT
#include "cli/shared/share_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "cli/shared/interrupt.hpp"
#include "cli/shared/words.hpp"

namespace touchstone::cli {

ShareLine::ShareLine() : visible_(::isatty(STDERR_FILENO) == 1) {}

ShareLine::~ShareLine() {
  if (drawn_) print_error("\r\033[K");
}

void ShareLine::operator()(std::string_view what, double share) {
  throw_if_interrupted();
  constexpr auto kPause = std::chrono::milliseconds(100);
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || now - last_ < kPause) return;
  last_ = now;
  drawn_ = true;
  print_error(fmt::format("\r\033[K{:3.0f} %  {}", 100 * share, what));
  std::fflush(stderr);
}

}  // namespace touchstone::cli
