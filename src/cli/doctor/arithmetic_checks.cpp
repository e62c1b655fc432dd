// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "cli/doctor/checks.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/integers/exact_number.hpp"
#include "seeded/rng.hpp"

namespace touchstone::cli {
namespace {

using numbers::Exact;

struct Mode {
  int rounding;
  std::string_view name;
};
constexpr std::array<Mode, 4> kModes = {
    {{FE_TONEAREST, "to nearest"}, {FE_UPWARD, "upward"}, {FE_DOWNWARD, "downward"}, {FE_TOWARDZERO, "toward zero"}}};

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kLeastNormal = std::numeric_limits<double>::min();
constexpr double kHuge = std::numeric_limits<double>::infinity();

/// Random operands: any sign, any mantissa or a short one, exponents in [-limit, limit].
double operand(seeded::Rng& rng, int limit) {
  const bool is_short = rng.one_in(4);
  const int mantissa = rng.between(1, 1 << 12);
  const double fraction = 1 + rng.unit();
  const int exponent = rng.between(-limit, limit);
  const double sign = rng.one_in(2) ? -1 : 1;
  return sign * std::ldexp(is_short ? mantissa * 0x1p-12 : fraction, exponent);
}

/// Whether `result` is the exact value x, rounded. @param side  side(y) is the sign of x - y, for any exact y
template <class Side>
bool is_rounded(double result, int rounding, const Side& side) {
  if (!std::isfinite(result)) return false;  // no case of these checks overflows
  const int error = side(Exact(result));
  if (error == 0) return true;
  const double beyond = std::nextafter(result, error * kHuge);
  if (!std::isfinite(beyond) || side(Exact(beyond)) != -error) return false;  // x is not between the two
  switch (rounding) {
    case FE_UPWARD: return error < 0;
    case FE_DOWNWARD: return error > 0;
    case FE_TOWARDZERO: return result == 0 || (result > 0) == (error > 0);
    default: break;
  }
  const Exact middle = (Exact(result) + Exact(beyond)) * numbers::power_of_two(-1);
  const int half = side(middle);
  if (half != 0) return half != error;
  // A tie goes to the even one of the two neighbours. The last bit of a multiple of twice the spacing is even.
  const double spacing = std::fabs(beyond - result);
  return std::fmod(std::fabs(result), 2 * spacing) == 0;
}

std::string fault(std::string_view mode, std::string_view operation, double result) {
  return fmt::format("rounding {}: {} gave {:a}", mode, operation, result);
}

/// One operation on one pair, with what it must give.
struct Case {
  double a, b;
  double sum, product, quotient, root;
};

std::string fault_of_case(const Case& x, const Mode& mode) {
  const Exact a(x.a), b(x.b);
  const auto side_of = [](const Exact& value) { return [value](const Exact& y) { return compare(value, y); }; };
  if (!is_rounded(x.sum, mode.rounding, side_of(a + b))) {
    return fault(mode.name, fmt::format("{:a} + {:a}", x.a, x.b), x.sum);
  }
  if (!is_rounded(x.product, mode.rounding, side_of(a * b))) {
    return fault(mode.name, fmt::format("{:a} * {:a}", x.a, x.b), x.product);
  }
  const int sign = b.sign();
  if (!is_rounded(x.quotient, mode.rounding, [&](const Exact& y) { return sign * compare(a, y * b); })) {
    return fault(mode.name, fmt::format("{:a} / {:a}", x.a, x.b), x.quotient);
  }
  const Exact square(std::fabs(x.a));
  const auto side_of_root = [&](const Exact& y) { return y.sign() < 0 ? 1 : compare(square, y * y); };
  if (!is_rounded(x.root, mode.rounding, side_of_root)) {
    return fault(mode.name, fmt::format("sqrt({:a})", std::fabs(x.a)), x.root);
  }
  return {};
}

/// Pairs whose results are ordinary, and pairs whose product or quotient is near the least doubles.
std::vector<std::array<double, 2>> pairs() {
  constexpr int kCount = 1500;
  seeded::Rng rng(1);
  std::vector<std::array<double, 2>> all;
  for (int i = 0; i < kCount; ++i) {
    const double a = operand(rng, 40);
    const double b = operand(rng, 40);
    all.push_back({a, b});
    const double small = operand(rng, 20);
    all.push_back({small * 0x1p-530, b * 0x1p-530});  // the product is about 2^-1060
  }
  return all;
}

}  // namespace

std::string fault_of_environment(const Arithmetic& arithmetic) {
#ifdef __GLIBC__
  if (fegetexcept() != 0) return "floating-point exceptions trap";
#endif
  const int rounding = std::fegetround();
  for (const Mode& mode : kModes) {
    if (mode.rounding == rounding && rounding != FE_TONEAREST) return fmt::format("it rounds {}", mode.name);
  }
  // The mode that the library reports is not the one of the processor in a program that set only one of its two units.
  if (arithmetic.sum(1, 0x1p-53) != 1 || arithmetic.sum(1, 0x1.8p-53) == 1 || arithmetic.sum(-1, -0x1p-53) != -1) {
    return "it does not round to nearest";
  }
  if (arithmetic.product(kLeastNormal, 0.5) == 0) return "it flushes results below 2^-1022 to zero";
  if (arithmetic.product(kTiny, 0x1p60) == 0) return "it takes operands below 2^-1022 for zero";
  return {};
}

std::string fault_of_rounding(const Arithmetic& arithmetic) {
  const numbers::DefaultFloatEnvironment environment;
  const auto operands = pairs();
  for (const Mode& mode : kModes) {
    std::vector<Case> cases;
    cases.reserve(operands.size());
    std::fesetround(mode.rounding);
    for (const auto& [a, b] : operands) {
      const double magnitude = a < 0 ? -a : a;
      cases.push_back({a, b, arithmetic.sum(a, b), arithmetic.product(a, b), arithmetic.quotient(a, b),
                       arithmetic.root(magnitude)});
    }
    std::fesetround(FE_TONEAREST);
    for (const Case& x : cases) {
      std::string text = fault_of_case(x, mode);
      if (!text.empty()) return text;
    }
  }
  return {};
}

std::string fault_of_subnormals(const Arithmetic& arithmetic) {
  const numbers::DefaultFloatEnvironment environment;
  const double half = arithmetic.product(kLeastNormal, 0.5);
  if (half != 0x1p-1023) return fmt::format("2^-1022 / 2 gave {:a}", half);
  const double difference = arithmetic.sum(0x1.0000000000001p-1022, -kLeastNormal);
  if (difference != kTiny) return fmt::format("the difference of two neighbours above 2^-1022 gave {:a}", difference);
  const double grown = arithmetic.product(kTiny, 0x1p60);
  if (grown != 0x1p-1014) return fmt::format("2^-1074 * 2^60 gave {:a}", grown);
  const double quotient = arithmetic.quotient(kTiny, 0x1p-60);
  if (quotient != 0x1p-1014) return fmt::format("2^-1074 / 2^-60 gave {:a}", quotient);
  return {};
}

std::string fault_of_contraction(const Arithmetic& arithmetic) {
  const numbers::DefaultFloatEnvironment environment;
  seeded::Rng rng(2);
  for (int i = 0; i < 1000; ++i) {
    const double a = operand(rng, 40);
    const double b = operand(rng, 40);
    const double product = arithmetic.product(a, b);
    const double rest = arithmetic.product_and_sum(a, b, -product);  // the rounding error of a b where it is contracted
    if (rest != 0) return fmt::format("{:a} * {:a} and a sum were contracted to one operation", a, b);
    const double lost = arithmetic.sum_of_three(a, product * 0x1p80, -product * 0x1p80);
    if (lost != arithmetic.sum(arithmetic.sum(a, product * 0x1p80), -product * 0x1p80)) {
      return fmt::format("the sum of {:a}, x and -x was reordered", a);
    }
  }
  return {};
}

std::string fault_of_fused(const Arithmetic& arithmetic) {
  const numbers::DefaultFloatEnvironment environment;
  seeded::Rng rng(3);
  for (int i = 0; i < 2000; ++i) {
    const double a = operand(rng, 40);
    const double b = operand(rng, 40);
    const double other = operand(rng, 80);
    const double c = rng.one_in(2) ? -arithmetic.product(a, b) : other;
    const double result = arithmetic.fused(a, b, c);
    const Exact exact = Exact(a) * Exact(b) + Exact(c);
    if (!is_rounded(result, FE_TONEAREST, [&](const Exact& y) { return compare(exact, y); })) {
      return fmt::format("fma({:a}, {:a}, {:a}) gave {:a}", a, b, c, result);
    }
  }
  return {};
}

}  // namespace touchstone::cli
