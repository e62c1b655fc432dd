// SPDX-License-Identifier: MIT
#include "filters/separation/distance_bound.hpp"

#include <cmath>

#include "filters/separation/entry_step.hpp"

namespace touchstone::filters {
namespace {

// Let e = 2^-53, and c = r - s u - q w for the parameters s and q that `closest` gives, made to be in their domain: c
// is the difference of a point of each element, so |c| is at least the distance. Each coordinate of r, u and w is a
// difference of doubles, with a relative error of e. Differences, products and sums make errors of 4 e |u|, 3 e |w| and
// 3 e |r| at most, but for terms of second order, and 1 - s, by which q is bounded, one of e |w|. So each coordinate of
// the computed c is off by less than 6 e (|r| + |u| + |w|), and |c| by less than 6 e S, where S is the sum of these
// over the axes. The rest of the constant covers the errors of the root, of S and of the last sum.
constexpr double kBoundError = 10 * 0x1p-53;

// Parts of |c| that the error, and what |c| is above the distance, may have. The distance is at least the product of
// c / |c| with the difference of any two points, so at least its least value at corners, m = c (r - s u - q w). Both m
// and |c|^2 are computed with errors below 8 e S |c|, which is less than kLargestError |c|^2 if the first test holds.
// So |c| (1 - 2 kLargestError - kLargestGap) is below the distance, and the bound is at most
// |c| (1 + kLargestError): their quotient is below 1 + kLoosestBound.
constexpr double kLargestError = 0x1p-23;
constexpr double kLargestGap = 0x1p-22;

// A unit vector along n is as far from every difference of two points as its product with r - s u - q w at the corners
// is, so the distance is at least the least of these, (n r - max(s n u + q n w)) / |n|, and over a straight motion the
// lesser of the values at both ends. The coordinates of r, u and w have relative errors of e, their products with n
// one more, sums of three two more, and max and the difference at most two more: 6 e S |n| in all, but for terms of
// second order. Root and quotient add 3 e times a number that is at most S. So 16 is more than enough.
constexpr double kProjectionError = 16 * 0x1p-53;

/// Two elements at one instant, by the differences of their corners.
struct Instant {
  Domain domain;
  Vector r, u, w;
  double size = 0;  // S

  Instant(Kind kind, const std::array<Vec3, 4>& corners) noexcept : domain(domain_of(kind)) {
    const Differences differences = differences_of(kind);
    r = difference(corners, differences.r);
    u = difference(corners, differences.u);
    w = difference(corners, differences.w);
    for (std::size_t k = 0; k < 3; ++k) size += std::fabs(r[k]) + std::fabs(u[k]) + std::fabs(w[k]);
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

}  // namespace

std::optional<double> distance_bound(Kind kind, const std::array<Vec3, 4>& corners) noexcept {
  const Instant instant(kind, corners);
  if (!instant.has_squares()) return std::nullopt;
  const Vector c = instant.shortest();
  const double square = dot(c, c);
  const double length = std::sqrt(square);
  const double error = kBoundError * instant.size;
  const double gap = square - instant.along(c);
  // Written so that NaN gives nothing.
  if (!(error <= kLargestError * length && gap <= kLargestGap * square)) return std::nullopt;
  return length + error;
}

double least_distance(const Query& query) noexcept {
  const Instant start(query.kind, query.start), end(query.kind, query.end);
  if (!start.has_squares() || !end.has_squares()) return 0;
  const double error = kProjectionError * std::max(start.size, end.size);
  double least = 0;
  for (const Instant* instant : {&start, &end}) {
    const Vector n = instant->shortest();
    const double length = std::sqrt(dot(n, n));
    // Beside a length that is much less than S, underflow might count. Written so that NaN gives nothing.
    if (!(length >= kLeastFraction * instant->size)) continue;
    least = std::max(least, std::min(start.along(n), end.along(n)) / length - error);
  }
  return least;
}

}  // namespace touchstone::filters
