// What a person reads at the end.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>

#include "certify/tally.hpp"
#include "cli/shared/words.hpp"

namespace touchstone::cli {

/// What a run's answers were and who gave them.
struct Counts {
  std::uint64_t queries = 0;
  std::array<std::uint64_t, 4> levels{};   ///< by Level
  std::array<std::uint64_t, 5> natures{};  ///< by Nature, Nature::none first

  void add(const Answer& answer) noexcept;
  void merge(const Counts& other) noexcept;
};

// Blocks of whole lines:
std::string counts_for_person(const Counts& counts);
std::string speed_for_person(std::uint64_t queries, double seconds, int threads);
std::string verdicts_for_person(const certify::VerdictCounts& verdicts);
std::string early_for_person(const certify::EarlyTally& early);  ///< empty when no claim had a toi

/// One refuted claim and the command that tells its story.
std::string refuted_for_person(const certify::RefutedClaim& refuted);

}  // namespace touchstone::cli
