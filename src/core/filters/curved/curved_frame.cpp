// SPDX-License-Identifier: MIT
#include "filters/curved/curved_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/curved/curved_scale.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::filters {
namespace {

using numbers::kRounding;
using numbers::kUnderflow;
using Index = std::size_t;

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
  const double largest = largest_component(motion);
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

VectorForm curve(const CurvedCorner& corner, Scale& lengths) noexcept {
  VectorForm form;
  form.degree = corner.control_points - 1;
  const auto& b = kBinomial[static_cast<Index>(form.degree)];
  for (Index i = 0; i < static_cast<Index>(form.degree + 1); ++i) {
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

/// Whether all corners of each element are on curves or on one body.
bool moves_alike(const CurvedQuery& query) noexcept {
  const Index second = geometry::corners_of_first(query.kind);
  for (Index i = 1; i < corner_count(query.kind); ++i) {
    if (i != second && query.corners[i].motion != query.corners[i - 1].motion) return false;
  }
  return true;
}

}  // namespace

CurvedFrame curved_frame(const CurvedQuery& query) noexcept {
  CurvedFrame frame;
  if (!moves_alike(query)) return frame;
  const Index second = geometry::corners_of_first(query.kind);
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

ScalarForm coplanarity_of(const CurvedFrame& frame) noexcept { return dot(cross(frame.u, frame.w), frame.between); }

ScalarForm cross_component_of(const CurvedFrame& frame, Index axis) noexcept {
  return cross_component(frame.between, frame.w, axis);
}

}  // namespace touchstone::filters
