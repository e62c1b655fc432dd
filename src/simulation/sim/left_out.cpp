// SPDX-License-Identifier: MIT
#include "sim/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace touchstone::sim {
namespace {

std::string counted(std::uint64_t number, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", number, number == 1 ? one : many);
}

std::string counted(std::uint64_t number, std::string_view thing) {
  return counted(number, thing, fmt::format("{}s", thing));
}

std::string elements_of(const Simulation& simulation) {
  const Colliders& colliders = simulation.colliders();
  std::vector<std::string> all;
  const auto add = [&](std::size_t number, std::string_view one, std::string_view many) {
    if (number > 0) all.push_back(counted(number, one, many));
  };
  add(colliders.before(1).edges, "edge", "edges");
  add(colliders.before(1).faces, "face", "faces");
  add(colliders.points().size(), "loose particle", "loose particles");
  add(simulation.scene().bodies.size(), "body", "bodies");
  return all.empty() ? "nothing" : fmt::format("{}", fmt::join(all, ", "));
}

/// Particles, and springs that are no edge of another element, that the scene exempts.
std::string not_colliding(const Simulation& simulation) {
  const Colliders& colliders = simulation.colliders();
  const auto& springs = simulation.scene().springs;
  const auto exempt = static_cast<std::size_t>(std::count_if(springs.begin(), springs.end(), [&](const Spring& s) {
    const Edge edge{std::min(s.a, s.b), std::max(s.a, s.b)};
    return !s.collides && !std::binary_search(colliders.edges().begin(), colliders.edges().end(), edge);
  }));
  std::vector<std::string> all;
  if (const std::size_t particles = colliders.passes().not_colliding; particles > 0) {
    all.push_back(counted(particles, "particle"));
  }
  if (exempt > 0) all.push_back(counted(exempt, "spring"));
  if (all.empty()) return {};
  const bool one = all.size() == 1 && all.front().substr(0, 2) == "1 ";
  return fmt::format("{} that {} not collide", fmt::join(all, " and "), one ? "does" : "do");
}

/// Pairs of elements that no step asks about, as nothing of them can move.
std::string held_pairs(const Simulation& simulation) {
  const Colliders& colliders = simulation.colliders();
  const auto held = [&](Index p) { return !colliders.can_move(p); };
  const auto count = [&](const auto& elements) {
    return static_cast<std::size_t>(std::count_if(elements.begin(), elements.end(), [&](const auto& element) {
      return std::all_of(element.begin(), element.end(), held);
    }));
  };
  const auto points =
      static_cast<std::size_t>(std::count_if(colliders.points().begin(), colliders.points().end(), held));
  const std::size_t edges = count(colliders.edges_of(kParticles)), faces = count(colliders.faces_of(kParticles));
  const auto& bodies = simulation.scene().bodies;
  const auto fixed = static_cast<std::size_t>(
      std::count_if(bodies.begin(), bodies.end(), [](const Body& b) { return b.motion == BodyMotion::fixed; }));
  // An edge alone, or a face with its edges, makes no pair.
  const std::size_t apart = points + (faces > 0 ? edges - std::min<std::size_t>(edges, 2) : edges) + fixed;
  if (apart < 2) return {};
  std::vector<std::string> all;
  if (edges + faces + points > 0) all.push_back(counted(edges + faces + points, "element"));
  if (fixed > 0) all.push_back(counted(fixed, "body", "bodies"));
  std::string text = fmt::format("pairs among {} that cannot move", fmt::join(all, " and "));
  if (const std::size_t meet = simulation.start().held; meet > 0) {
    text += fmt::format(" ({} of which {})", meet, meet == 1 ? "intersects" : "intersect");
  }
  return text;
}

/// Why a run asks about no pair of elements at all; empty when it does.
std::string nothing_asked(const Simulation& simulation) {
  const Colliders& colliders = simulation.colliders();
  const Passes& passes = colliders.passes();
  const auto& bodies = simulation.scene().bodies;
  const bool body_moves =
      std::any_of(bodies.begin(), bodies.end(), [](const Body& b) { return b.motion != BodyMotion::fixed; });
  const bool particles = colliders.before(1).edges > 0 || !colliders.points().empty();
  if (passes.edge_edge || passes.vertex_face || passes.joints || passes.points) return {};
  if (bodies.empty() && !particles) return "nothing collides";
  if (!body_moves && !passes.anything_moves) return "nothing that collides can move";
  if (bodies.size() + (particles ? 1 : 0) < 2) return "only one element or body collides";
  return {};
}

}  // namespace

std::string checked_for_person(const Simulation& simulation, std::uint64_t steps) {
  const double first = static_cast<double>(simulation.steps() - steps) * simulation.scene().settings.time_step;
  std::string what = simulation.start().held > 0 ? " of anything that can move" : "";
  if (simulation.start().within_bodies > 0) what += " but within bodies";
  return fmt::format("checked: no intersection{} at {:.9g} s, and each step to {:.9g} s, of {}\n", what, first,
                     simulation.state().time, elements_of(simulation));
}

std::string left_out_for_person(const Simulation& simulation, std::uint64_t steps) {
  std::string text;
  if (const std::string reason = nothing_asked(simulation); !reason.empty()) {
    text += fmt::format("; warning: {}, so no pair was asked about", reason);
  }
  if (steps == 0) text += "; warning: only the start was asked about";
  std::vector<std::string> all{not_colliding(simulation), held_pairs(simulation)};
  if (const std::size_t within = simulation.start().within_bodies; within > 0) {
    all.push_back(
        fmt::format("{} within bodies, which {}", counted(within, "pair"), within == 1 ? "intersects" : "intersect"));
  }
  if (simulation.ignores_radii()) {
    all.emplace_back("the radii of the scene");
  } else if (const std::size_t neighbours = simulation.colliders().neighbours().count(); neighbours > 0) {
    all.push_back(fmt::format("the separations of {} of neighbours", counted(neighbours, "pair")));
  }
  if (const std::size_t waypoints = simulation.passed_waypoints(); waypoints > 0) {
    all.push_back(fmt::format("{} of paths between the ends of steps", counted(waypoints, "waypoint")));
  }
  const auto& cables = simulation.scene().cables;
  const auto thin = static_cast<std::size_t>(
      std::count_if(cables.begin(), cables.end(), [](const Cable& cable) { return !cable.solid; }));
  if (thin > 0) {
    all.push_back(fmt::format("the {} of {} that {} not solid", thin == 1 ? "radius" : "radii", counted(thin, "cable"),
                              thin == 1 ? "is" : "are"));
  }
  all.erase(std::remove(all.begin(), all.end(), std::string()), all.end());
  if (!all.empty()) text += fmt::format("; left out: {}", fmt::join(all, ", "));
  if (const StartFindings& start = simulation.start(); start.enclosed > 0) {
    text +=
        fmt::format("; {} wholly inside a closed {} at the start, without contact of surfaces ({}{})",
                    counted(start.enclosed, "part"), start.enclosed_in_bodies == start.enclosed ? "body" : "surface",
                    start.enclosed_first, start.enclosed > 1 ? ", ..." : "");
  }
  if (const std::size_t surfaces = simulation.start().branching; surfaces > 0) {
    text += fmt::format("; what is inside what is not known of {} with an edge of three faces or more",
                        counted(surfaces, "surface"));
  }
  if (const std::size_t in_open = simulation.start().in_open; in_open > 0) {
    text += fmt::format("; {} in the box around an open surface at the start, which has no inside",
                        counted(in_open, "part"));
  }
  return text;
}

}  // namespace touchstone::sim
