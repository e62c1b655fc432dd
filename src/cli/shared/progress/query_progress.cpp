// SPDX-License-Identifier: MIT
#include "cli/shared/progress/query_progress.hpp"

#include <fmt/format.h>

#include "cli/shared/words.hpp"

namespace touchstone::cli {

QueryProgress::QueryProgress(const std::vector<Input>& inputs) {
  for (const auto& input : inputs) {
    if (!input.bytes) total_bytes_ = std::nullopt;
    if (total_bytes_) *total_bytes_ += *input.bytes;
  }
}

void QueryProgress::add(std::size_t bytes, std::uint64_t queries) {
  bytes_ += bytes;
  queries_ += queries;
  line_.draw([this] { return text(); });
}

std::string QueryProgress::text() const {
  constexpr double kMegabyte = 1e6;
  const double elapsed = seconds();
  std::string text;
  if (total_bytes_ && *total_bytes_ > 0) {
    const double fraction = static_cast<double>(bytes_) / static_cast<double>(*total_bytes_);
    text = fmt::format("{} {:3.0f} % of {:.0f} MB, ", progress_bar(fraction), 100 * fraction,
                       static_cast<double>(*total_bytes_) / kMegabyte);
    if (fraction > 0) text += fmt::format("{:.0f} s left, ", elapsed / fraction - elapsed);
  } else if (bytes_ > 0) {
    text = fmt::format("{:.0f} MB, ", static_cast<double>(bytes_) / kMegabyte);
  }
  const auto rate = static_cast<std::uint64_t>(static_cast<double>(queries_) / elapsed);
  return text + fmt::format("{}, {} a second", counted(queries_, "query"), grouped(rate));
}

}  // namespace touchstone::cli
