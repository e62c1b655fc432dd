// Scenes of rigid bodies: a chain of links, boxes on one another, a nut that runs down a thread.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <utility>

#include "scene/body_shapes.hpp"
#include "scene/parts.hpp"
#include "scene/shipped_scenes.hpp"

namespace touchstone::sim {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Quaternion turned_about(const Vector3& axis, double angle) {
  const Vector3 v = std::sin(angle / 2) * axis;
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

Body ground(double half_width) {
  const double w = half_width;
  Body body;
  body.vertices = {{-w, -w, 0}, {w, -w, 0}, {w, w, 0}, {-w, w, 0}};
  body.faces = {{0, 1, 2}, {0, 2, 3}};
  return fixed(std::move(body));
}

/// A link of wire: two straight sides and two half circles, around the origin, along x in the plane z = 0.
Body link(Index edges, double half_side, double radius, double density) {
  Body body;
  const double around = kTurn * radius, length = around + 4 * half_side;
  for (Index i = 0; i < edges; ++i) {
    double s = length * i / edges;
    Vector3 at;
    const auto arc = [&](double centre, double start) {
      const double phi = start + s / radius;
      return Vector3(centre + radius * std::cos(phi), radius * std::sin(phi), 0);
    };
    if (s < 2 * half_side) {
      at = {-half_side + s, -radius, 0};
    } else if ((s -= 2 * half_side) < around / 2) {
      at = arc(half_side, -kTurn / 4);
    } else if ((s -= around / 2) < 2 * half_side) {
      at = {half_side - s, radius, 0};
    } else {
      s -= 2 * half_side;
      at = arc(-half_side, kTurn / 4);
    }
    body.vertices.push_back(at);
    body.edges.push_back({i, (i + 1) % edges});
  }
  body.density = density;
  return body;
}

// The thread, m: the radius of its middle, half its depth, its pitch, and how much wider the nut is.
constexpr double kThreadRadius = 0.010, kThreadDepth = 0.0015, kPitch = 0.010, kClearance = 0.0004;
constexpr Index kRowsPerPitch = 10;

double thread(double phi, double z) { return kThreadRadius + kThreadDepth * std::cos(kTurn * z / kPitch - phi); }

/// Points on a surface around the axis z, row by row.
template <class Radius>
Index add_rows(Body& body, Index around, Index rows, double bottom, double height, Radius radius) {
  const auto first = static_cast<Index>(body.vertices.size());
  for (Index j = 0; j <= rows; ++j) {
    const double z = bottom + height * j / rows;
    for (Index i = 0; i < around; ++i) {
      const double phi = kTurn * i / around, r = radius(phi, z);
      body.vertices.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
    }
  }
  return first;
}

/// Faces between two rows of points: seen from outside counter-clockwise, or from the axis.
void join_rows(Body& body, Index around, Index below, Index above, bool outward) {
  for (Index i = 0; i < around; ++i) {
    const Index n = (i + 1) % around;
    const Index a = below + i, b = below + n, c = above + n, d = above + i;
    if (outward) {
      body.faces.push_back({a, b, c});
      body.faces.push_back({a, c, d});
    } else {
      body.faces.push_back({a, c, b});
      body.faces.push_back({a, d, c});
    }
  }
}

}  // namespace

Scene make_stack(Index boxes) {
  Scene scene;
  scene.settings.time_step = 1.0 / 100;
  scene.settings.duration = 5;
  set_contact(scene.settings.contact, 0, 0.5, 2e-3);
  constexpr double kSide = 0.2, kGap = 1e-3;
  scene.bodies.push_back(ground(2));
  for (Index i = 0; i < boxes; ++i) {
    Body body = box({kSide, kSide, kSide}, 500);
    body.pose = {turned_about(Vector3::UnitZ(), 0.3 * i), {0, 0, (kSide + kGap) * i + kSide / 2 + kGap}};
    scene.bodies.push_back(body);
  }
  return scene;
}

Scene make_link_chain(Index links) {
  Scene scene;
  scene.settings.time_step = 1.0 / 1600;
  scene.settings.duration = 1.5;
  set_contact(scene.settings.contact, 0.1, 0.2, 1e-3);
  constexpr double kHalfSide = 0.03, kRadius = 0.02;
  constexpr double kPlay = 0.01;  // between two links, at the start
  const double distance = 2 * (kHalfSide + kRadius) - kPlay;
  for (Index i = 0; i < links; ++i) {
    Body body = link(100, kHalfSide, kRadius, 0.4);
    body.pose = {turned_about(Vector3::UnitX(), i % 2 == 0 ? 0.1 : 0.1 + kTurn / 4), {distance * i, 0, 0}};
    scene.bodies.push_back(i == 0 ? fixed(body, body.pose.p) : body);
  }
  return scene;
}

Scene make_nut_and_bolt(Index around) {
  Scene scene;
  scene.settings.time_step = 1.0 / 500;
  scene.settings.duration = 0.6;
  set_contact(scene.settings.contact, 0, 0.02, 1e-4);
  constexpr Index kBoltPitches = 7;
  constexpr Index kBoltRows = kRowsPerPitch * kBoltPitches, kNutRows = kRowsPerPitch * 3 / 2;
  constexpr double kNutHeight = kPitch * 1.5, kNutRadius = 0.018;
  Body bolt;
  add_rows(bolt, around, kBoltRows, 0, kPitch * kBoltPitches, thread);
  for (Index j = 0; j < kBoltRows; ++j) join_rows(bolt, around, around * j, around * (j + 1), true);
  scene.bodies.push_back(fixed(std::move(bolt)));

  // The nut has fewer faces around, so that their edges do not all lie in the bolt's corners at one time.
  const Index of_nut = around - 5;
  Body nut;
  const double bottom = kPitch * kBoltPitches - kNutHeight - kPitch / 2;
  const Index inner = add_rows(nut, of_nut, kNutRows, bottom, kNutHeight,
                               [](double phi, double z) { return thread(phi, z) + kClearance; });
  for (Index j = 0; j < kNutRows; ++j) join_rows(nut, of_nut, inner + of_nut * j, inner + of_nut * (j + 1), false);
  const Index outer = add_rows(nut, of_nut, 1, bottom, kNutHeight, [](double, double) { return kNutRadius; });
  join_rows(nut, of_nut, outer, outer + of_nut, true);
  join_rows(nut, of_nut, inner, outer, true);
  join_rows(nut, of_nut, inner + of_nut * kNutRows, outer + of_nut, false);
  nut.density = 7800;
  scene.bodies.push_back(nut);
  return scene;
}

}  // namespace touchstone::sim
