// SPDX-License-Identifier: MIT
#include "io/queries/query_writer.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace touchstone::io {
namespace {

/// odd * 2^twos in decimal.
std::string decimal(std::uint64_t odd, int twos) {
  constexpr std::uint64_t kBase = 1'000'000'000;
  std::vector<std::uint64_t> limbs;  // base 10^9, the lowest first
  for (; odd > 0; odd /= kBase) limbs.push_back(odd % kBase);
  while (twos > 0) {
    const int step = twos < 30 ? twos : 30;  // 10^9 * 2^30 + carry < 2^64
    std::uint64_t carry = 0;
    for (auto& limb : limbs) {
      carry += limb << step;
      limb = carry % kBase;
      carry /= kBase;
    }
    for (; carry > 0; carry /= kBase) limbs.push_back(carry % kBase);
    twos -= step;
  }
  std::string text = std::to_string(limbs.back());
  for (std::size_t i = limbs.size() - 1; i-- > 0;) {
    const std::string digits = std::to_string(limbs[i]);
    text.append(9 - digits.size(), '0').append(digits);
  }
  return text;
}

void append_row(std::string& out, const std::array<Fraction, 3>& corner, std::optional<bool> truth) {
  for (const auto& coordinate : corner) {
    out += coordinate.numerator;
    out += ',';
    out += coordinate.denominator;
    out += ',';
  }
  if (truth) {
    out += *truth ? "1" : "0";
  } else {
    out.pop_back();
  }
  out += '\n';
}

void append_row(std::string& out, const Vec3& corner, std::optional<bool> truth) {
  append_row(out, std::array{fraction_of(corner.x), fraction_of(corner.y), fraction_of(corner.z)}, truth);
}

template <class AnyQuery>
void append_rows(std::string& out, const AnyQuery& query, std::optional<bool> truth) {
  const std::size_t corners = corner_count(query.kind);
  for (std::size_t i = 0; i < corners; ++i) append_row(out, query.start[i], truth);
  for (std::size_t i = 0; i < corners; ++i) append_row(out, query.end[i], truth);
}

}  // namespace

Fraction fraction_of(double value) {
  if (value == 0) return {};
  int exponent = 0;
  const double significand = std::frexp(std::abs(value), &exponent);  // in [1/2, 1)
  auto odd = static_cast<std::uint64_t>(std::ldexp(significand, 53));
  exponent -= 53;
  const int zeros = std::countr_zero(odd);
  odd >>= zeros;
  exponent += zeros;
  Fraction fraction{decimal(odd, exponent), decimal(1, -exponent)};
  if (std::signbit(value)) fraction.numerator.insert(0, 1, '-');
  return fraction;
}

void append_query(std::string& out, const Query& query, std::optional<bool> truth) { append_rows(out, query, truth); }

void append_query(std::string& out, const RationalQuery& query, std::optional<bool> truth) {
  append_rows(out, query, truth);
}

}  // namespace touchstone::io
