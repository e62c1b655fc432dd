// SPDX-License-Identifier: MIT
#include "scene/body.hpp"

#include <Eigen/Eigenvalues>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <touchstone/error.hpp>

#include "scene/scene.hpp"

namespace touchstone::sim {
namespace {

constexpr double kMostLength = 1e9;  // m, as of particles
constexpr double kMostMass = 1e15;
constexpr double kMostTurning = 1e6;  // rad/s
constexpr std::size_t kMostElements = 10'000'000;

// Fraction of the largest principal moment of inertia: a body on a line has none about it, but for rounding.
constexpr double kLeastMoment = 1e-9;

// By which a principal moment may exceed the sum of the two others: given numbers are rounded.
constexpr double kMomentRounding = 1e-6;

class BodyPath {
 public:
  explicit BodyPath(std::size_t number) : number_(number) {}

  [[noreturn]] void fail(std::string_view key, std::string_view reason) const {
    throw Error(fmt::format("bodies[{}]{}{}: {}", number_, key.empty() ? "" : ".", key, reason));
  }
  void in_range(std::string_view key, double value, double low, double high) const {
    if (!(value >= low && value <= high)) fail(key, fmt::format("{} is not in [{}, {}]", value, low, high));
  }
  void vector(std::string_view key, const Vector3& value, double most = kMostLength) const {
    if (!value.allFinite() || value.lpNorm<Eigen::Infinity>() > most) {
      fail(key, fmt::format("must be three finite numbers of at most {}", most));
    }
  }
  void quaternion(std::string_view key, const Quaternion& q) const {
    const double length = std::sqrt(dot(q, q));
    if (!(length >= 1e-3 && length <= 1e3)) {
      fail(key, fmt::format("must be a quaternion w, x, y, z with a length in [0.001, 1000], not {}", length));
    }
  }

 private:
  std::size_t number_;
};

template <std::size_t N>
void check_elements(const BodyPath& path, std::string_view name, const Body& body,
                    const std::vector<std::array<std::uint32_t, N>>& elements, std::vector<char>& used) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto key = [&] { return fmt::format("{}[{}]", name, i); };
    for (std::size_t k = 0; k < N; ++k) {
      const std::uint32_t vertex = elements[i][k];
      if (vertex >= body.vertices.size()) {
        path.fail(key(), fmt::format("there is no vertex {}: there are {}", vertex, body.vertices.size()));
      }
      for (std::size_t j = 0; j < k; ++j) {
        if (elements[i][j] == vertex) path.fail(key(), fmt::format("vertex {} is there twice", vertex));
        if (body.vertices[elements[i][j]] == body.vertices[vertex]) {
          path.fail(key(), fmt::format("vertices {} and {} are in one place", elements[i][j], vertex));
        }
      }
      used[vertex] = 1;
    }
  }
}

void check_shape(const BodyPath& path, const Body& body) {
  if (body.vertices.empty()) path.fail("vertices", "a body must have some");
  if (body.vertices.size() > kMostElements) path.fail("vertices", "are more than 10,000,000");
  if (body.faces.empty() == body.edges.empty()) {
    path.fail("", "a body has either faces, as a mesh, or edges, as a wire frame");
  }
  if (body.faces.size() + body.edges.size() > kMostElements) path.fail("", "has more than 10,000,000 elements");
  for (std::size_t i = 0; i < body.vertices.size(); ++i) path.vector(fmt::format("vertices[{}]", i), body.vertices[i]);
  std::vector<char> used(body.vertices.size(), 0);
  check_elements(path, "edges", body, body.edges, used);
  check_elements(path, "faces", body, body.faces, used);
  const auto unused = std::find(used.begin(), used.end(), char{0});
  if (unused != used.end()) {
    path.fail(fmt::format("vertices[{}]", unused - used.begin()), "is in no edge and in no face");
  }
}

/// A mesh has an inside when each edge has two faces, which run along it in opposite directions.
void check_closed(const BodyPath& path, const Body& body) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  sides.reserve(3 * body.faces.size());
  for (const auto& face : body.faces) {
    for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(face[k], face[(k + 1) % 3]);
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& [a, b] = sides[i];
    if (i > 0 && sides[i - 1] == sides[i]) {
      path.fail("faces",
                fmt::format("two faces run from vertex {} to vertex {}: a mesh with a density has two faces at "
                            "each edge, which turn the same way",
                            a, b));
    }
    if (!std::binary_search(sides.begin(), sides.end(), std::pair{b, a})) {
      path.fail("faces", fmt::format("the mesh is open at edge {}-{}: a density needs a closed one; mass and inertia "
                                     "would be right",
                                     a, b));
    }
  }
}

void check_mass(const BodyPath& path, const Body& body) {
  path.vector("centre", body.centre);
  const bool given = body.mass != 0 || body.inertia != std::array<double, 6>{};
  if (body.motion != BodyMotion::free) {
    if (body.density != 0) path.fail("density", "goes with a body that is free");
    if (given || body.centre != Vector3::Zero()) path.fail("mass", "goes with a body that is free");
    return;
  }
  if (body.density != 0 && given) path.fail("mass", "follows from the density where there is one");
  if (body.density != 0 && body.centre != Vector3::Zero()) path.fail("centre", "follows from the density");
  if (body.density == 0 && !given) path.fail("density", "a free body needs one, or mass and inertia");
  if (given) {
    if (!(body.mass > 0 && body.mass <= kMostMass)) {
      path.fail("mass", fmt::format("{} is not in (0, {}]", body.mass, kMostMass));
    }
    for (const double moment : body.inertia) path.in_range("inertia", moment, -kMostMass, kMostMass);
  } else {
    if (!(body.density > 0 && body.density <= kMostMass)) {
      path.fail("density", fmt::format("{} is not in (0, {}]", body.density, kMostMass));
    }
    if (!body.faces.empty()) check_closed(path, body);
  }
  const MassProperties mass = mass_properties(body);
  if (mass.mass < 0) path.fail("faces", "they turn clockwise as seen from outside: the other way would be right");
  if (!(mass.mass > 0) || !std::isfinite(mass.mass) || !mass.inertia.allFinite()) {
    path.fail("density", fmt::format("the body has a mass of {} kg: it must be positive", mass.mass));
  }
  const Vector3 moments = Eigen::SelfAdjointEigenSolver<Matrix3>(mass.inertia, Eigen::EigenvaluesOnly).eigenvalues();
  const char* const key = given ? "inertia" : "density";
  if (!(moments[0] > kLeastMoment * moments[2])) {
    path.fail(key, fmt::format("the principal moments of inertia are {}, {} and {}: all must be positive; a body on a "
                               "line has none about it",
                               moments[0], moments[1], moments[2]));
  }
  if (moments[2] > (moments[0] + moments[1]) * (1 + kMomentRounding)) {
    path.fail(key, fmt::format("the principal moments of inertia are {}, {} and {}: no body has one that exceeds the "
                               "sum of the others",
                               moments[0], moments[1], moments[2]));
  }
}

void check_motion(const BodyPath& path, const Body& body) {
  path.vector("position", body.pose.p);
  path.quaternion("orientation", body.pose.q);
  path.vector("velocity", body.velocity);
  path.vector("angular_velocity", body.angular_velocity, kMostTurning);
  const bool moves = !body.velocity.isZero(0) || !body.angular_velocity.isZero(0);
  if (body.motion == BodyMotion::fixed && moves) path.fail("velocity", "a fixed body has none");
  if (body.path.empty()) return;
  if (body.motion != BodyMotion::driven) path.fail("path", "goes with a driven body");
  if (moves) path.fail("path", "a driven body has a path or velocities, not both");
  for (std::size_t i = 0; i < body.path.size(); ++i) {
    const auto key = [&](const char* name) { return fmt::format("path[{}].{}", i, name); };
    path.vector(key("position"), body.path[i].pose.p);
    path.quaternion(key("orientation"), body.path[i].pose.q);
    path.in_range(key("time"), body.path[i].time, 0, kMostMass);
    if (i > 0 && !(body.path[i].time > body.path[i - 1].time)) {
      path.fail(key("time"), "must be later than the waypoint before it");
    }
  }
}

}  // namespace

std::string_view body_motion_name(BodyMotion motion) noexcept {
  switch (motion) {
    case BodyMotion::free: return "free";
    case BodyMotion::fixed: return "fixed";
    case BodyMotion::driven: return "driven";
  }
  return "";
}

MassProperties mass_properties(const Body& body) {
  if (body.density != 0) {
    return body.faces.empty() ? wire_properties(body.vertices, body.edges, body.density)
                              : solid_properties(body.vertices, body.faces, body.density);
  }
  const auto& [xx, yy, zz, xy, xz, yz] = body.inertia;
  MassProperties given{body.mass, body.centre, Matrix3::Zero()};
  given.inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return given;
}

void check_bodies(const Scene& scene) {
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyPath path(i);
    const Body& body = scene.bodies[i];
    check_shape(path, body);
    vertices += body.vertices.size();
    if (vertices > kMostElements) path.fail("vertices", "the bodies have more than 10,000,000 vertices");
    if (const std::string reason = wrong_radius(body.radius); !reason.empty()) path.fail("radius", reason);
    check_motion(path, body);
    check_mass(path, body);
  }
}

}  // namespace touchstone::sim
