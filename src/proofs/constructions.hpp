// Points of two elements that may be in contact at the first time of a contact.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "proofs/elements.hpp"

namespace touchstone::proofs {

/// Weights of the corners, which give a point of each element where those of each element have one sign, and the times
/// at which a contact of these points may begin.
struct Construction {
  std::array<Dense, 4> weights;  ///< none for a corner whose weight is zero

  /// At such a time all polynomials of one of these lists vanish. Without a separation, and with a Euclidean one, there
  /// is one list: the points are in contact where all of its polynomials are zero, or, with a separation, not positive.
  std::vector<std::vector<Dense>> events;
};

/// Whether constructions in the metric `max` need their events.
enum class Events { needed, unneeded };

/// Calls `try_one` with constructions to one of which the first contact belongs, until it returns true; docs/proofs.md
/// says why. In the metric `max` there may be dozens; those that seem to exist at the time come first.
void try_constructions(const Elements& elements, const Exact& time, Events events,
                       const std::function<bool(const Construction&)>& try_one);

/// The sums of the weights over each element, each times the corner's own weight: they are positive where the weighted
/// points are.
std::array<Dense, 2> sums_of(const Elements& elements, const std::array<Dense, 4>& weights);

/// In the metric `max` and with a separation: the six polynomials that are not negative where the weighted points are
/// in contact, given that the weights of each element have a positive sum. Otherwise none.
std::vector<Dense> conditions(const Elements& elements, const std::array<Dense, 4>& weights);

}  // namespace touchstone::proofs
