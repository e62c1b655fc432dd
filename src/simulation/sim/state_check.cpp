// SPDX-License-Identifier: MIT
#include "sim/state_check.hpp"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <touchstone/error.hpp>

#include "dynamics/rounding.hpp"
#include "io/times.hpp"

namespace touchstone::sim {
namespace {

// A director is r / |r| in doubles: the square root and the division are good to 5 halves and 1 half of epsilon, and
// its length is computed here with the same errors.
constexpr double kUnitLengthError = 4 * kEpsilon;

// r is the component of a vector u, |u| < 4, across the tangent. Rounding leaves at most 28 |u| epsilon of it along the
// tangent, and |r| may be as small as 1e-8 (unit_perpendicular): 1.3e-6.
constexpr double kAcross = 2e-6;

// m. Squared lengths of shorter segments underflow, and these have no tangent.
constexpr double kShortest = 1e-150;

// Radians. A frame turns by half a turn at most in each substep: no run has so many substeps as this takes.
constexpr double kMostTwist = 1e12;

// 1 + cosine of the angle between two segments. Below it they are so near to a fold, which has no shortest rotation,
// that parallel_transport takes another way.
constexpr double kFold = 1e-11;

// Radians: rounding of the twist between two directors, which the steps of a run add up. Near a fold, rounding turns
// the shortest rotation by so many epsilon over 1 + the cosine.
constexpr double kTwistRounding = 1e-9;
constexpr double kFoldRounding = 64 * kEpsilon;

// A driven coordinate's velocity is a difference of two rounded positions over the length of a substep, of unknown
// length: epsilon of the positions, with room for the interpolation of the path. Its speed is rounded, too.
constexpr double kPathRounding = 16 * kEpsilon;
constexpr double kSpeedRounding = 1.000001;

[[noreturn]] void fail(std::string_view key, std::size_t number, const std::string& reason) {
  throw Error(fmt::format("{}[{}]: {}", key, number, reason));
}

void check_size(std::string_view key, std::size_t is, std::size_t must, std::string_view what) {
  if (is == must) return;
  throw Error(fmt::format("{}: has {} numbers, and this scene needs {}: {}", key, is, must, what));
}

void check_sizes(const System& system, const State& state) {
  const auto size = static_cast<std::size_t>(system.size());
  const std::string what = fmt::format(
      "3 for each of {} particles, {} of which hold the direction of clamped ends, and "
      "1 for each of {} segments that resist bending",
      system.particle_count(), system.ghosts.size(), system.edges.size());
  check_size("q", static_cast<std::size_t>(state.q.size()), size, what);
  check_size("v", static_cast<std::size_t>(state.v.size()), size, what);
  check_size("directors", 3 * state.frames.director.size(), 3 * system.edges.size(),
             "3 for each segment that resists bending");
  check_size("reference_twists", state.frames.reference_twist.size(), system.joints.size(),
             "1 for each joint of such segments");
}

/// "the y of particle 3"
std::string coordinate_name(const System& system, std::size_t i) {
  const std::size_t particles = system.particle_count();
  if (i < 3 * particles) return fmt::format("the {} of particle {}", "xyz"[i % 3], i / 3);
  const RodEdge& edge = system.edges[i - 3 * particles];
  return fmt::format("the twist of segment {}-{}", edge.a, edge.b);
}

/// The driven coordinates of a scene: their greatest speed (m/s or rad/s) and distance from the origin (m).
struct Driven {
  double speed = 0, reach = 0;
};

Driven driven_of(const Scene& scene) {
  Driven most;
  for (const Particle& p : scene.particles) {
    for (std::size_t i = 0; i < p.path.size(); ++i) {
      most.reach = std::max(most.reach, p.path[i].position.lpNorm<Eigen::Infinity>());
      if (i == 0) continue;
      const Vector3 way = p.path[i].position - p.path[i - 1].position;
      most.speed = std::max(most.speed, way.lpNorm<Eigen::Infinity>() / (p.path[i].time - p.path[i - 1].time));
    }
  }
  for (const Cable& cable : scene.cables) {
    most.speed = std::max({most.speed, std::abs(cable.start.twist_rate), std::abs(cable.end.twist_rate)});
  }
  return most;
}

void check_finite(std::string_view key, const VectorX& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) fail(key, static_cast<std::size_t>(i), "must be finite");
  }
}

void check_held(const Scene& scene, const System& system, const State& state) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  VectorX moved = VectorX::Constant(system.size(), none);  // by paths and turned ends
  system.prescribe(state.time, moved);
  const Driven driven = driven_of(scene);
  const double shortest = std::ldexp(scene.settings.time_step, -kMostHalvings);
  for (std::size_t i = 0; i < system.fixed.size(); ++i) {
    if (!system.fixed[i]) continue;
    const auto at = static_cast<Eigen::Index>(i);
    const bool moves = !std::isnan(moved[at]);
    const double held = moves ? moved[at] : system.initial_position[at];
    if (state.q[at] != held) {
      fail("q", i,
           fmt::format("{} is {}: at {} s it must be {}, not {}", coordinate_name(system, i), moves ? "driven" : "held",
                       state.time, io::hexfloat(held), io::hexfloat(state.q[at])));
    }
    if (!moves && state.v[at] != 0) fail("v", i, coordinate_name(system, i) + " is held: its velocity must be 0");
    const double rounding = kPathRounding * (driven.reach + std::abs(held)) / shortest;
    if (std::abs(state.v[at]) <= driven.speed * kSpeedRounding + rounding) continue;
    fail("v", i,
         fmt::format("{} is driven, and nothing in this scene is driven faster than {:.6g}", coordinate_name(system, i),
                     driven.speed));
  }
}

Vector3 tangent(const State& state, const RodEdge& edge) {
  return (position(state.q, edge.b) - position(state.q, edge.a)).normalized();
}

bool has_tangent(const State& state, const RodEdge& edge) {
  return (position(state.q, edge.b) - position(state.q, edge.a)).lpNorm<Eigen::Infinity>() > kShortest;
}

void check_directors(const System& system, const State& state) {
  for (std::size_t j = 0; j < system.edges.size(); ++j) {
    const RodEdge& edge = system.edges[j];
    const Vector3& director = state.frames.director[j];
    if (!director.allFinite()) fail("directors", 3 * j, "must be finite");
    if (!has_tangent(state, edge)) continue;
    if (!(std::abs(director.norm() - 1) <= kUnitLengthError)) {
      fail("directors", 3 * j,
           fmt::format("this and the next two numbers, the director of segment {}-{}, must have length 1, not {}",
                       edge.a, edge.b, director.norm()));
    }
    const double along = director.dot(tangent(state, edge));
    if (std::abs(along) <= kAcross) continue;
    fail("directors", 3 * j,
         fmt::format("this and the next two numbers, the director of segment {}-{}, must be perpendicular to it: the "
                     "cosine between them is {:.3g}",
                     edge.a, edge.b, along));
  }
}

/// The shortest rotation from one segment to the next, and then the twist, take one director to the other.
void check_twists(const System& system, const State& state) {
  for (std::size_t j = 0; j < system.joints.size(); ++j) {
    const Joint& joint = system.joints[j];
    const RodEdge &e = system.edges[joint.e], &f = system.edges[joint.f];
    const double twist = state.frames.reference_twist[j];
    if (!(std::abs(twist) <= kMostTwist)) {
      fail("reference_twists", j, fmt::format("{} is not in [-{}, {}]", twist, kMostTwist, kMostTwist));
    }
    if (!has_tangent(state, e) || !has_tangent(state, f)) continue;
    const Vector3 te = tangent(state, e), tf = tangent(state, f);
    const double fold = 1 + te.dot(tf);
    if (fold < kFold) continue;
    const double tolerance = kTwistRounding + kFoldRounding / fold + kEpsilon * std::abs(twist);
    const Vector3 over = unit_perpendicular(parallel_transport(state.frames.director[joint.e], te, tf), tf);
    const double off = signed_angle(turned(over, tf, twist), state.frames.director[joint.f], tf);
    if (std::abs(off) <= tolerance) continue;
    fail("reference_twists", j,
         fmt::format("the directors of segments {}-{} and {}-{} are turned by {:.9g} rad, or whole turns more or less, "
                     "not by {:.9g}",
                     e.a, e.b, f.a, f.b, std::remainder(twist + off, 2 * std::numbers::pi), twist));
  }
}

}  // namespace

void check_state(const Scene& scene, const System& system, const State& state, std::uint64_t steps) {
  if (steps > kMostSteps) throw Error(fmt::format("steps: must be a whole number from 0 to {}", kMostSteps));
  const double time = static_cast<double>(steps) * scene.settings.time_step;
  if (state.time != time) {
    throw Error(fmt::format("time: after {} steps of {} s it must be {}, not {}", steps, scene.settings.time_step,
                            io::hexfloat(time), io::hexfloat(state.time)));
  }
  check_sizes(system, state);
  check_finite("q", state.q);
  check_finite("v", state.v);
  check_held(scene, system, state);
  check_directors(system, state);
  check_twists(system, state);
}

}  // namespace touchstone::sim
