// Proofs of answers: what they are, and how they are found. docs/proofs.md says why they prove.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "proofs/dense.hpp"

namespace touchstone::proofs {

/// A plane that keeps the elements apart from the end of the piece before, or 0, until `until`.
struct Piece {
  bool normal = false;    ///< the plane's direction is u x w; the rest of the direction is then not used
  DenseVector direction;  ///< the plane's direction, a polynomial in t
  Exact until;
};

/// A proof that the elements touch at a root of a polynomial: a point of one element, given by weights of its corners,
/// is then a point of the other.
struct Meeting {
  Dense root;                    ///< changes its sign between low and high; empty when the time is a double
  Exact low, high;               ///< within toi and toi_upper
  std::array<Dense, 4> weights;  ///< of the corners; those of each element have a positive sum
};

/// The proof of an answer.
struct Proof {
  std::vector<Piece> pieces;       ///< no contact before the first one, or none at all
  std::optional<Meeting> meeting;  ///< with contact
};

/// A proof of the answer of `solve` to a valid query over [0, 1] with this separation. Every answer has one; a false
/// answer has none. @throws Error  for an answer that has none, after a long search
Proof prove(const Query& query, const Answer& answer, const Separation& separation = {});
Proof prove(const RationalQuery& query, const Answer& answer, const Separation& separation = {});
Proof prove(const CurvedQuery& query, const Answer& answer, const Separation& separation = {});

}  // namespace touchstone::proofs
