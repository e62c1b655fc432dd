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
