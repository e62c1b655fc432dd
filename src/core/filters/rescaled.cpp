// SPDX-License-Identifier: MIT
#include "filters/rescaled.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace touchstone::filters {
namespace {

// Beyond these, products of differences of coordinates may be out of the range of the filters' bounds.
constexpr double kLeast = 0x1p-150;
constexpr double kGreatest = 0x1p150;

// The filters' bounds are for the largest difference along any axis. Where that is so many times the largest one along
// another axis, they are mostly too large to decide.
constexpr double kGreatestRatio = 0x1p20;

/// One axis of a query, times a power of two that makes the largest difference about 1.
class Scale {
 public:
  explicit Scale(double largest) noexcept {
    constexpr std::uint64_t kMost = 2046;  // the greatest biased exponent, twice that of 1
    // Both powers are normal doubles.
    const std::uint64_t biased = std::clamp<std::uint64_t>(std::bit_cast<std::uint64_t>(largest) >> 52, 1, kMost - 1);
    down_ = std::bit_cast<double>((kMost - biased) << 52);
    up_ = std::bit_cast<double>(biased << 52);
  }
  Scale() noexcept = default;  ///< for zeros

  double operator()(double x) const noexcept { return x * down_; }
  /// Whether x was not rounded. Where the product rounds, it underflows, and so the way back up is exact.
  bool is_exact(double x) const noexcept { return x * down_ * up_ == x; }

 private:
  double down_ = 1, up_ = 1;
};

}  // namespace

bool seems_extreme(const Query& query) noexcept {
  double largest = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const Vec3& x = query.start[i];
    largest = std::max({largest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
  }
  return largest > kGreatest || (largest < kLeast && largest > 0);
}

std::optional<Query> rescaled(const Query& query) noexcept {
  const std::size_t count = corner_count(query.kind);
  const Vec3& origin = query.start[0];
  Vec3 largest = {0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    for (const Vec3* x : {&query.start[i], &query.end[i]}) {
      largest.x = std::max(largest.x, std::fabs(x->x - origin.x));
      largest.y = std::max(largest.y, std::fabs(x->y - origin.y));
      largest.z = std::max(largest.z, std::fabs(x->z - origin.z));
    }
  }
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const double x : {largest.x, largest.y, largest.z}) {
    if (x == 0) continue;
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
  if (greatest == 0 || (least >= kLeast && greatest <= kGreatest && greatest <= kGreatestRatio * least)) {
    return std::nullopt;
  }
  const auto scale = [](double x) { return x == 0 ? Scale() : Scale(x); };
  const Scale along_x = scale(largest.x), along_y = scale(largest.y), along_z = scale(largest.z);
  bool exact = true;
  const auto scaled = [&](const Vec3& x) {
    const bool exact_x = along_x.is_exact(x.x), exact_y = along_y.is_exact(x.y), exact_z = along_z.is_exact(x.z);
    exact = exact & exact_x & exact_y & exact_z;
    return Vec3{along_x(x.x), along_y(x.y), along_z(x.z)};
  };
  std::optional<Query> result(std::in_place);
  result->kind = query.kind;
  for (std::size_t i = 0; i < count; ++i) {
    result->start[i] = scaled(query.start[i]);
    result->end[i] = scaled(query.end[i]);
  }
  if (!exact) result.reset();
  return result;
}

}  // namespace touchstone::filters
