// SPDX-License-Identifier: MIT
#include "exact/exact.hpp"
#include "numbers/float_environment.hpp"
#include "proofs/elements.hpp"
#include "proofs/meeting.hpp"
#include "proofs/pieces.hpp"
#include "proofs/proof.hpp"

namespace touchstone::proofs {
namespace {

/// A proof stays one when a direction, the meeting's polynomial, or the weights of one element are multiplied by a
/// positive number. Integers are the shortest text.
void shorten(const Elements& elements, Proof& proof) {
  for (Piece& piece : proof.pieces) {
    auto& n = piece.direction;
    make_short_integers({&n[0], &n[1], &n[2]});
  }
  if (!proof.meeting) return;
  make_short_integers({&proof.meeting->root});
  auto& w = proof.meeting->weights;
  if (elements.is_edge_edge()) {
    make_short_integers({&w[0], &w[1]});
    make_short_integers({&w[2], &w[3]});
  } else {
    make_short_integers({&w[0]});
    make_short_integers({&w[1], &w[2], &w[3]});
  }
}

template <class Q>
Proof prove_exactly(const Q& query, const Answer& answer, const Separation& separation) {
  const Elements elements = elements_of(query, separation);
  const auto is_true = [&] {
    const Answer exact =
        separation.distance > 0 ? exact::decide_exactly(query, 1, separation) : exact::decide_exactly(query, 1);
    return exact.contact == answer.contact && exact.toi == answer.toi && exact.toi_upper == answer.toi_upper;
  };
  Proof proof;
  if (!answer.contact) {
    proof.pieces = separating_pieces(elements, Exact(1), false, is_true);
    shorten(elements, proof);
    return proof;
  }
  const bool is_double = answer.toi == answer.toi_upper;
  if (!is_double || answer.toi > 0) {
    proof.pieces = separating_pieces(elements, Exact(answer.toi), is_double, is_true);
  }
  proof.meeting = meeting(elements, answer);
  shorten(elements, proof);
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
  return prove_exactly(query, answer, separation);
}

Proof prove(const RationalQuery& query, const Answer& answer, const Separation& separation) {
  const numbers::DefaultFloatEnvironment environment;
  return prove_exactly(query, answer, separation);
}

}  // namespace touchstone::proofs
