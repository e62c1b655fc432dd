// certain_same_side for one query, with the step's two ends side by side in a pack of two: half the operations, the
// same steps in each lane. SPDX-License-Identifier: MIT
#include "filters/same_side.hpp"

#include "numbers/pack.hpp"

namespace touchstone::filters {
namespace {

using Ends = numbers::Pack<2>;  // at t = 0 and at t = 1
using EndsVector = geometry::Vector<Ends>;

EndsVector swapped(const EndsVector& a) {
  return {{numbers::swapped(a[0]), numbers::swapped(a[1]), numbers::swapped(a[2])}};
}

/// The largest absolute coordinate at either end.
double largest(const EndsVector& a) {
  const Ends both = larger(larger(magnitude(a[0]), magnitude(a[1])), magnitude(a[2]));
  return larger(both.v[0], both.v[1]);
}

}  // namespace

bool same_side(const Query& query) noexcept {
  if (!has_cubic(query.kind)) return false;
  const auto corner = [&query](std::size_t i) {
    const Vec3& a = query.start[i];
    const Vec3& b = query.end[i];
    return EndsVector{{numbers::pack(a.x, b.x), numbers::pack(a.y, b.y), numbers::pack(a.z, b.z)}};
  };
  const auto [u, w, r] = geometry::frame_of(query.kind == Kind::edge_edge,
                                            [&corner](std::size_t i, std::size_t j) { return corner(i) - corner(j); });
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

bool clear_all_along(const Query& query, const Separation& separation) noexcept {
  if (!has_cubic(query.kind)) return false;
  const StepFrame<double> frame = frame_of(query);
  return separation.metric == Metric::euclidean ? certain_clearance<true>(frame, separation.distance)
                                                : certain_clearance<false>(frame, separation.distance);
}

}  // namespace touchstone::filters
