// Planes that keep two elements apart.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "proofs/elements.hpp"
#include "proofs/proof.hpp"

namespace touchstone::proofs {

/// Pieces that cover [0, end], or [0, end) if `open`, by exact arithmetic. The elements are not in contact there, which
/// `is_true` confirms: it is asked when the search is long. @throws Error  when it does not
std::vector<Piece> separating_pieces(const Elements& elements, const Exact& end, bool open,
                                     const std::function<bool()>& is_true);

}  // namespace touchstone::proofs
