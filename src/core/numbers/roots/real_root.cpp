// SPDX-License-Identifier: MIT
#include "numbers/roots/real_root.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "numbers/integers/gmp_conversions.hpp"
#include "numbers/roots/coprime.hpp"
#include "numbers/roots/integer_polynomial.hpp"

namespace touchstone::numbers {
namespace {

constexpr int kMaxSize = kMostDegree + 1;  // coefficients

/// The sign of q(numerator / denominator), denominator > 0.
int sign_at_rational(Coefficients q, const Exact& numerator, const Exact& denominator) {
  if (is_zero(numerator)) return sign_of(q.c[0]);
  Exact value = q.c[q.size - 1];
  Exact power = denominator;
  for (int i = q.size - 2; i >= 0; --i) {
    value = value * numerator + q.c[i] * power;
    if (i > 0) power = power * denominator;
  }
  return sign_of(value);
}

/// Whether q is a constant times p, which is not zero.
bool is_multiple_of(Coefficients p, Coefficients q) {
  int size = q.size;
  while (size > 0 && is_zero(q.c[size - 1])) --size;
  if (size != p.size) return false;
  const Exact &of_p = p.c[size - 1], &of_q = q.c[size - 1];
  for (int i = size - 2; i >= 0; --i) {
    if (is_zero(p.c[i]) != is_zero(q.c[i])) return false;
    if (p.c[i] * of_q != q.c[i] * of_p) return false;
  }
  return true;
}

/// A polynomial whose leading coefficient is not zero; empty for the zero polynomial.
struct Dense {
  ExactList c;

  explicit Dense(Coefficients q) : c(q.c, q.size) { trim(); }
  int size() const { return c.size(); }
  void trim() {
    int size = c.size();
    while (size > 0 && is_zero(c[static_cast<std::size_t>(size - 1)])) --size;
    c.shorten(size);
  }
  const Exact& leading() const { return c[static_cast<std::size_t>(size() - 1)]; }
  int sign_at(const Exact& t) const { return size() == 0 ? 0 : sign_of(evaluate({c.begin(), size()}, t)); }
};

/// A positive multiple of the remainder of a by b, b not zero.
Dense positive_remainder(Dense a, const Dense& b) {
  const bool negative = sign_of(b.leading()) < 0;
  const Exact scale = negative ? -b.leading() : b.leading();
  while (a.size() >= b.size()) {
    const Exact factor = negative ? -a.leading() : a.leading();
    const int shift = a.size() - b.size();
    for (int i = 0; i < a.size() - 1; ++i) {
      Exact& target = a.c[static_cast<std::size_t>(i)];
      target = target * scale;
      if (i >= shift) target = target - factor * b.c[static_cast<std::size_t>(i - shift)];
    }
    a.c.shorten(a.size() - 1);
    a.trim();
  }
  return a;
}

/// numerator / denominator over a bracket, if it varies by so little that this is the quotient at the root within
/// 2^-50.5; it is known to lie in [0, 1] there.
bool quotient_over(const RootBracket& bracket, Coefficients numerator, Coefficients denominator, double& result) {
  // Both polynomials lie between the least and the greatest of their Bernstein coefficients over the bracket. Equal
  // formal degrees have coefficients times the same number.
  const auto enclose = [&bracket](Coefficients q, Exact& least, Exact& greatest) {
    const BernsteinForm form(q, bracket.low(), bracket.high());
    least = *std::min_element(form.begin(), form.end());
    greatest = *std::max_element(form.begin(), form.end());
  };
  Exact n_least, n_greatest, d_least, d_greatest;
  enclose(numerator, n_least, n_greatest);
  enclose(denominator, d_least, d_greatest);
  if (sign_of(d_greatest) < 0) {
    std::swap(n_least, n_greatest);
    std::swap(d_least, d_greatest);
    n_least = -n_least;
    n_greatest = -n_greatest;
    d_least = -d_least;
    d_greatest = -d_greatest;
  }
  if (sign_of(n_least) < 0) n_least = Exact(0);  // the quotient is known not to be negative
  if (sign_of(d_least) <= 0 || n_greatest * d_greatest - n_least * d_least > Exact(0x1p-53) * d_least * d_greatest) {
    return false;
  }
  result = std::clamp(approximate_quotient(n_least + n_greatest, d_least + d_greatest), 0.0, 1.0);
  return true;
}

constexpr double kGreatest = std::numeric_limits<double>::max();

Exact magnitude(const Exact& x) { return sign_of(x) < 0 ? -x : x; }

/// How much q's values in the bracket differ from that at its lower end, at most: see below.
Exact spread(const RootBracket& bracket, Coefficients q) {
  Exact sum(0);
  for (int k = 1; k < q.size; ++k) sum = sum + magnitude(q.c[k]);
  return sum * Exact(q.size - 1) * (bracket.high() - bracket.low());
}

/// The greatest double <= n / d, for positive n and d, but at least the least positive one; infinity beyond all.
double lower_double(const Exact& n, const Exact& d) {
  // Doubles that are positive have the order of their bits.
  const auto is_at_least = [&](std::uint64_t bits) { return n >= Exact(std::bit_cast<double>(bits)) * d; };
  constexpr auto kMost = std::bit_cast<std::uint64_t>(kGreatest);
  if (is_at_least(kMost)) return std::numeric_limits<double>::infinity();
  std::uint64_t low =
      std::max<std::uint64_t>(std::bit_cast<std::uint64_t>(std::min(approximate_quotient(n, d), kGreatest)), 1);
  std::uint64_t high = low;
  for (std::uint64_t step = 1; low > 1 && !is_at_least(low); step *= 2) low -= std::min(low - 1, step);
  for (std::uint64_t step = 1; high <= low || is_at_least(high); step *= 2) high += std::min(kMost - high, step);
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (is_at_least(middle) ? low : high) = middle;
  }
  return std::bit_cast<double>(low);
}

/// The same from the values at the bracket's lower end, which is much cheaper for high degrees. A polynomial differs
/// from its value there by at most its slope's bound, the sum of k |c_k| in [0, 1], times the bracket's width. For the
/// values n and d and these bounds a and b, the quotient differs from n / d by at most (a |d| + |n| b) / (|d| (|d| -
/// b)).
bool quotient_at_low(const RootBracket& bracket, Coefficients numerator, Coefficients denominator, double& result) {
  const Exact n = evaluate(numerator, bracket.low()), d = evaluate(denominator, bracket.low());
  const Exact a = spread(bracket, numerator), b = spread(bracket, denominator), size = magnitude(d), left = size - b;
  if (sign_of(left) <= 0 || a * size + magnitude(n) * b > Exact(0x1p-53) * size * left) return false;
  result = std::clamp(approximate_quotient(n, d), 0.0, 1.0);
  return true;
}

std::string hexfloat(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

}  // namespace

ScaledDoubles scaled_to_doubles(Coefficients p) {
  std::array<Approximation, kMostDegree + 1> terms;
  ScaledDoubles result = {{}, std::numeric_limits<long>::min()};
  const std::size_t size = static_cast<std::size_t>(p.size);
  for (std::size_t i = 0; i < size; ++i) {
    terms[i] = approximate(p.c[i]);
    if (terms[i].significand != 0) result.exponent = std::max(result.exponent, terms[i].exponent);
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (terms[i].significand == 0) continue;
    const long exponent = std::max(terms[i].exponent - result.exponent, -2000L);
    result.c[i] = std::ldexp(terms[i].significand, static_cast<int>(exponent));
  }
  return result;
}

RealRoot RealRoot::rational(const Exact& numerator, const Exact& denominator, int multiplicity) {
  RealRoot root;
  root.is_rational_ = true;
  root.multiplicity_ = multiplicity;
  const bool negate = sign_of(denominator) < 0;
  root.numerator_ = negate ? -numerator : numerator;
  root.denominator_ = negate ? -denominator : denominator;
  root.find_neighbouring_doubles();
  root.find_small_integers();
  return root;
}

RealRoot RealRoot::isolated(Coefficients p, const Exact& low, const Exact& high, int sign_low) {
  RealRoot root;
  root.degree_ = p.size - 1;
  if (root.degree_ <= kShort) {
    std::copy(p.c, p.c + p.size, root.p_.begin());
  } else {
    root.long_p_.assign(p.c, p.c + p.size);
  }
  root.bracket_ = RootBracket(low, high, sign_low);
  root.find_neighbouring_doubles();
  root.narrow_ = root.bracket_;
  return root;
}

int RealRoot::compare(const Exact& value) const {
  if (is_rational_) return sign_of(numerator_ - value * denominator_);
  return bracket_.compare(polynomial(), value);
}

int RealRoot::compare(const RealRoot& other) const {
  if (upper_ < other.lower_) return -1;
  if (lower_ > other.upper_) return 1;
  if (other.is_rational_) {
    if (is_rational_) return sign_of(numerator_ * other.denominator_ - other.numerator_ * denominator_);
    return -other.compare(*this);
  }
  // The other is the only root of its polynomial in its interval: find the side of it on which this root lies.
  if (compare(other.bracket_.low()) <= 0) return -1;
  if (compare(other.bracket_.high()) >= 0) return 1;
  const int sign = sign_at(other.polynomial());
  return sign == 0 ? 0 : sign == other.bracket_.sign_low() ? -1 : 1;
}

/// A double near the root, by safeguarded Newton iteration in doubles; only a hint.
double RealRoot::estimate() const {
  if (is_rational_) return approximate_quotient(numerator_, denominator_);
  const auto [c, largest] = scaled_to_doubles(polynomial());
  double low = to_double(bracket_.low());
  double high = to_double(bracket_.high());
  double t = 0.5 * (low + high);
  double slope = 0;
  constexpr int kIterations = 50;
  for (int i = 0; i < kIterations; ++i) {
    double value = c[static_cast<std::size_t>(degree_)];
    slope = degree_ * value;
    for (int k = degree_ - 1; k >= 0; --k) {
      value = value * t + c[static_cast<std::size_t>(k)];
      if (k > 0) slope = slope * t + k * c[static_cast<std::size_t>(k)];
    }
    if ((value < 0) == (bracket_.sign_low() < 0)) {
      low = t;
    } else {
      high = t;
    }
    double next = t - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool converged = std::fabs(next - t) <= 0x1p-52 * t;
    t = next;
    if (converged) break;
  }
  // One Newton step with the exact residual makes up for the rounding of the coefficients.
  const Approximation residual = approximate(evaluate(polynomial(), Exact(t)));
  if (residual.exponent - largest > -2000 && residual.exponent - largest < 2000) {
    const double better = t - std::ldexp(residual.significand, static_cast<int>(residual.exponent - largest)) / slope;
    if (better >= to_double(bracket_.low()) && better <= to_double(bracket_.high())) t = better;
  }
  return t;
}

void RealRoot::find_neighbouring_doubles() {
  // Doubles >= 0 are ordered as their bit patterns: `below` <= root <= `above`, one probe at a time.
  const auto settle = [this](double time) {
    lower_ = upper_ = time;
    if (!is_rational_) become_rational(Exact(time));
  };
  if (is_rational_ && is_zero(numerator_)) return settle(0.0);
  if (is_rational_ && numerator_ == denominator_) return settle(1.0);
  std::uint64_t below = std::bit_cast<std::uint64_t>(0.0);
  std::uint64_t above = std::bit_cast<std::uint64_t>(1.0);
  std::uint64_t probe = std::bit_cast<std::uint64_t>(std::clamp(estimate(), 0.0, 1.0));
  std::uint64_t stride = 1;
  int previous = 0;
  constexpr std::uint64_t kPoorHint = 4;
  int better_hints = 2;  // to come
  while (above - below > 1) {
    probe = std::clamp(probe, below + 1, above - 1);
    const double time = std::bit_cast<double>(probe);
    const int side = compare(Exact(time));
    if (side == 0) return settle(time);
    (side > 0 ? below : above) = probe;
    // Gallop away from the hint until the root is passed, then bisect.
    if (previous != 0 && side != previous) stride = 0;
    previous = side;
    if (stride == kPoorHint && !is_rational_ && better_hints-- > 0) {
      bracket_.keep_between(Exact(std::bit_cast<double>(below)), Exact(std::bit_cast<double>(above)));
      bracket_.narrow(polynomial());
      bracket_.narrow(polynomial());
      probe = std::bit_cast<std::uint64_t>(
          std::clamp(to_double((bracket_.low() + bracket_.high()) * Exact(0.5)), 0.0, 1.0));
      stride = 1;
      previous = 0;
    } else if (stride == 0) {
      probe = below + (above - below) / 2;
    } else {
      probe = side > 0 ? (above - probe > stride ? probe + stride : above)
                       : (probe - below > stride ? probe - stride : below);
      stride *= 2;
    }
  }
  lower_ = std::bit_cast<double>(below);
  upper_ = std::bit_cast<double>(above);
  if (is_rational_) return;
  if (bracket_.is_root()) return become_rational(bracket_.low());  // with more digits than a double has
  bracket_.keep_between(Exact(lower_), Exact(upper_));
}

void RealRoot::become_rational(const Exact& value) {
  is_rational_ = true;
  numerator_ = value;
  denominator_ = Exact(1);
  find_small_integers();
}

void RealRoot::find_small_integers() {
  // Of one limb each, over the same power of two; or a double with few digits.
  const auto small = [](const Exact& x) { return x.limb_count() == 1 && x.limb(0) < Exact::Limb{kSmall}; };
  if (is_zero(numerator_)) {
    small_numerator_ = 0;
    small_denominator_ = 1;
  } else if (small(numerator_) && small(denominator_) && numerator_.limb_exponent() == denominator_.limb_exponent()) {
    small_numerator_ = static_cast<std::int64_t>(numerator_.limb(0));
    small_denominator_ = static_cast<std::int64_t>(denominator_.limb(0));
  } else if (lower_ == upper_ && lower_ > 0x1p-50) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(lower_);
    const std::uint64_t significand = (bits & 0x000FFFFFFFFFFFFF) | 0x0010000000000000;
    const int zeros = std::countr_zero(significand);
    const int shift = 1075 - static_cast<int>(bits >> 52) - zeros;  // value = (significand >> zeros) 2^-shift
    if (shift < 0 || shift > 59) return;
    small_numerator_ = static_cast<std::int64_t>(significand >> zeros);
    small_denominator_ = std::int64_t{1} << shift;
  }
}

/// Whether q has the isolated root: then it is one of their greatest common divisor, which has no other between low and
/// high and changes its sign there, as p does.
bool RealRoot::vanishes_at_isolated(Coefficients q) const {
  if (certainly_coprime(polynomial(), q)) return false;
  if (is_multiple_of(polynomial(), q)) return true;  // mostly p itself
  constexpr int kLow = 6;
  if (degree_ > kLow || q.size > kLow + 1) {
    // Without the division of common factors, the coefficients' lengths grow exponentially with the degree.
    const Integers divisor = greatest_common_divisor(primitive_integers(polynomial()), primitive_integers(q));
    std::vector<Exact> c;
    for (const mpz_class& integer : divisor) c.push_back(exact_from_integer(integer));
    const Dense common(Coefficients(c.data(), static_cast<int>(c.size())));
    return common.size() > 1 && common.sign_at(bracket_.low()) * common.sign_at(bracket_.high()) < 0;
  }
  Dense divisor(polynomial());
  Dense rest(q);
  while (rest.size() > 0) {
    Dense next = positive_remainder(divisor, rest);
    divisor = std::move(rest);
    rest = std::move(next);
  }
  return divisor.size() > 1 && divisor.sign_at(bracket_.low()) * divisor.sign_at(bracket_.high()) < 0;
}

ValueNear value_near(const double* c, int size, double lower) noexcept {
  // e = 2^-53, S the sum of the coefficients' absolute values, n the degree. At `lower` the coefficients are off by
  // 4 e S, and at most 2 n roundings of values of at most S follow. The next double is at most e away, where the slope
  // is at most n S: (4 + 3 n) e S in all; the rest is for second-order terms and the rounding of S. From a least S up,
  // coefficients and products that underflow do not count; an overflow makes the error infinite.
  constexpr double kConstantBound = 5 * 0x1p-53;
  constexpr double kDegreeBound = 3 * 0x1p-53;
  constexpr double kLeast = 0x1p-900;
  double value = c[size - 1];
  double sum = std::fabs(value);
  for (int i = size - 2; i >= 0; --i) {
    value = value * lower + c[i];
    sum += std::fabs(c[i]);
  }
  const double bound = kConstantBound + kDegreeBound * (size - 1);
  return {value, sum >= kLeast ? bound * sum : std::numeric_limits<double>::quiet_NaN()};
}

int RealRoot::sign_at(Coefficients q) const {
  if (is_rational_) return sign_at_rational(q, numerator_, denominator_);
  if (const auto sign = bracket_.sign_over(q)) return *sign;
  if (vanishes_at_isolated(q)) return 0;
  // Not zero: a bracket that is narrow enough shows the sign.
  for (;;) {
    if (const auto sign = narrow_.sign_over(q)) return *sign;
    narrow_.narrow(polynomial());
  }
}

int RealRoot::quick_sign_at(Coefficients q) const {
  std::array<double, kMaxSize> c;
  for (int i = 0; i < q.size; ++i) c[static_cast<std::size_t>(i)] = to_double(q.c[i]);
  const int sign = certain_sign(c.data(), q.size);
  return sign != 0 ? sign : sign_at(q);
}

int RealRoot::sign_after(Coefficients q) const { return sign_beside(q, 1); }
int RealRoot::sign_before(Coefficients q) const { return sign_beside(q, -1); }

int RealRoot::sign_beside(Coefficients q, int side) const {
  // Just after the root, q has the sign of its first derivative that does not vanish there. Just before it, a
  // derivative of odd order counts with the opposite sign.
  ExactList derivative(q.c, q.size);
  int factor = 1;
  for (int size = q.size; size > 0; --size) {
    const int sign = sign_at({derivative.begin(), size});
    if (sign != 0) return factor * sign;
    factor *= side;
    for (int i = 1; i < size; ++i)
      derivative[static_cast<std::size_t>(i - 1)] = derivative[static_cast<std::size_t>(i)] * Exact(i);
  }
  return 0;
}

RealRoot RealRoot::reversed() const {
  if (is_rational_) return rational(denominator_ - numerator_, denominator_, multiplicity_);
  ExactList mirrored = taylor_coefficients(polynomial(), Exact(1));  // of p(1 - t), but for signs
  for (std::size_t i = 1; i <= static_cast<std::size_t>(degree_); i += 2) mirrored[i] = -mirrored[i];
  RealRoot root = isolated({mirrored.begin(), mirrored.size()}, Exact(1) - bracket_.high(), Exact(1) - bracket_.low(),
                           -bracket_.sign_low());
  root.multiplicity_ = multiplicity_;
  return root;
}

Exact RealRoot::homogeneous_value(Coefficients q, int degree) const {
  Exact value(0);
  Exact power(1);  // of the denominator
  for (int i = degree; i >= 0; --i) {
    value = value * numerator_;
    if (i < q.size) value = value + q.c[i] * power;
    if (i > 0) power = power * denominator_;
  }
  return value;
}

double RealRoot::ratio(Coefficients numerator, Coefficients denominator) const {
  if (is_rational_) {
    const int degree = std::max(numerator.size, denominator.size) - 1;
    const Exact n = homogeneous_value(numerator, degree), d = homogeneous_value(denominator, degree);
    return sign_of(n) * sign_of(d) * lower_double(magnitude(n), magnitude(d));
  }
  // The values n and d at the bracket's lower end are off by at most a and b. A double is the ratio, or beside it, if
  // (n - a) / (d + b) is above the double before it, and (n + a) / (d - b) is below the one after it.
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (;; narrow_.narrow(polynomial())) {
    const Exact at_numerator = evaluate(numerator, narrow_.low()),
                at_denominator = evaluate(denominator, narrow_.low());
    const Exact n = magnitude(at_numerator), d = magnitude(at_denominator);
    const Exact a = spread(narrow_, numerator), b = spread(narrow_, denominator);
    if (n <= a || d <= b) continue;
    const double lower = lower_double(n, d);
    const int sign = sign_of(at_numerator) * sign_of(at_denominator);
    for (const double found : {lower, lower == kInfinity ? kGreatest : std::nextafter(lower, kInfinity)}) {
      const double before = std::nextafter(found, 0.0), after = std::nextafter(found, kInfinity);
      const bool is_above = before == 0 || n - a > Exact(before) * (d + b);
      const bool is_below = after == kInfinity || n + a < Exact(after) * (d - b);
      if (is_above && is_below) return sign * found;
    }
  }
}

double RealRoot::quotient(Coefficients numerator, Coefficients denominator) const {
  if (is_rational_) {
    const int degree = std::max(numerator.size, denominator.size) - 1;
    const Exact n = homogeneous_value(numerator, degree), d = homogeneous_value(denominator, degree);
    return std::clamp(approximate_quotient(n, d), 0.0, 1.0);
  }
  if (numerator.size != denominator.size) {  // the bounds below are for equal formal degrees
    const auto lengthened = [size = std::max(numerator.size, denominator.size)](Coefficients q) {
      ExactList c(size);
      std::copy(q.c, q.c + q.size, c.begin());
      return c;
    };
    const ExactList n = lengthened(numerator);
    const ExactList d = lengthened(denominator);
    return quotient({n.begin(), n.size()}, {d.begin(), d.size()});
  }
  double result;
  constexpr int kLongSize = 5;
  if (numerator.size >= kLongSize) {
    while (!quotient_at_low(narrow_, numerator, denominator, result)) narrow_.narrow(polynomial());
    return result;
  }
  if (quotient_over(bracket_, numerator, denominator, result)) return result;
  while (!quotient_over(narrow_, numerator, denominator, result)) narrow_.narrow(polynomial());
  return result;
}

std::string RealRoot::to_string() const {
  if (is_rational_) return quotient_to_string(numerator_, denominator_);
  std::string text = "root of";
  for (int i = degree_; i >= 0; --i) {
    const Exact& c = polynomial().c[i];
    if (is_zero(c)) continue;
    if (i < degree_) text += " +";
    text += " (" + numbers::to_string(c) + ")";
    if (i > 0) text += i == 1 ? " t" : " t^" + std::to_string(i);
  }
  return text + " in [" + hexfloat(lower_) + ", " + hexfloat(upper_) + "]";
}

}  // namespace touchstone::numbers
