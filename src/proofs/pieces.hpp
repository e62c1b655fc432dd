// Planes that keep two elements apart. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "proofs/elements.hpp"
#include "proofs/proof.hpp"

namespace touchstone::proofs {

/// Pieces that cover [0, end], or [0, end) if `open`, by exact arithmetic. The elements are not in contact there, which
/// `is_true` confirms: it is asked when the search is long. @throws Error  when it does not
std::vector<Piece> separating_pieces(const Elements& elements, const Exact& end, bool open,
                                     const std::function<bool()>& is_true);

/// A direction that separates over all of [0, 1]: u x w, or one of three integers below 2^52.
struct QuickDirection {
  bool normal = false;
  std::array<double, 3> integers{};
};

/// Such a direction, found in doubles; none when doubles do not find one.
std::optional<QuickDirection> quick_direction(const Query& query, const Separation& separation);

}  // namespace touchstone::proofs
