// Frames of edge-edge queries and their cubics, in doubles and exactly, for searches over the filters' bounds.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "filters/bernstein_cubic.hpp"
#include "filters/bound_search.hpp"
#include "filters/coplanarity_form.hpp"
#include "filters/step_frame.hpp"
#include "numbers/integers/exact_number.hpp"

namespace touchstone::tests {

using numbers::Exact;

/// An edge-edge query from 24 doubles, its frame, and the exact Bernstein coefficients of V, each times 3 when inner.
struct FrameCase {
  Query query;
  filters::StepFrame<double> frame;
  struct {
    double u, w, r;
  } size;                                          ///< bounds of the coordinates of u, w, r
  std::array<std::array<Exact, 3>, 3> start, end;  // u, w, r
  std::array<Exact, 4> exact;                      // b0, 3 b1, 3 b2, b3

  explicit FrameCase(const std::vector<double>& x) {
    for (std::size_t i = 0; i < 4; ++i) {
      query.start[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
      query.end[i] = {x[12 + 3 * i], x[12 + 3 * i + 1], x[12 + 3 * i + 2]};
    }
    static constexpr std::size_t kMinuend[] = {1, 3, 2};
    static constexpr std::size_t kSubtrahend[] = {0, 2, 0};
    filters::Vector* rounded[2][3] = {{&frame.start.u, &frame.start.w, &frame.start.r},
                                      {&frame.end.u, &frame.end.w, &frame.end.r}};
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double a = x[12 * side + 3 * kMinuend[v] + k], b = x[12 * side + 3 * kSubtrahend[v] + k];
          (*rounded[side][v])[k] = a - b;
          (side == 0 ? start : end)[v][k] = Exact(a) - Exact(b);
        }
      }
    }
    size = {filters::largest(frame.start.u, frame.end.u), filters::largest(frame.start.w, frame.end.w),
            filters::largest(frame.start.r, frame.end.r)};
    exact[0] = determinant(start[0], start[1], start[2]);
    exact[1] = determinant(start[0], end[1], start[2]) + determinant(end[0], start[1], start[2]) +
               determinant(start[0], start[1], end[2]);
    exact[2] = determinant(end[0], end[1], start[2]) + determinant(start[0], end[1], end[2]) +
               determinant(end[0], start[1], end[2]);
    exact[3] = determinant(end[0], end[1], end[2]);
  }

  using Vector = std::array<Exact, 3>;
  static Exact determinant(const Vector& a, const Vector& b, const Vector& c) {
    return a[0] * b[1] * c[2] + a[1] * b[2] * c[0] + a[2] * b[0] * c[1] - a[2] * b[1] * c[0] - a[0] * b[2] * c[1] -
           a[1] * b[0] * c[2];
  }

  /// Whether it is in the range of the bracket level.
  bool usable() const {
    return std::min({size.u, size.w, size.r}) >= 0x1p-250 && std::max({size.u, size.w, size.r}) <= 0x1p250;
  }
  filters::BernsteinCubic cubic() const { return {filters::coplanarity_coefficients(frame), size.u * size.w * size.r}; }

  /// The blossom of V: its Bernstein coefficients over [p, q] are those of (p p p), (p p q), (p q q), (q q q).
  Exact blossom(const Exact& a, const Exact& b, const Exact& c) const {
    const Exact one(1);
    const Exact na = one - a, nb = one - b, nc = one - c;
    // Times 3, so that no division is needed.
    return Exact(3) * exact[0] * na * nb * nc + exact[1] * (a * nb * nc + na * b * nc + na * nb * c) +
           exact[2] * (a * b * nc + a * nb * c + na * b * c) + Exact(3) * exact[3] * a * b * c;
  }

  /// V, V' and V'', three times each.
  Exact value(const Exact& t) const { return blossom(t, t, t); }
  Exact slope(const Exact& t) const { return Exact(3) * (blossom(t, t, Exact(1)) - blossom(t, t, Exact(0))); }
  Exact second(const Exact& t) const {
    const Exact zero(0), one(1);
    return Exact(6) * (blossom(t, one, one) - Exact(2) * blossom(t, zero, one) + blossom(t, zero, zero));
  }

  /// A coordinate of vector v (u, w or r) at a time.
  Exact at(std::size_t v, std::size_t k, const Exact& t) const { return start[v][k] + t * (end[v][k] - start[v][k]); }
  /// Coordinate k of the cross product of vectors a and b at a time.
  Exact cross(std::size_t a, std::size_t b, std::size_t k, const Exact& t) const {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return at(a, i, t) * at(b, j, t) - at(a, j, t) * at(b, i, t);
  }
};

inline double over(const Exact& error, double bound) {
  return std::fabs(numbers::approximate_quotient(error, Exact(bound)));
}

/// A number in [0, 1] from any double; the ends are frequent.
inline double share(double x) {
  int exponent = 0;
  const double s = 2 * std::fabs(std::frexp(x, &exponent)) - 1;  // in [0, 1)
  return s < 0.125 ? 0 : s > 0.875 ? 1 : (s - 0.125) / 0.75;
}

/// A time for a BernsteinCubic.
inline double time_from(double x) { return filters::exact_to_one(share(x)); }

/// Searches over the 24 coordinates and `more` numbers besides, with so many steps at most from a start, among samples
/// for which `usable` says that the level works on them.
template <class Usable, class Ratio>
BoundSearch searched(std::uint64_t seed, std::size_t more, int steps, const Usable& usable, const Ratio& ratio) {
  Rng rng(seed);
  BoundSearch search;
  const auto measured = [&](const std::vector<double>& x) {
    const FrameCase sample(x);
    return usable(sample) ? ratio(sample, x) : std::nan("");
  };
  if (!kLongSearches) steps = 200;
  search_bound(search, rng, 24 + more, 0, 0, 3, steps, measured);
  // At 2^-346 products of three are subnormal, and the level must keep its hands off.
  for (const int exponent : {40, -40, 200, -200, -346}) {
    search_bound(search, rng, 24 + more, exponent, 0, 1, steps / 10, measured);
  }
  search_bound(search, rng, 24 + more, 0, 20, 2, steps / 10, measured);
  return search;
}

}  // namespace touchstone::tests
