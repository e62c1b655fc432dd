// The counts and the speed of a run, as text for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <touchstone/answer.hpp>

namespace touchstone::cli {

/// The answers of a run, counted by level and by nature.
struct Counts {
  std::uint64_t queries = 0;
  std::array<std::uint64_t, 4> levels{};   ///< by Level
  std::array<std::uint64_t, 6> natures{};  ///< by Nature, Nature::none first
  std::uint64_t no_doubles = 0;            ///< coordinates that are decimals, taken as written, and no doubles

  void add(const Answer& answer) noexcept;
  void merge(const Counts& other) noexcept;
};

/// One line of a summary, with its line feed.
std::string summary_line(std::string_view heading, std::string_view text);

/// What `no_doubles` coordinates were taken for.
std::string decimals_for_person(std::uint64_t no_doubles);

// Blocks of whole lines:
std::string counts_for_person(const Counts& counts);
/// @param threads  those that worked
std::string speed_for_person(std::uint64_t queries, double seconds, int threads);
}  // namespace touchstone::cli
