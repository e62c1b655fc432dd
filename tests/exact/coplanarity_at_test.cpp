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
  Rng rng(57);
  std::size_t zero = 0;
  const std::size_t count = effort(200000);
  for (std::size_t i = 0; i < count; ++i) {
    const int time_bits = rng.between(0, 8);  // the time is m / 2^time_bits
    const int bits = rng.between(std::max(6, time_bits + 2), 19 - time_bits);
    const int m = rng.between(0, 1 << time_bits);
    const auto size = [&](int of_bits) { return rng.between(-(1 << of_bits), 1 << of_bits); };
    // The corners at that time. A corner moves through its place there by `speed` each 2^-time_bits of the step.
    std::array<Integers, 4> at{}, speed{};
    for (std::size_t k = 0; k < 3; ++k) {
      at[3][k] = 2 << bits;
      while (std::abs(at[3][k]) >= 1 << (bits - 1)) {
        for (std::size_t c = 0; c < 3; ++c) at[c][k] = size(bits - 1);
        at[3][k] = at[1][k] + at[2][k] - at[0][k];
      }
      for (Integers& of_corner : speed) of_corner[k] = size(bits - time_bits - 2);
    }
    at[3][static_cast<std::size_t>(rng.between(0, 2))] += rng.between(-1, 1);
    for (std::size_t c = 3; c > 0; --c) std::swap(at[c], at[rng.below(c + 1)]);
    const int exponent = rng.one_in(2) ? 0 : rng.between(-320, 320);
    Query query;
    query.kind = rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto place = [&](std::size_t k, int steps) {
        return std::ldexp(static_cast<double>(at[c][k] + speed[c][k] * steps), exponent);
      };
      const int left = (1 << time_bits) - m;
      query.start[c] = {place(0, -m), place(1, -m), place(2, -m)};
      query.end[c] = {place(0, left), place(1, left), place(2, left)};
    }
    const double expected = std::ldexp(static_cast<double>(coplanarity(query.kind, at)), 3 * exponent);
    INFO(cpp_initializer(query) << " at " << m << " / 2^" << time_bits);
    REQUIRE(exact::coplanarity_at(query, std::ldexp(m, -time_bits)) == expected);
    zero += expected == 0;
  }
  CHECK(zero * 5 > count);
  CHECK(zero * 2 < count);
}

}  // namespace touchstone::tests
