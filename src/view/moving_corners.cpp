// SPDX-License-Identifier: MIT
#include "view/moving_corners.hpp"

#include <utility>
#include <variant>

#include "exact/corners.hpp"
#include "geometry/frame.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::view {
namespace {

MovingCorners corners_of_kind(Kind kind) {
  MovingCorners result;
  result.kind = kind;
  result.count = corner_count(kind);
  result.first_count = geometry::corners_of_first(kind);
  return result;
}

template <class StraightQuery>
MovingCorners moving_corners(const StraightQuery& query) {
  MovingCorners result = corners_of_kind(query.kind);
  const exact::ScaledCorners scaled = exact::scaled_corners(query);
  for (std::size_t i = 0; i < result.count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.numerators[i][k] = {scaled.corners[i][k][0], scaled.corners[i][k][1]};
    }
  }
  result.denominator = {scaled.factor};
  return result;
}

Dense dense(const exact::Form& form) {
  Dense result;
  for (int i = 0; i < form.size(); ++i) result.push_back(form[i]);
  return result;
}

MovingCorners moving_corners(const CurvedQuery& query) {
  MovingCorners result = corners_of_kind(query.kind);
  const exact::AnyCorners scaled = exact::moving_corners<exact::AnyDegree>(query);
  for (std::size_t i = 0; i < result.count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result.numerators[i][k] = dense(scaled[i][k]);
  }
  result.denominator = scaled.factor * dense(scaled.scale);
  return result;
}

}  // namespace

std::array<ExactVector, 4> MovingCorners::at(const Exact& t) const {
  std::array<ExactVector, 4> points;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) points[i][k] = value(numerators[i][k], t);
  }
  return points;
}

Dense MovingCorners::coplanarity() const {
  if (count < 4) return {};
  const auto frame =
      geometry::frame_of(kind, [this](std::size_t i, std::size_t j) { return numerators[i] - numerators[j]; });
  return trimmed(dot(cross(frame.u, frame.w), frame.r));
}

bool MovingCorners::is_planar() const {
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_zero(numerators[i][2])) return false;
  }
  return true;
}

MovingCorners moving_corners_of(const io::FileQuery& query) {
  return std::visit([](const auto& any) { return moving_corners(any); }, query);
}

Dense shifted(Dense p, const Exact& shift) {
  if (p.empty() || numbers::is_zero(shift)) return p;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    for (std::size_t j = p.size() - 1; j-- > i;) p[j] = p[j] + p[j + 1] * shift;
  }
  return p;
}

DenseVector shifted(const DenseVector& p, const Exact& shift) {
  return {{shifted(p[0], shift), shifted(p[1], shift), shifted(p[2], shift)}};
}

Dense trimmed(Dense p) {
  while (!p.empty() && numbers::is_zero(p.back())) p.pop_back();
  return p;
}

Exact long_quotient(const Exact& numerator, const Exact& denominator) {
  constexpr int kRounds = 5;  // each is within a relative error of 2^-50 of what the ones before it left
  Exact quotient(0), rest = numerator;
  for (int round = 0; round < kRounds && !numbers::is_zero(rest); ++round) {
    const Exact more(numbers::approximate_quotient(rest, denominator));
    quotient = quotient + more;
    rest = rest - more * denominator;
  }
  return quotient;
}

Exact narrowed_root(const Dense& p, Exact low, Exact high) {
  constexpr int kHalvings = 1400;  // from a bracket near the smallest double up to 1
  const Exact half = numbers::power_of_two(-1), least = numbers::power_of_two(-260);
  const int sign_low = numbers::sign_of(value(p, low));
  if (sign_low == 0) return low;
  for (int i = 0; i < kHalvings && high - low > high * least; ++i) {
    Exact middle = (low + high) * half;
    const int sign = numbers::sign_of(value(p, middle));
    if (sign == 0) return middle;
    (sign == sign_low ? low : high) = std::move(middle);
  }
  return high;
}

}  // namespace touchstone::view
