// The distance of two elements at one rational time, by rational numbers alone: no root, no sign of a polynomial.
// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/difference.hpp"

namespace touchstone::oracle {

/// The square of the Euclidean distance.
Rational squared_distance_at(const DifferencePolygon& polygon, const Rational& time);

/// The distance in the largest-axis metric.
Rational max_distance_at(const DifferencePolygon& polygon, const Rational& time);

}  // namespace touchstone::oracle
