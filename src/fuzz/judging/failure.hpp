// The ways in which a reply can be wrong, given the exact answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <touchstone/answer.hpp>
#include <touchstone/fuzz.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

using FailureClass = FuzzFailure;
inline constexpr std::size_t kFailureClasses = 9;
inline constexpr std::array<FailureClass, kFailureClasses> kEveryFailure{
    FailureClass::crash, FailureClass::hang,    FailureClass::malformed, FailureClass::missed, FailureClass::late,
    FailureClass::nan,   FailureClass::phantom, FailureClass::early,     FailureClass::differs};

/// The distance by which a claimed time may lie before the exact time; without either member, any distance.
struct EarlyLimit {
  std::optional<std::uint64_t> ulps;  ///< doubles between the claim and the answer's toi
  std::optional<double> fraction;     ///< of the step
};

/// A failure. `detail` tells a person more than the class alone.
struct Failure {
  FailureClass failure;
  std::string detail;
};

/// The failure of this reply to `query`, if any. `truth` is the exact answer for the separation.
std::optional<Failure> failure_of(const Query& query, const Reply& reply, const Answer& truth, const EarlyLimit& early,
                                  const Separation& separation = {});

/// The failure of a whole answer, if any. Everything except its level counts.
std::optional<Failure> failure_of(Kind kind, const Answer& answer, const Answer& truth, double t_max = 1);

}  // namespace touchstone::fuzz
