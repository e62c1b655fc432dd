// V at a time of few bits, against determinants of integers. Corners that almost lie in a plane leave only the last
// bits of V's sums: so every rounded bit shows.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "exact/exact.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using Integers = std::array<std::int64_t, 3>;

Integers minus(const Integers& a, const Integers& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

std::int64_t determinant(const Integers& u, const Integers& w, const Integers& r) {
  return (u[1] * w[2] - u[2] * w[1]) * r[0] + (u[2] * w[0] - u[0] * w[2]) * r[1] + (u[0] * w[1] - u[1] * w[0]) * r[2];
}

/// V as docs/design.md defines it.
std::int64_t coplanarity(Kind kind, const std::array<Integers, 4>& x) {
  if (kind == Kind::edge_edge) return determinant(minus(x[1], x[0]), minus(x[3], x[2]), minus(x[2], x[0]));
  return determinant(minus(x[2], x[1]), minus(x[3], x[1]), minus(x[0], x[1]));
}

}  // namespace

TEST_CASE("V at a time of few bits is exact where corners almost lie in a plane") {
  constexpr double kLeastDouble = 0x1p-1074;
  Rng rng(57);
  std::size_t zero = 0, tiny = 0;
  const std::size_t count = effort(200000);
  for (std::size_t i = 0; i < count; ++i) {
    const int time_bits = rng.between(0, 8);
    const int later = rng.between(0, 1 << time_bits),
              earlier = (1 << time_bits) - later;  // the time, times 2^time_bits
    const int bits = rng.between(2, 19 - time_bits);
    std::array<std::array<Integers, 4>, 2> side{};
    for (std::array<Integers, 4>& x : side) {
      for (std::size_t k = 0; k < 3; ++k) {
        x[3][k] = 1 << bits;
        while (std::abs(x[3][k]) >= 1 << bits) {
          for (std::size_t c = 0; c < 3; ++c) x[c][k] = rng.between(1 - (1 << bits), (1 << bits) - 1);
          x[3][k] = x[1][k] + x[2][k] - x[0][k];
        }
      }
    }
    side[rng.below(2)][rng.below(4)][rng.below(3)] += rng.between(-1, 1);
    for (std::size_t c = 3; c > 0; --c) {
      const std::size_t other = rng.below(c + 1);
      for (std::array<Integers, 4>& x : side) std::swap(x[c], x[other]);
    }
    std::array<Integers, 4> at{};  // times 2^time_bits
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t k = 0; k < 3; ++k) at[c][k] = earlier * side[0][c][k] + later * side[1][c][k];
    }
    const int exponent = rng.one_in(2) ? 0 : rng.between(-370, 330);
    Query query;
    query.kind = rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
    const auto scaled = [&](const Integers& x) {
      const auto along = [&](std::size_t k) { return std::ldexp(static_cast<double>(x[k]), exponent); };
      return Vec3{along(0), along(1), along(2)};
    };
    for (std::size_t c = 0; c < 4; ++c) {
      query.start[c] = scaled(side[0][c]);
      query.end[c] = scaled(side[1][c]);
    }
    const auto v = static_cast<double>(coplanarity(query.kind, at));
    double expected = std::ldexp(v, 3 * (exponent - time_bits));
    if (v != 0 && expected == 0) expected = std::copysign(kLeastDouble, v);
    INFO(cpp_initializer(query) << " at " << later << " / 2^" << time_bits);
    REQUIRE(exact::coplanarity_at(query, std::ldexp(later, -time_bits)) == expected);
    zero += v == 0;
    tiny += v != 0 && std::fabs(expected) < 0x1p-1022;
  }
  CHECK(zero * 5 > count);
  CHECK(zero * 5 < 4 * count);
  CHECK(tiny * 200 > count);
}

}  // namespace touchstone::tests
