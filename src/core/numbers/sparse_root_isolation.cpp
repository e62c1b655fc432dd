// The sparse roots of a polynomial in [0, 1], each with a bracket.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "numbers/sparse_root.hpp"
#include "numbers/sparse_values.hpp"

namespace touchstone::numbers {

using Rewind = SparseScratch::Rewind;

void SparseRoots::push(SparseRoot&& root) {
  if (doubt_.raised() || (limit_ < 1 && root.compare(limit_) > 0)) return;
  roots_[static_cast<std::size_t>(size_++)] = std::move(root);
}

void SparseRoots::push_double(double time, int multiplicity) {
  push(SparseRoot::at_double(time, multiplicity, doubt_));
}

/// When it lies in (0, 1).
void SparseRoots::push_quotient(const Sparse& numerator, const Sparse& denominator, int multiplicity) {
  const bool negative = denominator.sign() < 0;
  const Sparse n = negative ? -numerator : numerator, d = negative ? -denominator : denominator;
  if (n.sign() <= 0 || (n - d).sign() >= 0) return;
  SparseRoot root;
  root.doubt_ = &doubt_;
  root.multiplicity_ = multiplicity;
  root.become_exact(n, d);
  push(std::move(root));
}

void SparseRoots::push_simple(const Coefficients& p, int size, const Sparse& low, const Sparse& high,
                              const Sparse& divisor, int sign_low) {
  auto root = SparseRoot::simple(p, size, low, high, divisor, sign_low, doubt_);
  if (root) push(std::move(*root));
}

void SparseRoots::isolate(Coefficients p, int size) {
  size = actual_size(p.data(), size);
  int at_zero = 0;
  while (size > 1 && p[0].is_zero()) {
    for (int i = 0; i + 1 < size; ++i) p[static_cast<std::size_t>(i)] = p[static_cast<std::size_t>(i + 1)];
    p[static_cast<std::size_t>(--size)] = Sparse();
    ++at_zero;
  }
  if (at_zero > 0) push_double(0, at_zero);
  if (size <= 1) return;
  const std::array<int, 4> signs = WidePolynomial(p.data(), size).bernstein_signs(std::nullopt, WidePoint());
  if (std::none_of(signs.begin(), signs.end(), [](int sign) { return sign == 0; })) {
    return isolate_inside(p, size, signs);
  }
  int ones = 0;
  while (size > 1 && value_at<Sparse>(p.data(), size, Sparse(1), Sparse(1)).is_zero()) {  // synthetic division by t - 1
    for (int i = size - 2; i > 0; --i) {
      p[static_cast<std::size_t>(i)] = p[static_cast<std::size_t>(i)] + p[static_cast<std::size_t>(i + 1)];
    }
    for (int i = 0; i + 1 < size; ++i) p[static_cast<std::size_t>(i)] = p[static_cast<std::size_t>(i + 1)];
    p[static_cast<std::size_t>(--size)] = Sparse();
    ++ones;
  }
  if (size > 1) isolate_inside(p, size, exact_bernstein_signs(p, size));
  if (ones > 0) push_double(1, ones);
}

/// Over [0, 1], of degree 3.
std::array<int, 4> SparseRoots::exact_bernstein_signs(const Coefficients& p, int size) {
  const Rewind rewind;
  const Sparse twice = p[0] + p[0], thrice = twice + p[0];
  const int first = p[0].sign();
  std::array<int, 4> signs = {first, first, first, first};
  if (size == 2) signs[3] = (p[0] + p[1]).sign();
  if (size == 3) {
    signs[2] = (twice + p[1]).sign();
    signs[3] = (p[0] + p[1] + p[2]).sign();
  }
  if (size == 4) {
    signs[1] = (thrice + p[1]).sign();
    signs[2] = (thrice + p[1] + p[1] + p[2]).sign();
    signs[3] = (p[0] + p[1] + p[2] + p[3]).sign();
  }
  return signs;
}

/// Of a polynomial that vanishes neither at 0 nor at 1, from the signs of its Bernstein coefficients.
void SparseRoots::isolate_inside(const Coefficients& p, int size, const std::array<int, 4>& signs) {
  const Sparse zero, one(1);
  const int first = signs[0];
  int variations = 0;
  int previous = first;
  for (const int sign : signs) {
    variations += sign == -previous && sign != 0;
    if (sign != 0) previous = sign;
  }
  if (variations == 0) return;
  if (variations == 1) return push_simple(p, size, zero, one, one, first);
  if (size == 3) return isolate_quadratic(p);
  isolate_cubic(p);
}

/// With two variations: it has the leading coefficient's sign at both ends, and its vertex lies inside.
void SparseRoots::isolate_quadratic(const Coefficients& p) {
  const Sparse product = p[0] * p[2], twice = product + product;
  const int discriminant = (p[1] * p[1] - (twice + twice)).sign();
  if (discriminant < 0) return;
  const bool negative = p[2].sign() < 0;
  const Sparse n = negative ? p[1] : -p[1], d = negative ? -(p[2] + p[2]) : p[2] + p[2];
  if (discriminant == 0) return push_quotient(n, d, 2);
  const int sign = p[0].sign();
  const Sparse zero, one(1);
  const Sparse vertex = sparse(approximate(n) / approximate(d));
  if (vertex.sign() > 0 && (one - vertex).sign() > 0 && sign_of_value(p.data(), 3, vertex, one) == -sign) {
    push_simple(p, 3, zero, vertex, one, sign);
    push_simple(p, 3, vertex, one, one, -sign);
  } else {
    push_simple(p, 3, zero, n, d, sign);
    push_simple(p, 3, n, d, d, -sign);
  }
}

namespace {

/// The signs of three times the Bernstein coefficients over [low, high], that is of the blossom's values.
std::array<int, 4> bernstein_signs(const std::array<Sparse, 4>& c, const Sparse& low, const Sparse& high) noexcept {
  const Rewind rewind;
  const Sparse three(3), c0 = three * c[0], c3 = three * c[3];
  const auto blossom = [&](const Sparse& a, const Sparse& b, const Sparse& d) {
    const Sparse ab = a * b;
    return (c0 + c[1] * (a + b + d) + c[2] * (ab + (a + b) * d) + c3 * (ab * d)).sign();
  };
  return {blossom(low, low, low), blossom(low, low, high), blossom(low, high, high), blossom(high, high, high)};
}

}  // namespace

/// With two or three variations.
void SparseRoots::isolate_cubic(const Coefficients& p) {
  // Near its critical points, or near its inflection if it has none.
  const Approximation a = approximate(p[3]) * normalised(3, 0), b = approximate(p[2]), c = approximate(p[1]);
  const Approximation discriminant = b * b + -(a * c);
  std::array<Sparse, 4> ends = {Sparse(), Sparse(1), Sparse(1), Sparse(1)};
  std::array<WidePoint, 4> points;  // the same, but for the first
  std::size_t count = 1;
  const auto add = [&](const Approximation& point) {
    const Sparse x = sparse(point);
    if ((x - ends[count - 1]).sign() <= 0 || (Sparse(1) - x).sign() <= 0) return;
    ends[count] = x;
    points[count++] = {point.significand, point.exponent, 0};
  };
  if (discriminant.significand > 0) {
    const Approximation root = root_of(discriminant);
    const Approximation sum = -(b + (b.significand < 0 ? -root : root));
    Approximation first = sum / a, second = c / sum;
    if ((sparse(first) - sparse(second)).sign() > 0) std::swap(first, second);
    add(first);
    add(second);
  } else {
    add(-b / a);
  }
  ends[count++] = Sparse(1);
  std::array<int, 4> one{};  // the sign at the start of a part with one root; 0: without a root
  const WidePolynomial wide(p.data(), 4);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    bool none = false, single = false;
    std::array<int, 4> signs{};
    const auto look_at = [&](const std::array<int, 4>& known) {
      signs = known;
      const bool certain = signs[0] != 0 && signs[3] != 0;
      none = certain && signs[0] == signs[3] && signs[1] == signs[0] && signs[2] == signs[0];
      single = certain && signs[0] != signs[3] && (signs[1] == signs[0] || signs[2] == signs[3]);
    };
    look_at(wide.bernstein_signs(i > 0 ? std::optional(points[i]) : std::nullopt, points[i + 1]));
    if (!none && !single) look_at(bernstein_signs(p, ends[i], ends[i + 1]));
    if (!none && !single) return isolate_between_critical_points(p);
    if (single) one[i] = signs[0];
  }
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if (one[i] != 0) push_simple(p, 4, ends[i], ends[i + 1], Sparse(1), one[i]);
  }
}

/// At a critical point r of p = a t^3 + b t^2 + c t + d, 9 a p(r) = (6 a c - 2 b^2) r + (9 a d - b c). Between such
/// points and the ends p is monotone. A double root of p is where the linear polynomial vanishes.
void SparseRoots::isolate_between_critical_points(const Coefficients& p) {
  const Polynomial<Sparse, 2> derivative = {{p[1], p[2] + p[2], p[3] * Sparse(3)}};
  const SparseRoots critical(derivative, 1, doubt_);
  const auto rest = [&p](auto n) {
    using N = decltype(n);
    const N a(p[3]), b(p[2]), c(p[1]), d(p[0]), six(Sparse(6)), nine(Sparse(9));
    return std::array<N, 2>{nine * (a * d) - b * c, six * (a * c) - (b * b + b * b)};
  };
  const int ascending = p[3].sign();

  // From the last point on, whose sign is not zero, p is monotone up to the next.
  Sparse low, divisor(1);
  int sign_low = p[0].sign();
  const auto push_between = [&](const Sparse& high, const Sparse& divisor_of_high) {
    push_simple(p, 4, low * divisor_of_high, high * divisor, divisor * divisor_of_high, sign_low);
  };
  for (int i = 0; i < critical.size() && !doubt_.raised(); ++i) {
    const SparseRoot& point = critical[i];
    if (point.upper() == 0 || point.lower() == 1) continue;
    const auto [first, last] = signs_of_linear(rest, point.low_, point.high_, point.divisor_);
    const int sign = ascending * (first == last ? first : point.sign_at(Polynomial<Sparse, 1>{rest(Sparse())}));
    if (sign == 0 && point.multiplicity() == 2) return push_quotient(point.low_, point.divisor_, 3);
    if (sign == 0) {
      // p = a (t - n / d)^2 (t - s), s = -b / a - 2 n / d. s is after n / d where p has the sign of -a before that.
      const auto linear = rest(Sparse());
      const Sparse n = linear[0], d = -linear[1];
      push_quotient(n, d, 2);
      if (sign_low != ascending) push_quotient(-(p[2] * d + p[3] * (n + n)), p[3] * d, 1);
      return;
    }
    if (sign != sign_low) {
      if (!point.narrow_until(p, sign, true)) return doubt_.raise();
      push_between(point.low_, point.divisor_);
    }
    // Just after the point, or a little later.
    if (!point.narrow_until(p, sign, false)) return doubt_.raise();
    low = point.high_;
    divisor = point.divisor_;
    sign_low = sign;
  }
  if (value_at<Sparse>(p.data(), 4, Sparse(1), Sparse(1)).sign() == -sign_low) push_between(Sparse(1), Sparse(1));
}

}  // namespace touchstone::numbers
