// SPDX-License-Identifier: MIT
#include "proofs/mesh_motion.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

#include <touchstone/curved.hpp>
#include <touchstone/solve.hpp>

#include "geometry/kind_traits.hpp"
#include "io/times.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/doubles/rounded_sum.hpp"
#include "proofs/body_box.hpp"
#include "proofs/proof_text.hpp"
#include "proofs/step_boxes.hpp"

namespace touchstone::proofs {
namespace {

RigidMotion motion_of(std::uint32_t body, const MotionFrame& start, const MotionFrame& end) {
  const MotionPose &from = start.poses[body], &to = end.poses[body];
  return {from.q, to.q, from.p, to.p};
}

void append_coordinate(std::string& to, double x) { to += x == 0 ? "0" : io::hexfloat(x); }

/// With the end of the line.
void append_point(std::string& to, const Vec3& point) {
  append_coordinate(to, point.x);
  to += ' ';
  append_coordinate(to, point.y);
  to += ' ';
  append_coordinate(to, point.z);
  to += '\n';
}

}  // namespace

std::vector<std::uint32_t> colliding_vertices(const std::vector<std::array<std::uint32_t, 2>>& edges,
                                              const std::vector<std::uint32_t>& loose_points) {
  std::vector<Index> vertices = loose_points;
  vertices.reserve(loose_points.size() + 2 * edges.size());
  for (const auto& edge : edges) vertices.insert(vertices.end(), edge.begin(), edge.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void add_body(MotionElements& to, std::uint32_t body, const std::vector<Vec3>& points,
              const std::vector<std::uint32_t>& collide, const std::vector<std::array<std::uint32_t, 2>>& edges,
              const std::vector<std::array<std::uint32_t, 3>>& faces) {
  const auto first = static_cast<Index>(to.vertex_count);
  to.vertex_count += points.size();
  for (const Vec3& point : points) to.on_bodies.push_back({body, point});
  for (const Index v : collide) to.points.push_back(first + v);
  for (const auto& [v, w] : edges) to.edges.push_back({first + v, first + w});
  for (const auto& [u, v, w] : faces) to.faces.push_back({first + u, first + v, first + w});
}

// Rounding to the nearest double keeps the order, and a and the sum's rounding s are doubles. So a < s implies a <= b +
// distance, and a > s the opposite. For a = s the error of the sum decides. Of the two terms let x be the one that is
// at least as large as y in absolute value; then s - x and y - (s - x) are exact (Dekker). A sum beyond the largest
// double is s = infinity, and more than a.
bool at_most_apart(double a, double b, double distance) noexcept {
  const double s = b + distance;
  if (a != s) return a < s;
  const auto [x, y] = std::fabs(b) < distance ? std::pair(distance, b) : std::pair(b, distance);
  return y - (s - x) >= 0;
}

StepProver::StepProver(MotionElements elements, const Separation& separation)
    : elements_(std::move(elements)), separation_(separation) {
  std::vector<std::array<Index, 2>> sides;
  for (const auto& face : elements_.faces) {
    for (std::size_t k = 0; k < 3; ++k) sides.push_back(side(face[k], face[(k + 1) % 3]));
  }
  std::sort(sides.begin(), sides.end());
  std::vector<char> in_edge(elements_.vertex_count, 0), in_wire(elements_.vertex_count, 0);
  for (Index e = 0; e < elements_.edges.size(); ++e) {
    const auto [v, w] = elements_.edges[e];
    in_edge[v] = in_edge[w] = 1;
    if (std::binary_search(sides.begin(), sides.end(), side(v, w))) continue;
    wires_.push_back(e);
    joined_.push_back(side(v, w));
    in_wire[v] = in_wire[w] = 1;
  }
  std::sort(joined_.begin(), joined_.end());
  for (auto& [v, w] : elements_.radii.near) std::tie(v, w) = std::pair(std::min(v, w), std::max(v, w));
  std::sort(elements_.radii.near.begin(), elements_.radii.near.end());
  for (Index i = 0; i < elements_.points.size(); ++i) {
    if (in_edge[elements_.points[i]] == 0) loose_.push_back(i);
    if (in_wire[elements_.points[i]] != 0) wire_ends_.push_back(i);
  }
}

bool StepProver::has_pair() const {
  const Rules rules(elements_);
  const SomePoints loose{elements_.points, loose_};
  const Cells<2> edges{elements_.edges};
  return rules.has_pair(edges, edges) || rules.has_pair(Points{elements_.points}, Cells<3>{elements_.faces}) ||
         rules.has_pair(loose, edges) || rules.has_pair(loose, loose) ||
         rules.has_pair(SomePoints{elements_.points, wire_ends_}, SomeEdges{elements_.edges, wires_}, Joined{joined_});
}

std::vector<MotionPair> StepProver::pairs(const MotionFrame& start, const MotionFrame& end, int threads) const {
  const numbers::DefaultFloatEnvironment environment;
  MotionFrame low, high;
  if (!elements_.on_bodies.empty()) {
    low = start;
    high = end;
    for (const BodyVertex& vertex : elements_.on_bodies) {
      const PointBox box = box_on_body(motion_of(vertex.body, start, end), vertex.point);
      low.push_back(box.low);
      high.push_back(box.high);
    }
  }
  const bool straight = elements_.on_bodies.empty();
  // Without radii, folds have the boxes of the file's separation.
  const auto separation = [&](const MotionPair& pair) {
    return elements_.radii.any() ? separation_of(pair).distance : separation_.distance;
  };
  const StepBoxes boxes(elements_, straight ? start : low, straight ? end : high, {largest_separation(), separation},
                        threads);
  const Points points{elements_.points};
  const SomePoints loose{elements_.points, loose_};
  const Cells<2> edges{elements_.edges};
  const Cells<3> faces{elements_.faces};
  const RestingTree edge_tree = boxes.tree(edges), loose_tree = boxes.tree(loose);
  std::vector<MotionPair> pairs;
  boxes.add_pairs(Kind::edge_edge, edges, edge_tree, edges, nullptr, pairs);
  if (faces.size() > 0) {
    const RestingTree point_tree = boxes.tree(points), face_tree = boxes.tree(faces);
    boxes.add_pairs(Kind::vertex_face, points, point_tree, faces, &face_tree, pairs);
  }
  boxes.add_pairs(Kind::point_edge, loose, loose_tree, edges, &edge_tree, pairs);
  boxes.add_pairs(Kind::point_point, loose, loose_tree, loose, nullptr, pairs);
  if (wires_.size() > 1) {
    const SomePoints ends{elements_.points, wire_ends_};
    const SomeEdges wires{elements_.edges, wires_};
    const RestingTree end_tree = boxes.tree(ends), wire_tree = boxes.tree(wires);
    boxes.add_pairs(Kind::point_edge, ends, end_tree, wires, &wire_tree, pairs, Joined{joined_});
  }
  return pairs;
}

std::array<std::uint32_t, 4> StepProver::corners_of(const MotionPair& pair) const noexcept {
  const auto number = [&](const geometry::Element& element, Index i) {
    return element.sort == MeshElement::vertex ? elements_.points[i] : i;
  };
  const auto& traits = geometry::traits_of(pair.kind);
  return geometry::pair_corners(pair.kind, number(traits.first, pair.first), number(traits.second, pair.second),
                                elements_.edges, elements_.faces);
}

Separation StepProver::separation_of(const MotionPair& pair) const noexcept {
  const bool is_fold = pair.kind == Kind::point_edge && !std::binary_search(loose_.begin(), loose_.end(), pair.first);
  const auto& touching = elements_.touching;
  if (is_fold || std::binary_search(touching.begin(), touching.end(), pair)) return {0, separation_.metric};
  const MotionRadii& radii = elements_.radii;
  if (!radii.any()) return separation_;
  if (are_near(pair)) return {};
  const auto radius = [&](const geometry::Element& element, Index i) {
    return (element.sort == MeshElement::vertex ? radii.points
            : element.sort == MeshElement::edge ? radii.edges
                                                : radii.faces)[i];
  };
  const auto& traits = geometry::traits_of(pair.kind);
  return {numbers::sum_rounded_up(radius(traits.first, pair.first), radius(traits.second, pair.second))};
}

bool StepProver::are_near(const MotionPair& pair) const noexcept {
  const auto& near = elements_.radii.near;
  if (near.empty()) return false;
  const auto corners = corners_of(pair);
  const std::size_t first = geometry::corners_of_first(pair.kind);
  for (std::size_t i = 0; i < first; ++i) {
    for (std::size_t j = first; j < corner_count(pair.kind); ++j) {
      if (std::binary_search(near.begin(), near.end(), side(corners[i], corners[j]))) return true;
    }
  }
  return false;
}

double StepProver::largest_separation() const noexcept {
  double largest = 0;
  for (const auto* radii : {&elements_.radii.points, &elements_.radii.edges, &elements_.radii.faces}) {
    for (const double radius : *radii) largest = std::max(largest, radius);
  }
  return std::max(separation_.distance, 2 * largest);
}

Query StepProver::query_of(const MotionPair& pair, const MotionFrame& start, const MotionFrame& end) const {
  Query query;
  query.kind = pair.kind;
  const auto corners = corners_of(pair);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    query.start[c] = start[corners[c]];
    query.end[c] = end[corners[c]];
  }
  return query;
}

CurvedQuery StepProver::curved_query_of(const MotionPair& pair, const MotionFrame& start,
                                        const MotionFrame& end) const {
  CurvedQuery query;
  query.kind = pair.kind;
  const auto corners = corners_of(pair);
  const std::size_t free = elements_.free_count();
  std::array<std::uint32_t, 4> bodies{};
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    if (corners[c] < free) {
      query.corners[c] = CurvedCorner::on_curve({start[corners[c]], end[corners[c]]});
      bodies[c] = ~std::uint32_t{0};
      continue;
    }
    // Corners of one body have one motion.
    const BodyVertex& vertex = elements_.on_bodies[corners[c] - free];
    bodies[c] = vertex.body;
    const auto first = std::find(bodies.begin(), bodies.end(), vertex.body) - bodies.begin();
    query.motions[static_cast<std::size_t>(first)] = motion_of(vertex.body, start, end);
    query.corners[c] = CurvedCorner::on_body(static_cast<int>(first), vertex.point);
  }
  return query;
}

bool StepProver::is_curved(const MotionPair& pair) const noexcept {
  const auto corners = corners_of(pair);
  return std::any_of(corners.begin(), corners.begin() + corner_count(pair.kind),
                     [&](Index v) { return v >= elements_.free_count(); });
}

Answer StepProver::append_proof(std::string& to, std::uint64_t number, const MotionPair& pair, const MotionFrame& start,
                                const MotionFrame& end) const {
  const auto append = [&](const auto& query) {
    const Separation separation = separation_of(pair);
    const Answer answer = solve(query, {.separation = separation});
    append_proof_of(to, number, query, answer, separation);
    return answer;
  };
  return is_curved(pair) ? append(curved_query_of(pair, start, end)) : append(query_of(pair, start, end));
}

std::string motion_head(const MotionElements& elements) {
  std::string text = "touchstone-motion 1\nvertices " + std::to_string(elements.vertex_count) + '\n';
  const auto add = [&](const char* sort, const auto& vertices) {
    text += sort;
    for (const Index vertex : vertices) text += ' ' + std::to_string(vertex);
    text += '\n';
  };
  double radius = 0;  // of the elements after the last line `radius`
  const auto add_all = [&](const char* sort, const auto& all, const std::vector<double>& radii) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!radii.empty() && radii[i] != radius) {
        radius = radii[i];
        text += "radius ";
        append_coordinate(text, radius);
        text += '\n';
      }
      if constexpr (std::is_same_v<decltype(all), const std::vector<Index>&>) {
        add(sort, std::array{all[i]});
      } else {
        add(sort, all[i]);
      }
    }
  };
  add_all("point", elements.points, elements.radii.points);
  add_all("edge", elements.edges, elements.radii.edges);
  add_all("face", elements.faces, elements.radii.faces);
  for (const auto& vertices : elements.radii.near) add("near", vertices);
  for (Index vertex = 0; vertex < elements.fixed.size(); ++vertex) {
    if (elements.fixed[vertex] != 0) add("fixed", std::array{vertex});
  }
  for (Index vertex = 0; vertex < elements.groups.of_vertices.size(); ++vertex) {
    const Index group = elements.groups.of_vertices[vertex];
    if (group != MotionGroups::kNone) add("group", std::array{vertex, group});
  }
  for (const auto& groups : elements.groups.ignored) add("ignore", groups);
  for (const auto& [kind, first, second] : elements.touching) {
    add(("touching " + std::string(name_of(kind))).c_str(), std::array{first, second});
  }
  for (std::size_t i = 0; i < elements.on_bodies.size(); ++i) {
    const BodyVertex& vertex = elements.on_bodies[i];
    text += "body " + std::to_string(elements.free_count() + i) + ' ' + std::to_string(vertex.body) + ' ';
    append_point(text, vertex.point);
  }
  return text;
}

void append_frame(std::string& to, const MotionFrame& frame) {
  to += "frame\n";
  for (const MotionPose& pose : frame.poses) {
    for (const double c : pose.q) {
      append_coordinate(to, c);
      to += ' ';
    }
    append_point(to, pose.p);
  }
  for (const Vec3& position : frame) append_point(to, position);
}

}  // namespace touchstone::proofs
