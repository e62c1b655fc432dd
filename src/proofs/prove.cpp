// SPDX-License-Identifier: MIT
#include <type_traits>

#include "exact/exact.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "proofs/elements.hpp"
#include "proofs/meeting.hpp"
#include "proofs/pieces.hpp"
#include "proofs/proof.hpp"
#include "proofs/quick_proof.hpp"

namespace touchstone::proofs {
namespace {

template <class Q>
Proof prove_exactly(const Q& query, const Answer& answer, const Separation& separation) {
  constexpr Factors kFactors = std::is_same_v<Q, RationalQuery> ? Factors::all : Factors::powers_of_two;
  const Elements elements = elements_of(query, separation);
  const auto is_true = [&] {
    const Answer exact =
        separation.distance > 0 ? exact::decide_exactly(query, 1, separation) : exact::decide_exactly(query, 1);
    return exact.contact == answer.contact && exact.toi == answer.toi && exact.toi_upper == answer.toi_upper;
  };
  Proof proof;
  if (!answer.contact) {
    proof.pieces = separating_pieces(elements, Exact(1), false, is_true);
    shorten(query.kind, kFactors, proof);
    return proof;
  }
  const bool is_double = answer.toi == answer.toi_upper;
  if (!is_double || answer.toi > 0) {
    proof.pieces = separating_pieces(elements, Exact(answer.toi), is_double, is_true);
  }
  proof.meeting = meeting(elements, answer);
  shorten(query.kind, kFactors, proof);
  return proof;
}

}  // namespace

Proof prove(const Query& query, const Answer& answer, const Separation& separation) {
  const numbers::DefaultFloatEnvironment environment;
  if (!answer.contact) {
    if (const auto quick = quick_direction(query, separation)) {
      Proof proof;
      Piece& piece = proof.pieces.emplace_back();
      piece.normal = quick->normal;
      for (std::size_t k = 0; k < 3 && !piece.normal; ++k) piece.direction[k] = {Exact(quick->integers[k])};
      piece.until = Exact(1);
      return proof;
    }
  }
  if (auto quick = quick_proof(query, answer, separation)) return std::move(*quick);
  return prove_exactly(query, answer, separation);
}

Proof prove(const RationalQuery& query, const Answer& answer, const Separation& separation) {
  const numbers::DefaultFloatEnvironment environment;
  return prove_exactly(query, answer, separation);
}

Proof prove(const CurvedQuery& query, const Answer& answer, const Separation& separation) {
  const numbers::DefaultFloatEnvironment environment;
  return prove_exactly(query, answer, separation);
}

}  // namespace touchstone::proofs
