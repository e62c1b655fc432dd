// Edge a0 a1 against edge b0 b1: see geometry/frame.hpp for u, w, r, n and V.
// SPDX-License-Identifier: MIT
#include "exact/elements.hpp"
#include "exact/vectors_at.hpp"

namespace touchstone::exact {

using geometry::dot;
using geometry::first_numerator;
using geometry::second_numerator;

namespace {
constexpr Kind kKind = Kind::edge_edge;
}

template <class N>
EdgeEdgeElements<N>::EdgeEdgeElements(const typename Forms<N>::Corners& corners)
    : corners_(corners),
      frame_(geometry::frame_of(kKind, [&](std::size_t i, std::size_t j) { return difference(corners, i, j); })),
      n_(geometry::normal(frame_)),
      coplanarity_(dot(n_, frame_.r)) {}

template <class N>
const PointOnEdge<N>& EdgeEdgeElements<N>::pair(Pair which) const {
  static constexpr PointOnEdgeNames names[] = {{"(a0 - b0) x (b1 - b0)", "(a0 - b0) . (a0 - b1)"},
                                               {"(a1 - b0) x (b1 - b0)", "(a1 - b0) . (a1 - b1)"},
                                               {"(b0 - a0) x (a1 - a0)", "(b0 - a0) . (b0 - a1)"},
                                               {"(b1 - a0) x (a1 - a0)", "(b1 - a0) . (b1 - a1)"}};
  return pairs_[which].value_or_make([&] {
    const bool on_b = which == a0_on_b || which == a1_on_b;
    return PointOnEdge<N>(corners_[which], corners_[on_b ? 2 : 0], corners_[on_b ? 3 : 1], names[which]);
  });
}

template <class N>
bool EdgeEdgeElements<N>::touching(const MomentOf<Time<N>>& moment, SideSigns& found) const {
  const NonzeroAxis along = nonzero_axis(n_, moment, "n");
  found.axis = along.axis;
  if (found.axis < 0) {  // parallel or of zero length: they touch exactly when some corner lies on the other edge
    return pair(a0_on_b).touching(moment) || pair(a1_on_b).touching(moment) || pair(b0_on_a).touching(moment) ||
           pair(b1_on_a).touching(moment);
  }
  // The lines meet at f1 = (r x w)_k / n_k on the first edge and f2 = (r x u)_k / n_k on the second; each in [0, 1].
  const auto axis = static_cast<std::size_t>(along.axis);
  const auto sign = [&](const Quadratic& x, const char* name) { return along.sign * moment.sign(x, name, along.axis); };
  const Quadratic f1 = first_numerator(frame_, axis);
  if ((found.sign[0] = sign(f1, "(r x w)")) < 0) return false;
  if ((found.sign[1] = sign(completed(corners_, 0, n_[axis]) - f1, "n - (r x w)")) < 0) return false;
  const Quadratic f2 = second_numerator(kKind, frame_, axis);
  if ((found.sign[2] = sign(f2, "(r x u)")) < 0) return false;
  return (found.sign[3] = sign(completed(corners_, 1, n_[axis]) - f2, "n - (r x u)")) >= 0;
}

template <class N>
void EdgeEdgeElements<N>::locate(const Time<N>& root, const SideSigns& found, Answer& answer) const {
  if (found.axis < 0) return locate_parallel(root, answer);
  const std::size_t axis = static_cast<std::size_t>(found.axis);
  // `element` is 0 or 1; `numerator` gives the fraction along it.
  const auto locate_on = [&](std::size_t element, const auto& numerator, std::array<Feature, 3> names,
                             Feature& feature) -> std::array<double, 3> {
    if (found.sign[2 * element] == 0) {
      feature = names[0];
      return {1, 0, 0};
    }
    if (found.sign[2 * element + 1] == 0) {
      feature = names[1];
      return {0, 1, 0};
    }
    feature = names[2];
    const auto along = [&](std::size_t k) {
      return std::pair(Quadratic(numerator(k)), Quadratic(completed(corners_, element, n_[k])));
    };
    const double weight =
        quotient_along(root, Quadratic(numerator(axis)), completed(corners_, element, n_[axis]), axis, along);
    return {1 - weight, weight, 0};
  };
  const auto f1 = [&](std::size_t k) { return first_numerator(frame_, k); };
  const auto f2 = [&](std::size_t k) { return second_numerator(kKind, frame_, k); };
  answer.weights_a = locate_on(0, f1, {Feature::a0, Feature::a1, Feature::a}, answer.feature_a);
  answer.weights_b = locate_on(1, f2, {Feature::b0, Feature::b1, Feature::b}, answer.feature_b);
}

template <class N>
void EdgeEdgeElements<N>::locate_parallel(const Time<N>& root, Answer& answer) const {
  static constexpr Feature a_features[] = {Feature::a0, Feature::a1, Feature::a};
  static constexpr Feature b_features[] = {Feature::b0, Feature::b1, Feature::b};
  const bool a_is_point = vanishes(frame_.u, root);
  const bool b_is_point = vanishes(frame_.w, root);
  if (a_is_point) {
    answer.feature_a = Feature::a0;
    answer.weights_a = {1, 0, 0};
    answer.feature_b = b_features[pair(a0_on_b).position(root)];  // b0 when the second edge is a point, too
    answer.weights_b = pair(a0_on_b).weights(root);
    return;
  }
  if (b_is_point) {
    answer.feature_b = Feature::b0;
    answer.weights_b = {1, 0, 0};
    answer.feature_a = a_features[pair(b0_on_a).position(root)];
    answer.weights_a = pair(b0_on_a).weights(root);
    return;
  }
  // Both have a length, and they are collinear. They share one point iff a corner of one is a corner of the other and
  // they leave it in opposite directions. Otherwise they share a longer part.
  for (const Pair a_corner : {a0_on_b, a1_on_b}) {
    const PointOnEdge<N>& corner = pair(a_corner);
    if (!corner.touching(MomentOf<Time<N>>::at(root))) continue;
    const int b_position = corner.position(root);
    if (b_position == 2) break;
    // Directions away from the shared corner: +-u and +-w.
    const int direction =
        sign_at(root, dot(frame_.u, frame_.w)) * (a_corner == a0_on_b ? 1 : -1) * (b_position == 0 ? 1 : -1);
    if (direction > 0) break;
    answer.feature_a = a_features[a_corner];
    answer.feature_b = b_features[b_position];
    answer.weights_a = a_corner == a0_on_b ? std::array<double, 3>{1, 0, 0} : std::array<double, 3>{0, 1, 0};
    answer.weights_b = corner.weights(root);
    return;
  }
  locate_overlap(root, answer);
}

/// The lexicographically smallest weights (a0, a1, b0, b1): the end of the shared part that is farthest along a.
template <class N>
void EdgeEdgeElements<N>::locate_overlap(const Time<N>& root, Answer& answer) const {
  answer.feature_a = answer.feature_b = Feature::overlap;
  if (pair(a1_on_b).touching(MomentOf<Time<N>>::at(root))) {
    answer.weights_a = {0, 1, 0};
    answer.weights_b = pair(a1_on_b).weights(root);
    return;
  }
  // The shared part ends at the corner of b that lies farther along a; the other one may be beyond a0.
  const bool same_direction = sign_at(root, dot(frame_.u, frame_.w)) > 0;
  answer.weights_a = pair(same_direction ? b1_on_a : b0_on_a).weights(root);
  answer.weights_b = same_direction ? std::array<double, 3>{0, 1, 0} : std::array<double, 3>{1, 0, 0};
}

template <class N>
void EdgeEdgeElements<N>::append_events(Events<N>& events) const {
  // While coplanar, two edges start or stop touching only where a corner of one lies on the other: a crossing of both
  // interiors at n != 0 persists.
  for (const Pair which : {a0_on_b, a1_on_b, b0_on_a, b1_on_a}) pair(which).append_events(events);
}

TOUCHSTONE_FOR_EACH_NUMBER_TYPE(EdgeEdgeElements);

}  // namespace touchstone::exact
