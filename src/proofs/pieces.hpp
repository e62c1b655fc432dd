// Planes that keep two elements apart. SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "proofs/elements.hpp"
#include "proofs/proof.hpp"

namespace touchstone::proofs {

/// Pieces that cover [0, end], or [0, end) if `open`, by exact arithmetic. The elements do not touch there.
/// @throws Error  when they seem to touch
std::vector<Piece> separating_pieces(const Elements& elements, const Exact& end, bool open);

/// One piece that covers [0, 1], found in doubles; none when doubles do not find one.
std::vector<Piece> quick_piece(const Query& query);

}  // namespace touchstone::proofs
