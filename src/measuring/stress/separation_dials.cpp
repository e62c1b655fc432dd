// SPDX-License-Identifier: MIT
#include "stress/separation_dials.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "stress/configuration.hpp"

namespace touchstone::stress {
namespace {

using seeded::Rng;

/// p / q.
struct Fraction {
  std::int64_t p, q;
};

/// Neighbours of a Farey sequence: p q' - p' q = 1, so that they differ by 1 / (q q'), the least that denominators of
/// this size allow. 0 <= p' / q' < p / q < 1.
std::pair<Fraction, Fraction> neighbours_of_random(int bits, Rng& rng) {
  Fraction one{};
  do {
    one.q = (std::int64_t{1} << (bits - 1)) + static_cast<std::int64_t>(rng.below(std::uint64_t{1} << (bits - 1)));
    one.p = 1 + static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(one.q - 1)));
  } while (std::gcd(one.p, one.q) != 1);
  // Euclid's algorithm, extended: p x + q y = 1.
  std::int64_t r0 = one.p, r1 = one.q, x0 = 1, x1 = 0, y0 = 0, y1 = 1;
  while (r1 != 0) {
    const std::int64_t quotient = r0 / r1;
    r0 = std::exchange(r1, r0 - quotient * r1);
    x0 = std::exchange(x1, x0 - quotient * x1);
    y0 = std::exchange(y1, y0 - quotient * y1);
  }
  if (x0 <= 0) {
    x0 += one.q;
    y0 -= one.p;
  }
  return {one, {-y0, x0}};
}

/// The same, with q of so many bits and q' no more than two bits shorter.
std::pair<Fraction, Fraction> neighbours(int bits, Rng& rng) {
  for (;;) {
    const auto pair = neighbours_of_random(bits, rng);
    if (4 * pair.second.q >= pair.first.q) return pair;
  }
}

/// A linear function by its values at t = 0 and t = 1; its root is start / (start - end).
struct Line {
  double start, end;
};

/// The root is p / (p + q 2^shift), and the values are of size 1.
Line line_through(const Fraction& root, int bits, int shift) {
  return {std::ldexp(static_cast<double>(root.p), -bits - shift), -std::ldexp(static_cast<double>(root.q), -bits)};
}

}  // namespace

Query separated_roots(Kind kind, int bits, Rng& rng) {
  // The roots are 1 / (q q') apart. With 53 bits this is at least about 2^-100. Roots near t = 0 can be nearer to each
  // other.
  const int digits = std::max(2, std::min(bits, 100) / 2);
  const int shift = std::max(0, bits - 100);
  auto [first, second] = neighbours(digits, rng);
  if (rng.one_in(2)) std::swap(first, second);
  const Line h = line_through(first, digits, shift), g = line_through(second, digits, shift);

  const bool inside = !rng.one_in(4);
  const double offset = (inside ? rng.between(-4, 4) : rng.one_in(2) ? 5 : -5) / 8.0;
  const auto corners = [&](double height, double rise) -> Corners {
    if (kind == Kind::edge_edge) {  // the second edge turns around its middle, over the first one
      return {{{-0.5, 0, 0}, {0.5, 0, 0}, {offset - 1, -rise, height}, {offset + 1, rise, height}}};
    }
    return {{{offset, 0, height}, {-1, -rise, 0}, {1, -rise, 0}, {0, rise, 0}}};
  };
  const int turns = rng.between(0, 2);
  Query query;
  query.kind = kind;
  query.start = turned(corners(h.start, g.start), turns);
  query.end = turned(corners(h.end, g.end), turns);
  if (rng.one_in(4)) std::swap(query.start, query.end);
  return query;
}

}  // namespace touchstone::stress
