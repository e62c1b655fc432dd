// The ways in which a reply can be wrong, given the exact answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/fuzz.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "certify/time_errors.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

using FailureClass = FuzzFailure;
inline constexpr std::size_t kFailureClasses = 9;
inline constexpr std::array<FailureClass, kFailureClasses> kEveryFailure{
    FailureClass::crash, FailureClass::hang,    FailureClass::malformed, FailureClass::missed, FailureClass::late,
    FailureClass::nan,   FailureClass::phantom, FailureClass::early,     FailureClass::differs};

/// What a reply may be without being a failure.
struct Allowance : certify::Counting<FailureClass> {
  certify::TimeLimit early;  ///< how far before the exact time
  /// A contact that does not exist, where the elements come within this part of the query's greatest coordinate of
  /// being in contact.
  double near = 0;
  /// An answer that is right for a query whose first element is moved by this length, plus this part of the greatest
  /// coordinate. A phantom is so where the elements come within that distance of being in contact.
  double moved = 0;
  double moved_relative = 0;
};

/// A failure. `detail` tells a person more than the class alone.
struct Failure {
  FailureClass failure;
  std::string detail;
};

/// The failure of this reply to `query`, if any. `truth` is the exact answer for the separation.
std::optional<Failure> failure_of(const Query& query, const Reply& reply, const Answer& truth,
                                  const certify::TimeLimit& early, const Separation& separation = {});

/// The failure of a whole answer, if any. Everything except its level counts.
std::optional<Failure> failure_of(Kind kind, const Answer& answer, const Answer& truth, double t_max = 1);

}  // namespace touchstone::fuzz
