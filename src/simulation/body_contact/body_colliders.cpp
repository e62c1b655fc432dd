// SPDX-License-Identifier: MIT
#include "body_contact/body_colliders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "broad_phase/box_tree.hpp"
#include "geometry/arc_bulge.hpp"
#include "geometry/kind_traits.hpp"
#include "numbers/doubles/rounded_sum.hpp"

namespace touchstone::sim {
namespace {

using broad_phase::MovingBox;

// A moving box follows the straight lines between the ends of its corners' paths. RigidMotion interpolates
// the quaternion straight, and q0 . q1 >= 0 in a step, as geometry::kArcBulge asks. 0.01 is for rounding.
constexpr double kBulge = geometry::kArcBulge + 0.01;

// The rounded matrix of a quaternion has entries of up to 1 and errors below 14 e, e = 2^-53; 3 products and 2 sums of
// them with a point X, below 51 e |X| together; the quaternion's length is off by 4 e, its square by 8 e, which is as
// much of |X|; the position adds e (|X| + |p|). All of it is below 2^-46 (|X| + |p|) = 128 e (|X| + |p|).
constexpr double kPositioning = 0x1p-46;

// Of a radius: its sums with margins, and with another radius, are rounded.
constexpr double kWidened = 1 + 0x1p-40;

double largest(const Vector3& x) { return x.lpNorm<Eigen::Infinity>(); }

broad_phase::Box around(const std::vector<Vector3>& at, const Index* corners, std::size_t count, double margin) {
  broad_phase::Box box = broad_phase::empty_box();
  for (std::size_t c = 0; c < count; ++c) {
    const Vector3& x = at[corners[c]];
    broad_phase::extend(box, {x.x(), x.y(), x.z()});
  }
  if (margin > 0) broad_phase::grow(box, margin);
  return box;
}

/// Where the corners of a body or of the particles are at both ends, and by how much their paths leave the lines
/// between. The corners of a body are placed when they are needed: most of them lie in clusters that meet nothing.
class Sweep {
 public:
  /// @param margin  beside what rounding and the bulge of arcs need
  Sweep(const RigidBody& body, const Pose& start, const Pose& end, double margin)
      : points_(&body.points),
        turns_{matrix_of(start.q), matrix_of(end.q)},
        positions_{start.p, end.p},
        start_(body.points.size()),
        end_(body.points.size()),
        placed_(body.points.size(), 0),
        rounding_(kPositioning * (body.reach + std::max(largest(start.p), largest(end.p)))),
        margin_(margin + bulge(start.q, end.q, body.reach) + rounding_) {}
  Sweep(std::vector<Vector3> start, std::vector<Vector3> end)
      : start_(std::move(start)), end_(std::move(end)), placed_(start_.size(), 1) {}

  template <class Element>
  MovingBox box_of(const Element& element, double radius) {
    for (const Index corner : element) {
      if (placed_[corner]) continue;
      placed_[corner] = 1;
      start_[corner] = turns_[0] * (*points_)[corner] + positions_[0];
      end_[corner] = turns_[1] * (*points_)[corner] + positions_[1];
    }
    const double margin = margin_ + kWidened * radius;
    return {around(start_, element.data(), element.size(), margin),
            around(end_, element.data(), element.size(), margin)};
  }

  /// A box that the boxes of all elements of a body's cluster are in. Their corners are rounded, and so is its centre.
  MovingBox box_of(const Cluster& cluster) const {
    const double margin = cluster.radius + margin_ + 2 * rounding_;
    const auto at = [&](std::size_t end) {
      const Vector3 centre = turns_[end] * cluster.centre + positions_[end];
      broad_phase::Box box = broad_phase::empty_box();
      broad_phase::extend(box, {centre.x(), centre.y(), centre.z()});
      broad_phase::grow(box, margin);
      return box;
    };
    return {at(0), at(1)};
  }

 private:
  const std::vector<Vector3>* points_ = nullptr;
  std::array<Matrix3, 2> turns_;
  std::array<Vector3, 2> positions_;
  std::vector<Vector3> start_, end_;
  std::vector<char> placed_;
  double rounding_ = 0, margin_ = 0;
};

/// Boxes of some elements, with their numbers.
struct Boxes {
  std::vector<Index> numbers;
  std::vector<MovingBox> boxes;
};

bool is_of_particles(const BodyPair& pair) { return pair.a.body == kParticles && pair.b.body == kParticles; }
Pair particle_pair(const BodyPair& pair) { return {pair.kind, pair.a.number, pair.b.number}; }

constexpr auto kAll = [](Index) { return true; };
constexpr auto kThin = [](Index) { return 0.0; };

/// Of those elements that meet the other's box. @param radius  by which they are wider, beside the sweep's margin
/// @param clusters  of a body: of all these elements; of the particles: none
template <class Element, class Selects, class Radius>
Boxes boxes_near(Sweep& sweep, const std::vector<Element>& elements, const std::vector<Cluster>& clusters,
                 const MovingBox& other, Selects selects, Radius radius) {
  Boxes near;
  const auto look_at = [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      if (!selects(i)) continue;
      const MovingBox box = sweep.box_of(elements[i], radius(i));
      if (!broad_phase::meet(box, other)) continue;
      near.numbers.push_back(i);
      near.boxes.push_back(box);
    }
  };
  if (clusters.empty()) look_at(0, static_cast<Index>(elements.size()));
  for (const Cluster& cluster : clusters) {
    if (broad_phase::meet(sweep.box_of(cluster), other)) look_at(cluster.begin, cluster.end);
  }
  return near;
}

std::vector<std::array<Index, 1>> singles(const std::vector<Index>& vertices) {
  std::vector<std::array<Index, 1>> all;
  for (const Index v : vertices) all.push_back({v});
  return all;
}

BodyColliders::Clusters all_clusters(const std::vector<Vector3>& points, const ElementSet& surface) {
  BodyColliders::Clusters clusters;
  clusters.singles = singles(surface.vertices);
  clusters.vertices = clusters_of(points, clusters.singles);
  clusters.edges = clusters_of(points, surface.edges);
  clusters.faces = clusters_of(points, surface.faces);
  return clusters;
}

// So many vertices have a box of their own, and more of them have one around those of their clusters.
constexpr std::size_t kFewVertices = 32;

}  // namespace

double bulge(const Quaternion& q0, const Quaternion& q1, double reach) noexcept {
  double apart = 0;
  for (std::size_t i = 0; i < 4; ++i) apart += (q1[i] - q0[i]) * (q1[i] - q0[i]);
  return kBulge * apart * reach;
}

BodyColliders::BodyColliders(const Scene& scene, const System& system, const Colliders& particles,
                             const BodySystem& bodies)
    : bodies_(&bodies), of_particles_(&particles), has_separations_(particles.has_separations()) {
  std::vector<Index> colliding;
  for (Index p = 0; p < scene.particles.size(); ++p) {
    if (scene.particles[p].collides) colliding.push_back(p);
    moves_.push_back(particles.can_move(p) ? 1 : 0);
  }
  particles_ = ElementSet(system.particle_count(), std::move(colliding), particles.edges(), particles.faces());
  no_clusters_.singles = singles(particles_.vertices);
  shortest_ = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies) {
    std::vector<Index> vertices(body.vertices.size());
    std::iota(vertices.begin(), vertices.end(), Index{0});
    surfaces_.emplace_back(body.vertices.size(), std::move(vertices), all_edges(body.edges, body.faces), body.faces);
    clusters_.push_back(all_clusters(bodies.bodies()[surfaces_.size() - 1].points, surfaces_.back()));
    radii_.push_back(body.radius);
    has_separations_ |= body.radius > 0;
    if (body.motion == BodyMotion::fixed) continue;
    for (const Edge& edge : surfaces_.back().edges) {
      shortest_ = std::min(shortest_, (body.vertices[edge[0]] - body.vertices[edge[1]]).norm());
    }
  }
}

bool BodyColliders::can_move(Index body) const noexcept { return bodies_->bodies()[body].motion != BodyMotion::fixed; }

double BodyColliders::separation_of(const BodyPair& pair) const noexcept {
  if (is_of_particles(pair)) return of_particles_->separation(particle_pair(pair));
  const auto radius_of = [&](MeshElement sort, const OfBody& element) {
    return element.body == kParticles ? of_particles_->radius_of(sort, element.number) : radii_[element.body];
  };
  const auto& [first, second] = geometry::traits_of(pair.kind);
  return numbers::sum_rounded_up(radius_of(first.sort, pair.a), radius_of(second.sort, pair.b));
}

std::array<OfBody, 4> BodyColliders::corners(const BodyPair& pair) const noexcept {
  std::array<OfBody, 4> all{};
  const auto put = [&](const geometry::Element& element, const OfBody& of, std::size_t at) {
    const ElementSet& set = surface(of.body);
    const Index* const vertices = geometry::corners_of(element.sort, of.number, set.edges, set.faces);
    for (std::size_t i = 0; i < element.corners(); ++i) all[at + i] = {of.body, vertices[i]};
  };
  const auto& [first, second] = geometry::traits_of(pair.kind);
  put(first, pair.a, 0);
  put(second, pair.b, first.corners());
  return all;
}

CurvedQuery BodyColliders::query(const BodyPair& pair, const BodyMotions& motions) const noexcept {
  CurvedQuery query;
  query.kind = pair.kind;
  const auto vec = [](const Vector3& x) { return Vec3{x.x(), x.y(), x.z()}; };
  const auto motion_of = [&](Index body) -> RigidMotion {
    const Pose &from = (*motions.start)[body].pose, &to = (*motions.end)[body].pose;
    return {from.q, to.q, vec(from.p), vec(to.p)};
  };
  // Each element has a motion of its own, unless both are of one kind.
  if (pair.a.body != kParticles) query.motions[0] = motion_of(pair.a.body);
  if (pair.b.body != kParticles) query.motions[1] = motion_of(pair.b.body);
  const auto all = corners(pair);
  const std::size_t of_first = geometry::corners_of_first(pair.kind);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    CurvedCorner& corner = query.corners[c];
    if (all[c].body == kParticles) {
      corner.control_points = 2;
      corner.points[0] = corner_of(*motions.x0, all[c].number);
      corner.points[1] = corner_of(*motions.x1, all[c].number);
    } else {
      corner.motion = c < of_first ? 0 : 1;
      corner.points[0] = vec(bodies_->bodies()[all[c].body].points[all[c].number]);
    }
  }
  return query;
}

std::vector<BodyPair> BodyColliders::candidates(const BodyMotions& motions, double margin) const {
  const std::size_t count = surfaces_.size();
  std::vector<Sweep> sweeps;
  sweeps.reserve(count);
  std::vector<MovingBox> whole(count);
  for (Index b = 0; b < count; ++b) {
    Sweep& sweep = sweeps.emplace_back(bodies_->bodies()[b], (*motions.start)[b].pose, (*motions.end)[b].pose,
                                       margin + kWidened * radii_[b]);
    const std::vector<Index>& vertices = surfaces_[b].vertices;
    if (vertices.size() <= kFewVertices) {
      whole[b] = sweep.box_of(vertices, 0);
      continue;
    }
    whole[b] = broad_phase::empty_moving_box();
    for (const Cluster& cluster : clusters_[b].vertices) broad_phase::join(whole[b], sweep.box_of(cluster));
  }

  std::vector<BodyPair> pairs;
  const auto meet_all = [&](const Boxes& a, const Boxes& b, Kind kind, Index of_a, Index of_b,
                            const std::vector<Index>* vertices) {
    if (a.boxes.empty() || b.boxes.empty()) return;
    broad_phase::for_each_pair(a.boxes, b.boxes, [&](Index i, Index j) {
      const Index first = vertices ? (*vertices)[a.numbers[i]] : a.numbers[i];
      pairs.push_back({kind, {of_a, first}, {of_b, b.numbers[j]}});
    });
  };
  const auto between_surfaces = [&](Index a, Sweep& sweep_a, const MovingBox& box_a, Index b, Sweep& sweep_b,
                                    const MovingBox& box_b) {
    const ElementSet &first = surface(a), &second = surface(b);
    const Clusters &of_a = a == kParticles ? no_clusters_ : clusters_[a], &of_b = clusters_[b];
    // The radius of a body is in its sweep's margin.
    const auto radius = [&](MeshElement sort, Index of) {
      return [this, sort, of](Index i) { return of == kParticles ? of_particles_->radius_of(sort, i) : 0.0; };
    };
    const auto vertex_radius = [&](Index of, const std::vector<Index>& vertices) {
      return [this, of, &vertices](Index i) {
        return of == kParticles ? of_particles_->radius_of(MeshElement::vertex, vertices[i]) : 0.0;
      };
    };
    const auto edges_a = boxes_near(sweep_a, first.edges, of_a.edges, box_b, kAll, radius(MeshElement::edge, a));
    meet_all(edges_a, boxes_near(sweep_b, second.edges, of_b.edges, box_a, kAll, radius(MeshElement::edge, b)),
             Kind::edge_edge, a, b, nullptr);
    if (!second.faces.empty()) {
      meet_all(boxes_near(sweep_a, of_a.singles, of_a.vertices, box_b, kAll, vertex_radius(a, first.vertices)),
               boxes_near(sweep_b, second.faces, of_b.faces, box_a, kAll, radius(MeshElement::face, b)),
               Kind::vertex_face, a, b, &first.vertices);
    }
    if (!first.faces.empty()) {
      meet_all(boxes_near(sweep_b, of_b.singles, of_b.vertices, box_a, kAll, vertex_radius(b, second.vertices)),
               boxes_near(sweep_a, first.faces, of_a.faces, box_b, kAll, radius(MeshElement::face, a)),
               Kind::vertex_face, b, a, &second.vertices);
    }
    // A particle in no edge meets the edges of wire frames. Those of faces are parts of the faces.
    if (a == kParticles && !first.points.empty()) {
      const auto bare = [&](Index e) { return second.bare[e] != 0; };
      meet_all(boxes_near(sweep_a, singles(first.points), {}, box_b, kAll, vertex_radius(a, first.points)),
               boxes_near(sweep_b, second.edges, of_b.edges, box_a, bare, kThin), Kind::point_edge, a, b,
               &first.points);
    }
  };
  broad_phase::for_each_pair(whole, [&](Index a, Index b) {
    if (can_move(a) || can_move(b)) between_surfaces(a, sweeps[a], whole[a], b, sweeps[b], whole[b]);
  });
  if (particles_.vertices.empty()) return pairs;
  std::vector<Vector3> starts, ends;
  for (Index p = 0; p < particles_.around.size(); ++p) {
    starts.push_back(position(*motions.x0, p));
    ends.push_back(position(*motions.x1, p));
  }
  Sweep particles(std::move(starts), std::move(ends));
  const MovingBox all = particles.box_of(particles_.vertices, of_particles_->largest_radius());
  for (Index b = 0; b < count; ++b) {
    if (!broad_phase::meet(all, whole[b])) continue;
    const std::size_t before = pairs.size();
    between_surfaces(kParticles, particles, all, b, sweeps[b], whole[b]);
    if (can_move(b)) continue;
    const auto is_still = [&](const BodyPair& pair) {
      const auto corner = corners(pair);
      for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
        if (corner[c].body == kParticles && moves_[corner[c].number]) return false;
      }
      return true;
    };
    pairs.erase(std::remove_if(pairs.begin() + static_cast<std::ptrdiff_t>(before), pairs.end(), is_still),
                pairs.end());
  }
  return pairs;
}

std::vector<BodyPair> BodyColliders::particle_candidates(const BodyMotions& motions,
                                                         const std::vector<char>& moved) const {
  std::vector<BodyPair> pairs;
  for (const Pair& pair : of_particles_->candidates(*motions.x0, *motions.x1, 0)) {
    const auto corners = of_particles_->corners(pair);
    const auto* const end = corners.begin() + corner_count(pair.kind);
    if (std::none_of(corners.begin(), end, [&](Index p) { return moved[p] != 0; })) continue;
    pairs.push_back({pair.kind, {kParticles, pair.i}, {kParticles, pair.j}});
  }
  return pairs;
}

std::string BodyColliders::describe(const BodyPair& pair) const {
  if (is_of_particles(pair)) return of_particles_->describe(particle_pair(pair));
  const auto c = corners(pair);
  const auto named = [](const geometry::Element& element, const OfBody* of) {
    const bool particle = of->body == kParticles && element.sort == MeshElement::vertex;
    std::string text(particle ? "particle" : name_of(element.sort));
    for (std::size_t i = 0; i < element.corners(); ++i) text += fmt::format("{}{}", i == 0 ? ' ' : '-', of[i].number);
    return of->body == kParticles ? text : text + fmt::format(" of body {}", of->body);
  };
  const auto& [first, second] = geometry::traits_of(pair.kind);
  return named(first, c.data()) + " and " + named(second, c.data() + first.corners());
}

Vector3 BodyColliders::at(const OfBody& corner, const BodyStates& states, const VectorX& x) const noexcept {
  if (corner.body == kParticles) return position(x, corner.number);
  return placed(states[corner.body].pose, bodies_->bodies()[corner.body].points[corner.number]);
}

}  // namespace touchstone::sim
