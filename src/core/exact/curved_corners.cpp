// From a curved query to corners whose coordinates are polynomials.
//
// A corner of a rigid body is at P(t) / W(t) with W = |q|^2, which is positive all over the step. Touching does not
// change when all corners are multiplied by one positive number, which may depend on t: nor do the barycentric weights,
// and V is multiplied by its cube, which changes no sign and no root's multiplicity. So the corners are multiplied by
// all different W. docs/design.md has the whole argument.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "exact/common_scale.hpp"
#include "exact/corners.hpp"
#include "exact/off_the_stack.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::exact {
namespace {

/// Doubles times one power of two.
class Scaled {
 public:
  explicit Scaled(const OrdinarySize& size) : power_(size.power()), factor_(numbers::power_of_two(power_)) {}
  Exact operator()(double x) const { return power_ != 0 ? Exact(x) * factor_ : Exact(x); }

 private:
  int power_;
  Exact factor_;
};

Form linear(const Exact& start, const Exact& end) { return Form(start, end - start); }

/// A rigid motion in polynomials: a body point X is at (rotation X + origin) / weight.
struct Pose {
  std::array<std::array<Form, 3>, 3> rotation;
  geometry::Vector<Form> origin;
  Form weight;
};

void add(const RigidMotion& motion, OrdinarySize& size) {
  for (const auto& end : {motion.q0, motion.q1}) {
    for (const double c : end) size.add(c);
  }
}

Pose pose_of(const RigidMotion& motion, const Scaled& lengths, const Scaled& scale) {
  const auto component = [&](std::size_t i) { return linear(scale(motion.q0[i]), scale(motion.q1[i])).trimmed(1); };
  const Form w = component(0), x = component(1), y = component(2), z = component(3);
  const Form ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const Exact two(2);
  const auto twice = [&](const Form& p) { return p * two; };
  const Form weight = (ww + xx + yy + zz).trimmed(1);
  const auto along = [&](double Vec3::*axis) {
    return weight * linear(lengths(motion.p0.*axis), lengths(motion.p1.*axis));
  };
  return {{{{ww + xx - yy - zz, twice(x * y - w * z), twice(x * z + w * y)},
            {twice(x * y + w * z), ww - xx + yy - zz, twice(y * z - w * x)},
            {twice(x * z - w * y), twice(y * z + w * x), ww - xx - yy + zz}}},
          {{along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)}},
          weight};
}

/// A body point in directions that do not turn, relative to the body's origin.
geometry::Vector<Form> turned(const Pose& pose, const Vec3& point, const Scaled& lengths) {
  const Exact coordinates[3] = {lengths(point.x), lengths(point.y), lengths(point.z)};
  geometry::Vector<Form> result;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) result[k] = result[k] + pose.rotation[k][j] * coordinates[j];
  }
  return result;
}

/// A Bezier curve in powers of t: coefficient k is binomial(n, k) times the k-th difference of the control points.
geometry::Vector<Form> on_curve(const CurvedCorner& corner, const Scaled& lengths) {
  constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  geometry::Vector<Form> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    numbers::ExactList c(corner.control_points);
    const std::size_t size = static_cast<std::size_t>(corner.control_points);
    for (std::size_t i = 0; i < size; ++i) c[i] = lengths(corner.points[i].*kAxes[axis]);
    for (std::size_t order = 1; order < size; ++order) {
      for (std::size_t i = size; i-- > order;) c[i] = c[i] - c[i - 1];
    }
    int binomial = 1;
    for (std::size_t k = 1; k < size; ++k) {
      binomial = binomial * static_cast<int>(size - k) / static_cast<int>(k);
      c[k] = c[k] * Exact(binomial);
    }
    result[axis] = Form(std::move(c));
  }
  return result;
}

std::size_t motion_of(const CurvedCorner& corner) { return static_cast<std::size_t>(corner.motion); }

std::array<bool, 4> used_motions(const CurvedQuery& query) {
  std::array<bool, 4> used{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (query.corners[i].motion != CurvedCorner::kOnCurve) used[motion_of(query.corners[i])] = true;
  }
  return used;
}

/// Of the coordinates that count.
OrdinarySize size_of(const CurvedQuery& query) {
  OrdinarySize size;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    const bool on_a_body = corner.motion != CurvedCorner::kOnCurve;
    const std::size_t points = on_a_body ? 1 : static_cast<std::size_t>(corner.control_points);
    for (std::size_t k = 0; k < points; ++k) size.add(corner.points[k]);
  }
  const std::array<bool, 4> used = used_motions(query);
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    size.add(query.motions[m].p0);
    size.add(query.motions[m].p1);
  }
  return size;
}

}  // namespace

template <>
Forms<AnyDegree>::Corners moving_corners<AnyDegree>(const CurvedQuery& query) {
  const std::size_t count = corner_count(query.kind);
  const std::array<bool, 4> used = used_motions(query);
  const Scaled lengths(size_of(query));
  std::array<std::unique_ptr<const Pose>, 4> poses;
  std::vector<Form> weights;               // the different ones
  std::array<std::size_t, 4> weight_of{};  // of a motion
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    OrdinarySize size;  // of the quaternion, whose length does not matter
    add(query.motions[m], size);
    poses[m] = off_the_stack([&] { return pose_of(query.motions[m], lengths, Scaled(size)); });
    const auto same = std::find(weights.begin(), weights.end(), poses[m]->weight);
    weight_of[m] = static_cast<std::size_t>(same - weights.begin());
    if (same == weights.end()) weights.push_back(poses[m]->weight);
  }

  // The product of all weights, but for one.
  const auto others = [&](std::size_t but) {
    Form product(Exact(1));
    for (std::size_t w = 0; w < weights.size(); ++w) {
      if (w != but) product = product * weights[w];
    }
    return product;
  };
  const std::size_t none = weights.size();
  constexpr int kLeastSize = 2;  // as of straight motion, so that equal motions have equal formal degrees
  const auto times = [](geometry::Vector<Form> x, const Form& factor) {
    for (Form& coordinate : x.c) coordinate = scaled_by(factor, coordinate).trimmed(kLeastSize);
    return x;
  };

  Forms<AnyDegree>::Corners result;
  result.factor = lengths(1);
  result.scale = others(none);
  result.second = geometry::corners_of_first(query.kind);
  for (std::size_t i = 0; i < count; ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (corner.motion == CurvedCorner::kOnCurve) {
      result.own[i] = times(on_curve(corner, lengths), Form(Exact(1)));
      result.corners[i] = times(result.own[i], result.scale);
    } else {
      const Pose& pose = *poses[motion_of(corner)];
      result.own[i] = turned(pose, corner.points[0], lengths);
      geometry::Vector<Form> position = pose.origin;
      for (std::size_t k = 0; k < 3; ++k) position[k] = position[k] + result.own[i][k];
      result.corners[i] = times(std::move(position), others(weight_of[motion_of(corner)]));
    }
  }
  for (std::size_t element = 0; element < 2; ++element) {
    const std::size_t begin = element == 0 ? 0 : result.second, end = element == 0 ? result.second : count;
    const int motion = query.corners[begin].motion;
    const bool all_alike = std::all_of(query.corners.begin() + begin, query.corners.begin() + end,
                                       [&](const CurvedCorner& corner) { return corner.motion == motion; });
    if (all_alike) {
      const bool curves = motion == CurvedCorner::kOnCurve;
      result.multipliers[element] = others(curves ? none : weight_of[static_cast<std::size_t>(motion)]);
    } else {
      std::copy(result.corners.begin() + begin, result.corners.begin() + end, result.own.begin() + begin);
    }
  }
  return result;
}

HomogeneousCorners homogeneous_corners(const CurvedQuery& query) {
  const Scaled lengths(size_of(query));
  OrdinarySize size;  // of all quaternions
  const std::array<bool, 4> used = used_motions(query);
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (used[m]) add(query.motions[m], size);
  }
  const Scaled turns(size);
  const Form square(turns(1) * turns(1));
  HomogeneousCorners result;
  result.factor = lengths(1);
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (corner.motion == CurvedCorner::kOnCurve) {
      result.numerators[i] = on_curve(corner, lengths);
      for (Form& coordinate : result.numerators[i].c) coordinate = scaled_by(square, coordinate);
      result.weights[i] = square;
      continue;
    }
    const Pose pose = pose_of(query.motions[motion_of(corner)], lengths, turns);
    result.numerators[i] = turned(pose, corner.points[0], lengths);
    for (std::size_t k = 0; k < 3; ++k) result.numerators[i][k] = result.numerators[i][k] + pose.origin[k];
    result.weights[i] = pose.weight;
  }
  return result;
}

}  // namespace touchstone::exact
