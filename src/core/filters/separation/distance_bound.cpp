// SPDX-License-Identifier: MIT
#include "filters/separation/distance_bound.hpp"

#include <cmath>

#include "filters/separation/entry_step.hpp"

namespace touchstone::filters {
namespace {

// Let e = 2^-53. At a time t, a coordinate of r, u or w is (1 - t) a + t b for the differences a and b at both ends. It
// is off by less than 4 e (|a| + |b|), for the difference, 1 - t, the product and the sum, but for terms of second
// order, as all below. Let S be the sum of |a| + |b| over r, u, w and the axes.
//
// c = r - s u - q w, for the parameters s and q that `closest` gives, made to be in their domain, is the difference of
// a point of each element. So |c| is at least the distance. A coordinate of c is off by 4 e for those of r, u and w, by
// 2 e for 1 - s, by which q is bounded, and by 3 e for products and differences: |c| by less than 9 e S, and by 3 e S
// more for the root.
//
// The product of n with the difference of any two points, over |n|, is at most their distance. Its least value is at
// corners: (n r - max(s n u + q n w)) / |n|. Products and their sums make errors of 3 e, the maximum and the difference
// 2 e: 9 e S |n| with those of the coordinates, and root and quotient 3 e S.
constexpr double kError = 16 * 0x1p-53;

// Parts of |c| that the error, and what |c| is above the distance, may have. The distance is at least m / |c|, for the
// least product m of c as above. Both m and |c|^2 are computed with errors below 20 e S |c|, which is less than
// 2 kLargestError |c|^2 if the first test holds. So |c| (1 - 4 kLargestError - kLargestGap) is below the distance, and
// the bound is at most |c| (1 + 2 kLargestError): their quotient is below 1 + kLoosestBound.
constexpr double kLargestError = 0x1p-24;
constexpr double kLargestGap = 0x1p-22;

constexpr double kAboveRoot3 = 1.7320509;

/// Two elements at one time, by the differences of their corners.
struct Instant {
  Domain domain;
  Vector r, u, w;
  double size = 0;  // S

  Instant(const Query& query, double t) noexcept : domain(domain_of(query.kind)) {
    const Differences of = differences_of(query.kind);
    const auto at = [&](const Difference& one) {
      const Vector a = difference(query.start, one), b = difference(query.end, one);
      for (std::size_t k = 0; k < 3; ++k) size += std::fabs(a[k]) + std::fabs(b[k]);
      return between(a, b, t);
    };
    r = at(of.r);
    u = at(of.u);
    w = at(of.w);
  }

  /// Whether the squares below are normal numbers where they count.
  bool has_squares() const noexcept { return size >= kLeastSize && size <= kGreatestSize; }

  /// The difference of two points that are nearest, or nearly.
  Vector shortest() const noexcept {
    Parameters at = closest(domain, r, u, w);
    at.s = unit_clamp(at.s);
    at.q = std::min(unit_clamp(at.q), domain == Domain::triangle ? 1 - at.s : 1.0);
    return combined(r, u, w, at.s, at.q);
  }

  /// The least product of n with the difference of two points.
  double along(const Vector& n) const noexcept { return dot(n, r) - greatest_at_corners(domain, dot(n, u), dot(n, w)); }
};

/// Whether a vector's length is so great that beside it no underflow counts. It is not for NaN.
bool is_long(double length, const Instant& instant) noexcept { return length >= kLeastFraction * instant.size; }

}  // namespace

std::optional<double> distance_bound(const Query& query, double t) noexcept {
  const Instant instant(query, t);
  if (!instant.has_squares()) return std::nullopt;
  const Vector c = instant.shortest();
  const double square = dot(c, c);
  const double length = std::sqrt(square);
  const double error = kError * instant.size;
  const double gap = square - instant.along(c);
  // Written so that NaN gives nothing.
  if (!(error <= kLargestError * length && gap <= kLargestGap * square)) return std::nullopt;
  return length + error;
}

double least_distance(const Query& query) noexcept {
  const Instant start(query, 0), end(query, 1);
  if (!start.has_squares()) return 0;
  double least = 0;
  for (const Instant* instant : {&start, &end}) {
    const Vector n = instant->shortest();
    const double length = std::sqrt(dot(n, n));
    if (!is_long(length, *instant)) continue;
    least = std::max(least, std::min(start.along(n), end.along(n)) / length - kError * start.size);
  }
  return least;
}

int side_of_distance(const Query& query, double t, const Separation& separation) noexcept {
  const Instant instant(query, t);
  if (!instant.has_squares()) return 0;
  const Vector c = instant.shortest();
  const double length = std::sqrt(dot(c, c)), error = kError * instant.size;
  // In the metric max a distance is at most the Euclidean one, and at least that over the root of 3.
  if (length + error < separation.distance) return -1;
  if (!is_long(length, instant)) return 0;
  const double factor = separation.metric == Metric::max ? kAboveRoot3 : 1;
  return instant.along(c) / length - error > factor * separation.distance ? 1 : 0;
}

}  // namespace touchstone::filters
