// Comparing two answers, and checking one by itself. Each function returns an empty string when all is
// well and one sentence otherwise.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::certify {

/// Two weights that are each within 2^-50 of the same number differ by at most this.
constexpr double kWeightTolerance = 0x1p-49;

/// Differences in contact, times, nature and features.
std::string decision_difference(const Answer& one, const Answer& other);

/// Differences in the weights by more than kWeightTolerance.
std::string weight_difference(const Answer& one, const Answer& other);

/// Differences in any field, compared bit for bit; with `levels`, the level too.
std::string bit_difference(const Answer& one, const Answer& other, bool levels);

/// What is wrong with the answer by itself: times that are not neighbouring doubles or lie outside [0, t_max], features
/// that the kind does not have, weights outside [0, 1], off their feature or not summing to 1.
std::string malformation(Kind kind, const Answer& answer, double t_max);

}  // namespace touchstone::certify
