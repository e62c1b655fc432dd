// SPDX-License-Identifier: MIT
#include "exact/elements.hpp"
#include "exact/vectors_at.hpp"

namespace touchstone::exact {

void keep_sign(std::vector<CandidateStory::Condition>& record, int sign, const char* name, int axis) {
  std::string full = name;
  if (axis >= 0) full += std::string("_") + "xyz"[axis];
  record.push_back({full, sign});
}

template <class N>
PointOnEdge<N>::PointOnEdge(const Point& p, const Point& x, const Point& y, Names names)
    : from_x_(p - x), from_y_(p - y), edge_(y - x), names_(names) {}

template <class N>
auto PointOnEdge<N>::cross() const -> const Cross& {
  return cross_.value_or_make([&] { return geometry::cross(from_x_, edge_); });
}

template <class N>
auto PointOnEdge<N>::product() const -> const Product& {
  return product_.value_or_make([&] { return geometry::dot(from_x_, from_y_); });
}

template <class N>
bool PointOnEdge<N>::always_beside() const {
  if constexpr (!std::is_same_v<N, AnyDegree>) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &x = from_x_[k], &y = from_y_[k];
      if (sign_of(x[0]) == sign_of(y[0]) && numbers::has_no_root(x) && numbers::has_no_root(y)) return true;
    }
    return sign_of(product()[0]) > 0 && numbers::has_no_root(product());
  }
  return false;
}

template <class N>
bool PointOnEdge<N>::touching(const MomentOf<Time<N>>& moment) const {
  // The product's sign is rarely zero, and zeros take the longest to prove.
  if (moment.sign(product(), names_.dot) > 0) return false;
  for (int k = 0; k < 3; ++k) {
    if (moment.sign(cross()[static_cast<std::size_t>(k)], names_.cross, k) != 0) return false;
  }
  return true;
}

template <class N>
int PointOnEdge<N>::position(const Time<N>& root) const {
  return vanishes(from_x_, root) ? 0 : vanishes(from_y_, root) ? 1 : 2;
}

template <class N>
std::array<double, 3> PointOnEdge<N>::weights(const Time<N>& root) const {
  const int where = position(root);
  if (where == 0) return {1, 0, 0};
  if (where == 1) return {0, 1, 0};
  const double s = root.quotient(geometry::dot(from_x_, edge_), geometry::dot(edge_, edge_));
  return {1 - s, s, 0};
}

template <class N>
void PointOnEdge<N>::append_events(Events<N>& events) const {
  // Touching needs all three components to vanish: the roots of one that is not identically zero contain those times.
  for (const auto& component : cross().c) {
    if (!is_zero(component)) {
      events.add(component);
      return;
    }
  }
  // Always collinear: touching begins and ends where the point passes an end of the edge.
  append_coincidence<N>(from_x_, events);
  append_coincidence<N>(from_y_, events);
}

TOUCHSTONE_FOR_EACH_NUMBER_TYPE(PointOnEdge);

}  // namespace touchstone::exact
