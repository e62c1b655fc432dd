// SPDX-License-Identifier: MIT
#include "contact/colliders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <touchstone/distance.hpp>

#include "geometry/kind_traits.hpp"
#include "numbers/doubles/rounded_sum.hpp"

namespace touchstone::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Of the edges that can move, as a large floor is no measure of the elements that lie on it; of all when none can.
double shortest_of(std::span<const Edge> edges, const std::vector<char>& moves, const VectorX& q) {
  double moving = kInfinity, all = kInfinity;
  for (const Edge& edge : edges) {
    const double length = (position(q, edge[0]) - position(q, edge[1])).norm();
    all = std::min(all, length);
    if (moves[edge[0]] || moves[edge[1]]) moving = std::min(moving, length);
  }
  if (moving < kInfinity) return moving;
  return all < kInfinity ? all : 1;
}

Edge sorted(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

Colliders::Colliders(const Scene& scene, const System& system, Keep keep) : bodies_(scene) {
  add_elements(scene);
  const std::size_t count = scene.particles.size();
  for (const Particle& particle : scene.particles) moves_.push_back(!particle.path.empty() || !particle.pinned());
  for (const Index group : group_of_) moves_.push_back(scene.bodies[group - 1].motion != BodyMotion::fixed);

  in_edge_.assign(count, 0);
  std::vector<std::vector<Index>> edges_at(count);
  for (Index e = 0; e < before_[1].edges; ++e) {
    for (const Index p : edges_[e]) {
      in_edge_[p] = 1;
      edges_at[p].push_back(e);
    }
  }
  shortest_ = shortest_of(edges_of(kParticles), moves_, system.initial_position);
  std::set<std::pair<Index, Index>> folding;  // in a triangle either end of an edge leads to the third corner
  for (Index p = 0; p < count; ++p) {
    if (!scene.particles[p].collides) continue;  // check_scene: then nothing that could be hit has it as a corner
    vertices_.push_back(p);
    if (!in_edge_[p]) points_.push_back(p);
    for (const Index e : edges_at[p]) {
      for (const Index other : edges_at[p]) {
        const Index end = edges_[other][0] == p ? edges_[other][1] : edges_[other][0];
        if (e == other || !can_move({Kind::point_edge, end, e})) continue;
        if (folding.insert({end, e}).second) folds_.push_back({end, e});
      }
    }
  }
  const bool anything_moves = std::any_of(vertices_.begin(), vertices_.end(), [&](Index p) { return moves_[p] != 0; });
  const Counts& particles = before_[1];
  passes_.edge_edge = anything_moves && particles.edges > 1;
  passes_.vertex_face = anything_moves && particles.faces > 0 && vertices_.size() > 3;
  passes_.joints = !folds_.empty();
  passes_.points = anything_moves && !points_.empty() && points_.size() + particles.edges > 1;
  passes_.anything_moves = anything_moves;
  passes_.free_points = points_.size();
  passes_.not_colliding = count - vertices_.size();
  if (!scene.bodies.empty()) add_neighbourhoods();
  if (!kSeparations || keep == Keep::contact) return;
  radii_ = Radii(scene, edges_);
  has_separations_ =
      radii_.any() || std::any_of(body_radii_.begin(), body_radii_.end(), [](double r) { return r > 0; });
  if (radii_.any()) neighbours_ = Neighbours(scene, edges_of(kParticles), radii_.particle, system.initial_position);
}

void Colliders::add_elements(const Scene& scene) {
  const auto add_edge = [&](Index a, Index b) { edges_.push_back(sorted(a, b)); };
  const auto add_face = [&](const Face& face) {
    faces_.push_back(face);
    for (std::size_t k = 0; k < 3; ++k) add_edge(face[k], face[(k + 1) % 3]);
  };
  for (const Facet& face : scene.faces) add_face(face.particles);
  for (const Surface& surface : scene.surfaces) {
    for (const Face& face : surface.faces) add_face(face);
  }
  for (const Spring& spring : scene.springs) {
    if (spring.collides) add_edge(spring.a, spring.b);
  }
  for (const Cable& cable : scene.cables) {
    for (std::size_t j = 0; j < cable.edge_count(); ++j) {
      add_edge(cable.particles[j], cable.particles[(j + 1) % cable.particles.size()]);
    }
  }
  for (const Wire& wire : scene.wires) add_edge(wire.particles[0], wire.particles[1]);
  auto vertices = static_cast<Index>(scene.particles.size());
  const auto end_group = [&] { before_.push_back({vertices, 0, static_cast<Index>(faces_.size())}); };
  end_group();
  shortest_of_bodies_ = kInfinity;
  for (const Body& body : scene.bodies) {
    const Index first = vertices;
    const std::size_t edges = edges_.size();
    for (const auto& [a, b] : body.edges) add_edge(first + a, first + b);
    for (const auto& [a, b, c] : body.faces) add_face({first + a, first + b, first + c});
    vertices += static_cast<Index>(body.vertices.size());
    group_of_.resize(group_of_.size() + body.vertices.size(), static_cast<Index>(before_.size() - 1));
    end_group();
    body_radii_.push_back(body.radius);
    if (body.motion == BodyMotion::fixed) continue;
    for (std::size_t e = edges; e < edges_.size(); ++e) {
      const auto [a, b] = edges_[e];
      shortest_of_bodies_ = std::min(shortest_of_bodies_, (body.vertices[a - first] - body.vertices[b - first]).norm());
    }
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  for (Counts& before : before_) {
    const auto first = std::lower_bound(edges_.begin(), edges_.end(), Edge{before.vertices, 0});
    before.edges = static_cast<Index>(first - edges_.begin());
  }
}

void Colliders::add_neighbourhoods() {
  opposite_.assign(edges_.size(), {kNoCorner, kNoCorner});
  around_.resize(before_.back().vertices);
  for (const Edge& edge : edges_) {
    around_[edge[0]].push_back(edge[1]);
    around_[edge[1]].push_back(edge[0]);
  }
  for (const Face& face : faces_) {
    for (std::size_t k = 0; k < 3; ++k) {
      auto& corners = opposite_[edge_between(face[k], face[(k + 1) % 3])];
      (corners[0] == kNoCorner ? corners[0] : corners[1]) = face[(k + 2) % 3];
    }
  }
  for (Index group = 1; group < group_count(); ++group) {
    auto& of_body = clusters_.emplace_back();
    for (const MeshElement sort : {MeshElement::vertex, MeshElement::edge, MeshElement::face}) {
      of_body[static_cast<std::size_t>(sort)] = clusters_of(group, sort);
    }
  }
}

Index Colliders::edge_between(Index a, Index b) const noexcept {
  return static_cast<Index>(std::lower_bound(edges_.begin(), edges_.end(), sorted(a, b)) - edges_.begin());
}

const Index* Colliders::corners_of(MeshElement sort, const Index& number) const noexcept {
  return geometry::corners_of(sort, number, edges_, faces_);
}

Index Colliders::group_of(MeshElement sort, Index number) const noexcept {
  return number < before_[1].of(sort) ? kParticles : group_of(*corners_of(sort, number));
}

bool Colliders::is_of_particles(const Pair& pair) const noexcept {
  const auto& [first, second] = geometry::traits_of(pair.kind);
  return pair.i < before_[1].of(first.sort) && pair.j < before_[1].of(second.sort);
}

double Colliders::radius_of(MeshElement sort, Index number) const noexcept {
  if (!has_separations()) return 0;
  if (const Index group = group_of(sort, number); group != kParticles) return body_radii_[group - 1];
  if (!radii_.any()) return 0;
  const auto& radii = sort == MeshElement::edge   ? radii_.edge
                      : sort == MeshElement::face ? radii_.face
                                                  : radii_.particle;
  return radii[number];
}

std::size_t Colliders::with_radius() const noexcept {
  if (!radii_.any()) return 0;
  const auto counted = [](const std::vector<double>& radii) {
    return static_cast<std::size_t>(std::count_if(radii.begin(), radii.end(), [](double r) { return r > 0; }));
  };
  const auto points = std::count_if(points_.begin(), points_.end(), [&](Index p) { return radii_.particle[p] > 0; });
  return counted(radii_.edge) + counted(radii_.face) + static_cast<std::size_t>(points);
}

double Colliders::largest_radius() const noexcept {
  return radii_.any() ? *std::max_element(radii_.particle.begin(), radii_.particle.end()) : 0;
}

double Colliders::separation_of(const Pair& pair) const noexcept {
  if (pair.kind == Kind::point_edge && in_edge_[pair.i]) return 0;  // a fold
  const auto& [first, second] = geometry::traits_of(pair.kind);
  const double d = numbers::sum_rounded_up(radius_of(first.sort, pair.i), radius_of(second.sort, pair.j));
  if (d == 0 || neighbours_.count() == 0 || !is_of_particles(pair)) return d;
  const auto particles = corners(pair);
  const std::size_t of_first = geometry::corners_of_first(pair.kind);
  for (std::size_t a = 0; a < of_first; ++a) {
    for (std::size_t b = of_first; b < corner_count(pair.kind); ++b) {
      if (neighbours_.near(particles[a], particles[b], d)) return 0;
    }
  }
  return d;
}

std::array<Index, 4> Colliders::corners(const Pair& pair) const noexcept {
  return geometry::pair_corners(pair.kind, pair.i, pair.j, edges_, faces_);
}

Query Colliders::query(const Pair& pair, const VectorX& x0, const VectorX& x1) const noexcept {
  Query query;
  query.kind = pair.kind;
  const auto particles = corners(pair);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    query.start[c] = corner_of(x0, particles[c]);
    query.end[c] = corner_of(x1, particles[c]);
  }
  return query;
}

CurvedQuery Colliders::query(const Pair& pair, const SceneMotion& motion) const noexcept {
  CurvedQuery query;
  query.kind = pair.kind;
  const auto vec = [](const Vector3& x) { return Vec3{x.x(), x.y(), x.z()}; };
  const auto all = corners(pair);
  const std::size_t of_first = geometry::corners_of_first(pair.kind);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    CurvedCorner& corner = query.corners[c];
    const Index group = group_of(all[c]);
    if (group == kParticles) {
      corner.control_points = 2;
      corner.points[0] = corner_of(*motion.x0, all[c]);
      corner.points[1] = corner_of(*motion.x1, all[c]);
      continue;
    }
    // Each element has a motion of its own, unless both are of one kind.
    corner.motion = c < of_first ? 0 : 1;
    corner.points[0] = vec(bodies_.bodies()[group - 1].points[all[c] - before_[group].vertices]);
    if (c != 0 && c != of_first) continue;
    const Pose &from = (*motion.start)[group - 1].pose, &to = (*motion.end)[group - 1].pose;
    query.motions[static_cast<std::size_t>(corner.motion)] = {from.q, to.q, vec(from.p), vec(to.p)};
  }
  return query;
}

Vector3 Colliders::at(Index vertex, const VectorX& x, const BodyStates& bodies) const noexcept {
  const Index group = group_of(vertex);
  if (group == kParticles) return position(x, vertex);
  return placed(bodies[group - 1].pose, bodies_.bodies()[group - 1].points[vertex - before_[group].vertices]);
}

Vector3 Colliders::contact_point(const Pair& pair, const VectorX& x0, const VectorX& x1,
                                 const Answer& answer) const noexcept {
  const auto c = corners(pair);
  const auto at = [&](Index p) -> Vector3 {
    return position(x0, p) + answer.toi * (position(x1, p) - position(x0, p));
  };
  if (pair.kind != Kind::edge_edge) return at(c[0]);  // the first element is a particle
  return answer.weights_a[0] * at(c[0]) + answer.weights_a[1] * at(c[1]);
}

double Colliders::distance(const Pair& pair, const VectorX& x) const {
  return touchstone::distance(query(pair, x, x)).value;
}

std::string Colliders::describe(const Pair& pair) const {
  const auto& [first, second] = geometry::traits_of(pair.kind);
  return describe(first.sort, corners_of(first.sort, pair.i)) + " and " +
         describe(second.sort, corners_of(second.sort, pair.j));
}

std::string Colliders::describe(MeshElement sort, const Index* corners) const {
  const Index group = group_of(*corners);
  std::string text(sort == MeshElement::vertex && group == kParticles ? "particle" : name_of(sort));
  for (std::size_t c = 0; c <= static_cast<std::size_t>(sort); ++c) {
    text += fmt::format("{}{}", c == 0 ? ' ' : '-', corners[c] - before_[group].vertices);
  }
  return group == kParticles ? text : fmt::format("{} of body {}", text, group - 1);
}

}  // namespace touchstone::sim
