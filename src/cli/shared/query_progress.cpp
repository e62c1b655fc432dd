// SPDX-License-Identifier: MIT
#include "cli/shared/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "cli/shared/words.hpp"

namespace touchstone::cli {

Progress::Progress(const std::vector<Input>& inputs) : visible_(::isatty(STDERR_FILENO) == 1) {
  for (const auto& input : inputs) {
    if (!input.bytes) total_bytes_ = std::nullopt;
    if (total_bytes_) *total_bytes_ += *input.bytes;
  }
}

Progress::~Progress() {
  if (drawn_) print_error("\r\033[K");
}

void Progress::add(std::size_t bytes, std::uint64_t queries) {
  constexpr auto kPause = std::chrono::milliseconds(100);
  bytes_ += bytes;
  queries_ += queries;
  const auto now = Clock::now();
  if (!visible_ || now - last_drawn_ < kPause) return;
  last_drawn_ = now;
  drawn_ = true;
  draw();
}

double Progress::seconds() const noexcept { return std::chrono::duration<double>(Clock::now() - start_).count(); }

void Progress::draw() const {
  constexpr std::size_t kWidth = 24;
  constexpr double kMegabyte = 1e6;
  const double elapsed = seconds();
  std::string line;
  if (total_bytes_ && *total_bytes_ > 0) {
    const double share = std::min(1.0, static_cast<double>(bytes_) / static_cast<double>(*total_bytes_));
    const auto filled = static_cast<std::size_t>(share * kWidth);
    line = fmt::format("[{}{}] {:3.0f} % of {:.0f} MB, ", std::string(filled, '#'), std::string(kWidth - filled, '.'),
                       100 * share, static_cast<double>(*total_bytes_) / kMegabyte);
    if (share > 0) line += fmt::format("{:.0f} s left, ", elapsed / share - elapsed);
  } else {
    line = fmt::format("{:.0f} MB, ", static_cast<double>(bytes_) / kMegabyte);
  }
  const auto rate = static_cast<std::uint64_t>(static_cast<double>(queries_) / elapsed);
  print_error(fmt::format("\r{}{} queries, {} a second\033[K", line, grouped(queries_), grouped(rate)));
  std::fflush(stderr);
}

}  // namespace touchstone::cli
