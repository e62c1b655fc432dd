// The elements of two bodies that come near each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>

#include <touchstone/answer.hpp>
#include <touchstone/bodies.hpp>
#include <touchstone/separation.hpp>

#include "rigid/arc.hpp"
#include "rigid/body_data.hpp"

namespace touchstone::rigid {

/// A body on an arc. Two of them are on arcs about their own origins, or on those of turn_together.
struct BodyOnArc {
  BodyIndex number;
  const Body::Impl& body;
  const Arc& arc;
};

/// Two elements, the first one of the sort that comes first in MeshElement, or of the body with the lesser number.
struct NearElements {
  MeshElement first_sort, second_sort;
  BodyElement first, second;
};
using NearConsumer = std::function<void(const NearElements&)>;

/// Hands out the pairs of elements that first_contact asks about, once each, but for pairs that are certainly farther
/// than their separation from each other all along both arcs.
void for_each_near_in_motion(const Bodies& bodies, const BodyOnArc& a, const BodyOnArc& b, const NearConsumer& take);

/// Hands out the pairs of elements that `intersections` asks about, once each, but for pairs that are certainly apart
/// at the starts of both arcs, which go nowhere.
void for_each_near_at_rest(const BodyOnArc& a, const BodyOnArc& b, const NearConsumer& take);

/// Hands out the pairs of elements that `distance` asks about, once each, but for pairs that are certainly farther than
/// `most` from each other at the starts of both arcs, which go nowhere. Nearer ones come first, about. `most` may fall
/// meanwhile.
void for_each_nearer_at_rest(const BodyOnArc& a, const BodyOnArc& b, Metric metric, const std::atomic<double>& most,
                             const NearConsumer& take);

}  // namespace touchstone::rigid
