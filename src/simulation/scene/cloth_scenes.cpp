// Cloth that falls into folds, that drapes over a ball, and that is wrung.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "generators/shapes.hpp"
#include "scene/parts.hpp"
#include "scene/sheet.hpp"
#include "scene/shipped_scenes.hpp"

namespace touchstone::sim {
namespace {

/// A cotton sheet: 0.2 kg/m^2. It is softer than cotton, and its limit of stretch makes up for that.
Surface cotton(const SheetMesh& mesh, double radius) {
  Surface surface;
  surface.faces = mesh.faces;
  surface.stretch = 100;
  surface.poisson = 0.3;
  surface.bend = 2e-5;
  surface.areal_density = 0.2;
  surface.damping = 2e-3;
  surface.strain_limit = 0.1;
  surface.radius = radius;
  return surface;
}

/// A held ball of triangles whose sides are about `side`.
void add_ball(Scene& scene, const Vector3& centre, double ball_radius, double side, double radius) {
  const auto n = static_cast<Index>(std::max(2.0, std::round(ball_radius * std::numbers::pi / 2 / side)));
  const generators::Sphere sphere = generators::sphere_mesh(n);
  const auto first = static_cast<Index>(scene.particles.size());
  for (const Vec3& d : sphere.directions) add_pinned(scene, centre + ball_radius * Vector3(d.x, d.y, d.z));
  for (const auto& face : sphere.mesh.faces)
    scene.faces.push_back({{first + face[0], first + face[1], first + face[2]}, radius});
}

/// A way on a circle about the x axis through `start`, while the x coordinate moves by `shift`.
std::vector<Waypoint> circling(const Vector3& start, double turns, double shift, double seconds) {
  constexpr int kSegments = 64;  // of a turn: the way is 0.1 % inside the circle at most
  std::vector<Waypoint> path;
  const auto count = static_cast<int>(std::ceil(std::abs(turns) * kSegments));
  for (int i = 0; i <= count; ++i) {
    const double fraction = static_cast<double>(i) / count, angle = 2 * std::numbers::pi * turns * fraction;
    const double c = std::cos(angle), s = std::sin(angle);
    path.push_back({seconds * fraction,
                    {start.x() + shift * fraction, c * start.y() - s * start.z(), s * start.y() + c * start.z()}});
  }
  return path;
}

}  // namespace

Scene make_flag(Index triangles) {
  constexpr double kLength = 0.9, kWidth = 0.6, kTop = 0.92, kEnd = 0.08, kSwing = 0.3, kNearer = 0.05,
                   kSwingTime = 0.5;
  constexpr int kSwings = 3;
  Scene scene;
  scene.settings.duration = 2.5;
  scene.settings.time_step = 1.0 / 480;
  scene.settings.drag = 1;
  scene.settings.newton_tolerance = 1e-4;
  scene.settings.contact = {0, 0.5, 1e-3, 8};
  const SheetMesh mesh =
      add_sheet(scene, {{0, 0, kTop}, {0, 0, -kLength}, {0, kWidth, 0}, columns_for(kLength, kWidth, triangles)});
  // It bulges a little: a plane sheet that is pushed together would never choose a side.
  for (Particle& p : scene.particles) {
    p.position.x() = 0.02 * std::sin(std::numbers::pi * (kTop - p.position.z()) / kLength);
  }
  // Down to the floor, forth, back and forth again, as one lays down a sheet in folds.
  for (const auto& [p, side] : {std::pair(mesh.rows.front().front(), 1), std::pair(mesh.rows.back().front(), -1)}) {
    Particle& corner = scene.particles[p];
    for (int i = 0; i <= kSwings; ++i) {
      const double fraction = static_cast<double>(i) / kSwings;
      const Vector3 moved(i % 2 == 1 ? kSwing : 0, kNearer * side * fraction, (kEnd - kTop) * fraction);
      corner.path.push_back({kSwingTime * i, corner.position + moved});
    }
  }
  scene.surfaces.push_back(cotton(mesh, 1e-3));
  add_floor(scene, 2);
  return scene;
}

Scene make_drape(Index triangles) {
  constexpr double kSide = 0.8, kBall = 0.18, kRadius = 1e-3;
  Scene scene;
  scene.settings.duration = 3;
  scene.settings.time_step = 1.0 / 120;
  scene.settings.drag = 0.5;
  scene.settings.newton_tolerance = 1e-4;
  scene.settings.contact = {0, 0.5, 1e-3, 8};
  // Turned a little, so that the sheet's folds do not follow those of the ball's triangles.
  const double c = std::cos(0.3), s = std::sin(0.3);
  const Vector3 along(kSide * c, kSide * s, 0), across(-kSide * s, kSide * c, 0);
  const Vector3 corner = Vector3(0.01, -0.02, 2 * kBall + 0.03) - 0.5 * (along + across);
  const SheetMesh mesh = add_sheet(scene, {corner, along, across, columns_for(kSide, kSide, triangles)});
  scene.surfaces.push_back(cotton(mesh, kRadius));
  add_ball(scene, {0, 0, kBall + 0.01}, kBall, kSide * std::sqrt(2.31 / triangles), kRadius);
  add_floor(scene, 2);
  return scene;
}

Scene make_twist(Index triangles) {
  constexpr double kLength = 1, kWidth = 0.25, kTurns = 5, kSeconds = 5, kShift = 0.15, kRadius = 5e-4;
  Scene scene;
  scene.settings.duration = kSeconds;
  scene.settings.time_step = 1.0 / 400;
  scene.settings.gravity.setZero();
  scene.settings.drag = 2;
  scene.settings.newton_tolerance = 1e-4;
  scene.settings.contact = {0, 0.1, 5e-4, 8};
  const SheetMesh mesh =
      add_sheet(scene, {{0, -kWidth / 2, 0}, {0, kWidth, 0}, {kLength, 0, 0}, columns_for(kWidth, kLength, triangles)});
  // A ripple of a tenth of a millimetre: a flat sheet would never choose a way to buckle.
  for (Particle& p : scene.particles) p.position.z() = 1e-4 * std::sin(40 * p.position.x() + 25 * p.position.y());
  for (const Index p : mesh.rows.front()) {
    scene.particles[p].path = circling(scene.particles[p].position, -kTurns, kShift, kSeconds);
  }
  for (const Index p : mesh.rows.back()) {
    scene.particles[p].path = circling(scene.particles[p].position, kTurns, -kShift, kSeconds);
  }
  Surface surface = cotton(mesh, kRadius);
  surface.strain_limit = 0;
  scene.surfaces.push_back(surface);
  return scene;
}

}  // namespace touchstone::sim
