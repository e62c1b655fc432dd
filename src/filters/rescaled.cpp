// SPDX-License-Identifier: MIT
#include "filters/rescaled.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace touchstone::filters {

std::optional<Query> rescaled(const Query& query) noexcept {
  // Beyond these, products of coordinates may be out of the range of the filters' bounds.
  constexpr double kLeast = 0x1p-150;
  constexpr double kGreatest = 0x1p150;
  const std::size_t count = corner_count(query.kind);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Vec3* x : {&query.start[i], &query.end[i]}) {
      largest = std::max({largest, std::fabs(x->x), std::fabs(x->y), std::fabs(x->z)});
    }
  }
  if (largest == 0 || (largest >= kLeast && largest <= kGreatest)) return std::nullopt;
  const int exponent = std::ilogb(largest);
  bool exact = true;
  const auto scaled = [&](const Vec3& x) {
    const Vec3 y = {std::ldexp(x.x, -exponent), std::ldexp(x.y, -exponent), std::ldexp(x.z, -exponent)};
    exact = exact && std::ldexp(y.x, exponent) == x.x && std::ldexp(y.y, exponent) == x.y &&
            std::ldexp(y.z, exponent) == x.z;
    return y;
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
