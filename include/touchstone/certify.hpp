// Touchstone: judge the claims of a solver.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/names.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// A solver's answer to one query, not yet judged.
struct Claim {
  bool contact = false;       ///< Whether the solver claims a contact.
  std::optional<double> toi;  ///< The claimed time of impact, finite; empty when the solver gives none.

  /// The time as the solver wrote it, a decimal ("0.1") or a hexfloat. It is needed when `toi` is only the nearest
  /// double to that number. If it is empty, the time is `toi`.
  std::string toi_as_written = {};
};

/// The judgement of a claim.
enum class Verdict : std::uint8_t {
  holds,    ///< the claim is true
  missed,   ///< the claim denies a contact that exists
  phantom,  ///< the claim has a contact that does not exist
  late      ///< the contact exists, but the claimed toi lies after its exact time: a step of that length passes through
};

/// "holds", "missed", "phantom", "late".
template <>
Names names_of<Verdict>() noexcept;

/// The verdict on `claim`, where `truth` is the exact answer to the same query. A claim without a toi is judged by
/// `contact` alone. A toi before the exact time holds, however early it is. `toi_as_written` is not read.
Verdict judge(const Claim& claim, const Answer& truth) noexcept;

/// The verdict with the time as written, compared exactly. The exact time is computed only when the time as written
/// lies strictly between `truth.toi` and `truth.toi_upper`.
/// @param claim  the claim on `query`
/// @param query  the query that was asked
/// @param truth  the exact answer to `query` for t_max = 1 and for the separation
/// @param separation  the separation that the claim is about
/// @throws InvalidQuery  when `toi_as_written` is no finite number, or has more than 4096 digits in its numerator or
///                       denominator
Verdict judge(const Claim& claim, const Query& query, const Answer& truth, const Separation& separation = {});

/// The same for rational coordinates.
Verdict judge(const Claim& claim, const RationalQuery& query, const Answer& truth, const Separation& separation = {});

/// The same for curved motion.
Verdict judge(const Claim& claim, const CurvedQuery& query, const Answer& truth, const Separation& separation = {});

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
