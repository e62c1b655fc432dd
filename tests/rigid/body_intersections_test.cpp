// Bodies at rest against an exact separating-axis test of boxes, and against meshes whose vertices are doubles.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "rigid/random_bodies.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Integer = std::int64_t;
using Vector = std::array<Integer, 3>;

Integer dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A box with integers: half widths, a quaternion and a position.
struct IntegerBox {
  Vector half, position;
  std::array<Integer, 4> q;

  Integer square() const { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }
  /// Its axes, times square().
  std::array<Vector, 3> axes() const {
    const auto [w, x, y, z] = q;
    return {{{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
             {2 * (x * y - w * z), w * w + y * y - x * x - z * z, 2 * (y * z + w * x)},
             {2 * (x * z + w * y), 2 * (y * z - w * x), w * w + z * z - x * x - y * y}}};
  }
};

/// Whether two solid boxes have a common point: no axis of theirs, nor a cross product of two, separates them.
bool overlap(const IntegerBox& a, const IntegerBox& b) {
  const auto of_a = a.axes(), of_b = b.axes();
  std::vector<Vector> axes(of_a.begin(), of_a.end());
  axes.insert(axes.end(), of_b.begin(), of_b.end());
  for (const Vector& one : of_a) {
    for (const Vector& other : of_b) axes.push_back(cross(one, other));
  }
  const Vector apart{b.position[0] - a.position[0], b.position[1] - a.position[1], b.position[2] - a.position[2]};
  for (const Vector& axis : axes) {
    Integer reach = 0;  // times both squares
    for (std::size_t i = 0; i < 3; ++i) {
      reach += a.half[i] * std::abs(dot(axis, of_a[i])) * b.square();
      reach += b.half[i] * std::abs(dot(axis, of_b[i])) * a.square();
    }
    if (std::abs(dot(axis, apart)) * a.square() * b.square() > reach) return false;
  }
  return true;
}

IntegerBox some_box(seeded::Rng& random, bool turned) {
  IntegerBox one{};
  const int most = random.one_in(2) ? 2 : 9;
  for (Integer& half : one.half) half = random.between(most / 2, most);
  for (Integer& x : one.position) x = random.between(-5, 5);
  one.q = {1, 0, 0, 0};
  if (turned) {
    do {
      for (Integer& component : one.q) component = random.between(-3, 3);
    } while (one.square() == 0);
  }
  return one;
}

Pose pose_of(const IntegerBox& one) {
  const auto d = [](Integer x) { return static_cast<double>(x); };
  return {{d(one.q[0]), d(one.q[1]), d(one.q[2]), d(one.q[3])},
          {d(one.position[0]), d(one.position[1]), d(one.position[2])}};
}

Body body_of(const IntegerBox& one) {
  return box(static_cast<double>(one.half[0]), static_cast<double>(one.half[1]), static_cast<double>(one.half[2]));
}

}  // namespace

TEST_CASE("boxes at rest intersect where no axis separates them") {
  seeded::Rng random(4103);
  const std::size_t scenes = effort(600);
  int meet = 0, inside = 0, apart = 0;
  for (std::size_t i = 0; i < scenes; ++i) {
    const IntegerBox a = some_box(random, !random.one_in(4)), b = some_box(random, !random.one_in(4));
    CAPTURE(i);
    Bodies bodies;
    bodies.bodies = {body_of(a), body_of(b)};
    const auto found = intersections(bodies, {pose_of(a), pose_of(b)});
    REQUIRE(found.empty() == !overlap(a, b));
    const bool nested = std::any_of(found.begin(), found.end(),
                                    [](const BodyIntersection& one) { return one.sort == IntersectionSort::inside; });
    CHECK((!nested || found.size() == 1));
    apart += found.empty() ? 1 : 0;
    inside += nested ? 1 : 0;
    meet += !found.empty() && !nested ? 1 : 0;
  }
  if (!whole_effort("that each sort of pair comes")) return;
  CHECK(meet > 0);
  CHECK(inside > 0);
  CHECK(apart > 0);
}

TEST_CASE("bodies that do not turn intersect as meshes do") {
  seeded::Rng random(4104);
  for (std::size_t i = 0; i < effort(200); ++i) {
    CAPTURE(i);
    Bodies bodies;
    bodies.bodies = {random_body(random, true, false), random_body(random, true, false)};
    const Vec3 shift = some_point(random, true, 1);
    // Both as one mesh, with a group each.
    MeshElements both;
    std::vector<Vec3> points;
    for (std::uint32_t b = 0; b < 2; ++b) {
      const auto first = static_cast<MeshIndex>(points.size());
      const Mesh& mesh = bodies.bodies[b].mesh();
      for (const Vec3& p : bodies.bodies[b].points()) {
        points.push_back(b == 0 ? p : Vec3{p.x + shift.x, p.y + shift.y, p.z + shift.z});
        both.rules.groups.push_back(b);
      }
      for (auto face : mesh.faces()) {
        for (MeshIndex& v : face) v += first;
        both.faces.push_back(face);
      }
      for (auto edge : mesh.edges()) {
        for (MeshIndex& v : edge) v += first;
        both.edges.push_back(edge);
      }
    }
    both.vertex_count = points.size();
    both.rules.group_pairs = {{0, 0}, {1, 1}};
    const auto expected = intersections(Mesh(both), Positions(points));
    std::vector<Pose> poses(2);
    poses[1].position = shift;
    const auto found = intersections(bodies, poses);
    // Elements of both: the numbers of the second body's come after those of the first.
    const auto count = [](const auto& all, IntersectionSort sort) {
      return std::count_if(all.begin(), all.end(), [sort](const auto& one) { return one.sort == sort; });
    };
    CHECK(count(found, IntersectionSort::pierces) == count(expected, IntersectionSort::pierces));
    CHECK(count(found, IntersectionSort::touches) == count(expected, IntersectionSort::touches));
  }
}

TEST_CASE("a body inside another one is found at the start, and a hollow one holds it") {
  Bodies bodies;
  bodies.bodies = {box(4, 4, 4), box(1, 1, 1)};
  std::vector<RigidMotion> motions(2);
  motions[1].q1 = {1, 1, 0, 0};
  const FirstBodyContact found = first_contact(bodies, motions);
  CHECK(!found.contact);
  CHECK(!found.free());
  REQUIRE(found.start_intersections.size() == 1);
  CHECK(found.start_intersections[0].sort == IntersectionSort::inside);
  CHECK(found.start_intersections[0].first.body == 1);
  CHECK(found.start_intersections[0].second.body == 0);
  BodyStepOptions options;
  options.check_start = false;
  const FirstBodyContact unasked = first_contact(bodies, motions, options);
  CHECK(!unasked.start_checked);
  CHECK(unasked.free());
  // A shell with a cavity: two closed surfaces, the inner one with its normals inwards.
  MeshElements shell;
  std::vector<Vec3> points;
  for (const double size : {4.0, 3.0}) {
    const Body one = box(size, size, size);
    const auto first = static_cast<MeshIndex>(points.size());
    for (const Vec3& p : one.points()) points.push_back(p);
    for (auto face : one.mesh().faces()) {
      for (MeshIndex& v : face) v += first;
      if (size < 4) std::swap(face[0], face[1]);
      shell.faces.push_back(face);
    }
  }
  shell.vertex_count = points.size();
  bodies.bodies[0] = Body(Mesh(shell), Positions(points));
  CHECK(first_contact(bodies, motions).free());
  CHECK(first_contact(bodies, motions).cancelled == 1);
  CHECK(first_contact(bodies, motions).in_open == 0);
}

TEST_CASE("a body in an open surface is counted: that has no inside") {
  Bodies bodies;
  const Body large = box(4, 4, 4);
  MeshElements open = large.mesh().elements();
  open.faces.pop_back();
  open.edges.clear();
  bodies.bodies = {Body(Mesh(open), Positions(large.points())), box(1, 1, 1), box(1, 1, 1)};
  std::vector<RigidMotion> motions(3);
  motions[2].p0.x = motions[2].p1.x = 20;
  const FirstBodyContact found = first_contact(bodies, motions);
  CHECK(found.free());
  CHECK(found.in_open == 1);
  CHECK(found.cancelled == 0);
}

TEST_CASE("a body in a surface of unjoined faces, or of two halves, is counted, wherever it is asked") {
  const Body large = box(4, 4, 4);
  MeshElements soup, halves = large.mesh().elements();
  std::vector<Vec3> points;
  for (const auto& face : large.mesh().faces()) {
    const auto first = static_cast<MeshIndex>(points.size());
    for (const MeshIndex v : face) points.push_back(large.points()[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  soup.vertex_count = points.size();
  // The second half of the faces has vertices of its own.
  const auto count = static_cast<MeshIndex>(large.points().size());
  std::vector<Vec3> twice(large.points().begin(), large.points().end());
  twice.insert(twice.end(), large.points().begin(), large.points().end());
  for (std::size_t f = halves.faces.size() / 2; f < halves.faces.size(); ++f) {
    for (MeshIndex& v : halves.faces[f]) v += count;
  }
  halves.edges.clear();
  halves.vertex_count = twice.size();
  for (const Body& around : {Body(Mesh(soup), Positions(points)), Body(Mesh(halves), Positions(twice))}) {
    Bodies bodies;
    bodies.bodies = {around, box(1, 1, 1), box(1, 1, 1)};
    std::vector<RigidMotion> motions(3);
    motions[2].p0.x = motions[2].p1.x = 20;
    const FirstBodyContact found = first_contact(bodies, motions);
    CHECK((found.free() && found.in_open == 1));
    CHECK(solve_screw(bodies, motions).in_open == 1);
    const std::vector<Pose> poses{{}, {}, {{1, 0, 0, 0}, {20, 0, 0}}};
    CHECK(distance(bodies, poses).in_open == 1);
    BodiesLeftOut left_out;
    CHECK(intersections(bodies, poses, {}, &left_out).empty());
    CHECK((left_out.in_open == 1 && left_out.cancelled == 0 && left_out.excluded == 0));
  }
}
