// SPDX-License-Identifier: MIT
#include "filters/curved/curved_frame.hpp"
#include "filters/curved/curved_scale.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::filters {
namespace {

using numbers::BoundedPair;
using Index = std::size_t;
using Pair = BoundedPair;
using PairVector = FrameAt::Vector;

constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};

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
  Scale scale(largest_component(motion));
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
  const Index second = geometry::corners_of_first(query.kind);
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
