// SPDX-License-Identifier: MIT
#include "mesh/group_relations/group_relations.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include <touchstone/error.hpp>

#include "geometry/union_find.hpp"
#include "mesh/candidates.hpp"
#include "mesh/group_relations/face_cuts.hpp"
#include "mesh/group_relations/point_beside.hpp"
#include "mesh/mesh_elements.hpp"
#include "mesh/moving_vertices.hpp"
#include "numbers/doubles/float_environment.hpp"

namespace touchstone::mesh {
namespace {

using broad_phase::Box;
using numbers::Exact;

/// What one group is made of.
struct Group {
  std::vector<Index> faces, wires, points;  ///< of the mesh; wires are edges in no face
  GroupFaces shape;
  Box box = broad_phase::empty_box();
  Index vertex = 0;  ///< one of its vertices
  bool is_solid = false;

  bool is_empty() const noexcept { return faces.empty() && wires.empty() && points.empty(); }
};

/// Where the surface of one group lies about another one's inside.
struct Flags {
  bool in = false, out = false;         ///< a piece is inside or outside
  bool same = false, opposite = false;  ///< a piece is on its surface, with the two insides on the same side of it or
                                        ///< on both

  /// Whether the groups can only overlap or cross: something is inside, and something else is not.
  bool is_partly_in() const noexcept { return in && (out || opposite); }
};

/// A face in the plane of another one.
struct FlushFace {
  ExactCorners shape;
  Box box;
  bool is_own;  ///< of the same group
};

std::array<Index, 2> in_order(Index a, Index b) noexcept { return {std::min(a, b), std::max(a, b)}; }

class Classifier {
 public:
  Classifier(const Mesh& mesh, const Positions& x, const std::vector<std::uint32_t>& groups, std::uint32_t count,
             const MeshOptions& options)
      : rules_(mesh.impl()), mesh_(without_rules(mesh)), options_(options), all_(count) {
    motion_ = motion_of(mesh_.impl(), x, x, 1);
    take_elements(groups, count);
    for (Group& group : all_) group.is_solid = is_solid(group);
    take_meetings(groups, count, intersections(mesh_, x, options));
  }

  GroupRelations relations() const {
    GroupRelations all;
    all.without_inside = static_cast<std::size_t>(std::count_if(
        all_.begin(), all_.end(), [](const Group& group) { return !group.is_empty() && !group.is_solid; }));
    all.pairs = classes();
    return all;
  }

 private:
  std::vector<GroupPair> classes() const {
    std::vector<GroupPair> found;
    std::vector<std::uint32_t> by_box;
    for (std::uint32_t p = 0; p < all_.size(); ++p) {
      if (!all_[p].is_empty()) by_box.push_back(p);
    }
    std::sort(by_box.begin(), by_box.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(all_[a].box.low[0], a) < std::pair(all_[b].box.low[0], b);
    });
    for (std::size_t i = 0; i < by_box.size(); ++i) {
      const Box& box = all_[by_box[i]].box;
      for (std::size_t j = i + 1; j < by_box.size() && all_[by_box[j]].box.low[0] <= box.high[0]; ++j) {
        const auto [a, b] = std::minmax(by_box[i], by_box[j]);
        if (!overlap(all_[a].box, all_[b].box)) continue;
        if (!corners_may_collide(rules_, std::array{all_[a].vertex}, std::array{all_[b].vertex})) continue;
        check_stop(options_.stop);
        const Relation sort = class_of(a, b);
        if (sort != Relation::clear) found.push_back({a, b, sort});
      }
    }
    std::sort(found.begin(), found.end(), [](const GroupPair& one, const GroupPair& two) {
      return std::pair(one.a, one.b) < std::pair(two.a, two.b);
    });
    return found;
  }

  static Mesh without_rules(const Mesh& mesh) {
    MeshElements elements = mesh.elements();
    elements.rules = {};
    return Mesh(std::move(elements));
  }

  Corners corners_of_face(Index f) const {
    const auto& [a, b, c] = mesh_.faces()[f];
    return {motion_[a].start, motion_[b].start, motion_[c].start};
  }

  void take_elements(const std::vector<std::uint32_t>& groups, std::uint32_t count) {
    const auto& faces = mesh_.faces();
    const auto& edges = mesh_.edges();
    std::map<std::array<Index, 2>, Index> numbers;
    for (Index e = 0; e < edges.size(); ++e) numbers.emplace(in_order(edges[e][0], edges[e][1]), e);
    faces_of_edge_.resize(edges.size());
    group_of_face_.resize(faces.size(), count);
    edges_of_face_.resize(faces.size());
    met_.resize(faces.size());
    const auto take = [&](Index vertex, std::vector<Index> Group::*list, Index number) {
      const std::uint32_t group = groups[vertex];
      if (group >= count) return;
      all_[group].vertex = vertex;
      (all_[group].*list).push_back(number);
    };
    const auto extend_box = [&](Index vertex) {
      if (groups[vertex] < count) broad_phase::extend(all_[groups[vertex]].box, motion_[vertex].start);
    };
    for (Index f = 0; f < faces.size(); ++f) {
      group_of_face_[f] = std::min(groups[faces[f][0]], count);
      take(faces[f][0], &Group::faces, f);
      if (group_of_face_[f] < count) all_[group_of_face_[f]].shape.add(corners_of_face(f));
      for (std::size_t i = 0; i < 3; ++i) {
        extend_box(faces[f][i]);
        edges_of_face_[f][i] = numbers.at(in_order(faces[f][i], faces[f][(i + 1) % 3]));
        faces_of_edge_[edges_of_face_[f][i]].push_back(f);
      }
    }
    for (Index e = 0; e < edges.size(); ++e) {
      if (!faces_of_edge_[e].empty()) continue;
      take(edges[e][0], &Group::wires, e);
      for (const Index end : edges[e]) extend_box(end);
    }
    for (const Index point : mesh_.points()) {
      take(point, &Group::points, point);
      extend_box(point);
    }
  }

  /// Closed and oriented faces, and nothing else, around a volume above 0.
  bool is_solid(const Group& group) const {
    if (group.faces.empty() || !group.wires.empty() || !group.points.empty()) return false;
    std::map<std::array<Index, 2>, int> passes;
    Exact volume;
    for (const Index f : group.faces) {
      const auto& corners = mesh_.faces()[f];
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = corners[i], b = corners[(i + 1) % 3];
        passes[in_order(a, b)] += a < b ? 1 : -1;
      }
      const ExactCorners x = exact(corners_of_face(f));
      volume = volume + geometry::dot(x[0], geometry::cross(x[1], x[2]));
    }
    return volume.sign() > 0 &&
           std::all_of(passes.begin(), passes.end(), [](const auto& edge) { return edge.second == 0; });
  }

  /// Faces that share points beyond common vertices and edges, and groups that share points.
  void take_meetings(const std::vector<std::uint32_t>& groups, std::uint32_t count,
                     const std::vector<Intersection>& found) {
    for (const Intersection& one : found) {
      if (one.sort == IntersectionSort::inside) continue;
      const auto group_of = [&](MeshElement element, Index number) {
        return groups[element == MeshElement::vertex ? number
                      : element == MeshElement::edge ? mesh_.edges()[number][0]
                                                     : mesh_.faces()[number][0]];
      };
      const std::uint32_t a = group_of(one.first_element, one.first), b = group_of(one.second_element, one.second);
      if (a >= count || b >= count) continue;
      if (a != b) {
        bool& pierces = meeting_[{std::min(a, b), std::max(a, b)}];
        pierces = pierces || one.sort == IntersectionSort::pierces;
      }
      if (one.second_element != MeshElement::face) continue;
      const Index face = one.second;
      if (one.first_element == MeshElement::vertex) {
        met_by_point_[one.first].push_back(face);
        continue;
      }
      const std::vector<Index>& beside = faces_of_edge_[one.first];
      if (beside.empty()) met_by_wire_[one.first].push_back(face);
      for (const Index other : beside) {
        if (other == face) continue;
        met_[other].push_back(face);
        met_[face].push_back(other);
      }
    }
    for (auto& met : met_) {
      std::sort(met.begin(), met.end());
      met.erase(std::unique(met.begin(), met.end()), met.end());
    }
  }

  /// The faces among those met that are of one of two groups.
  std::vector<Index> of_groups(const std::vector<Index>& met, std::uint32_t a, std::uint32_t b) const {
    std::vector<Index> some;
    for (const Index f : met) {
      if (group_of_face_[f] == a || group_of_face_[f] == b) some.push_back(f);
    }
    return some;
  }

  std::vector<ExactCorners> shapes_of(const std::vector<Index>& faces) const {
    std::vector<ExactCorners> shapes;
    for (const Index f : faces) shapes.push_back(exact(corners_of_face(f)));
    return shapes;
  }

  /// Where the faces, wires and points of group a lie about the solid b.
  Flags flags_of(std::uint32_t a, std::uint32_t b) const {
    Flags flags;
    const auto add_bare = [&](const Vec3& p, const Vec3& q, const std::vector<Index>& met) {
      const std::vector<ExactCorners> shapes = shapes_of(of_groups(met, b, b));
      for (const RationalPoint& middle : middles_between(exact(p), exact(q), shapes)) {
        const bool on =
            std::any_of(shapes.begin(), shapes.end(), [&](const auto& face) { return is_on(middle, face); });
        if (on) continue;
        (winding_number(all_[b].shape, {middle, {}, {}}, box_around(middle)) > 0 ? flags.in : flags.out) = true;
      }
    };
    std::vector<Index> apart;  // faces that meet none of both groups: their surface lies as one of them does
    for (const Index f : all_[a].faces) {
      check_stop(options_.stop);
      const std::vector<Index> met = of_groups(met_[f], a, b);
      const Corners corners = corners_of_face(f);
      if (!all_[a].is_solid && is_zero(normal_of(exact(corners)))) {  // without an area it is its edges
        for (std::size_t i = 0; i < 3; ++i) add_bare(corners[i], corners[(i + 1) % 3], met);
      } else if (met.empty()) {
        apart.push_back(f);
      } else if (!flags.is_partly_in()) {
        add_face(f, met, a, b, flags);
      }
    }
    for (const Index f : one_of_each_surface(apart)) {
      if (flags.is_partly_in()) break;
      check_stop(options_.stop);
      add_cell(point_in(exact(corners_of_face(f))), {}, a, b, flags);
    }
    const auto met_by = [](const std::map<Index, std::vector<Index>>& all, Index number) {
      const auto found = all.find(number);
      return found == all.end() ? std::vector<Index>() : found->second;
    };
    for (const Index e : all_[a].wires) {
      const auto [p, q] = mesh_.edges()[e];
      add_bare(motion_[p].start, motion_[q].start, met_by(met_by_wire_, e));
    }
    for (const Index p : all_[a].points) {
      add_bare(motion_[p].start, motion_[p].start, met_by(met_by_point_, p));
    }
    return flags;
  }

  void add_face(Index f, const std::vector<Index>& met, std::uint32_t a, std::uint32_t b, Flags& flags) const {
    const ExactCorners face = exact(corners_of_face(f));
    const ExactPoint normal = normal_of(face);
    if (is_zero(normal)) return;  // it has no area, and bounds nothing
    const std::vector<ExactCorners> shapes = shapes_of(met);
    std::vector<FlushFace> flush;
    for (std::size_t i = 0; i < met.size(); ++i) {
      const auto in_plane = [&](const ExactPoint& x) { return geometry::dot(normal, x - face[0]).is_zero(); };
      if (!std::all_of(shapes[i].begin(), shapes[i].end(), in_plane)) continue;
      Box box = broad_phase::empty_box();
      for (const Vec3& corner : corners_of_face(met[i])) broad_phase::extend(box, corner);
      flush.push_back({shapes[i], box, group_of_face_[met[i]] == a});
    }
    for_each_cell(face, shapes, [&](const PointBeside& beside) {
      add_cell(beside, flush, a, b, flags);
      return !flags.is_partly_in();
    });
  }

  /// A point above a face of group a, and the one below it. @param flush  the other faces of both groups in its plane
  void add_cell(const PointBeside& beside, const std::vector<FlushFace>& flush, std::uint32_t a, std::uint32_t b,
                Flags& flags) const {
    const Group &own = all_[a], &other = all_[b];
    const Box box = box_around(beside.point);
    int own_step = 1, other_step = 0;  // of the winding numbers, from above the face to below it
    for (const FlushFace& face : flush) {
      if (overlap(face.box, box)) (face.is_own ? own_step : other_step) += covers(face.shape, beside);
    }
    const int around = winding_number(other.shape, beside, box);
    const bool above = around > 0, below = around + other_step > 0;
    if (!own.is_solid) {
      (above != below ? flags.same : above ? flags.in : flags.out) = true;
      return;
    }
    const int own_around = winding_number(own.shape, beside, box);
    const bool own_above = own_around > 0, own_below = own_around + own_step > 0;
    if (own_above == own_below) return;  // a surface within its own solid bounds nothing
    (above != below ? (own_above == above ? flags.same : flags.opposite) : above ? flags.in : flags.out) = true;
  }

  /// Of faces that nothing else meets, one of each set that edges of two faces, with one direction each, connect: on
  /// both sides of such an edge the winding numbers are the same.
  std::vector<Index> one_of_each_surface(const std::vector<Index>& faces) const {  // in ascending order
    std::vector<std::array<Index, 2>> neighbours;
    geometry::UnionFind sets(faces.size());
    std::vector<char> has_area(faces.size(), 0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      has_area[i] = is_zero(normal_of(exact(corners_of_face(faces[i])))) ? 0 : 1;
      for (const Index e : edges_of_face_[faces[i]]) {
        const std::vector<Index>& beside = faces_of_edge_[e];
        if (beside.size() != 2 || beside[0] != faces[i]) continue;
        const auto other = std::lower_bound(faces.begin(), faces.end(), beside[1]);
        if (other == faces.end() || *other != beside[1]) continue;
        const auto j = static_cast<std::size_t>(other - faces.begin());
        neighbours.push_back({static_cast<Index>(i), static_cast<Index>(j)});
      }
    }
    for (const auto& [one, two] : neighbours) {
      if (has_area[one] != 0 && has_area[two] != 0) sets.join(one, two);
    }
    std::vector<Index> some;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (has_area[i] != 0 && sets.root(static_cast<Index>(i)) == i) some.push_back(faces[i]);
    }
    return some;
  }

  Relation class_of(std::uint32_t a, std::uint32_t b) const {
    const auto meeting = meeting_.find({a, b});
    const bool meet = meeting != meeting_.end();
    const Relation apart = meet ? Relation::touching : Relation::clear;
    if (!all_[a].is_solid && !all_[b].is_solid) return meet && meeting->second ? Relation::crossing : apart;
    if (!all_[a].is_solid || !all_[b].is_solid) {
      const bool first_is_solid = all_[a].is_solid;
      const Flags flags = first_is_solid ? flags_of(b, a) : flags_of(a, b);
      if (!flags.in) return apart;
      if (flags.out) return Relation::crossing;
      return first_is_solid ? Relation::around : Relation::inside;
    }
    const Flags one = flags_of(a, b);
    if (one.is_partly_in()) return Relation::overlapping;
    const Flags two = flags_of(b, a);
    if (!one.in && !one.same && !two.in && !two.same) return apart;
    const bool is_inside = !one.out && !one.opposite && !two.in, is_around = !two.out && !two.opposite && !one.in;
    if (is_inside && is_around) return Relation::same;
    if (is_inside) return Relation::inside;
    return is_around ? Relation::around : Relation::overlapping;
  }

  const Mesh::Impl& rules_;
  Mesh mesh_;  // without rules: a group may meet itself
  const MeshOptions& options_;
  Motion motion_;
  std::vector<Group> all_;
  std::vector<std::uint32_t> group_of_face_;
  std::vector<std::array<Index, 3>> edges_of_face_;
  std::vector<std::vector<Index>> faces_of_edge_, met_;  // by edge; by face: those that share points with it
  std::map<Index, std::vector<Index>> met_by_wire_, met_by_point_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> meeting_;  // groups that share points; whether one pierces
};

}  // namespace

std::string_view name_of(Relation sort) noexcept {
  constexpr std::string_view kNames[kRelations] = {"clear",  "touching", "overlapping", "inside",
                                                   "around", "same",     "crossing"};
  return kNames[static_cast<std::size_t>(sort)];
}

GroupRelations group_relations(const Mesh& mesh, const Positions& x, const std::vector<std::uint32_t>& groups,
                               std::uint32_t count, const MeshOptions& options) {
  if (mesh.dimension() != 3)
    throw InvalidQuery("classes of groups are those of solids in space; the mesh is in the plane");
  if (groups.size() != mesh.vertex_count()) throw InvalidQuery("the groups must be those of all vertices");
  const numbers::DefaultFloatEnvironment environment;
  return Classifier(mesh, x, groups, count, options).relations();
}

}  // namespace touchstone::mesh
