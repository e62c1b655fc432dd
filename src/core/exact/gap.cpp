// Why a narrower gap changes nothing but times and weights. gap_answer.cpp finds those.
//
// Let the norm of a polynomial in t and d be the sum of the absolute values of its coefficients; the norm of a product
// is at most the product of the norms. Along axis k, let the difference of any two moving corners have a norm of at
// most L_k, an integer. So the components of cross products of two differences have norms of at most 2 L_i L_j. The
// weights' numerators are such ones, too: n - (r x w) = (u - r) x w for edges, and for a face
// n - (r x w) - (u x r) = (u - r) x (w - r). V has at most the sum of the six products of a norm of u, one of w and one
// of r along three axes.
//
// Whether, when and in which features two elements touch in [0, 1] is told by the signs of V, of such components and
// sums, and of differences of coordinates, at and between their roots, and by where 0 and 1 lie among these. (The sign
// of a dot product is asked for collinear vectors only. There it is that of a product of differences along one axis.)
// The roots are continuous in d, with the same coincidences, multiplicities and order for all d in an interval, if the
// leading coefficients and the principal subresultant coefficients of all pairs of these polynomials, and of each and
// its derivative, have one sign in this interval, or are zero all over it (delineability: Collins, "Quantifier
// elimination for real closed fields by cylindrical algebraic decomposition", 1975). Each of them is a polynomial in d
// with integer coefficients: a determinant whose norm is at most the product of the norms of its rows. With v, q and l
// the norms of V, of quadratics and of differences, the largest are that of V's discriminant, v^2 q^3 of V and a
// quadratic, q^4 of two quadratics, and v l^3. The discriminant b^2 c^2 - 4 a c^3 - 4 b^3 d - 27 a^2 d^2 + 18 a b c d,
// for coefficients whose norms add up to v, has (16 + 108 + 108 + 432 + 18) v^4 / 256 < 2.7 v^4, more than the other
// subresultant's 9 v^3, as v >= 4. Let 2^(S - 1) be at least all of these. Where d <= 2^-S, the lowest coefficient that
// is not zero, an integer, exceeds the sum of all later terms: such a polynomial is zero or has one sign for all d in
// (0, 2^-S].
// SPDX-License-Identifier: MIT
#include "exact/gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "exact/common_scale.hpp"
#include "exact/elements.hpp"
#include "exact/gap_bounds.hpp"

namespace touchstone::exact {
namespace {

constexpr int kLeastGap = 32;  // a narrower one is no gap

/// The norm of the difference of two corners along each axis, h and l d being the coordinates.
geometry::Vector<double> difference_norm(const std::array<Query, 2>& parts, std::size_t i, std::size_t j) noexcept {
  geometry::Vector<double> norm = {{0, 0, 0}};
  for (const Query& part : parts) {
    const Vec3 &start_i = part.start[i], &start_j = part.start[j], &end_i = part.end[i], &end_j = part.end[j];
    const Vec3 at_start = {start_i.x - start_j.x, start_i.y - start_j.y, start_i.z - start_j.z};
    norm[0] += std::fabs(at_start.x) + std::fabs(end_i.x - end_j.x - at_start.x);
    norm[1] += std::fabs(at_start.y) + std::fabs(end_i.y - end_j.y - at_start.y);
    norm[2] += std::fabs(at_start.z) + std::fabs(end_i.z - end_j.z - at_start.z);
  }
  return norm;
}

/// The coordinates along one axis: multiples of 2^unit, and lesser ones, multiples of 2^least, below a gap.
struct Split {
  int unit = 0, least = 0;
  bool gapped = false;
};

Split split_along(const Query& query, double Vec3::*axis) {
  std::array<BitSpan, 8> spans;
  std::size_t count = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const Vec3* x : {&query.start[i], &query.end[i]}) {
      if (x->*axis == 0) continue;
      BitSpan span;
      span.add(x->*axis);
      std::size_t at = count++;  // the greatest first
      for (; at > 0 && spans[at - 1].high < span.high; --at) spans[at] = spans[at - 1];
      spans[at] = span;
    }
  }
  if (count == 0) return {};
  Split split;
  int low = spans[0].low, widest = kLeastGap - 1;
  for (std::size_t i = 1; i < count; ++i) {
    const int gap = low - spans[i].high;
    if (gap > widest) {
      widest = gap;
      split.gapped = true;
      split.unit = low;
    }
    low = std::min(low, spans[i].low);
  }
  split.least = low;
  if (!split.gapped) split.unit = low;
  return split;
}

}  // namespace

std::optional<Gap> Gap::of(const Query& query) {
  static constexpr double Vec3::*axes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  std::array<Split, 3> splits;
  int spread = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    splits[k] = split_along(query, axes[k]);
    if (splits[k].gapped) spread = std::max(spread, splits[k].unit - splits[k].least);
  }
  if (spread == 0) return std::nullopt;

  std::optional<Gap> gap(std::in_place);
  gap->spread_ = spread;
  gap->base_.kind = gap->low_.kind = gap->narrowed_.kind = query.kind;
  std::array<Query, 2> parts;  // the integers: h and l
  parts[0].kind = parts[1].kind = query.kind;
  constexpr int kGreatestBits = 20;
  int high_bits = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double border = std::ldexp(1, splits[k].unit);
    double high = 1;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      for (const bool at_end : {false, true}) {
        const double x = (at_end ? query.end : query.start)[i].*axes[k];
        const bool is_low = std::fabs(x) < border;
        const int unit = splits[k].unit - (is_low ? spread : 0);
        BitSpan span;
        span.add(x);
        if (span.bits() > 0 && span.high - unit > kGreatestBits) return std::nullopt;
        const double integer = static_cast<double>(numbers::SmallInt::scaled(x, unit).value());
        const double size = std::fabs(integer);
        if (!is_low) high = std::max(high, size);
        for (const bool part : {false, true}) {
          (at_end ? parts[part].end : parts[part].start)[i].*axes[k] = part == is_low ? integer : 0;
        }
      }
    }
    if (splits[k].gapped) high_bits = std::max(high_bits, bits_of(high));
  }
  auto& norm = gap->norm_;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const geometry::Vector<double> between = difference_norm(parts, i, j);
      for (std::size_t k = 0; k < 3; ++k) norm[k] = std::max(norm[k], between[k]);
    }
  }
  double v = kLeastVolume;
  if (query.kind == Kind::edge_edge || query.kind == Kind::vertex_face) {
    const auto [u, w, r] = geometry::frame_of(
        query.kind == Kind::edge_edge, [&](std::size_t i, std::size_t j) { return difference_norm(parts, i, j); });
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      sum += u[k] * (w[i] * r[j] + w[j] * r[i]);
    }
    v = std::max(v, sum);
  }
  if (bits_of(v) > kMostVolumeBits) return std::nullopt;
  const double l = std::max({norm[0], norm[1], norm[2]});
  const double q = kQuadraticNorm * norm[0] * norm[1] * norm[2] / std::min({norm[0], norm[1], norm[2]});
  const double greatest = std::max({2.7 * v * v * v * v, v * v * q * q * q, q * q * q * q, v * l * l * l,
                                    std::ldexp(std::max(v, q), 3 * kTimeBits + 2)});
  const int enough = 1 + bits_of(kSlack * greatest);
  const int narrow = enough;
  gap->volume_norm_ = v;
  if (narrow + high_bits > kMostBits<2> || spread <= narrow) return std::nullopt;
  gap->narrow_ = narrow;
  gap->base_.start = parts[0].start;
  gap->base_.end = parts[0].end;
  gap->low_.start = parts[1].start;
  gap->low_.end = parts[1].end;
  const double d = std::ldexp(1, -narrow);
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const bool at_end : {false, true}) {
      const Vec3& h = (at_end ? parts[0].end : parts[0].start)[i];
      const Vec3& l_times = (at_end ? parts[1].end : parts[1].start)[i];
      (at_end ? gap->narrowed_.end : gap->narrowed_.start)[i] = {h.x + d * l_times.x, h.y + d * l_times.y,
                                                                 h.z + d * l_times.z};
    }
  }
  return gap;
}

}  // namespace touchstone::exact
