// SPDX-License-Identifier: MIT
#include "filters/curved_frame.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::filters {
namespace {

using numbers::Bounded;
using numbers::BoundedPair;
using numbers::kRounding;
using numbers::kUnderflow;
using Index = std::size_t;
using Coefficients = std::array<double, kMostCurvedDegree + 1>;

constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};

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

ScalarForm constant(double x) noexcept {
  ScalarForm form;
  form.size = std::fabs(x);
  form.c[0][0] = x;
  return form;
}

}  // namespace

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

namespace {

/// A point or an orientation, times 2^exponent without any rounding.
struct Scale {
  double factor = 1, inverse = 1;
  bool exact = true;

  explicit Scale(double largest) noexcept {
    constexpr double kLeast = 0x1p-20, kMost = 0x1p20, kExtreme = 0x1p900;
    if (largest == 0 || (largest >= kLeast && largest <= kMost)) return;
    if (!(largest >= 1 / kExtreme && largest <= kExtreme)) {
      exact = false;
      return;
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    factor = std::ldexp(1.0, -exponent);
    inverse = std::ldexp(1.0, exponent);
  }
  double operator()(double x) noexcept {
    const double y = factor * x;
    exact = exact && y * inverse == x;
    return y;
  }
};

double largest_of(const Vec3& x) noexcept { return std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)}); }

/// What the corners of one element have in common.
struct Body {
  bool turns = false;
  const RigidMotion* motion = nullptr;
  std::array<double, 4> q0{}, q1{};
  /// The coefficients M(q0, q0), 2 M(q0, q1) and M(q1, q1) of the matrix M(q), where M(a, b) is bilinear.
  std::array<std::array<std::array<double, 3>, 3>, 3> matrix;
  double largest = 0;  ///< component of q0 and q1
  ScalarForm weight = constant(1);
};

std::array<std::array<double, 3>, 3> bilinear(const std::array<double, 4>& a, const std::array<double, 4>& b) noexcept {
  const double ww = a[0] * b[0], xx = a[1] * b[1], yy = a[2] * b[2], zz = a[3] * b[3];
  const auto mixed = [&](Index i, Index j) { return a[i] * b[j] + a[j] * b[i]; };
  const double xy = mixed(1, 2), xz = mixed(1, 3), yz = mixed(2, 3);
  const double wx = mixed(0, 1), wy = mixed(0, 2), wz = mixed(0, 3);
  return {{{(ww + xx) - (yy + zz), xy - wz, xz + wy},
           {xy + wz, (ww + yy) - (xx + zz), yz - wx},
           {xz - wy, yz + wx, (ww + zz) - (xx + yy)}}};
}

// An entry of M(a, b) sums 4 products of components of q, each with its own rounding and those of two sums: 3 e each,
// in all 4 m^2 and 12 e m^2, for m the largest component. With a coordinate of the point, up to L and off by up to x,
// there is one rounding more, and those of the sums of three such products are two more: 6 e. So M(a, b) X is at most
// 12 m^2 L and off by at most 12 m^2 (6 e L + x). W = q . q sums 4 products with 3 roundings at most: 4 m^2, and off by
// 12 e m^2. Doublings are exact. What underflows is below kUnderflow for m <= 2^20 and L <= 2^20.
constexpr double kTurned = 12;
constexpr double kTurnedRoundings = 6;
constexpr double kWeightRoundings = 3;

Body body_of(const RigidMotion& motion, bool& exact) noexcept {
  Body body;
  body.turns = true;
  body.motion = &motion;
  double largest = 0;
  for (Index i = 0; i < 4; ++i) largest = std::max({largest, std::fabs(motion.q0[i]), std::fabs(motion.q1[i])});
  Scale scale(largest);
  for (Index i = 0; i < 4; ++i) {
    body.q0[i] = scale(motion.q0[i]);
    body.q1[i] = scale(motion.q1[i]);
  }
  exact = exact && scale.exact;
  body.largest = scale.factor * largest;
  body.matrix = {bilinear(body.q0, body.q0), bilinear(body.q0, body.q1), bilinear(body.q1, body.q1)};
  for (auto& row : body.matrix[1]) {
    for (double& entry : row) entry *= 2;
  }
  const auto dot = [](const std::array<double, 4>& a, const std::array<double, 4>& b) {
    return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
  };
  body.weight.degree = 2;
  body.weight.c[0] = {dot(body.q0, body.q0), 2 * dot(body.q0, body.q1), dot(body.q1, body.q1)};
  const double square = 4 * (body.largest * body.largest);
  body.weight.measure();
  body.weight.error = kWeightRoundings * kRounding * square + kUnderflow;
  return body;
}

/// M(q) x for a vector whose coordinates are each off by at most `off`.
VectorForm turned(const Body& body, const std::array<double, 3>& x, double off) noexcept {
  VectorForm form;
  form.degree = 2;
  for (Index i = 0; i < 3; ++i) {
    const auto& m = body.matrix[i];
    for (Index k = 0; k < 3; ++k) form.c[k][i] = (m[k][0] * x[0] + m[k][1] * x[1]) + m[k][2] * x[2];
  }
  const double largest = std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])});
  form.error = (kTurned * (body.largest * body.largest)) * (kTurnedRoundings * kRounding * largest + off) + kUnderflow;
  form.measure();
  return form;
}

/// Lengths are multiplied by `lengths`.
std::array<double, 3> point(const Vec3& x, Scale& lengths) noexcept {
  return {lengths(x.x), lengths(x.y), lengths(x.z)};
}

VectorForm curve(const CurvedCorner& corner, Scale& lengths) noexcept {
  VectorForm form;
  form.degree = corner.control_points - 1;
  const auto& b = kBinomial[static_cast<Index>(form.degree)];
  for (Index i = 0; i < size_of(form.degree); ++i) {
    const auto x = point(corner.points[i], lengths);
    for (Index k = 0; k < 3; ++k) form.c[k][i] = b[i] * x[k];  // 1 or 3 times
  }
  form.measure();
  form.error = kRounding * form.size;
  return form;
}

VectorForm position(const RigidMotion& motion, Scale& lengths) noexcept {
  VectorForm form;
  form.degree = 1;
  const auto x0 = point(motion.p0, lengths), x1 = point(motion.p1, lengths);
  for (Index k = 0; k < 3; ++k) {
    form.c[k][0] = x0[k];
    form.c[k][1] = x1[k];
  }
  form.measure();
  return form;
}

/// Corner i minus corner j, of one element.
VectorForm within(const CurvedQuery& query, const Body& body, Index i, Index j, Scale& lengths) noexcept {
  const CurvedCorner &a = query.corners[i], &b = query.corners[j];
  if (!body.turns) return sum(curve(a, lengths), curve(b, lengths), -1);
  const auto x = point(a.points[0], lengths), y = point(b.points[0], lengths);
  const std::array<double, 3> difference = {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
  const double largest = std::max({std::fabs(difference[0]), std::fabs(difference[1]), std::fabs(difference[2])});
  return turned(body, difference, kRounding * largest);
}

/// An upper bound on all lengths.
double longest(const CurvedQuery& query) noexcept {
  double longest = 0;
  std::array<bool, 4> used{};
  for (Index i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    const bool on_body = corner.motion != CurvedCorner::kOnCurve;
    if (on_body) used[static_cast<Index>(corner.motion)] = true;
    const Index points = on_body ? 1 : static_cast<Index>(corner.control_points);
    for (Index k = 0; k < points; ++k) longest = std::max(longest, largest_of(corner.points[k]));
  }
  for (Index m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    longest = std::max({longest, largest_of(query.motions[m].p0), largest_of(query.motions[m].p1)});
  }
  return longest;
}

Index first_of_second(Kind kind) noexcept { return kind == Kind::edge_edge ? 2 : 1; }

/// Whether all corners of each element are on curves or on one body.
bool moves_alike(const CurvedQuery& query) noexcept {
  const Index second = first_of_second(query.kind);
  for (Index i = 1; i < corner_count(query.kind); ++i) {
    if (i != second && query.corners[i].motion != query.corners[i - 1].motion) return false;
  }
  return true;
}

}  // namespace

CurvedFrame curved_frame(const CurvedQuery& query) noexcept {
  CurvedFrame frame;
  if (!moves_alike(query)) return frame;
  const Index second = first_of_second(query.kind);
  bool exact = true;
  const auto body = [&](Index corner) {
    const int motion = query.corners[corner].motion;
    return motion == CurvedCorner::kOnCurve ? Body() : body_of(query.motions[static_cast<Index>(motion)], exact);
  };
  const Body a = body(0), b = body(second);
  Scale lengths(longest(query));

  // B - A = Wa Wb T + Wa Mb Xb - Wb Ma Xa, with T the difference of the curves, or of the bodies' positions.
  const auto origin = [&](const Body& of, Index corner) {
    return of.turns ? position(*of.motion, lengths) : curve(query.corners[corner], lengths);
  };
  frame.between = sum(origin(b, second), origin(a, 0), -1);
  frame.between.measure();
  if (a.turns) frame.between = a.weight * frame.between;
  if (b.turns) {
    VectorForm own = turned(b, point(query.corners[second].points[0], lengths), 0);
    frame.between = b.weight * frame.between;
    frame.between = sum(frame.between, a.turns ? a.weight * own : own, 1);
  }
  if (a.turns) {
    VectorForm own = turned(a, point(query.corners[0].points[0], lengths), 0);
    frame.between = sum(frame.between, b.turns ? b.weight * own : own, -1);
  }
  frame.between.measure();
  switch (query.kind) {
    case Kind::edge_edge:
      frame.u = within(query, a, 1, 0, lengths);
      frame.w = within(query, b, 3, 2, lengths);
      break;
    case Kind::vertex_face:
      frame.u = within(query, b, 2, 1, lengths);
      frame.w = within(query, b, 3, 1, lengths);
      break;
    case Kind::point_edge: frame.w = within(query, b, 2, 1, lengths); break;
    case Kind::point_point: break;
  }
  frame.first_multiplier = b.weight;
  frame.second_multiplier = a.weight;
  frame.factor = lengths.factor;
  frame.known = exact && lengths.exact;
  return frame;
}

namespace {

/// Component k of a x b, before it is measured.
void cross_component(const VectorForm& a, const VectorForm& b, Index k, Coefficients& result) noexcept {
  const Index i = (k + 1) % 3, j = (k + 2) % 3;
  std::fill_n(result.begin(), size_of(a.degree + b.degree), 0.0);
  convolve<false>(result, a.c[i], size_of(a.degree), b.c[j], size_of(b.degree));
  convolve<true>(result, a.c[j], size_of(a.degree), b.c[i], size_of(b.degree));
}

}  // namespace

ScalarForm coplanarity_of(const CurvedFrame& frame) noexcept {
  VectorForm n;
  n.degree = frame.u.degree + frame.w.degree;
  for (Index k = 0; k < 3; ++k) cross_component(frame.u, frame.w, k, n.c[k]);
  n.measure();
  n.error = product_error(frame.u, frame.w, 2);
  ScalarForm v;
  v.degree = n.degree + frame.between.degree;
  std::fill_n(v.c[0].begin(), size_of(v.degree), 0.0);
  for (Index k = 0; k < 3; ++k) {
    convolve<false>(v.c[0], n.c[k], size_of(n.degree), frame.between.c[k], size_of(frame.between.degree));
  }
  v.error = product_error(n, frame.between, 3);
  v.measure();
  return v;
}

ScalarForm cross_component_of(const CurvedFrame& frame, Index axis) noexcept {
  ScalarForm form;
  form.degree = frame.between.degree + frame.w.degree;
  cross_component(frame.between, frame.w, axis, form.c[0]);
  form.error = product_error(frame.between, frame.w, 2);
  form.measure();
  return form;
}

namespace {

/// The bound on the values within `radius` of the time of evaluation. A term c_k t^k s^(n - k) has at most n roundings of
/// powers, n of s = 1 - t, 2 of products and n of sums: 3 n + 2. The terms' absolute values sum to at most the size, if
/// they are not below it by 2^-900, where something underflows.
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

// With p's coefficients b_k in the Bernstein basis, those of its derivative are n (b_(k+1) - b_k). Times binomial(n - 1, k)
// this is (k + 1) c_(k+1) - (n - k) c_k. Each product is at most binomial(n - 1, k) n size, and it is rounded; so is
// their difference: 4 e n size.
ScalarForm derivative_of(const ScalarForm& p) noexcept {
  ScalarForm result;
  const double n = p.degree;
  if (p.degree == 0) return constant(0);
  result.degree = p.degree - 1;
  for (Index k = 0; k < size_of(result.degree); ++k) {
    const double at = static_cast<double>(k);
    result.c[0][k] = (at + 1) * p.c[0][k + 1] - (n - at) * p.c[0][k];
  }
  result.measure();
  result.error = n * (2 * p.error + 4 * kRounding * p.size) + kUnderflow;
  return result;
}

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

Bounded value_at(const ScalarForm& p, double t, double radius, double slope) noexcept {
  return {evaluate(p.c[0], p.degree, t, 1 - t), value_error(p, radius, slope)};
}

geometry::Vector<Bounded> value_at(const VectorForm& p, double t, double radius, double slope) noexcept {
  const double error = value_error(p, radius, slope), s = 1 - t;
  return {{Bounded{evaluate(p.c[0], p.degree, t, s), error}, Bounded{evaluate(p.c[1], p.degree, t, s), error},
           Bounded{evaluate(p.c[2], p.degree, t, s), error}}};
}

namespace {

using Pair = BoundedPair;
using PairVector = FrameAt::Vector;

struct Moment {
  Pair t, s;

  Pair between(double start, double end) const noexcept {
    return s * numbers::exact_pair(start) + t * numbers::exact_pair(end);
  }
};

/// The rotation matrix times |q|^2, and |q|^2.
struct PoseAt {
  std::array<std::array<Pair, 3>, 3> matrix;
  Pair weight;
};

PoseAt pose_at(const RigidMotion& motion, const Moment& moment) noexcept {
  double largest = 0;
  for (Index i = 0; i < 4; ++i) largest = std::max({largest, std::fabs(motion.q0[i]), std::fabs(motion.q1[i])});
  Scale scale(largest);
  const auto component = [&](Index i) { return moment.between(scale(motion.q0[i]), scale(motion.q1[i])); };
  const Pair w = component(0), x = component(1), y = component(2), z = component(3);
  const auto twice = [](const Pair& p) { return Pair{{2 * p.value.high, 2 * p.value.low}, 2 * p.error}; };
  const Pair ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const Pair xy = twice(x * y), xz = twice(x * z), yz = twice(y * z);
  const Pair wx = twice(w * x), wy = twice(w * y), wz = twice(w * z);
  return {{{{(ww + xx) - (yy + zz), xy - wz, xz + wy},
            {xy + wz, (ww + yy) - (xx + zz), yz - wx},
            {xz - wy, yz + wx, (ww + zz) - (xx + yy)}}},
          (ww + xx) + (yy + zz)};
}

PairVector turned(const PoseAt& pose, const PairVector& x) noexcept {
  PairVector result;
  for (Index k = 0; k < 3; ++k) {
    result[k] = (pose.matrix[k][0] * x[0] + pose.matrix[k][1] * x[1]) + pose.matrix[k][2] * x[2];
  }
  return result;
}

PairVector times(const Pair& factor, const PairVector& x) noexcept {
  return {{factor * x[0], factor * x[1], factor * x[2]}};
}
PairVector plus(const PairVector& x, const PairVector& y) noexcept { return {{x[0] + y[0], x[1] + y[1], x[2] + y[2]}}; }

PairVector curve_at(const CurvedCorner& corner, const Moment& moment, Scale& lengths) noexcept {
  PairVector result;
  for (Index k = 0; k < 3; ++k) {
    std::array<Pair, 4> p;
    Index count = static_cast<Index>(corner.control_points);
    for (Index i = 0; i < count; ++i) p[i] = numbers::exact_pair(lengths(corner.points[i].*kAxes[k]));
    for (; count > 1; --count) {
      for (Index i = 0; i + 1 < count; ++i) p[i] = moment.s * p[i] + moment.t * p[i + 1];
    }
    result[k] = p[0];
  }
  return result;
}

PairVector exact_difference(const std::array<double, 3>& x, const std::array<double, 3>& y) noexcept {
  PairVector result;
  for (Index k = 0; k < 3; ++k) result[k] = {numbers::two_difference(x[k], y[k]), 0};
  return result;
}

}  // namespace

FrameAt frame_at(const CurvedQuery& query, const BoundedPair& t) noexcept {
  const Moment moment = {t, numbers::exact_pair(1) - t};
  const Index second = first_of_second(query.kind);
  Scale lengths(longest(query));
  const Pair one = numbers::exact_pair(1);
  std::array<PoseAt, 2> poses;
  std::array<bool, 2> turns{};
  std::array<PairVector, 2> origin;
  for (Index element = 0; element < 2; ++element) {
    const CurvedCorner& corner = query.corners[element == 0 ? 0 : second];
    turns[element] = corner.motion != CurvedCorner::kOnCurve;
    poses[element].weight = one;
    if (!turns[element]) {
      origin[element] = curve_at(corner, moment, lengths);
      continue;
    }
    const RigidMotion& motion = query.motions[static_cast<Index>(corner.motion)];
    poses[element] = pose_at(motion, moment);
    for (Index k = 0; k < 3; ++k) {
      origin[element][k] = moment.between(lengths(motion.p0.*kAxes[k]), lengths(motion.p1.*kAxes[k]));
    }
  }
  const auto own = [&](Index element, Index corner) {
    const auto x = point(query.corners[corner].points[0], lengths);
    PairVector exact = {{numbers::exact_pair(x[0]), numbers::exact_pair(x[1]), numbers::exact_pair(x[2])}};
    return turned(poses[element], exact);
  };
  const auto within_element = [&](Index element, Index i, Index j) {
    const CurvedCorner &a = query.corners[i], &b = query.corners[j];
    if (!turns[element]) return curve_at(a, moment, lengths) - curve_at(b, moment, lengths);
    return turned(poses[element], exact_difference(point(a.points[0], lengths), point(b.points[0], lengths)));
  };
  FrameAt frame;
  frame.first_multiplier = poses[1].weight;
  frame.second_multiplier = poses[0].weight;
  frame.between = origin[1] - origin[0];
  if (turns[0]) frame.between = times(poses[0].weight, frame.between);
  if (turns[1]) {
    frame.between = times(poses[1].weight, frame.between);
    const PairVector x = own(1, second);
    frame.between = plus(frame.between, turns[0] ? times(poses[0].weight, x) : x);
  }
  if (turns[0]) {
    const PairVector x = own(0, 0);
    frame.between = frame.between - (turns[1] ? times(poses[1].weight, x) : x);
  }
  switch (query.kind) {
    case Kind::edge_edge:
      frame.u = within_element(0, 1, 0);
      frame.w = within_element(1, 3, 2);
      break;
    case Kind::vertex_face:
      frame.u = within_element(1, 2, 1);
      frame.w = within_element(1, 3, 1);
      break;
    case Kind::point_edge: frame.w = within_element(1, 2, 1); break;
    case Kind::point_point: break;
  }
  return frame;
}

}  // namespace touchstone::filters
