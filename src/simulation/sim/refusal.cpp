// SPDX-License-Identifier: MIT
#include "sim/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/kind_traits.hpp"

namespace touchstone::sim {
namespace {

constexpr std::string_view kMoreRoom = "a larger strain_limit, or paths that leave it room, would be right";

std::string at(const Vector3& point) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", point.x(), point.y(), point.z());
}

/// Whether any particle of the pair is free to move in any direction.
bool can_give_way(const Pair& pair, const System& system, const Colliders& colliders) {
  const auto corners = colliders.corners(pair);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    const auto* const fixed = system.fixed.data() + 3 * std::size_t{corners[c]};
    if (!fixed[0] || !fixed[1] || !fixed[2]) return true;
  }
  return false;
}

/// "touch", or "come within 0.01 m".
std::string meeting(const char* without_radii, double separation) {
  return separation > 0 ? fmt::format("come within {:.6g} m", separation) : without_radii;
}

std::string not_converged(const Refusal& refusal, const Scene& scene, const System& system, const VectorX& q) {
  if (scene.settings.integrator == Integrator::symplectic_euler) {
    return "its numbers grow out of range; settings.time_step below the stiffest period / pi, or another "
           "settings.integrator than symplectic-euler, would be right";
  }
  // Close to the limit of stretch, no step of Newton's method goes far.
  const bool limited = std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                                   [](const Surface& surface) { return surface.strain_limit > 0; });
  const std::string advice = fmt::format(
      "a smaller settings.time_step{} or softer springs and cables would be right",
      refusal.with_contacts && scene.settings.contact.friction > 0 ? ", less settings.contact.friction" : "");
  const std::string_view with = refusal.with_contacts ? " with its contacts" : "";
  if (refusal.largest_change.coordinate < 0)
    return limited ? fmt::format("what is held or driven would stretch cloth to its strain_limit; {}", kMoreRoom)
                   : fmt::format("its equations{} cannot be solved in doubles; {}", with, advice);
  const auto coordinate = static_cast<std::size_t>(refusal.largest_change.coordinate);
  const std::size_t particles = system.particle_count();
  const bool is_angle = coordinate >= 3 * particles;
  const RodEdge edge = is_angle ? system.edges[coordinate - 3 * particles] : RodEdge{};
  const Index particle = is_angle ? edge.a : static_cast<Index>(coordinate / 3);
  return fmt::format(
      "Newton's method{} does not settle {} at {}, which it still changes by {:.3g} {}; {}", with,
      is_angle ? fmt::format("the twist of segment {}-{}", edge.a, edge.b) : fmt::format("particle {}", particle),
      at(position(q, particle)), refusal.largest_change.speed, is_angle ? "rad/s" : "m/s", advice);
}

}  // namespace

std::string refused_for_person(const RefusedCounts& counts, const RefusedCounts& before) {
  constexpr std::array<const char*, kCauses> kWhat{
      "did not converge",         "found no response",
      "would have gained energy", "would have stretched cloth to its limit",
      "failed their proof",       "were less accurate than the tolerance",
      "turned a body too far"};
  std::string text;
  for (std::size_t c = 0; c < kCauses; ++c) {
    if (const std::uint64_t number = counts[c] - before[c]; number > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, kWhat[c]);
  }
  return text;
}

std::string refusal_for_person(const Refusal& refusal, const Scene& scene, const System& system,
                               const Colliders& colliders, const VectorX& q) {
  const std::string pair = refusal.pair ? colliders.describe(*refusal.pair) : "";
  const double separation = refusal.pair ? colliders.separation(*refusal.pair) : 0;
  switch (refusal.cause) {
    case Cause::not_converged: return not_converged(refusal, scene, system, q);
    case Cause::not_resolved:
      if (!refusal.pair) return "contacts are left";
      if (!colliders.is_of_particles(*refusal.pair)) {
        return fmt::format("{} would {} at {}, and find no way apart; paths that leave them room would be right", pair,
                           meeting("touch", separation), at(refusal.point));
      }
      return fmt::format("{} would {} at {}, and {}", pair, meeting("touch", separation), at(refusal.point),
                         can_give_way(*refusal.pair, system, colliders)
                             ? "have no room between what is held or driven; paths that leave them room would be right"
                             : "nothing of them is free to give way; other paths or pins would be right");
    case Cause::gained_energy: return "energy would be gained";
    case Cause::overstretched:
      return fmt::format("what is held, driven or in contact would stretch cloth to its strain_limit; {}", kMoreRoom);
    case Cause::inaccurate: return "the tolerance asks for shorter ones; a larger one would be right";
    case Cause::turns_too_far: return "a body turns too fast; slower angular velocities would be right";
    case Cause::not_certified:
      return fmt::format(
          "{} would {} at {}; a smaller settings.time_step or a larger settings.contact.thickness "
          "would be right",
          pair, meeting("cross", separation), at(refusal.point));
  }
  return "";
}

}  // namespace touchstone::sim
