// Touchstone: judge what a solver claims.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone {

/// What somebody's solver says of one query.
struct Claim {
  bool contact = false;
  std::optional<double> toi;  ///< the time of impact claimed, if any; finite

  /// The time as somebody wrote it, a decimal ("0.1") or a hexfloat, when `toi` is only the nearest double to it.
  /// Empty: the time is `toi`.
  std::string toi_as_written = {};
};

enum class Verdict : std::uint8_t {
  holds,    ///< the claim is true
  missed,   ///< contact denied, but there is one
  phantom,  ///< contact claimed, but there is none
  late      ///< contact claimed rightly, but its toi lies after the exact time: stepping there would pass through
};

std::string_view verdict_name(Verdict verdict) noexcept;  ///< "holds", "missed", "phantom", "late"

/// The verdict on a claim, given the exact answer. A claim without a toi is judged on contact alone. Of a time, only
/// `toi` counts.
Verdict judge(const Claim& claim, const Answer& truth) noexcept;

/// The same with the time as written, compared exactly. The query is asked for its exact time only when the time as
/// written lies strictly between `truth.toi` and `truth.toi_upper`.
/// @param truth  the answer to `query` for t_max = 1
/// @throws InvalidQuery  when `toi_as_written` is no finite number, or has more than 4096 digits in its numerator or
///                       denominator
Verdict judge(const Claim& claim, const Query& query, const Answer& truth);
Verdict judge(const Claim& claim, const RationalQuery& query, const Answer& truth);

}  // namespace touchstone
