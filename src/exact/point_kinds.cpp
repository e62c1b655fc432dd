// Point against edge, point against point. SPDX-License-Identifier: MIT
#include "exact/elements.hpp"
#include "exact/vectors_at.hpp"

namespace touchstone::exact {

PointEdgeElements::PointEdgeElements(const std::array<Point, 4>& corners)
    : point_(corners[0], corners[1], corners[2], {"(p - e0) x (e1 - e0)", "(p - e0) . (p - e1)"}) {}

void PointEdgeElements::locate(const RealRoot& root, Answer& answer) const {
  static constexpr Feature features[] = {Feature::e0, Feature::e1, Feature::e};
  answer.feature_a = Feature::p;
  answer.weights_a = {1, 0, 0};
  answer.feature_b = features[point_.place(root)];
  answer.weights_b = point_.weights(root);
}

std::vector<Quadratic> PointEdgeElements::events() const {
  std::vector<Quadratic> events;
  point_.append_events(events);
  return events;
}

PointPointElements::PointPointElements(const std::array<Point, 4>& corners) : difference_(corners[0] - corners[1]) {}

bool PointPointElements::touching(const Moment& moment) const {
  return nonzero_axis(difference_, moment, "(p - q)").axis < 0;
}

void PointPointElements::locate(const RealRoot&, Answer& answer) const {
  answer.feature_a = Feature::p;
  answer.feature_b = Feature::q;
  answer.weights_a = answer.weights_b = {1, 0, 0};
}

std::vector<Quadratic> PointPointElements::events() const {
  std::vector<Quadratic> events;
  append_coincidence(difference_, events);
  return events;
}

}  // namespace touchstone::exact
