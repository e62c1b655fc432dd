// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "numbers/doubles/decimal_text.hpp"
#include "numbers/roots/vanishing.hpp"
#include "solver/validate.hpp"

namespace touchstone::solver {
namespace {

void validate_finite(const Vec3& x, const std::string& what) {
  const double coordinates[3] = {x.x, x.y, x.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::isfinite(coordinates[axis])) continue;
    throw InvalidQuery(what + " has " + "xyz"[axis] + " = " + numbers::decimal_text(coordinates[axis]) +
                       "; coordinates must be finite");
  }
}

void validate_orientation(const std::array<double, 4>& q, const std::string& what) {
  bool zero = true;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!std::isfinite(q[i])) {
      throw InvalidQuery(what + " has " + "wxyz"[i] + " = " + numbers::decimal_text(q[i]) +
                         "; its components must be finite");
    }
    zero = zero && q[i] == 0;
  }
  if (zero) throw InvalidQuery(what + " is zero; an orientation needs a component that is not 0");
}

void validate(const CurvedCorner& corner, const std::string& name) {
  const int last_motion = static_cast<int>(CurvedQuery().motions.size()) - 1;
  const int most_points = static_cast<int>(corner.points.size());
  if (corner.motion != CurvedCorner::kOnCurve) {
    if (corner.motion < 0 || corner.motion > last_motion) {
      throw InvalidQuery(name + " has motion = " + std::to_string(corner.motion) + "; it must be 0 to " +
                         std::to_string(last_motion) + ", or -1 for a corner on a curve");
    }
    return validate_finite(corner.points[0], name + ": the body point");
  }
  if (corner.control_points < 1 || corner.control_points > most_points) {
    throw InvalidQuery(name + " has " + std::to_string(corner.control_points) + " control points; a curve has 1 to " +
                       std::to_string(most_points) + " of them");
  }
  for (int i = 0; i < corner.control_points; ++i) {
    validate_finite(corner.points[static_cast<std::size_t>(i)], name + ": control point " + std::to_string(i));
  }
}

/// Whether a query is certainly valid, without the names that errors need. A number times 0 is 0 or -0 exactly if it is
/// finite.
bool certainly_valid(const CurvedQuery& query, double t_max) noexcept {
  if (!(query.kind <= kKinds.back()) || !(t_max >= 0 && t_max <= 1)) return false;
  double zero = 0;
  const auto see = [&zero](const Vec3& x) { zero += 0 * x.x + 0 * x.y + 0 * x.z; };
  std::array<bool, 4> used{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (corner.motion != CurvedCorner::kOnCurve) {
      if (corner.motion < 0 || corner.motion >= static_cast<int>(used.size())) return false;
      used[static_cast<std::size_t>(corner.motion)] = true;
      see(corner.points[0]);
      continue;
    }
    if (corner.control_points < 1 || corner.control_points > static_cast<int>(corner.points.size())) return false;
    for (std::size_t k = 0; k < static_cast<std::size_t>(corner.control_points); ++k) see(corner.points[k]);
  }
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    const RigidMotion& motion = query.motions[m];
    if (motion.control_points != 2) return false;
    see(motion.p0);
    see(motion.p1);
    // Opposite orientations have no component whose product is positive, and neither has one that is zero.
    double dot = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      dot += motion.q0[i] * motion.q1[i];
      zero += 0 * motion.q0[i] + 0 * motion.q1[i];
    }
    if (!(dot > 0)) return false;
  }
  return zero == 0;
}

constexpr int kFewestArcs = 4;  // so that an arc's quaternions are less than 1 apart
constexpr int kMostArcs = 1 << 20;

void validate_arcs(int arcs, const char* name) {
  if (arcs >= kFewestArcs && arcs <= kMostArcs && (arcs & (arcs - 1)) == 0) return;
  throw InvalidQuery(std::string(name) + " is " + std::to_string(arcs) +
                     "; the number of arcs must be a power of two from " + std::to_string(kFewestArcs) + " to " +
                     std::to_string(kMostArcs));
}

}  // namespace

void validate_arcs(int arcs, int most_arcs) {
  validate_arcs(arcs, "arcs");
  validate_arcs(most_arcs, "most_arcs");
}

void validate(const RigidMotion& motion, const std::string& name, OriginPath path) {
  validate_orientation(motion.q0, name + ": the quaternion q0");
  validate_orientation(motion.q1, name + ": the quaternion q1");
  validate_finite(motion.p0, name + ": the position p0");
  validate_finite(motion.p1, name + ": the position p1");
  if (motion.control_points < 2 || motion.control_points > 4) {
    throw InvalidQuery(name + ": the position has " + std::to_string(motion.control_points) +
                       " control points; its curve has 2 to 4 of them: p0, none to two of `inner`, and p1");
  }
  if (motion.control_points > 2 && path == OriginPath::straight) {
    throw InvalidQuery(name + ": the position is on a curve of " + std::to_string(motion.control_points) +
                       " control points; only solve_screw takes that");
  }
  for (int i = 0; i + 2 < motion.control_points; ++i) {
    validate_finite(motion.inner[static_cast<std::size_t>(i)], name + ": the inner control point " + std::to_string(i));
  }
  const auto time = numbers::zero_between(motion.q0, motion.q1);
  if (!time) return;
  throw InvalidQuery(name + ": q1 is q0 times a negative number, so that (1 - t) q0 + t q1 is zero near t = " +
                     numbers::decimal_text(*time) +
                     "; change the sign of all components of q1: the orientation at t = 1 stays the same");
}

void validate(const CurvedQuery& query, double t_max, OriginPath path) {
  if (certainly_valid(query, t_max)) return;
  validate_kind(query.kind);
  validate_t_max(t_max);
  std::array<bool, 4> used{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    std::string name(name_of(query.kind));
    validate(corner, name.append(" query: corner ").append(corner_name(query.kind, i)));
    if (corner.motion != CurvedCorner::kOnCurve) used[static_cast<std::size_t>(corner.motion)] = true;
  }
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (used[m]) validate(query.motions[m], "motion " + std::to_string(m), path);
  }
}

}  // namespace touchstone::solver
