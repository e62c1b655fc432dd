// SPDX-License-Identifier: MIT
#include "fuzz/shrinking/simplicity.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <set>

#include "families/curved_parts.hpp"

namespace touchstone::fuzz {
namespace {

constexpr std::int64_t kMovingCorner = 3;
constexpr std::int64_t kRepeatedCorner = 2;
constexpr std::int64_t kSign = 1;
constexpr std::int64_t kDigit = 2;
constexpr std::int64_t kFractionDigit = 6;  // for each place after the point

bool same_bits(const Vec3& a, const Vec3& b) noexcept {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

std::int64_t of_corner(const std::array<Vec3, 4>& corners, std::size_t i) noexcept {
  const std::int64_t own = difficulty(corners[i].x) + difficulty(corners[i].y) + difficulty(corners[i].z);
  for (std::size_t j = 0; j < i; ++j) {
    if (same_bits(corners[i], corners[j])) return std::min(own, kRepeatedCorner);
  }
  return own;
}

}  // namespace

std::int64_t difficulty(double x) noexcept {
  const std::int64_t sign = std::signbit(x) ? kSign : 0;
  if (x == 0) return sign;
  int exponent = 0;
  const double significand = std::frexp(std::fabs(x), &exponent);
  auto digits = static_cast<std::uint64_t>(std::ldexp(significand, 53));  // |x| = digits 2^(exponent - 53)
  const int zeros = std::countr_zero(digits);
  digits >>= zeros;
  const int last_bit = exponent - 53 + zeros;
  const std::int64_t length = std::bit_width(digits) - 1;
  if (last_bit < 0) return sign + 1 + kDigit * length - kFractionDigit * last_bit;
  return sign + 1 + kDigit * (length + last_bit);
}

std::int64_t difficulty(const Query& query) noexcept {
  std::int64_t sum = 0;
  std::array<double, 24> values{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    sum += of_corner(query.start, i);
    if (!same_bits(query.start[i], query.end[i])) sum += kMovingCorner + of_corner(query.end, i);
    for (const Vec3& corner : {query.start[i], query.end[i]}) {
      for (const double x : {corner.x, corner.y, corner.z}) values[count++] = std::fabs(x);
    }
  }
  std::sort(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
  return sum + (std::unique(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)) - values.begin());
}

std::int64_t difficulty(const CurvedQuery& query) {
  constexpr std::int64_t kControlPoint = 4, kTurn = 6;
  const auto of = [](const Vec3& x) { return difficulty(x.x) + difficulty(x.y) + difficulty(x.z); };
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    const int points = corner.motion == CurvedCorner::kOnCurve ? corner.control_points : 1;
    std::int64_t own = corner.motion == CurvedCorner::kOnCurve ? kControlPoint * (points - 1) : kRepeatedCorner;
    own += corner.motion > 0 ? corner.motion : 0;
    for (int k = 0; k < points; ++k) own += of(corner.points[static_cast<std::size_t>(k)]);
    for (std::size_t j = 0; j < i; ++j) {
      bool repeated = query.corners[j].motion == corner.motion && query.corners[j].control_points == points;
      for (std::size_t k = 0; k < corner.points.size(); ++k) {
        repeated = repeated &&
                   (k >= static_cast<std::size_t>(points) || same_bits(query.corners[j].points[k], corner.points[k]));
      }
      if (repeated) own = std::min(own, kRepeatedCorner);
    }
    sum += own;
  }
  CurvedQuery read = query;
  families::for_each_motion(read, [&](const RigidMotion& motion) {
    sum += kMovingCorner + of(motion.p0) + (same_bits(motion.p0, motion.p1) ? 0 : kMovingCorner + of(motion.p1));
    for (const double c : motion.q0) sum += difficulty(c);
    if (motion.q0 == motion.q1) return;
    sum += kTurn;
    for (const double c : motion.q1) sum += difficulty(c);
  });
  std::set<double> values;
  families::for_each_number(read, [&](const double& x) { values.insert(std::fabs(x)); });
  return sum + static_cast<std::int64_t>(values.size());
}

}  // namespace touchstone::fuzz
