// The bound on how far the paths of a body's corners leave the straight lines between their ends: a search for its
// breach, with paths by the definition of the motion, and pairs that touch are looked for among the candidates.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <random>

#include <touchstone/curved.hpp>

#include "bodies_support.hpp"
#include "scene/shipped_scenes.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using namespace touchstone::tests;

namespace {

using Real = long double;
using Point = std::array<Real, 3>;

/// Where the corner X is at t, by the quaternion itself: M(q) X / |q|^2.
Point turned_by(const Quaternion& q0, const Quaternion& q1, const Vector3& corner, Real t) {
  std::array<Real, 4> q;
  for (std::size_t i = 0; i < 4; ++i) q[i] = (1 - t) * q0[i] + t * q1[i];
  const Real w = q[0], x = q[1], y = q[2], z = q[3], n = w * w + x * x + y * y + z * z;
  const Real a = corner.x(), b = corner.y(), c = corner.z();
  return {((w * w + x * x - y * y - z * z) * a + 2 * (x * y - w * z) * b + 2 * (x * z + w * y) * c) / n,
          (2 * (x * y + w * z) * a + (w * w - x * x + y * y - z * z) * b + 2 * (y * z - w * x) * c) / n,
          (2 * (x * z - w * y) * a + 2 * (y * z + w * x) * b + (w * w - x * x - y * y + z * z) * c) / n};
}

/// The largest distance of the path from the line at the same time, along one axis, over the reach.
Real leaves_line(const Quaternion& q0, const Quaternion& q1, const Vector3& corner) {
  const Point from = turned_by(q0, q1, corner, 0), to = turned_by(q0, q1, corner, 1);
  Real most = 0;
  constexpr int kTimes = 64;
  for (int i = 1; i < kTimes; ++i) {
    const Real t = static_cast<Real>(i) / kTimes;
    const Point at = turned_by(q0, q1, corner, t);
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(at[k] - ((1 - t) * from[k] + t * to[k])));
  }
  return most / static_cast<Real>(corner.norm());
}

struct Random {
  std::mt19937_64 engine{20261123};
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(engine); }
  Vector3 vector() { return {unit(), unit(), unit()}; }
  Vector3 direction() { return vector().normalized(); }
};

}  // namespace

TEST_CASE("no path of a corner leaves its line by more than the bulge bound, which a search comes near to") {
  Random random;
  double nearest = 0;
  for (std::size_t trial = 0; trial < effort(1500); ++trial) {
    // Angles from tiny ones up to a half turn, where q0 . q1 = 0.
    const double angle = std::acos(-1.0) * std::pow(10.0, -3 * std::abs(random.unit()));
    Vector3 axis = random.direction();
    Vector3 corner = random.direction();
    Quaternion start = normalised({random.unit(), random.unit(), random.unit(), random.unit()});
    const auto ratio = [&](const Quaternion& q0, const Vector3& about, const Vector3& x) {
      Quaternion q1 = normalised(product(rotation_by(angle * about), q0));
      if (dot(q0, q1) < 0) q1 = negated(q1);
      return static_cast<double>(leaves_line(q0, q1, x)) / bulge(q0, q1, 1.0);
    };
    double best = ratio(start, axis, corner);
    // A climb from there: the worst orientation for this angle.
    double step = 0.5;
    for (int i = 0; i < 40; ++i, step *= 0.9) {
      const Vector3 other_axis = (axis + step * random.vector()).normalized();
      const Vector3 other_corner = (corner + step * random.vector()).normalized();
      const double there = ratio(start, other_axis, other_corner);
      if (!(there > best)) continue;
      best = there;
      axis = other_axis;
      corner = other_corner;
    }
    CAPTURE(angle, axis.transpose(), corner.transpose());
    REQUIRE(best <= 1);
    nearest = std::max(nearest, best);
  }
  CAPTURE(nearest);
  if (whole_effort("the nearest approach to the bound")) CHECK(nearest > 0.85);
}

TEST_CASE("bodies that touch on strongly bent ways are among the candidates") {
  Random random;
  std::size_t touching = 0;
  for (std::size_t trial = 0; trial < effort(400); ++trial) {
    Scene scene = empty_scene(1);
    // A rod that sweeps far, and a small triangle near the arc of its end.
    Body rod;
    rod.vertices = {{0, 0, 0}, {1, 0, 0}};
    rod.edges = {{0, 1}};
    rod.mass = 1;
    rod.inertia = {1, 1, 1, 0, 0, 0};
    const Vector3 axis = random.direction();
    const double angle = 3.1 * std::abs(random.unit());
    BodyStates from(2), to(2);
    to[0].pose.q = rotation_by(angle * axis);
    const Point at = turned_by(from[0].pose.q, to[0].pose.q, {1, 0, 0}, 0.5 + 0.4 * random.unit());
    const Vector3 there(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]));
    Body target = rod;
    target.vertices = {there + 1e-3 * random.vector(), there + 1e-3 * random.vector(), there + 1e-3 * random.vector()};
    target.edges.clear();
    target.faces = {{0, 1, 2}};
    scene.bodies = {rod, target};
    const System system(scene);
    const Colliders colliders(scene, system);
    const VectorX none;
    const SceneMotion motion{&none, &none, &from, &to};
    const auto candidates = colliders.body_candidates(motion, 0);
    for (Index edge = 1; edge <= 3; ++edge) {
      const Pair pair{touchstone::Kind::edge_edge, 0, edge};
      if (!solve(colliders.query(pair, motion)).contact) continue;
      ++touching;
      REQUIRE(std::find(candidates.begin(), candidates.end(), pair) != candidates.end());
    }
  }
  if (whole_effort("rods that touch")) CHECK(touching > 50);
}

TEST_CASE("links of many edges that touch are candidates, whatever clusters their edges are in") {
  Random random;
  std::size_t touching = 0, pairs = 0;
  for (std::size_t trial = 0; trial < effort(200); ++trial) {
    Scene scene;
    scene.bodies = make_link_chain(2).bodies;
    const System system(scene);
    const Colliders colliders(scene, system);
    BodyStates from = colliders.bodies().initial(), to = from;
    for (std::size_t i = 0; i < 2; ++i) {
      from[i].pose = {rotation_by(0.3 * random.vector()), from[i].pose.p + 0.03 * random.vector()};
      to[i].pose = {product(rotation_by(0.2 * random.vector()), from[i].pose.q),
                    from[i].pose.p + 0.03 * random.vector()};
      if (dot(from[i].pose.q, to[i].pose.q) < 0) to[i].pose.q = negated(to[i].pose.q);
    }
    const VectorX none;
    const SceneMotion motion{&none, &none, &from, &to};
    const auto candidates = colliders.body_candidates(motion, 0);
    pairs += candidates.size();
    const auto edges = static_cast<Index>(colliders.edges_of(1).size());
    REQUIRE(edges == 100);
    for (Index a = 0; a < edges; ++a) {
      for (Index b = edges; b < 2 * edges; ++b) {
        const Pair pair{touchstone::Kind::edge_edge, a, b};
        if (!solve(colliders.query(pair, motion), {.wanted = Wanted::contact}).contact) continue;
        ++touching;
        REQUIRE(std::find(candidates.begin(), candidates.end(), pair) != candidates.end());
      }
    }
  }
  if (!whole_effort("links that touch")) return;
  CHECK(touching > 10);
  CHECK(pairs < 200 * 3000);  // of 10,000 each
}
