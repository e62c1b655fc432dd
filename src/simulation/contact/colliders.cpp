// SPDX-License-Identifier: MIT
#include "contact/colliders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <touchstone/distance.hpp>

#include "broad_phase/box_tree.hpp"
#include "geometry/kind_traits.hpp"
#include "numbers/doubles/rounded_sum.hpp"
#include "scene/features.hpp"

namespace touchstone::sim {
namespace {

/// The box around the particles at x, wider by at least `margin` in exact arithmetic. A rounded sum y is off by less
/// than the distance to the next double, which is at most 2^-52 |y|; where that underflows, the sum is exact.
template <std::size_t N>
broad_phase::Box box_around(const std::array<Index, N>& particles, const VectorX& x, double margin) {
  constexpr double kToNext = 0x1p-52;
  broad_phase::Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto coordinate = [&](Index p) { return x[3 * static_cast<Eigen::Index>(p) + static_cast<Eigen::Index>(k)]; };
    double low = coordinate(particles[0]), high = low;
    for (std::size_t c = 1; c < N; ++c) {
      low = std::min(low, coordinate(particles[c]));
      high = std::max(high, coordinate(particles[c]));
    }
    low -= margin;
    high += margin;
    const double outward = margin > 0 ? kToNext : 0;
    box.low[k] = low - outward * std::fabs(low);
    box.high[k] = high + outward * std::fabs(high);
  }
  return box;
}

/// The margin of a box around an element with this radius. A separation exceeds the sum of two radii by the rounding of
/// that sum, less than two units in the last place of the larger one: 2^-51 of it is as much.
double with_radius_added(double margin, double radius) {
  constexpr double kRoundedSum = 0x1p-51;
  return radius > 0 ? numbers::sum_rounded_up(margin, radius + kRoundedSum * radius) : margin;
}

/// The motion of particles in a substep, give or take a margin along each axis.
struct Sweep {
  const VectorX& x0;
  const VectorX& x1;
  double margin;

  template <std::size_t N>
  broad_phase::MovingBox box(const std::array<Index, N>& particles, double radius) const {
    const double wider = with_radius_added(margin, radius);
    return {box_around(particles, x0, wider), box_around(particles, x1, wider)};
  }
  broad_phase::MovingBox box(Index particle, double radius) const { return box(std::array{particle}, radius); }

  /// @param radius_of  the radius of elements[i], by i
  template <class Element, class RadiusOf>
  std::vector<broad_phase::MovingBox> boxes(const std::vector<Element>& elements, RadiusOf radius_of) const {
    std::vector<broad_phase::MovingBox> boxes;
    boxes.reserve(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) boxes.push_back(box(elements[i], radius_of(i)));
    return boxes;
  }
};

template <std::size_t N>
bool contains(const std::array<Index, N>& element, Index particle) {
  return std::find(element.begin(), element.end(), particle) != element.end();
}

/// Of the edges that can move, as a large floor is no measure of the elements that lie on it; of all when none can.
double shortest_of(const std::vector<Edge>& edges, const std::vector<char>& moves, const VectorX& q) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double moving = kInfinity, all = kInfinity;
  for (const Edge& edge : edges) {
    const double length = (position(q, edge[0]) - position(q, edge[1])).norm();
    all = std::min(all, length);
    if (moves[edge[0]] || moves[edge[1]]) moving = std::min(moving, length);
  }
  if (moving < kInfinity) return moving;
  return all < kInfinity ? all : 1;
}

}  // namespace

Colliders::Colliders(const Scene& scene, const System& system, Keep keep) {
  faces_.reserve(scene.faces.size());
  for (const Facet& face : scene.faces) faces_.push_back(face.particles);
  for (const Surface& surface : scene.surfaces) faces_.insert(faces_.end(), surface.faces.begin(), surface.faces.end());
  for (const Spring& spring : scene.springs) {
    if (spring.collides) edges_.push_back({spring.a, spring.b});
  }
  for (const Cable& cable : scene.cables) {
    for (std::size_t j = 0; j < cable.edge_count(); ++j) {
      edges_.push_back({cable.particles[j], cable.particles[(j + 1) % cable.particles.size()]});
    }
  }
  for (const Wire& wire : scene.wires) edges_.push_back(wire.particles);
  for (const Face& face : faces_) {
    for (std::size_t k = 0; k < 3; ++k) edges_.push_back({face[k], face[(k + 1) % 3]});
  }
  for (Edge& edge : edges_) std::sort(edge.begin(), edge.end());
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());

  const std::size_t count = scene.particles.size();
  moves_.assign(system.particle_count(), 0);
  for (std::size_t p = 0; p < count; ++p) moves_[p] = !scene.particles[p].path.empty() || !scene.particles[p].pinned();

  in_edge_.assign(count, 0);
  std::vector<std::vector<Index>> edges_at(count);
  for (Index e = 0; e < edges_.size(); ++e) {
    for (const Index p : edges_[e]) {
      in_edge_[p] = 1;
      edges_at[p].push_back(e);
    }
  }
  shortest_ = shortest_of(edges_, moves_, system.initial_position);
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
  passes_.edge_edge = anything_moves && edges_.size() > 1;
  passes_.vertex_face = anything_moves && !faces_.empty() && vertices_.size() > 3;
  passes_.joints = !folds_.empty();
  passes_.points = anything_moves && !points_.empty() && points_.size() + edges_.size() > 1;
  passes_.anything_moves = anything_moves;
  passes_.free_points = points_.size();
  passes_.not_colliding = count - vertices_.size();
  if (!kSeparations || keep == Keep::contact) return;
  radii_ = Radii(scene, edges_);
  if (!radii_.any()) return;
  neighbours_ = Neighbours(scene, edges_, radii_.particle, system.initial_position);
}

std::size_t Colliders::with_radius() const noexcept {
  if (!has_separations()) return 0;
  const auto counted = [](const std::vector<double>& radii) {
    return static_cast<std::size_t>(std::count_if(radii.begin(), radii.end(), [](double r) { return r > 0; }));
  };
  const auto points = std::count_if(points_.begin(), points_.end(), [&](Index p) { return radii_.particle[p] > 0; });
  return counted(radii_.edge) + counted(radii_.face) + static_cast<std::size_t>(points);
}

double Colliders::largest_radius() const noexcept {
  return has_separations() ? *std::max_element(radii_.particle.begin(), radii_.particle.end()) : 0;
}

double Colliders::separation_of(const Pair& pair) const noexcept {
  if (pair.kind == Kind::point_edge && in_edge_[pair.i]) return 0;  // a fold
  const auto& [first, second] = geometry::traits_of(pair.kind);
  const double d = numbers::sum_rounded_up(radius_of(first.sort, pair.i), radius_of(second.sort, pair.j));
  if (d == 0 || neighbours_.count() == 0) return d;
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

bool Colliders::can_move(const Pair& pair) const noexcept {
  const auto particles = corners(pair);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    if (moves_[particles[c]]) return true;
  }
  return false;
}

std::vector<Pair> Colliders::candidates(const VectorX& x0, const VectorX& x1, double margin) const {
  std::vector<Pair> pairs;
  const Sweep motion{x0, x1, margin};
  const bool thick = has_separations();
  const auto by_number = [thick](const std::vector<double>& radii) {
    return [thick, &radii](std::size_t i) { return thick ? radii[i] : 0; };
  };
  const auto by_particle = [&](const std::vector<Index>& particles) {
    return [&](std::size_t i) { return thick ? radii_.particle[particles[i]] : 0; };
  };
  const auto add = [&](const Pair& pair) {
    if (can_move(pair)) pairs.push_back(pair);
  };
  std::vector<broad_phase::MovingBox> edge_boxes;
  if (passes_.edge_edge || passes_.joints || passes_.points) edge_boxes = motion.boxes(edges_, by_number(radii_.edge));
  if (passes_.edge_edge) {
    broad_phase::for_each_pair(edge_boxes, [&](Index i, Index j) {
      if (!contains(edges_[j], edges_[i][0]) && !contains(edges_[j], edges_[i][1])) add({Kind::edge_edge, i, j});
    });
  }
  if (kFaces && passes_.vertex_face) {
    const auto vertex_boxes = motion.boxes(vertices_, by_particle(vertices_));
    const auto face_boxes = motion.boxes(faces_, by_number(radii_.face));
    broad_phase::for_each_pair(vertex_boxes, face_boxes, [&](Index i, Index j) {
      if (!contains(faces_[j], vertices_[i])) add({Kind::vertex_face, vertices_[i], j});
    });
  }
  if (kFolds && passes_.joints) {
    for (const Fold& fold : folds_) {
      if (broad_phase::meet(motion.box(fold.particle, 0), edge_boxes[fold.edge]))
        pairs.push_back({Kind::point_edge, fold.particle, fold.edge});
    }
  }
  if (passes_.points) {
    const auto point_boxes = motion.boxes(points_, by_particle(points_));
    broad_phase::for_each_pair(point_boxes, edge_boxes, [&](Index i, Index j) {
      add({Kind::point_edge, points_[i], j});
    });
    broad_phase::for_each_pair(point_boxes, [&](Index i, Index j) {
      add({Kind::point_point, points_[i], points_[j]});
    });
  }
  return pairs;
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
  const auto c = corners(pair);
  const auto named = [](const geometry::Element& element, const Index* particles) {
    return fmt::format("{} {}", element.sort == MeshElement::vertex ? "particle" : name_of(element.sort),
                       fmt::join(particles, particles + element.corners(), "-"));
  };
  const auto& [first, second] = geometry::traits_of(pair.kind);
  return named(first, c.data()) + " and " + named(second, c.data() + first.corners());
}

}  // namespace touchstone::sim
