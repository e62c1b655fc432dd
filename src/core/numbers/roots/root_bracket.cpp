// SPDX-License-Identifier: MIT
#include "numbers/roots/root_bracket.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace touchstone::numbers {
namespace {

constexpr long kMostBits = 20000;  // of a bracket's ends: a hint is not worth more

/// A double with an exponent of its own: no overflow, no underflow. Only for hints.
class Wide {
 public:
  Wide() : Wide(0) {}
  explicit Wide(double m, long e = 0) : m_(m), e_(e) {
    int shift = 0;
    m_ = std::frexp(m_, &shift);
    e_ = m_ == 0 ? 0 : e_ + shift;
  }
  explicit Wide(const Exact& x) : Wide(approximate(x)) {}

  int sign() const { return (m_ > 0) - (m_ < 0); }
  /// 2^(log2() - 1) <= |x| < 2^log2(); for zero less than any of the numbers here.
  long log2() const { return m_ == 0 ? -(1L << 30) : e_; }
  Exact exact() const { return Exact(m_) * power_of_two(e_); }
  /// With so many significant bits, 1 <= bits <= 53.
  Wide rounded(long bits) const {
    const double scale = std::ldexp(1.0, static_cast<int>(bits));
    return Wide(std::nearbyint(m_ * scale) / scale, e_);
  }

  friend Wide operator-(const Wide& a) { return Wide(-a.m_, a.e_); }
  friend Wide operator*(const Wide& a, const Wide& b) { return Wide(a.m_ * b.m_, a.e_ + b.e_); }
  friend Wide operator/(const Wide& a, const Wide& b) { return Wide(a.m_ / b.m_, a.e_ - b.e_); }
  friend Wide operator+(const Wide& a, const Wide& b) {
    if (a.m_ == 0 || (b.m_ != 0 && b.e_ > a.e_)) return b.m_ == 0 ? a : b + a;
    return Wide(a.m_ + std::ldexp(b.m_, static_cast<int>(std::max(b.e_ - a.e_, -kFar))), a.e_);
  }
  friend Wide operator-(const Wide& a, const Wide& b) { return a + -b; }
  friend Wide sqrt(const Wide& a) {
    const long rest = a.e_ & 1;
    return Wide(std::sqrt(std::ldexp(a.m_, static_cast<int>(rest))), (a.e_ - rest) / 2);
  }
  friend Wide cbrt(const Wide& a) {
    const long rest = (a.e_ % 3 + 3) % 3;
    return Wide(std::cbrt(std::ldexp(a.m_, static_cast<int>(rest))), (a.e_ - rest) / 3);
  }
  /// Overflows and underflows as ldexp does.
  double to_double() const { return std::ldexp(m_, static_cast<int>(std::clamp(e_, -kFar, kFar))); }

 private:
  explicit Wide(const Approximation& a) : Wide(a.significand, a.exponent) {}
  static constexpr long kFar = 2000;

  double m_;
  long e_;
};

/// numerator / denominator within about 2^exponent.
Exact quotient(Exact numerator, const Exact& denominator, long exponent) {
  const Wide divisor(denominator);
  Exact result;
  for (;;) {
    const Wide term = Wide(numerator) / divisor;
    if (term.log2() < exponent) return result;
    const Exact exact = term.exact();
    result = result + exact;
    numerator = numerator - exact * denominator;
  }
}

/// The coefficients of q(point + x) of degrees below `count`; those of higher degrees are of no use.
ExactList first_taylor_coefficients(Coefficients q, const Exact& point, std::size_t count) {
  ExactList c(q.c, q.size);
  if (is_zero(point)) return c;
  const std::size_t size = static_cast<std::size_t>(q.size);
  for (std::size_t first = 0; first + 1 < size && first < count; ++first) {  // synthetic divisions
    for (std::size_t i = size - 1; i-- > first;) c[i] = c[i] + c[i + 1] * point;
  }
  return c;
}

/// Factors that bring the coefficients of a degree to its Bernstein basis without fractions: element i is u / b(n, i)
/// with b(n, i) the binomial coefficients and u their least common multiple.
constexpr int kTabled = 27;
struct BernsteinUnits {
  double factor[kTabled + 1][kTabled + 1] = {};

  constexpr BernsteinUnits() {
    for (int n = 0; n <= kTabled; ++n) {
      std::int64_t binomial[kTabled + 1] = {1};
      std::int64_t unit = 1;
      for (int i = 1; i <= n; ++i) {
        binomial[i] = binomial[i - 1] * (n - i + 1) / i;
        unit = std::lcm(unit, binomial[i]);
      }
      for (int i = 0; i <= n; ++i) factor[n][i] = static_cast<double>(unit / binomial[i]);
    }
  }
};
constexpr BernsteinUnits kBernstein;
static_assert(kBernstein.factor[6][0] == 60 && kBernstein.factor[6][3] == 3);
static_assert(kBernstein.factor[kTabled][0] < 0x1p53, "integers that doubles hold");

/// Multiplies by such factors, for any degree n. Those of high degrees are n! / b(n, i) = i! (n - i)!.
void to_bernstein_units(ExactList& c) {
  const std::size_t degree = static_cast<std::size_t>(c.size()) - 1;
  if (degree <= kTabled) {
    for (std::size_t i = 0; i <= degree; ++i) c[i] = c[i] * Exact(kBernstein.factor[degree][i]);
    return;
  }
  ExactList factorial(c.size());
  factorial[0] = Exact(1);
  for (std::size_t i = 1; i <= degree; ++i) factorial[i] = factorial[i - 1] * Exact(static_cast<double>(i));
  for (std::size_t i = 0; i <= degree; ++i) c[i] = c[i] * factorial[i] * factorial[degree - i];
}

/// The first four coefficients of p(point + x).
struct TaylorCubic {
  Exact value, slope, half_curvature, third;
};
TaylorCubic taylor_cubic(Coefficients p, const Exact& point) {
  if (p.size > 4) {
    const ExactList c = first_taylor_coefficients(p, point, 4);
    return {c[0], c[1], c[2], c[3]};
  }
  const Exact leading = p.size == 4 ? p.c[3] : Exact();
  const Exact inner = p.c[2] + leading * point;
  const Exact twice = inner + leading * point;
  return {p.c[0] + (p.c[1] + inner * point) * point, p.c[1] + (inner + twice) * point, twice + leading * point,
          leading};
}

/// A step from a point towards a root.
struct Step {
  Wide length;        ///< to the root of p's parabola at the point
  long good_bits;     ///< of the length; an estimate
  Wide newton_slope;  ///< p' at the root, with as many good bits; 0 where two roots are so close that it has none
};

/// The step to the root where p rises (slope_sign 1) or falls (-1). Two roots close to each other do not disturb it.
/// Nothing when p is too far from a parabola between the point and the root, as its cubic term there shows.
std::optional<Step> parabola_step(Coefficients p, const Exact& point, int slope_sign) {
  const auto [value, slope, half_curvature, leading] = taylor_cubic(p, point);

  // value + slope s + half_curvature s^2 = 0, and slope + 2 half_curvature s = +-sqrt(discriminant)
  const Wide f(value), d(slope), a(half_curvature);
  const Wide squared = d * d;
  Wide discriminant = squared - Wide(4) * a * f;
  constexpr long kCancelled = 10;
  if (discriminant.log2() < squared.log2() - kCancelled) {
    discriminant = Wide(slope * slope - Exact(4) * half_curvature * value);
  }
  const Wide root = sqrt(discriminant.sign() > 0 ? discriminant : -discriminant);
  const Wide to_come = slope_sign > 0 ? root : -root;
  const bool cancels = d.sign() == slope_sign;
  if (!cancels && a.sign() == 0) return std::nullopt;
  const Wide length = discriminant.sign() < 0 ? -d / (Wide(2) * a)
                      : cancels               ? Wide(-2) * f / (d + to_come)
                                              : (to_come - d) / (Wide(2) * a);

  // The error from the cubic's leading term, and from the missing root of a negative discriminant.
  const Wide disturbance = Wide(leading) * length * length * length;
  const bool close = root.log2() < d.log2() - 2 * kCancelled;  // the other root, as seen from here
  const long error = !close ? disturbance.log2() - root.log2()
                            : std::max((disturbance.log2() - a.log2()) / 2,
                                       discriminant.sign() < 0 ? root.log2() - a.log2() : -kMostBits);
  if (discriminant.sign() <= 0 && !close) return std::nullopt;
  const long good_bits = std::min(46L, length.log2() - error - 3);
  if (good_bits < 5) return std::nullopt;
  return Step{length.rounded(good_bits + 2), good_bits, close ? Wide(0) : to_come};
}

struct NearRoots {
  std::array<Wide, 3> y;
  int count;
};

/// Approximations of the real roots of y^3 + 3 p y + q, by Cardano's formula where there is one root and by Viete's
/// where there are three. Of two roots that nearly coincide, half of the digits are right. Where it is uncertain
/// whether two roots are real, they are given.
NearRoots roots_of_depressed(const Wide& p, const Wide& q) {
  const Wide half_q = Wide(0.5) * q;
  const Wide discriminant = half_q * half_q + p * p * p;
  if (discriminant.sign() >= 0) {
    const Wide z = cbrt(q.sign() > 0 ? -half_q - sqrt(discriminant) : -half_q + sqrt(discriminant));
    if (z.sign() == 0) return {{}, 1};
    const Wide other = p / z;  // the root is z - other; without cancellation:
    const Wide y = p.sign() > 0 ? -q / (z * z + p + other * other) : z - other;
    return {{y, Wide(-0.5) * y}, 2};
  }
  const Wide radius = sqrt(-p);
  const double angle = std::acos(std::clamp((-half_q / (radius * radius * radius)).to_double(), -1.0, 1.0)) / 3;
  constexpr double kThird = 2 * std::numbers::pi / 3;
  const Wide greatest = Wide(2 * std::cos(angle)) * radius;
  const Wide least = Wide(2 * std::cos(angle + kThird)) * radius;
  return {{greatest, least, -q / (greatest * least)}, 3};  // their product is -q; the middle one may be small
}

}  // namespace

Exact evaluate(Coefficients p, const Exact& t) {
  Exact value = p.c[p.size - 1];
  for (int i = p.size - 2; i >= 0; --i) value = value * t + p.c[i];
  return value;
}

ExactList taylor_coefficients(Coefficients q, const Exact& point) {
  return first_taylor_coefficients(q, point, static_cast<std::size_t>(q.size));
}

BernsteinForm::BernsteinForm(Coefficients q, const Exact& low, const Exact& high) : c_(taylor_coefficients(q, low)) {
  // With c_i the coefficients of q(low + (high - low) x), n the formal degree and b(n, i) the binomial coefficients,
  // coefficient k is the sum of b(k, i) / b(n, i) c_i. All are times a common multiple of the b(n, i).
  const std::size_t degree = static_cast<std::size_t>(q.size) - 1;
  const Exact width = high - low;
  Exact power(1);
  for (std::size_t i = 0; i <= degree; ++i) {
    c_[i] = c_[i] * power;
    if (i < degree) power = power * width;
  }
  to_bernstein_units(c_);
  // The sums of b(k, i) c_i have the differences c_i at their start: add them up as in Pascal's triangle.
  for (std::size_t first = degree; first-- > 0;) {
    for (std::size_t k = first; k < degree; ++k) c_[k + 1] = c_[k + 1] + c_[k];
  }
}

int BernsteinForm::variations() const {
  int count = 0;
  int previous = 0;
  for (const Exact& c : *this) {
    const int sign = sign_of(c);
    if (sign == 0) continue;
    count += previous != 0 && sign != previous;
    previous = sign;
  }
  return count;
}

std::pair<BernsteinForm, BernsteinForm> BernsteinForm::split(int position) const {
  const Exact later(position / 64.0);
  const Exact earlier = Exact(1) - later;
  const std::size_t size = static_cast<std::size_t>(c_.size());
  BernsteinForm left(c_.size()), right = *this;
  for (std::size_t round = 0; round < size; ++round) {  // de Casteljau's algorithm
    left.c_[round] = right.c_[0];
    for (std::size_t i = 0; i + round + 1 < size; ++i) {
      right.c_[i] = earlier * right.c_[i] + later * right.c_[i + 1];
    }
  }
  return {std::move(left), std::move(right)};
}

int RootBracket::compare(Coefficients p, const Exact& value) const {
  if (value <= low_) return is_root() ? sign_of(low_ - value) : 1;
  if (value >= high_) return -1;
  const int sign = sign_of(evaluate(p, value));
  return sign == 0 ? 0 : sign == sign_low_ ? 1 : -1;
}

bool RootBracket::keep_side(Coefficients p, const Exact& value) {
  if (value <= low_ || value >= high_) return false;
  const int side = compare(p, value);
  if (side >= 0) low_ = value;
  if (side <= 0) high_ = value;
  return side == 0;
}

std::optional<int> RootBracket::sign_over(Coefficients q) const {
  const int sign = sign_of(evaluate(q, low_));
  if (is_root()) return sign;
  const auto agrees = [sign](const Exact& x) { return sign_of(x) == sign; };
  bool certain = sign != 0 && agrees(evaluate(q, high_));
  // The inner coefficients, times a positive number: q's polar form with some arguments low and the others high.
  if (certain && q.size == 3) {
    certain = agrees(Exact(2) * q.c[0] + q.c[1] * (low_ + high_) + Exact(2) * q.c[2] * low_ * high_);
  } else if (certain && q.size > 4) {
    const BernsteinForm form(q, low_, high_);
    certain = std::all_of(form.begin(), form.end(), agrees);
  } else if (certain && q.size == 4) {
    const auto inner = [&](const Exact& twice, const Exact& once) {
      return Exact(3) * q.c[0] + q.c[1] * (Exact(2) * twice + once) + q.c[2] * twice * (twice + Exact(2) * once) +
             Exact(3) * q.c[3] * twice * twice * once;
    };
    certain = agrees(inner(low_, high_)) && agrees(inner(high_, low_));
  }
  return certain ? std::optional<int>(sign) : std::nullopt;
}

void RootBracket::narrow(Coefficients p) {
  if (is_root() || narrow_by_model(p) || narrow_by_formula(p)) return;
  constexpr int kBisections = 8;
  for (int i = 0; i < kBisections; ++i) {
    if (keep_side(p, (low_ + high_) * Exact(0.5))) return;
  }
}

// Tries an interval around the root of p's parabola at the lower end, and steps from there. The parabola is only a
// hint: exact signs of p prove the ends of every bracket. False when the bracket has not become much smaller.
bool RootBracket::narrow_by_model(Coefficients p) {
  std::optional<Step> step = parabola_step(p, low_, -sign_low_);
  if (!step || step->length.sign() <= 0 || step->length.log2() > Wide(high_ - low_).log2() + 1) return false;
  Exact root = low_ + step->length.exact();
  for (int i = 0; i < corrections_; ++i) {
    if (step->newton_slope.sign() != 0) {
      step->length = (Wide(evaluate(p, root)) / -step->newton_slope).rounded(step->good_bits + 2);
    } else {
      const std::optional<Step> next = parabola_step(p, root, -sign_low_);
      if (!next) break;
      step = next;
    }
    if (step->length.sign() == 0) break;
    root = root + step->length.exact();
  }
  if (step->length.sign() == 0) return keep_side(p, root);
  corrections_ = std::min(2 * corrections_ + 1, 15);
  return keep_within(p, root, power_of_two(step->length.log2() - step->good_bits + 1));
}

// For three roots so close to each other that the parabola cannot tell them apart. With t = (y - b) / 3a, a cubic's
// roots are those of y^3 + 3 (3ac - b^2) y + (2b^3 - 9abc + 27a^2 d), over 27 a^2.
bool RootBracket::narrow_by_formula(Coefficients cubic) {
  if (by_formula_ || cubic.size != 4) return false;
  by_formula_ = true;
  const Exact &d = cubic.c[0], &c = cubic.c[1], &b = cubic.c[2], &a = cubic.c[3];
  const Exact three_a = Exact(3) * a;
  const Exact b_squared = b * b;
  const Wide linear(three_a * c - b_squared);
  const Wide constant(b * (Exact(2) * b_squared - three_a * Exact(3) * c) + three_a * three_a * (Exact(3) * d));
  const NearRoots roots = roots_of_depressed(linear, constant);
  for (const long good_bits : {40L, 18L}) {
    for (int i = 0; i < roots.count; ++i) {
      const Wide offset = roots.y[static_cast<std::size_t>(i)] / Wide(three_a);
      const long accuracy = offset.log2() - good_bits;
      if (offset.sign() == 0 || accuracy < -kMostBits) continue;
      const Exact root = quotient(-b, three_a, accuracy) + offset.rounded(good_bits).exact();
      if (keep_within(cubic, root, power_of_two(accuracy + 2))) return true;
    }
  }
  return false;
}

/// Narrows to within the radius of the middle, or else to the side of that interval on which the root lies. Returns
/// whether the bracket has become much smaller.
bool RootBracket::keep_within(Coefficients p, const Exact& middle, const Exact& radius) {
  const Exact before = high_ - low_;
  if (keep_side(p, middle - radius) || keep_side(p, middle + radius)) return true;
  return (high_ - low_) * Exact(16) < before;
}

}  // namespace touchstone::numbers
