// Touchstone: judge what a solver claims.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <touchstone/answer.hpp>

namespace touchstone {

/// What somebody's solver says of one query.
struct Claim {
  bool contact = false;
  std::optional<double> toi;  ///< the time of impact claimed, if any; finite
};

enum class Verdict : std::uint8_t {
  holds,    ///< the claim is true
  missed,   ///< contact denied, but there is one
  phantom,  ///< contact claimed, but there is none
  late      ///< contact claimed rightly, but its toi lies after the exact time: stepping there would pass through
};

std::string_view verdict_name(Verdict verdict) noexcept;  ///< "holds", "missed", "phantom", "late"

/// The verdict on a claim, given the exact answer. A claim without a toi is judged on contact alone.
Verdict judge(const Claim& claim, const Answer& truth) noexcept;

}  // namespace touchstone
