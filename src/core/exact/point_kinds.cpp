// Point against edge, point against point.
// SPDX-License-Identifier: MIT
#include "exact/elements.hpp"
#include "exact/vectors_at.hpp"

namespace touchstone::exact {

template <class N>
PointEdgeElements<N>::PointEdgeElements(const typename Forms<N>::Corners& corners)
    : point_(corners[0], corners[1], corners[2], {"(p - e0) x (e1 - e0)", "(p - e0) . (p - e1)"}) {}

template <class N>
void PointEdgeElements<N>::locate(const Time<N>& root, const SideSigns&, Answer& answer) const {
  static constexpr Feature features[] = {Feature::e0, Feature::e1, Feature::e};
  answer.feature_a = Feature::p;
  answer.weights_a = {1, 0, 0};
  answer.feature_b = features[point_.position(root)];
  answer.weights_b = point_.weights(root);
}

template <class N>
void PointEdgeElements<N>::append_events(Events<N>& events) const {
  point_.append_events(events);
}

template <class N>
PointPointElements<N>::PointPointElements(const typename Forms<N>::Corners& corners)
    : difference_(corners[0] - corners[1]) {}

template <class N>
bool PointPointElements<N>::touching(const MomentOf<Time<N>>& moment) const {
  return nonzero_axis(difference_, moment, "(p - q)").axis < 0;
}

template <class N>
void PointPointElements<N>::locate(const Time<N>&, const SideSigns&, Answer& answer) const {
  answer.feature_a = Feature::p;
  answer.feature_b = Feature::q;
  answer.weights_a = answer.weights_b = {1, 0, 0};
}

template <class N>
void PointPointElements<N>::append_events(Events<N>& events) const {
  append_coincidence<N>(difference_, events);
}

TOUCHSTONE_FOR_EACH_NUMBER_TYPE(PointEdgeElements);
TOUCHSTONE_FOR_EACH_NUMBER_TYPE(PointPointElements);

}  // namespace touchstone::exact
