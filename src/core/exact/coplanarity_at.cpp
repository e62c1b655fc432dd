// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>

#include "exact/common_scale.hpp"
#include "exact/exact.hpp"
#include "geometry/frame.hpp"
#include "numbers/integers/exact_number.hpp"
#include "numbers/integers/fixed_int.hpp"
#include "numbers/integers/limb_scratch.hpp"

namespace touchstone::exact {
namespace {

/// V of four positions, in any number type.
template <class N>
auto coplanarity_of(Kind kind, const std::array<geometry::Vector<N>, 4>& x) {
  return geometry::coplanarity(geometry::frame_of(kind, [&](std::size_t i, std::size_t j) { return x[i] - x[j]; }));
}

/// A value times 2^exponent; the least double of its sign where that underflows to zero.
double scaled(double value, int exponent) noexcept {
  constexpr double kLeastDouble = 0x1p-1074;
  const double result = std::ldexp(value, exponent);
  return value != 0 && result == 0 ? std::copysign(kLeastDouble, value) : result;
}

template <int Limbs>
geometry::Vector<numbers::FixedInt<Limbs>> integers(const Vec3& x, int low) {
  using Int = numbers::FixedInt<Limbs>;
  return {{Int::scaled(x.x, low), Int::scaled(x.y, low), Int::scaled(x.z, low)}};
}

// Integer coordinates x / 2^low are below 2^bits, and differences below 2^(bits + 1). V sums 6 products of three
// differences. With 3 spare bits in each difference, the sum and its sign have room. Positions at the time m / 2^k,
// times 2^k, are below 2^(bits + k).

template <int Limbs>
double value_at_end(const Query& query, const BitSpan& span, bool start) {
  std::array<geometry::Vector<numbers::FixedInt<Limbs>>, 4> positions;
  for (std::size_t i = 0; i < 4; ++i) positions[i] = integers<Limbs>((start ? query.start : query.end)[i], span.low);
  return scaled(to_double(coplanarity_of(query.kind, positions)), 3 * span.low);
}

template <int Limbs, int TimeLimbs>
double value_between(const Query& query, const BitSpan& span, double t, int time_low) {
  const auto later = numbers::FixedInt<TimeLimbs>::scaled(t, time_low);
  const auto earlier = numbers::FixedInt<TimeLimbs>::scaled(1, time_low) - later;
  std::array<geometry::Vector<numbers::FixedInt<Limbs + TimeLimbs>>, 4> positions;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto from = integers<Limbs>(query.start[i], span.low);
    const auto to = integers<Limbs>(query.end[i], span.low);
    for (std::size_t k = 0; k < 3; ++k) positions[i][k] = from[k] * earlier + to[k] * later;
  }
  return scaled(to_double(coplanarity_of(query.kind, positions)), 3 * (span.low + time_low));
}

double value_in_any_size(const Query& query, double t) {
  using numbers::Exact;
  const numbers::LimbScratch scratch;
  const Exact later(t);
  const Exact earlier = Exact(1) - later;
  std::array<geometry::Vector<Exact>, 4> positions;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto along = [&](double Vec3::*axis) {
      return earlier * Exact(query.start[i].*axis) + later * Exact(query.end[i].*axis);
    };
    positions[i] = {{along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)}};
  }
  const auto [significand, exponent] = numbers::approximate(coplanarity_of(query.kind, positions));
  return scaled(significand, static_cast<int>(exponent));
}

/// Whether every sum and product of V is an integer of at most 53 bits times a power of two, for positions of so many
/// bits, and none overflows or underflows.
bool is_exact_in_doubles(const BitSpan& span, int position_bits) noexcept {
  constexpr int kFar = 300;
  return 3 * (position_bits + 1) + 3 <= 53 && span.low > -kFar && span.high < kFar;
}

/// V where is_exact_in_doubles.
double value_in_doubles(const Query& query, double t) {
  std::array<geometry::Vector<double>, 4> positions;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 &from = query.start[i], &to = query.end[i];
    const auto along = [&](double Vec3::*axis) { return (1 - t) * from.*axis + t * to.*axis; };
    positions[i] = {{along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)}};
  }
  return coplanarity_of(query.kind, positions);
}

/// How many limbs hold so many bits and 3 to spare; 3 stands for more than two.
int limbs_for(int bits) noexcept { return bits <= 64 - 3 ? 1 : bits <= 128 - 3 ? 2 : 3; }

}  // namespace

double coplanarity_at(const Query& query, double t) {
  const BitSpan span = coordinate_span(query);
  BitSpan time;
  time.add(1.0);
  time.add(t);
  if (is_exact_in_doubles(span, span.bits() - time.low)) return value_in_doubles(query, t);
  const int limbs = limbs_for(span.bits() + 1);
  if (t == 0 || t == 1) {
    if (limbs == 1) return value_at_end<1>(query, span, t == 0);
    if (limbs == 2) return value_at_end<2>(query, span, t == 0);
    return value_in_any_size(query, t);
  }
  const int time_limbs = limbs_for(1 - time.low);
  if (limbs == 1 && time_limbs == 1) return value_between<1, 1>(query, span, t, time.low);
  if (limbs == 1 && time_limbs == 2) return value_between<1, 2>(query, span, t, time.low);
  if (limbs == 2 && time_limbs == 1) return value_between<2, 1>(query, span, t, time.low);
  return value_in_any_size(query, t);
}

}  // namespace touchstone::exact
