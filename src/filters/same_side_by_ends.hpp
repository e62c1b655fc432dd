// certain_same_side for one query, with the step's two ends side by side: half the operations, the same steps in each lane.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "filters/coplanarity_form.hpp"
#include "numbers/pack.hpp"

namespace touchstone::filters {
namespace {

using Ends = numbers::Pack<2>;  // at t = 0 and at t = 1
using EndsVector = geometry::Vector<Ends>;

inline EndsVector operator-(const EndsVector& a, const EndsVector& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
inline EndsVector swapped(const EndsVector& a) {
  return {{numbers::swapped(a[0]), numbers::swapped(a[1]), numbers::swapped(a[2])}};
}

/// The largest absolute coordinate at either end.
inline double largest(const EndsVector& a) {
  const Ends both = larger(larger(magnitude(a[0]), magnitude(a[1])), magnitude(a[2]));
  return larger(both.v[0], both.v[1]);
}

/// certain_same_side(frame, coplanarity_coefficients(frame)) of the query's frame, for a kind that has a cubic.
inline bool certain_same_side_by_ends(const Query& query) noexcept {
  const auto corner = [&query](std::size_t i) {
    const Vec3& a = query.start[i];
    const Vec3& b = query.end[i];
    return EndsVector{{numbers::pack(a.x, b.x), numbers::pack(a.y, b.y), numbers::pack(a.z, b.z)}};
  };
  const bool edges = query.kind == Kind::edge_edge;
  const EndsVector x0 = corner(0), x1 = corner(1), x2 = corner(2), x3 = corner(3);
  const EndsVector u = edges ? x1 - x0 : x2 - x1;
  const EndsVector w = edges ? x3 - x2 : x3 - x1;
  const EndsVector r = edges ? x2 - x0 : x0 - x1;
  const EndsVector n = geometry::cross(u, w);
  const EndsVector c = geometry::cross(u, swapped(w));  // u0 x w1 and u1 x w0
  const EndsVector d = swapped(c);
  const EndsVector n1 = {{c[0] + d[0], c[1] + d[1], c[2] + d[2]}};
  const Ends outer = geometry::dot(n, r);                                  // b0 and b3
  const Ends inner = geometry::dot(n1, r) + geometry::dot(n, swapped(r));  // 3 b1 and 3 b2

  const double uw = largest(u) * largest(w);
  const double uwr = uw * largest(r);
  const bool valid = products_in_range(uw, uwr);
  const double ends = kEndsBound * uwr;
  const double middle = kMiddleBound * uwr;
  const Ends sign = numbers::pack(outer.v[0], outer.v[0]);
  const auto same =
      (flipped(outer, sign) > numbers::pack(ends, ends)) & (flipped(inner, sign) > numbers::pack(middle, middle));
  return valid & (same[0] != 0) & (same[1] != 0);
}

}  // namespace
}  // namespace touchstone::filters
