// Proofs of the usual answers, in doubles and in integers of fixed size.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "proofs/proof.hpp"

namespace touchstone::proofs {

/// A direction that separates over all of [0, 1]: u x w, or one of three integers below 2^52.
struct QuickDirection {
  bool normal = false;
  std::array<double, 3> integers{};
};

/// Such a direction, found in doubles; none when doubles do not find one.
std::optional<QuickDirection> quick_direction(const Query& query, const Separation& separation);

/// A proof of the answer; none when it is not found. Without contact: a few pieces, found in doubles. For two edges, or
/// a vertex and a face, that come into contact between their ends: the points that do, in integers of fixed size. With
/// a separation in the metric `max`, contacts have no such proof.
std::optional<Proof> quick_proof(const Query& query, const Answer& answer, const Separation& separation);

/// A proof stays one when a direction, the meeting's polynomial, or the weights of one element are multiplied by a
/// positive number. Integers are the shortest text.
enum class Factors {
  powers_of_two,  ///< integers, not all of them even
  all,            ///< integers without a common factor. Coordinates in fractions have many: the denominators of others
};
void shorten(Kind kind, Factors factors, Proof& proof);

}  // namespace touchstone::proofs
