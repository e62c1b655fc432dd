// Points of a body on an arc are within the arc's bounds, by positions in quadruple precision.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <touchstone/curved.hpp>

#include "rigid/arc.hpp"
#include "rigid/random_bodies.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Real = __float128;
using Point = std::array<Real, 3>;

Point position(const RigidMotion& motion, const Vec3& point, Real t) {
  std::array<Real, 4> q;
  for (std::size_t i = 0; i < 4; ++i) q[i] = (1 - t) * Real(motion.q0[i]) + t * Real(motion.q1[i]);
  const auto [w, x, y, z] = q;
  const Real n = w * w + x * x + y * y + z * z;
  const Real a = point.x, b = point.y, c = point.z;
  const auto shift = [&](double p0, double p1) { return (1 - t) * Real(p0) + t * Real(p1); };
  return {((w * w + x * x - y * y - z * z) * a + 2 * (x * y - w * z) * b + 2 * (x * z + w * y) * c) / n +
              shift(motion.p0.x, motion.p1.x),
          (2 * (x * y + w * z) * a + (w * w + y * y - x * x - z * z) * b + 2 * (y * z - w * x) * c) / n +
              shift(motion.p0.y, motion.p1.y),
          (2 * (x * z - w * y) * a + 2 * (y * z + w * x) * b + (w * w + z * z - x * x - y * y) * c) / n +
              shift(motion.p0.z, motion.p1.z)};
}

Vec3 sum(const Vec3& a, const Vec3& b, double sign = 1) {
  return {a.x + sign * b.x, a.y + sign * b.y, a.z + sign * b.z};
}

}  // namespace

TEST_CASE("a point of a body is within the bounds of its arc at all times") {
  seeded::Rng random(4105);
  double most = 0;  // of the bound that is used
  for (std::size_t i = 0; i < effort(50000); ++i) {
    const bool coarse = random.one_in(3);
    RigidMotion motion = some_motion(random, coarse, random.one_in(4) ? 1e-3 : 10);
    if (random.one_in(3)) {  // a small turn
      for (std::size_t k = 0; k < 4; ++k)
        motion.q1[k] = motion.q0[k] + std::ldexp(random.symmetric(), -random.between(1, 50));
    }
    const double scale = std::ldexp(1.0, random.between(-40, 40));
    Vec3 point = some_point(random, coarse, scale);
    if (random.one_in(4)) point.x += 1e5 * scale;  // far from the origin
    const double size = std::sqrt(point.x * point.x + point.y * point.y + point.z * point.z) * (1 + 1e-15);
    int halvings = random.between(0, 8);
    if (random.one_in(4)) halvings = random.between(9, 20);
    const int pieces = 1 << halvings;
    const auto piece = static_cast<double>(random.between(0, pieces - 1));
    const double from = piece / pieces, to = (piece + 1) / pieces;
    const rigid::Arc arc(motion, from, to, size);
    const auto ends = arc.ends_of(point);
    broad_phase::Box own = broad_phase::empty_box();
    broad_phase::extend(own, point);
    const auto box = arc.around(own, rigid::reach_of(own), 0);
    const Real deviation = arc.deviation(size);
    for (int k = 0; k < 5; ++k) {
      const Real part = k == 0 ? 0 : k == 1 ? 1 : Real(random.uniform(0, 1));
      const Point at = position(motion, point, Real(from) + part * (Real(to) - Real(from)));
      const double start[3] = {ends.start.x, ends.start.y, ends.start.z}, end[3] = {ends.end.x, ends.end.y, ends.end.z};
      Real square = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real off = at[axis] - ((1 - part) * Real(start[axis]) + part * Real(end[axis]));
        square += off * off;
        const Real low = (1 - part) * Real(box.low[axis][0]) + part * Real(box.low[axis][1]);
        const Real high = (1 - part) * Real(box.high[axis][0]) + part * Real(box.high[axis][1]);
        REQUIRE(at[axis] >= low);
        REQUIRE(at[axis] <= high);
      }
      REQUIRE(square <= deviation * deviation);
      if (to - from == 1 && size > 0)
        most = std::max(most, std::sqrt(static_cast<double>(square)) / static_cast<double>(deviation));
    }
  }
  CHECK(most > 0.3);  // the bound is not idle
}

TEST_CASE("differences of points of two bodies that turn together are within the bounds of both arcs") {
  seeded::Rng random(4106);
  std::size_t together = 0, narrower = 0;
  for (std::size_t i = 0; i < effort(20000); ++i) {
    const bool coarse = random.one_in(3);
    RigidMotion a = some_motion(random, coarse, random.one_in(4) ? 1e-3 : 10), b = a;
    // The second body has another frame of its own, and its quaternions another length.
    const std::array<double, 4> r =
        random.one_in(3) ? std::array<double, 4>{1, 0, 0, 0} : some_motion(random, coarse, 1).q0;
    const auto composed = [&](const std::array<double, 4>& q) {
      return std::array<double, 4>{
          q[0] * r[0] - q[1] * r[1] - q[2] * r[2] - q[3] * r[3], q[0] * r[1] + q[1] * r[0] + q[2] * r[3] - q[3] * r[2],
          q[0] * r[2] + q[2] * r[0] + q[3] * r[1] - q[1] * r[3], q[0] * r[3] + q[3] * r[0] + q[1] * r[2] - q[2] * r[1]};
    };
    b.q0 = composed(a.q0), b.q1 = composed(a.q1);
    if (random.one_in(3)) {  // it turns a little differently
      for (std::size_t k = 0; k < 4; ++k) b.q1[k] += std::ldexp(random.symmetric(), -random.between(0, 60));
    }
    if (random.one_in(8)) b = some_motion(random, coarse, 10);
    b.p0 = some_point(random, coarse, 10), b.p1 = random.one_in(2) ? b.p0 : some_point(random, coarse, 10);
    const double far = std::ldexp(1.0, random.between(0, 40));
    const Vec3 middle = some_point(random, coarse, far);
    const auto turned_back = [&](const Vec3& c) {  // where a's frame has it, about
      const Point at = position({r, r, {}, {}}, c, 0);
      return Vec3{static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
    };
    const Vec3 x = sum(turned_back(middle), some_point(random, coarse, 2)),
               y = sum(middle, some_point(random, coarse, 2));
    broad_phase::Box of_x = broad_phase::empty_box(), of_y = of_x;
    broad_phase::extend(of_x, x), broad_phase::extend(of_y, y);
    broad_phase::Box of_b = of_y;
    broad_phase::extend(of_b, sum(y, some_point(random, coarse, 2)));
    const int pieces = 1 << random.between(0, 20);
    const auto piece = static_cast<double>(random.between(0, pieces - 1));
    const double from = piece / pieces, to = (piece + 1) / pieces;
    const auto arcs = rigid::turn_together(a, of_x, b, of_b, from, to);
    if (!arcs) continue;
    ++together;
    const auto& [arc_a, arc_b] = *arcs;
    const double reach = rigid::reach_of(of_x), plain = rigid::Arc(a, from, to, reach).deviation(reach);
    const double off_a = arc_a.deviation(arc_a.reach_of(x)), off_b = arc_b.deviation(arc_b.reach_of(y));
    narrower += off_a + off_b < plain / 16 ? 1 : 0;
    const auto ends_a = arc_a.ends_of(x), ends_b = arc_b.ends_of(y);
    const auto box_a = arc_a.around(of_x, reach, 0), box_b = arc_b.around(of_y, rigid::reach_of(of_y), 0);
    const Vec3 start = sum(ends_a.start, ends_b.start, -1), end = sum(ends_a.end, ends_b.end, -1);
    CAPTURE(i, far, from, to);
    for (int k = 0; k < 5; ++k) {
      const Real fraction = k == 0 ? 0 : k == 1 ? 1 : Real(random.uniform(0, 1));
      const Real t = Real(from) + fraction * (Real(to) - Real(from));
      const Point of_a = position(a, x, t), on_b = position(b, y, t);
      const double starts[3] = {start.x, start.y, start.z}, all_ends[3] = {end.x, end.y, end.z};
      Real square = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real apart = of_a[axis] - on_b[axis];
        const Real off = apart - ((1 - fraction) * Real(starts[axis]) + fraction * Real(all_ends[axis]));
        square += off * off;
        const auto between = [&](const auto& bound) {
          return (1 - fraction) * Real(bound[0]) + fraction * Real(bound[1]);
        };
        REQUIRE(apart >= between(box_a.low[axis]) - between(box_b.high[axis]));
        REQUIRE(apart <= between(box_a.high[axis]) - between(box_b.low[axis]));
      }
      const Real most = Real(off_a) + Real(off_b) + 0x1p-50 * (Real(off_a) + Real(off_b) + 64);  // of start and end
      REQUIRE(square <= most * most);
    }
  }
  if (!whole_effort("that bodies turn together, and that it helps")) return;
  CHECK(together > 5000);
  CHECK(narrower > 1000);
}
