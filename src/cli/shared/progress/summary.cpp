// SPDX-License-Identifier: MIT
#include "cli/shared/progress/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "cli/shared/words.hpp"

namespace touchstone::cli {
namespace {

void append(std::string& list, const std::string& item) {
  if (!list.empty()) list += ", ";
  list += item;
}

}  // namespace

void Counts::add(const Answer& answer) noexcept {
  ++queries;
  ++levels[static_cast<std::size_t>(answer.level)];
  ++natures[static_cast<std::size_t>(answer.nature)];
}

void Counts::merge(const Counts& other) noexcept {
  queries += other.queries;
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] += other.levels[i];
  for (std::size_t i = 0; i < natures.size(); ++i) natures[i] += other.natures[i];
  no_doubles += other.no_doubles;
}

std::string decimals_for_person(std::uint64_t no_doubles) {
  return counted(no_doubles, "coordinate") +
         " of the files are decimals that no double equals, and were taken as written; --as-doubles takes the nearest "
         "doubles";
}

std::string summary_line(std::string_view heading, std::string_view text) {
  return fmt::format("  {:<12}{}\n", heading, text);
}

std::string counts_for_person(const Counts& counts) {
  std::string levels;
  for (const Level level : {Level::filter, Level::bracket, Level::exact, Level::oracle}) {
    const auto number = counts.levels[static_cast<std::size_t>(level)];
    if (number > 0)
      append(levels, fmt::format("{} {} ({})", name_of(level), grouped(number), percentage(number, counts.queries)));
  }
  std::string natures;
  for (const Nature nature :
       {Nature::crossing, Nature::grazing, Nature::sustained, Nature::isolated, Nature::entering}) {
    const auto number = counts.natures[static_cast<std::size_t>(nature)];
    if (number > 0) append(natures, fmt::format("{} {}", grouped(number), name_of(nature)));
  }
  const std::uint64_t contacts = counts.queries - counts.natures[static_cast<std::size_t>(Nature::none)];
  return summary_line("contacts", grouped(contacts) + (natures.empty() ? "" : ": " + natures)) +
         summary_line("decided by", levels) +
         (counts.no_doubles > 0 ? summary_line("decimals", decimals_for_person(counts.no_doubles)) : "");
}

std::string speed_for_person(std::uint64_t queries, double seconds, int threads) {
  const auto count = static_cast<double>(queries > 0 ? queries : 1);
  seconds = std::max(seconds, 1e-9);
  return summary_line("time", fmt::format("{:.2f} s: {:.2f} microseconds a query, {} queries a second, {}", seconds,
                                          seconds / count * 1e6, grouped(static_cast<std::uint64_t>(count / seconds)),
                                          counted(static_cast<std::uint64_t>(threads), "thread")));
}

}  // namespace touchstone::cli
