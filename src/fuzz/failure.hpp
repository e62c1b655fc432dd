// What can be wrong with a reply, given the exact answer.
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

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

using FailureClass = FuzzFailure;
inline constexpr std::size_t kFailureClasses = 9;
inline constexpr std::array<FailureClass, kFailureClasses> kEveryFailure{
    FailureClass::crash, FailureClass::hang,    FailureClass::malformed, FailureClass::missed, FailureClass::late,
    FailureClass::nan,   FailureClass::phantom, FailureClass::early,     FailureClass::differs};

std::string_view failure_name(FailureClass failure) noexcept;  ///< "crash", "missed", ...

/// How far before the exact time a claimed time may lie; without either member, as far as it likes.
struct EarlyLimit {
  std::optional<std::uint64_t> ulps;  ///< doubles between the claim and the answer's toi
  std::optional<double> share;        ///< of the step
};

/// A failure and, for a person, what is wrong where the class alone does not say.
struct Failure {
  FailureClass failure;
  std::string detail;
};

/// What is wrong with this reply to `query`, if anything. `truth` is the exact answer.
std::optional<Failure> failure_of(const Query& query, const Reply& reply, const Answer& truth, const EarlyLimit& early);

/// What is wrong with a whole answer, if anything: everything but its level counts.
std::optional<Failure> failure_of(Kind kind, const Answer& answer, const Answer& truth);

/// Asks the solver and judges what it says; `whole` is the same solver where it gives whole answers, else null.
class AnsweringSolver;
std::optional<Failure> failure_on(const Query& query, SolverUnderTest& solver, AnsweringSolver* whole,
                                  const Answer& truth, const EarlyLimit& early, Reply& reply);

}  // namespace touchstone::fuzz
