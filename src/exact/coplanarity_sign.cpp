// SPDX-License-Identifier: MIT
#include "exact/exact.hpp"
#include "geometry/vector.hpp"
#include "numbers/exact_number.hpp"

namespace touchstone::exact {

int coplanarity_sign(const Query& query, double t) {
  using numbers::Exact;
  using Position = geometry::Vector<Exact>;
  const Exact time(t);
  const auto difference = [&](std::size_t i, std::size_t j) {
    const auto along = [&](double Vec3::*axis) {
      const Exact start = Exact(query.start[i].*axis) - Exact(query.start[j].*axis);
      const Exact end = Exact(query.end[i].*axis) - Exact(query.end[j].*axis);
      return start + time * (end - start);
    };
    return Position{{along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)}};
  };
  const bool edges = query.kind == Kind::edge_edge;
  const Position u = edges ? difference(1, 0) : difference(2, 1);
  const Position w = edges ? difference(3, 2) : difference(3, 1);
  const Position r = edges ? difference(2, 0) : difference(0, 1);
  return numbers::sign_of(geometry::dot(geometry::cross(u, w), r));
}

}  // namespace touchstone::exact
