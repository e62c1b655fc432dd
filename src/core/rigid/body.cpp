// The checks of bodies, of their rules and of their motions.
// SPDX-License-Identifier: MIT
#include <touchstone/bodies.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "geometry/kind_traits.hpp"
#include "mesh/moving_vertices.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/doubles/rounded_sum.hpp"
#include "rigid/arc.hpp"
#include "rigid/body_data.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::rigid {
namespace {

std::string text(std::size_t number) { return std::to_string(number); }

/// "there are 12 bodies (0 to 11)".
std::string there_are(std::size_t count) {
  if (count == 0) return "there are no bodies";
  if (count == 1) return "there is 1 body, number 0";
  return "there are " + text(count) + " bodies (0 to " + text(count - 1) + ")";
}

TOUCHSTONE_BEHIND_GUARD void plant_tree(Body::Impl& body) {
  const Mesh::Impl& mesh = body.mesh.impl();
  const auto box_of = [&](Index n) {
    const mesh::Representative one = mesh::representative(mesh, n);
    Box box = broad_phase::empty_box();
    for (std::size_t i = 0; i < one.count(); ++i) broad_phase::extend(box, body.points[one.corners[i]]);
    return box;
  };
  const std::size_t count = mesh.stands_for.size();
  body.tree = broad_phase::BoxTree<Box>(count, box_of);
  if (body.tree.empty()) return;
  std::vector<Index> waiting{body.tree.root()};
  while (!waiting.empty()) {
    const Index n = waiting.back();
    waiting.pop_back();
    const auto& node = body.tree.node(n);
    if (n >= body.reaches.size()) body.reaches.resize(n + std::size_t{1});
    body.reaches[n] = reach_of(node.box);
    if (!node.is_leaf()) waiting.insert(waiting.end(), {node.first, node.second});
  }
  body.box = body.tree.node(body.tree.root()).box;
  body.reach = body.reaches[body.tree.root()];
  if (!mesh.radii.empty()) {
    for (const Index vertex : mesh.vertices) body.radius = std::max(body.radius, mesh.radii[vertex]);
  }
}

const Body::Impl& body_of(const Bodies& bodies, BodyIndex number) {
  if (number < bodies.bodies.size()) return bodies.bodies[number].impl();
  throw InvalidMesh("the pair names body " + text(number) + ", and " + there_are(bodies.bodies.size()));
}

std::size_t count_of(const Mesh::Impl& mesh, MeshElement sort) noexcept {
  return sort == MeshElement::vertex ? mesh.vertex_count
         : sort == MeshElement::edge ? mesh.edges.size()
                                     : mesh.faces.size();
}

const Mesh::Impl& check_element(const Bodies& bodies, const BodyElement& of, MeshElement sort) {
  const Mesh::Impl& mesh = body_of(bodies, of.body).mesh.impl();
  if (of.element < count_of(mesh, sort)) return mesh;
  throw InvalidMesh("the pair names " + std::string(name_of(sort)) + " " + text(of.element) + " of body " +
                    text(of.body) + ", which has " + text(count_of(mesh, sort)) + " of them");
}

void check_pair(const Bodies& bodies, const BodyPair& pair) {
  solver::validate_kind(pair.kind);
  const auto& [first, second] = geometry::traits_of(pair.kind);
  check_element(bodies, pair.first, first.sort);
  check_element(bodies, pair.second, second.sort);
}

/// The corners of an element that exists.
const Index* corners_of(const Bodies& bodies, MeshElement sort, const BodyElement& of) noexcept {
  const Mesh::Impl& mesh = bodies.bodies[of.body].impl().mesh.impl();
  return geometry::corners_of(sort, of.element, mesh.edges, mesh.faces);
}

std::vector<std::uint64_t> sorted(const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(pairs.size());
  for (const auto& pair : pairs) numbers.push_back(mesh::unordered(pair[0], pair[1]));
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

double radius_of(const Mesh::Impl& mesh, const Index* corners, std::size_t count) noexcept {
  double radius = 0;
  if (mesh.radii.empty()) return radius;
  for (std::size_t c = 0; c < count; ++c) radius = std::max(radius, mesh.radii[corners[c]]);
  return radius;
}

double separation_between(const Bodies& bodies, const BodyPair& pair) noexcept {
  const auto& [first, second] = geometry::traits_of(pair.kind);
  const auto radius = [&](const geometry::Element& element, const BodyElement& of) {
    return radius_of(bodies.bodies[of.body].impl().mesh.impl(), corners_of(bodies, element.sort, of),
                     element.corners());
  };
  const double radii = numbers::sum_rounded_up(radius(first, pair.first), radius(second, pair.second));
  return std::min(numbers::sum_rounded_up(bodies.separation.distance, radii), std::numeric_limits<double>::max());
}

CurvedQuery query_between(const Bodies& bodies, const BodyPair& pair,
                          const std::vector<RigidMotion>& motions) noexcept {
  CurvedQuery query;
  query.kind = pair.kind;
  query.motions[0] = motions[pair.first.body];
  query.motions[1] = motions[pair.second.body];
  std::size_t at = 0;
  const auto put = [&](const geometry::Element& element, const BodyElement& of, int motion) {
    const Index* const corners = corners_of(bodies, element.sort, of);
    for (std::size_t i = 0; i < element.corners(); ++i) {
      query.corners[at++] = CurvedCorner::on_body(motion, bodies.bodies[of.body].impl().points[corners[i]]);
    }
  };
  const auto& [first, second] = geometry::traits_of(pair.kind);
  put(first, pair.first, 0);
  put(second, pair.second, 1);
  return query;
}

CollidingBodies::CollidingBodies(const Bodies& bodies)
    : rules_(bodies.rules),
      count_(bodies.bodies.size()),
      body_pairs_(sorted(bodies.rules.body_pairs)),
      group_pairs_(sorted(bodies.rules.group_pairs)) {
  solver::validate(bodies.separation);
  if (count_ >= StandsFor::kNone) throw InvalidQuery("there are 2^32 - 1 bodies or more; there must be fewer");
  for (const auto& pair : rules_.body_pairs) {
    for (const BodyIndex body : pair) {
      if (body < count_) continue;
      throw InvalidQuery("the rules name body " + text(body) + ", and " + there_are(count_));
    }
    if (pair[0] == pair[1]) {
      throw InvalidQuery("the rules name the pair of body " + text(pair[0]) +
                         " with itself; a body is never asked about with itself");
    }
  }
  if (!rules_.groups.empty() && rules_.groups.size() != count_) {
    throw InvalidQuery("the rules have the groups of " + text(rules_.groups.size()) + " bodies, and " +
                       there_are(count_) + "; there must be one for each body, or none");
  }
  if (rules_.groups.empty() && !(rules_.group_pairs.empty() && rules_.group_rule == GroupRule::all_but_listed)) {
    throw InvalidQuery("the rules are about pairs of groups, and the bodies have no groups");
  }
}

bool CollidingBodies::may_collide(BodyIndex a, BodyIndex b) const noexcept {
  if (!rules_.groups.empty()) {
    const std::uint64_t pair = mesh::unordered(rules_.groups[a], rules_.groups[b]);
    const bool listed = std::binary_search(group_pairs_.begin(), group_pairs_.end(), pair);
    if (listed != (rules_.group_rule == GroupRule::only_listed)) return false;
  }
  return !std::binary_search(body_pairs_.begin(), body_pairs_.end(), mesh::unordered(a, b));
}

std::size_t CollidingBodies::excluded() const {
  if (rules_.groups.empty()) return body_pairs_.size();
  std::size_t excluded = 0;
  for (BodyIndex b = 1; b < count_; ++b) {
    for (BodyIndex a = 0; a < b; ++a) excluded += may_collide(a, b) ? 0 : 1;
  }
  return excluded;
}

void validate(const Bodies& bodies, const std::vector<RigidMotion>& motions, int threads, solver::OriginPath path) {
  threads::validate_threads(threads);
  if (motions.size() != bodies.bodies.size()) {
    throw InvalidQuery(text(motions.size()) + " motions do not fit: " + there_are(bodies.bodies.size()) +
                       ", and each needs one");
  }
  for (std::size_t b = 0; b < motions.size(); ++b) solver::validate(motions[b], "body " + text(b), path);
}

}  // namespace touchstone::rigid

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

const mesh::Pieces& Body::Impl::pieces() const {
  std::call_once(once_, [this] {
    at_rest_ = mesh::Motion(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) at_rest_[v] = {points[v], points[v]};
    pieces_ = std::make_unique<const mesh::Pieces>(mesh.impl(), at_rest_);
  });
  return *pieces_;
}

Body::Body() : Body(Mesh(), Positions()) {}

Body::Body(const Mesh& mesh, const Positions& points) {
  const numbers::DefaultFloatEnvironment environment;
  if (mesh.dimension() != 3) {
    throw InvalidMesh("the body's mesh is in the plane; a body needs a mesh in three dimensions");
  }
  auto impl = std::make_shared<Impl>();
  impl->mesh = mesh;
  const mesh::Motion at_rest = mesh::motion_of(mesh.impl(), points, points, 1);
  impl->points.reserve(at_rest.size());
  for (const mesh::MovingVertex& vertex : at_rest) impl->points.push_back(vertex.start);
  rigid::plant_tree(*impl);
  impl_ = std::move(impl);
}

const Mesh& Body::mesh() const noexcept { return impl_->mesh; }
const std::vector<Vec3>& Body::points() const noexcept { return impl_->points; }

Pose pose_of(const Vec3& position, const std::array<double, 4>& quaternion, QuaternionOrder order) {
  const auto& [a, b, c, d] = quaternion;
  if (order == QuaternionOrder::wxyz) return {quaternion, position};
  return {{d, a, b, c}, position};
}

RigidMotion motion_between(const Pose& start, const Pose& end, Turn turn) {
  const RigidMotion motion{start.orientation, end.orientation, start.position, end.position};
  return turn == Turn::shorter ? with_shorter_turn(motion) : motion;
}

CurvedQuery query_of(const Bodies& bodies, const BodyPair& pair, const std::vector<RigidMotion>& motions) {
  rigid::check_pair(bodies, pair);
  rigid::validate(bodies, motions, 1, solver::OriginPath::curved);
  return rigid::query_between(bodies, pair, motions);
}

Separation separation_of(const Bodies& bodies, const BodyPair& pair) {
  const numbers::DefaultFloatEnvironment environment;
  rigid::check_pair(bodies, pair);
  solver::validate(bodies.separation);
  return {rigid::separation_between(bodies, pair), bodies.separation.metric};
}

std::string describe(const Bodies& bodies, const BodyPair& pair) {
  rigid::check_pair(bodies, pair);
  const auto named = [&](const geometry::Element& element, const BodyElement& of) {
    std::string all = std::string(name_of(element.sort)) + " " + rigid::text(of.element);
    const MeshIndex* const corners = rigid::corners_of(bodies, element.sort, of);
    for (std::size_t i = 0; element.sort != MeshElement::vertex && i < element.corners(); ++i) {
      all.append(i == 0 ? " (" : "-").append(rigid::text(corners[i]));
    }
    if (element.sort != MeshElement::vertex) all.append(")");
    return all.append(" of body ").append(rigid::text(of.body));
  };
  const auto& [first, second] = geometry::traits_of(pair.kind);
  return named(first, pair.first) + " and " + named(second, pair.second);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
