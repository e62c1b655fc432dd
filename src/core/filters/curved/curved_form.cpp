// SPDX-License-Identifier: MIT
#include "filters/curved/curved_form.hpp"

namespace touchstone::filters {
namespace {

using numbers::Bounded;
using numbers::kRounding;
using numbers::kUnderflow;
using Index = std::size_t;
using Coefficients = std::array<double, kMostCurvedDegree + 1>;

Index size_of(int degree) noexcept { return static_cast<Index>(degree) + 1; }

/// sum += a * b, or sum -= a * b.
template <bool Minus>
void convolve(Coefficients& sum, const Coefficients& a, Index a_size, const Coefficients& b, Index b_size) noexcept {
  for (Index i = 0; i < a_size; ++i) {
    for (Index j = 0; j < b_size; ++j) {
      const double product = a[i] * b[j];
      sum[i + j] = Minus ? sum[i + j] - product : sum[i + j] + product;
    }
  }
}

/// The bound on a sum of `count` products of forms with these sizes and errors, each product a convolution. In each of
/// them a coefficient sums at most 1 + min(m, n) products, m and n the degrees. So at most count (1 + min(m, n)) + 1
/// roundings, the product's own among them, meet a product. The products' absolute values sum to at most
/// count times the product of the sizes, times the binomial coefficient.
template <class A, class B>
double product_error(const A& a, const B& b, int count) noexcept {
  const double roundings = count * (1 + std::min(a.degree, b.degree)) + 1;
  return count *
         (a.size * b.error + a.error * (b.size + b.error) + (roundings * kRounding) * (a.size * b.size) + kUnderflow);
}

/// Component k of a x b, before it is measured.
void cross_component(const VectorForm& a, const VectorForm& b, Index k, Coefficients& result) noexcept {
  const Index i = (k + 1) % 3, j = (k + 2) % 3;
  std::fill_n(result.begin(), size_of(a.degree + b.degree), 0.0);
  convolve<false>(result, a.c[i], size_of(a.degree), b.c[j], size_of(b.degree));
  convolve<true>(result, a.c[j], size_of(a.degree), b.c[i], size_of(b.degree));
}

}  // namespace

ScalarForm constant(double x) noexcept {
  ScalarForm form;
  form.size = std::fabs(x);
  form.c[0][0] = x;
  return form;
}

template <Index Dim>
CurvedForm<Dim> operator*(const ScalarForm& a, const CurvedForm<Dim>& b) noexcept {
  CurvedForm<Dim> product;
  product.degree = a.degree + b.degree;
  for (Index k = 0; k < Dim; ++k) {
    std::fill_n(product.c[k].begin(), size_of(product.degree), 0.0);
    convolve<false>(product.c[k], a.c[0], size_of(a.degree), b.c[k], size_of(b.degree));
  }
  product.size = a.size * b.size;
  product.error = product_error(a, b, 1);
  return product;
}

/// The same polynomials, of a higher degree: times 1 = (1 - t) + t.
template <Index Dim>
CurvedForm<Dim> elevated(CurvedForm<Dim> form, int degree) noexcept {
  ScalarForm one;
  one.degree = 1;
  one.size = 1;
  one.c[0][0] = one.c[0][1] = 1;
  while (form.degree < degree) form = one * form;
  return form;
}

/// a + sign b.
template <Index Dim>
CurvedForm<Dim> sum(CurvedForm<Dim> a, CurvedForm<Dim> b, double sign) noexcept {
  if (a.degree < b.degree) a = elevated(a, b.degree);
  if (b.degree < a.degree) b = elevated(b, a.degree);
  for (Index k = 0; k < Dim; ++k) {
    for (Index i = 0; i < size_of(a.degree); ++i) a.c[k][i] += sign * b.c[k][i];
  }
  a.size += b.size;
  a.error += b.error + kRounding * a.size;
  return a;
}

template VectorForm operator*(const ScalarForm&, const VectorForm&) noexcept;
template ScalarForm operator*(const ScalarForm&, const ScalarForm&) noexcept;
template VectorForm sum(VectorForm, VectorForm, double) noexcept;
template ScalarForm sum(ScalarForm, ScalarForm, double) noexcept;
template VectorForm elevated(VectorForm, int) noexcept;
template ScalarForm elevated(ScalarForm, int) noexcept;

ScalarForm dot(const VectorForm& a, const VectorForm& b) noexcept {
  ScalarForm form;
  form.degree = a.degree + b.degree;
  std::fill_n(form.c[0].begin(), size_of(form.degree), 0.0);
  for (Index k = 0; k < 3; ++k) convolve<false>(form.c[0], a.c[k], size_of(a.degree), b.c[k], size_of(b.degree));
  form.error = product_error(a, b, 3);
  form.measure();
  return form;
}

VectorForm cross(const VectorForm& a, const VectorForm& b) noexcept {
  VectorForm form;
  form.degree = a.degree + b.degree;
  for (Index k = 0; k < 3; ++k) cross_component(a, b, k, form.c[k]);
  form.error = product_error(a, b, 2);
  form.measure();
  return form;
}

ScalarForm cross_component(const VectorForm& a, const VectorForm& b, Index axis) noexcept {
  ScalarForm form;
  form.degree = a.degree + b.degree;
  cross_component(a, b, axis, form.c[0]);
  form.error = product_error(a, b, 2);
  form.measure();
  return form;
}

// With p's coefficients b_k in the Bernstein basis, those of its derivative are n (b_(k+1) - b_k). Times binomial(n -
// 1, k) this is (k + 1) c_(k+1) - (n - k) c_k. Each product is at most binomial(n - 1, k) n size, and it is rounded; so
// is their difference: 4 e n size.
template <Index Dim>
CurvedForm<Dim> derivative_of(const CurvedForm<Dim>& p) noexcept {
  CurvedForm<Dim> result;
  const double n = p.degree;
  if (p.degree == 0) {
    for (auto& c : result.c) c[0] = 0;
    return result;
  }
  result.degree = p.degree - 1;
  for (Index axis = 0; axis < Dim; ++axis) {
    for (Index k = 0; k < size_of(result.degree); ++k) {
      const double at = static_cast<double>(k);
      result.c[axis][k] = (at + 1) * p.c[axis][k + 1] - (n - at) * p.c[axis][k];
    }
  }
  result.measure();
  result.error = n * (2 * p.error + 4 * kRounding * p.size) + kUnderflow;
  return result;
}
template ScalarForm derivative_of(const ScalarForm&) noexcept;
template VectorForm derivative_of(const VectorForm&) noexcept;

template <Index Dim>
double slope_of(const CurvedForm<Dim>& p) noexcept {
  if (p.degree == 0) return 0;
  const auto& b = kBinomial[static_cast<Index>(p.degree)];
  double largest = 0;
  for (const auto& c : p.c) {
    for (Index k = 1; k < size_of(p.degree); ++k)
      largest = std::max(largest, std::fabs(c[k] / b[k] - c[k - 1] / b[k - 1]));
  }
  return p.degree * (largest + 4 * kRounding * p.size);  // the quotients are rounded, and their difference
}
template double slope_of(const ScalarForm&) noexcept;
template double slope_of(const VectorForm&) noexcept;

namespace {

/// The bound on the values within `radius` of the time of evaluation. A term c_k t^k s^(n - k) has at most n roundings
/// of powers, n of s = 1 - t, 2 of products and n of sums: 3 n + 2. The terms' absolute values sum to at most the size,
/// if they are not below it by 2^-900, where something underflows.
template <Index Dim>
double value_error(const CurvedForm<Dim>& p, double radius, double slope) noexcept {
  return p.error + p.size * ((3 * p.degree + 3) * kRounding) + slope * radius + kUnderflow;
}

double evaluate(const Coefficients& c, int degree, double t, double s) noexcept {
  double value = c[0], power = 1;
  for (Index k = 1; k < size_of(degree); ++k) {
    power *= t;
    value = value * s + c[k] * power;
  }
  return value;
}

}  // namespace

Bounded value_at(const ScalarForm& p, double t, double radius, double slope) noexcept {
  return {evaluate(p.c[0], p.degree, t, 1 - t), value_error(p, radius, slope)};
}

geometry::Vector<Bounded> value_at(const VectorForm& p, double t, double radius, double slope) noexcept {
  const double error = value_error(p, radius, slope), s = 1 - t;
  return {{Bounded{evaluate(p.c[0], p.degree, t, s), error}, Bounded{evaluate(p.c[1], p.degree, t, s), error},
           Bounded{evaluate(p.c[2], p.degree, t, s), error}}};
}

}  // namespace touchstone::filters
