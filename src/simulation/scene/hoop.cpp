// Figure 1 of the paper: a basketball of springs, a rim, and a net of strings. And the same with a rigid rim on a pole.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generators/shapes.hpp"
#include "scene/body_shapes.hpp"
#include "scene/parts.hpp"
#include "scene/shipped_scenes.hpp"

namespace touchstone::sim {
namespace {

constexpr double kBallRadius = 0.12, kBallMass = 0.6, kRimRadius = 0.225, kRimHeight = 1.6;
// Half the thickness of the ball's skin, the radius of the rim's rod, and that of a string unless the net is fine.
constexpr double kSkinRadius = 2e-3, kRodRadius = 9e-3, kStringRadius = 2.5e-3;
// The radius of a string is at most this part of the distance of knots, or they would fill the net.
constexpr double kStringsPerKnot = 0.1;
// rad/s. The spin is too slow to be seen. But with it the ends of an edge do not move exactly alike, and the leading
// coefficient of a cubic is tiny instead of zero. The paper's closed form divides by that coefficient, and loses edges.
constexpr double kSpin = 1e-12;
constexpr Index kStringSegments = 2;                // segments of a string between two knots
constexpr double kNetDepth = 0.4, kNetEnd = 0.128;  // radius of the net's opening, which a cord holds

void add_ball(Scene& scene, Index n, const Vector3& centre, const Vector3& velocity, const Vector3& spin) {
  const generators::Sphere sphere = generators::sphere_mesh(n);
  const auto first = static_cast<Index>(scene.particles.size());
  const double mass = kBallMass / (1.1 * static_cast<double>(sphere.directions.size()));
  const double middle_radius = kBallRadius - kSkinRadius;  // of the middle of its skin
  for (const Vec3& d : sphere.directions) add_particle(scene, centre + middle_radius * Vector3(d.x, d.y, d.z), mass);
  // Springs from the middle stand for the air inside; the middle is nothing that could be hit.
  const Index middle = add_particle(scene, centre, 0.1 * kBallMass / 1.1);
  scene.particles[middle].collides = false;
  const auto corners = static_cast<double>(sphere.directions.size());
  for (const auto& edge : sphere.mesh.edges) add_spring(scene, first + edge[0], first + edge[1], 4000, 0.5, true);
  for (Index i = first; i < middle; ++i) add_spring(scene, i, middle, 6e4 / corners, 20 / corners, false);
  for (const auto& face : sphere.mesh.faces) {
    scene.faces.push_back({{first + face[0], first + face[1], first + face[2]}, kSkinRadius});
  }
  for (Index i = first; i <= middle; ++i) {
    scene.particles[i].velocity = velocity + spin.cross(scene.particles[i].position - centre);
  }
}

/// Strings resist neither bending nor twist.
void make_string(Cable& cord, double radius) {
  set_material(cord, 5e7, 0.3, radius, 1100);
  cord.solid = true;
  cord.bend = cord.twist = 0;
  cord.damping = 5e-3;
}

/// Knots in rows, each tied to two of the next row by strings of so many segments. @returns the knots of the first row
std::vector<Index> add_net(Scene& scene, Index around, Index rows, Index segments) {
  std::vector<std::vector<Index>> knots(rows + 1);
  for (Index r = 0; r <= rows; ++r) {
    const double down = static_cast<double>(r) / rows;
    const double radius = kRimRadius + (kNetEnd - kRimRadius) * std::sin(0.5 * std::numbers::pi * down);
    for (Index i = 0; i < around; ++i) {
      const double phi = 2 * std::numbers::pi * (i + 0.5 * (r % 2)) / around;
      const Vector3 at(radius * std::cos(phi), radius * std::sin(phi), kRimHeight - kNetDepth * down);
      knots[r].push_back(r == 0 ? add_pinned(scene, at) : add_particle(scene, at, 0));
    }
  }
  const double between_knots = 2 * std::numbers::pi * kNetEnd / around;
  const double string_radius = std::min(kStringRadius, kStringsPerKnot * between_knots);
  for (Index r = 0; r < rows; ++r) {
    for (Index i = 0; i < around; ++i) {
      for (Index side = 0; side < 2; ++side) {
        const Index other = r % 2 == 0 ? (i + side + around - 1) % around : (i + side) % around;
        const Index from = knots[r][i], to = knots[r + 1][other];
        Cable cord;
        cord.particles.push_back(from);
        const Vector3 a = scene.particles[from].position, b = scene.particles[to].position;
        for (Index s = 1; s < segments; ++s) {
          cord.particles.push_back(add_particle(scene, a + (b - a) * (static_cast<double>(s) / segments), 0));
        }
        cord.particles.push_back(to);
        make_string(cord, string_radius);
        scene.cables.push_back(std::move(cord));
      }
    }
  }
  // Without it the net would hang as a cylinder.
  Cable last;
  last.particles = knots[rows];
  last.closed = true;
  make_string(last, string_radius);
  scene.cables.push_back(std::move(last));
  return knots.front();
}

struct HoopSize {
  Index ball = 0, around = 0, rows = 0;
};

/// Half of the edges for the ball, 12 ball^2, and half for the net, 2 * around * rows * kStringSegments.
HoopSize hoop_size(Index edges) {
  const double half = 0.5 * edges;
  const double rows = std::max(3.0, std::round(std::cbrt(half / 2) * 0.95));
  return {static_cast<Index>(std::max(2.0, std::round(std::sqrt(half / 12)))),
          static_cast<Index>(std::max(8.0, std::round(half / (2.0 * kStringSegments * rows)))),
          static_cast<Index>(rows)};
}

void set_hoop_settings(Settings& settings) {
  set_contact(settings.contact, 0.4, 0.2, 1e-3);
  settings.drag = 0.1;
  settings.newton_tolerance = 1e-4;
}

/// A wire around the axis z, which two stays hold from the side of +x.
Body rim(Index around, double radius, double height, double stays_end) {
  Body body;
  for (Index i = 0; i < around; ++i) {
    const double phi = 2 * std::numbers::pi * i / around;
    body.vertices.emplace_back(radius * std::cos(phi), radius * std::sin(phi), height);
    body.edges.push_back({i, (i + 1) % around});
  }
  const Index aside = around / 8;
  for (const Index from : {aside, around - aside}) {
    const auto to = static_cast<Index>(body.vertices.size());
    body.vertices.emplace_back(stays_end, body.vertices[from].y(), height);
    body.edges.push_back({from, to});
  }
  body.motion = BodyMotion::fixed;
  return body;
}

}  // namespace

Scene make_hoop(Index edges) {
  Scene scene;
  set_hoop_settings(scene.settings);
  scene.settings.duration = 10;
  const HoopSize size = hoop_size(edges);
  const std::vector<Index> top = add_net(scene, size.around, size.rows, kStringSegments);
  for (Index i = 0; i < size.around; ++i) {
    scene.wires.push_back({{top[i], top[(i + 1) % size.around]}, kRodRadius});
  }
  add_ball(scene, size.ball, {0.03, -0.02, kRimHeight + 0.6}, Vector3::Zero(), kSpin * Vector3(0.48, 0.6, 0.64));
  add_floor(scene, 3);
  return scene;
}

Scene make_hoop_rim(Index edges) {
  Scene scene;
  set_hoop_settings(scene.settings);
  scene.settings.time_step = 1.0 / 480;
  scene.settings.duration = 4;
  const HoopSize size = hoop_size(edges);
  // The net hangs on hooks, just below the rim and inside of it.
  constexpr double kHook = 0.02;
  add_net(scene, size.around, size.rows, kStringSegments);
  // It is thrown at the board, bounces off it onto the rim, and goes in.
  add_ball(scene, size.ball, {-1.2, 0.06, kRimHeight - 0.2}, {2.35, -0.08, 4.35}, {0, -6, 0});
  add_floor(scene, 3);
  constexpr double kBoard = 0.4, kBoardDepth = 0.02, kPoleSide = 0.08, kPoleHeight = 2.1, kGap = 0.005;
  scene.bodies.push_back(rim(2 * size.around, kRimRadius + kHook / 2, kRimHeight + kHook, kBoard - kGap));
  scene.bodies.push_back(fixed(box({kBoardDepth, 0.9, 0.6}, 0), {kBoard + kBoardDepth / 2, 0, kRimHeight + 0.25}));
  scene.bodies.push_back(fixed(box({kPoleSide, kPoleSide, kPoleHeight - kGap}, 0),
                               {kBoard + kBoardDepth + kGap + kPoleSide / 2, 0, (kPoleHeight + kGap) / 2}));
  scene.bodies[0].radius = kRodRadius;
  return scene;
}

}  // namespace touchstone::sim
