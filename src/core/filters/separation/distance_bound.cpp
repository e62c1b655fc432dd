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

}  // namespace

std::optional<double> distance_bound(Kind kind, const std::array<Vec3, 4>& corners) noexcept {
  const Differences differences = differences_of(kind);
  const Vector r = difference(corners, differences.r), u = difference(corners, differences.u),
               w = difference(corners, differences.w);
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) size += std::fabs(r[k]) + std::fabs(u[k]) + std::fabs(w[k]);
  if (!(size >= kLeastSize && size <= kGreatestSize)) return std::nullopt;
  const Domain domain = domain_of(kind);
  Parameters at = closest(domain, r, u, w);
  at.s = unit_clamp(at.s);
  at.q = std::min(unit_clamp(at.q), domain == Domain::triangle ? 1 - at.s : 1.0);
  const Vector c = combined(r, u, w, at.s, at.q);
  const double square = dot(c, c);
  const double length = std::sqrt(square);
  const double error = kBoundError * size;
  const double gap = square - (dot(c, r) - greatest_at_corners(domain, dot(c, u), dot(c, w)));
  // Written so that NaN gives nothing.
  if (!(error <= kLargestError * length && gap <= kLargestGap * square)) return std::nullopt;
  return length + error;
}

}  // namespace touchstone::filters
