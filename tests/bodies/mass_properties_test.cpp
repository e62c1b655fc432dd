// Mass, centre and moments of inertia against solids whose values are known.
// SPDX-License-Identifier: MIT
#include "bodies/mass_properties.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "generators/shapes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;
using Edges = std::vector<std::array<std::uint32_t, 2>>;

std::vector<Vector3> box_corners(const Vector3& size) {
  std::vector<Vector3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1 ? 0.5 : -0.5) * size.x(), (i & 2 ? 0.5 : -0.5) * size.y(),
                         (i & 4 ? 0.5 : -0.5) * size.z());
  }
  return corners;
}

const Faces kBoxFaces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};

Matrix3 diagonal(double x, double y, double z) { return Vector3(x, y, z).asDiagonal(); }

double relative(const Matrix3& a, const Matrix3& b) { return (a - b).norm() / b.norm(); }

/// The same solid at another place, turned.
std::vector<Vector3> moved(std::vector<Vector3> points, const Matrix3& turn, const Vector3& by) {
  for (Vector3& x : points) x = turn * x + by;
  return points;
}

const Matrix3 kTurn = Eigen::AngleAxisd(1.1, Vector3(1, -2, 0.7).normalized()).toRotationMatrix();

}  // namespace

TEST_CASE("a box has its known mass and moments, wherever it is and however it is turned") {
  const Vector3 size(0.3, 1.7, 0.9);
  const double density = 2700, mass = density * size.prod();
  const Matrix3 moments = mass / 12 *
                          diagonal(size.y() * size.y() + size.z() * size.z(), size.x() * size.x() + size.z() * size.z(),
                                   size.x() * size.x() + size.y() * size.y());
  for (const double away : {0.0, 1.0, 1000.0}) {
    const Vector3 by = away * Vector3(1, -0.5, 2);
    const MassProperties box = solid_properties(moved(box_corners(size), kTurn, by), kBoxFaces, density);
    CHECK(std::abs(box.mass / mass - 1) < 1e-12 * (1 + away));
    CHECK((box.centre - by).norm() < 1e-13 * (1 + away));
    CHECK(relative(box.inertia, kTurn * moments * kTurn.transpose()) < 1e-12 * (1 + away));
  }
}

TEST_CASE("a tetrahedron has its known moments") {
  // Of the corner of a cube: mass 1/6, centre 1/4; int x^2 = 1/60, int x y = 1/120.
  const MassProperties corner =
      solid_properties({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, 6);
  CHECK(std::abs(corner.mass - 1) < 1e-14);
  CHECK((corner.centre - Vector3::Constant(0.25)).norm() < 1e-15);
  const double square = 0.1 - 1.0 / 16, mixed = 0.05 - 1.0 / 16;
  Matrix3 second = Matrix3::Constant(mixed);
  second.diagonal().setConstant(square);
  CHECK(relative(corner.inertia, second.trace() * Matrix3::Identity() - second) < 1e-13);
}

TEST_CASE("faces that turn the other way give a negative mass") {
  Faces inward = kBoxFaces;
  for (auto& face : inward) std::swap(face[0], face[1]);
  CHECK(solid_properties(box_corners({1, 1, 1}), inward, 1).mass == Approx(-1));
}

TEST_CASE("meshes of a sphere and of a cylinder converge to the solids, with the square of the edges' length") {
  double last = 0;
  for (const std::uint32_t n : {4, 8, 16}) {
    const auto sphere = touchstone::generators::sphere_mesh(n);
    std::vector<Vector3> points;
    for (const auto& d : sphere.directions) points.push_back(0.3 * Vector3(d.x, d.y, d.z).normalized());
    Faces faces(sphere.mesh.faces.begin(), sphere.mesh.faces.end());
    for (auto& face : faces) {
      const Vector3 normal = (points[face[1]] - points[face[0]]).cross(points[face[2]] - points[face[0]]);
      if (normal.dot(points[face[0]]) < 0) std::swap(face[0], face[1]);
    }
    const MassProperties ball = solid_properties(points, faces, 1000);
    const double mass = 1000 * 4.0 / 3 * std::numbers::pi * 0.027;
    const double error = relative(ball.inertia, 0.4 * mass * 0.09 * Matrix3::Identity());
    if (last > 0) {
      CHECK(error < last / 3);
      CHECK(error > last / 5);
    }
    last = error;
  }
  CHECK(last < 0.02);

  last = 0;
  for (const std::uint32_t n : {16, 32, 64}) {
    std::vector<Vector3> points;
    Faces faces;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double phi = 2 * std::numbers::pi * i / n;
      for (const double z : {-0.4, 0.4}) points.emplace_back(0.2 * std::cos(phi), 0.2 * std::sin(phi), z);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
      faces.push_back({a, b, b + 1});
      faces.push_back({a, b + 1, a + 1});
      if (i > 0 && i + 1 < n) {
        faces.push_back({0, b, a});
        faces.push_back({1, a + 1, b + 1});
      }
    }
    const MassProperties rod = solid_properties(points, faces, 500);
    const double mass = 500 * std::numbers::pi * 0.04 * 0.8;
    const double across = mass * (3 * 0.04 + 0.64) / 12;
    const double error = relative(rod.inertia, diagonal(across, across, mass * 0.04 / 2));
    if (last > 0) {
      CHECK(error < last / 3.5);
      CHECK(error > last / 4.5);
    }
    last = error;
  }
  CHECK(last < 0.005);
}

TEST_CASE("wire frames: a square and a ring") {
  // A square of side 1 in the plane: each side 1/12 + 1/4 about the axis across it.
  const MassProperties square = wire_properties(moved({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, kTurn, {5, 6, 7}),
                                                Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}}, 0.25);
  CHECK(std::abs(square.mass - 1) < 1e-14);
  CHECK(relative(square.inertia, kTurn * diagonal(1.0 / 6, 1.0 / 6, 1.0 / 3) * kTurn.transpose()) < 1e-13);

  std::vector<Vector3> points;
  Edges edges;
  for (std::uint32_t i = 0; i < 400; ++i) {
    const double phi = 2 * std::numbers::pi * i / 400;
    points.emplace_back(2 * std::cos(phi), 2 * std::sin(phi), 0);
    edges.push_back({i, (i + 1) % 400});
  }
  const MassProperties ring = wire_properties(points, edges, 3);
  const double mass = 3 * 4 * std::numbers::pi;
  CHECK(relative(ring.inertia, mass * diagonal(2, 2, 4)) < 1e-3);
}
