// SPDX-License-Identifier: MIT
#include "numbers/float_environment.hpp"
#include "proofs/elements.hpp"
#include "proofs/meeting.hpp"
#include "proofs/pieces.hpp"
#include "proofs/proof.hpp"

namespace touchstone::proofs {
namespace {

Proof prove_exactly(const Elements& elements, const Answer& answer) {
  Proof proof;
  if (!answer.contact) {
    proof.pieces = separating_pieces(elements, Exact(1), false);
    return proof;
  }
  const bool is_double = answer.toi == answer.toi_upper;
  if (!is_double || answer.toi > 0) proof.pieces = separating_pieces(elements, Exact(answer.toi), is_double);
  proof.meeting = meeting(elements, answer);
  return proof;
}

}  // namespace

Proof prove(const Query& query, const Answer& answer) {
  const numbers::DefaultFloatEnvironment environment;
  if (!answer.contact) {
    Proof proof;
    proof.pieces = quick_piece(query);
    if (!proof.pieces.empty()) return proof;
  }
  return prove_exactly(elements_of(query), answer);
}

Proof prove(const RationalQuery& query, const Answer& answer) {
  const numbers::DefaultFloatEnvironment environment;
  return prove_exactly(elements_of(query), answer);
}

}  // namespace touchstone::proofs
