// The checks of answers, by the names that the tests use.
// SPDX-License-Identifier: MIT
#pragma once

#include "certify/answer_check.hpp"

namespace touchstone::tests {

using certify::bit_difference;
using certify::decision_difference;
using certify::kWeightTolerance;
using certify::malformation;
using certify::weight_difference;

}  // namespace touchstone::tests
