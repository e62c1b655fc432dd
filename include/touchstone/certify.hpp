// Touchstone: judge the claims of a solver.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <touchstone/answer.hpp>

namespace touchstone {

/// A solver's answer to one query, not yet judged.
struct Claim {
  bool contact = false;       ///< Whether the solver claims a contact.
  std::optional<double> toi;  ///< The claimed time of impact, finite; empty when the solver gives none.
};

/// The judgement of a claim.
enum class Verdict : std::uint8_t {
  holds,    ///< the claim is true
  missed,   ///< the claim denies a contact that exists
  phantom,  ///< the claim has a contact that does not exist
  late      ///< the contact exists, but the claimed toi lies after its exact time: a step of that length passes through
};

/// The verdict's name in files and on the command line: "holds", "missed", "phantom" or "late".
std::string_view verdict_name(Verdict verdict) noexcept;

/// The verdict on `claim`, where `truth` is the exact answer to the same query. A claim without a toi is judged by
/// `contact` alone. A toi before the exact time holds, however early it is.
Verdict judge(const Claim& claim, const Answer& truth) noexcept;

}  // namespace touchstone
