// certain_same_side and certain_clearance for one query, with the step's two ends side by side in a pack of two: half
// the operations, the same steps in each lane.
// SPDX-License-Identifier: MIT
#include "filters/apart/same_side.hpp"

#include "numbers/doubles/pack.hpp"

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

/// V and n over the step: their Bernstein coefficients, and the products that bound their errors.
struct PackedForm {
  Ends outer, inner;  ///< b0 and b3; 3 b1 and 3 b2
  EndsVector n, n1;   ///< n0 and n2; 2 n1, in both lanes
  double uw, uwr;
};

TOUCHSTONE_INLINE PackedForm form_of(const Query& query) {
  const auto corner = [&query](std::size_t i) {
    const Vec3& a = query.start[i];
    const Vec3& b = query.end[i];
    return EndsVector{{numbers::pack(a.x, b.x), numbers::pack(a.y, b.y), numbers::pack(a.z, b.z)}};
  };
  const auto [u, w, r] =
      geometry::frame_of(query.kind, [&corner](std::size_t i, std::size_t j) { return corner(i) - corner(j); });
  const EndsVector n = geometry::cross(u, w);
  const EndsVector c = geometry::cross(u, swapped(w));  // u0 x w1 and u1 x w0
  const EndsVector d = swapped(c);
  const EndsVector n1 = {{c[0] + d[0], c[1] + d[1], c[2] + d[2]}};
  const double uw = largest(u) * largest(w);
  return {geometry::dot(n, r), geometry::dot(n1, r) + geometry::dot(n, swapped(r)), n, n1, uw, uw * largest(r)};
}

/// Whether the coefficients have one sign and exceed the bounds.
TOUCHSTONE_INLINE bool exceed(const PackedForm& form, double ends, double middle) {
  const Ends sign = numbers::pack(form.outer.v[0], form.outer.v[0]);
  const auto same = (flipped(form.outer, sign) > numbers::pack(ends, ends)) &
                    (flipped(form.inner, sign) > numbers::pack(middle, middle));
  return (same[0] != 0) & (same[1] != 0);
}

/// certain_clearance, in the same steps.
template <bool Euclidean>
bool clear_all_along(const Query& query, double distance) noexcept {
  const PackedForm form = form_of(query);
  const auto norm = [](const EndsVector& v) {
    if constexpr (Euclidean) return geometry::dot(v, v);
    return magnitude(v[0]) + magnitude(v[1]) + magnitude(v[2]);
  };
  const Ends outer = norm(form.n);
  const double middle_norm = (Euclidean ? 0.25 : 0.5) * norm(form.n1).v[0];
  const double greatest = larger(larger(outer.v[0], outer.v[1]), middle_norm);
  const double kept = distance * (kNormFactor * (Euclidean ? square_root(greatest) : greatest) + kNormBound * form.uw);
  const double ends = kEndsBound * form.uwr + kNormFactor * kept;
  const double middle = kMiddleBound * form.uwr + kNormFactor * (3.0 * kept);
  return norms_in_range(form.uw, form.uwr) & exceed(form, ends, middle);
}

}  // namespace

bool same_side(const Query& query) noexcept {
  if (!has_cubic(query.kind)) return false;
  const PackedForm form = form_of(query);
  const bool in_range = products_in_range(form.uw, form.uwr);
  const bool exceeds = exceed(form, kEndsBound * form.uwr, kMiddleBound * form.uwr);
  return in_range & exceeds;
}

bool clear_all_along(const Query& query, const Separation& separation) noexcept {
  if (!has_cubic(query.kind)) return false;
  return separation.metric == Metric::euclidean ? clear_all_along<true>(query, separation.distance)
                                                : clear_all_along<false>(query, separation.distance);
}

}  // namespace touchstone::filters
