// Vertex v against triangle f0 f1 f2: see geometry/frame.hpp for u, w, r, n and V.
// SPDX-License-Identifier: MIT
#include "exact/elements.hpp"
#include "exact/vectors_at.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::exact {

using geometry::first_numerator;
using geometry::second_numerator;

namespace {
constexpr Kind kKind = Kind::vertex_face;
}

template <class N>
VertexFaceElements<N>::VertexFaceElements(const typename Forms<N>::Corners& corners)
    : corners_(corners),
      frame_(geometry::frame_of(kKind, [&](std::size_t i, std::size_t j) { return difference(corners, i, j); })),
      n_(geometry::normal(frame_)),
      coplanarity_(geometry::dot(n_, frame_.r)) {}

template <class N>
const PointOnEdge<N>& VertexFaceElements<N>::side(std::size_t which) const {
  static constexpr PointOnEdgeNames names[] = {{"(v - f0) x (f1 - f0)", "(v - f0) . (v - f1)"},
                                               {"(v - f1) x (f2 - f1)", "(v - f1) . (v - f2)"},
                                               {"(v - f2) x (f0 - f2)", "(v - f2) . (v - f0)"}};
  return sides_[which].value_or_make(
      [&] { return PointOnEdge<N>(corners_[0], corners_[1 + which], corners_[1 + (which + 1) % 3], names[which]); });
}

template <class N>
bool VertexFaceElements<N>::touching(const MomentOf<Time<N>>& moment, SideSigns& found) const {
  const NonzeroAxis along = nonzero_axis(n_, moment, "n");
  found.axis = along.axis;
  if (found.axis < 0) return side(0).touching(moment) || side(1).touching(moment) || side(2).touching(moment);
  // r = w1 u + w2 w with w1 = (r x w)_k / n_k and w2 = (u x r)_k / n_k; inside iff w1, w2 and 1 - w1 - w2 are >= 0.
  const auto axis = static_cast<std::size_t>(along.axis);
  const auto sign = [&](const Quadratic& x, const char* name) { return along.sign * moment.sign(x, name, along.axis); };
  const Quadratic w1 = first_numerator(frame_, axis);
  if ((found.sign[1] = sign(w1, "(r x w)")) < 0) return false;
  const Quadratic w2 = second_numerator(kKind, frame_, axis);
  if ((found.sign[2] = sign(w2, "(u x r)")) < 0) return false;
  const Quadratic rest = completed(corners_, 1, n_[axis]) - w1 - w2;
  return (found.sign[0] = sign(rest, "n - (r x w) - (u x r)")) >= 0;
}

template <class N>
void VertexFaceElements<N>::locate(const Time<N>& root, const SideSigns& found, Answer& answer) const {
  answer.feature_a = Feature::v;
  answer.weights_a = {1, 0, 0};
  if (found.axis < 0) return locate_flat(root, answer);
  const std::size_t axis = static_cast<std::size_t>(found.axis);
  struct Components {
    Quadratic n;
    std::array<Quadratic, 3> weights;  // times n
  };
  const auto components = [&](std::size_t k) -> Components {
    const Quadratic n = completed(corners_, 1, n_[k]);
    const Quadratic w1 = first_numerator(frame_, k), w2 = second_numerator(kKind, frame_, k);
    return {n, {n - w1 - w2, w1, w2}};
  };
  const Components own = components(axis);
  unsigned support = 0;  // bit i: weight i is positive
  for (unsigned i = 0; i < 3; ++i) {
    if (found.sign[i] != 0) support |= 1U << i;
  }
  answer.feature_b = geometry::kFace.features[support];
  for (unsigned i = 0; i < 3; ++i) {
    if ((support & (1U << i)) != 0) {
      const auto along = [&](std::size_t k) {
        const Components other = components(k);
        return std::pair(other.weights[i], other.n);
      };
      answer.weights_b[i] = support == 1U << i ? 1.0 : quotient_along(root, own.weights[i], own.n, axis, along);
    }
  }
}

template <class N>
void VertexFaceElements<N>::locate_flat(const Time<N>& root, Answer& answer) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (side(i).position(root) == 0) {
      static constexpr Feature corners[] = {Feature::f0, Feature::f1, Feature::f2};
      answer.feature_b = corners[i];
      answer.weights_b[i] = 1;
      return;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (side(i).touching(MomentOf<Time<N>>::at(root))) {
      static constexpr Feature edges[] = {Feature::f01, Feature::f12, Feature::f20};
      answer.feature_b = edges[i];
      const std::array<double, 3> along = side(i).weights(root);
      answer.weights_b[i] = along[0];
      answer.weights_b[(i + 1) % 3] = along[1];
      return;
    }
  }
}

template <class N>
void VertexFaceElements<N>::append_events(Events<N>& events) const {
  // While coplanar, touching starts or stops only on the border of the triangle.
  for (std::size_t i = 0; i < 3; ++i) side(i).append_events(events);
}

TOUCHSTONE_FOR_EACH_NUMBER_TYPE(VertexFaceElements);

}  // namespace touchstone::exact
