// The checks of a mesh, once for all questions.
// SPDX-License-Identifier: MIT
#include <touchstone/mesh.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include <touchstone/error.hpp>

#include "geometry/kind_traits.hpp"
#include "mesh/mesh_elements.hpp"
#include "mesh/pair_distance.hpp"
#include "numbers/doubles/decimal_text.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/validate.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

using mesh::Index;

std::string text(std::size_t number) { return std::to_string(number); }

/// "8000 vertices (0 to 7999)", "no vertex".
std::string counted(std::size_t count, const char* one, const char* many) {
  if (count == 0) return std::string("no ") + one;
  if (count == 1) return std::string("1 ") + one + " (number 0)";
  return text(count) + " " + many + " (0 to " + text(count - 1) + ")";
}

void check_index(const std::string& who, std::size_t index, std::size_t count, const char* one, const char* many) {
  if (index < count) return;
  throw InvalidMesh(who + " names " + one + " " + text(index) + ", and the mesh has " + counted(count, one, many));
}

template <std::size_t N>
void check_corners(const char* name, std::size_t number, const std::array<Index, N>& corners, std::size_t count) {
  const std::string who = std::string(name) + " " + text(number);
  for (std::size_t i = 0; i < N; ++i) {
    check_index(who, corners[i], count, "vertex", "vertices");
    for (std::size_t j = 0; j < i; ++j) {
      if (corners[i] != corners[j]) continue;
      throw InvalidMesh(who + " names vertex " + text(corners[i]) + " twice; its corners must be " + text(N) +
                        " different vertices");
    }
  }
}

/// The corners in ascending order, and the element's number.
template <std::size_t N>
struct Sorted {
  std::array<Index, N> corners;
  Index number;
  bool operator<(const Sorted& other) const {
    return corners != other.corners ? corners < other.corners : number < other.number;
  }
};

template <std::size_t N>
void check_duplicates(const char* name, const std::vector<std::array<Index, N>>& elements) {
  std::vector<Sorted<N>> sorted(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    sorted[i] = {elements[i], static_cast<Index>(i)};
    std::sort(sorted[i].corners.begin(), sorted[i].corners.end());
  }
  std::sort(sorted.begin(), sorted.end());
  const Sorted<N>* worst = nullptr;  // the one that comes first in the list of elements
  Index earlier = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].corners != sorted[i - 1].corners || (worst != nullptr && worst->number < sorted[i].number)) continue;
    worst = &sorted[i];
    earlier = sorted[i - 1].number;
  }
  if (worst == nullptr) return;
  std::string corners;
  for (const Index corner : worst->corners) corners.append(corners.empty() ? "" : " ").append(text(corner));
  throw InvalidMesh(std::string(name) + " " + text(worst->number) + " has the same corners as " + name + " " +
                    text(earlier) + ": vertices " + corners + "; each " + name + " may be given once");
}

using Edge = std::array<Index, 2>;

Edge in_order(Edge edge) noexcept { return edge[0] < edge[1] ? edge : Edge{edge[1], edge[0]}; }

/// An edge of a face.
struct Side {
  Edge edge;
  Index face;
  bool operator<(const Side& other) const { return edge != other.edge ? edge < other.edge : face < other.face; }
};

/// The edges of the faces, each once, in ascending order: as a side of the least face that has it.
std::vector<Side> sides_of(const std::vector<std::array<Index, 3>>& faces) {
  std::vector<Side> sides;
  sides.reserve(3 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides.push_back({in_order({faces[f][i], faces[f][(i + 1) % 3]}), static_cast<Index>(f)});
    }
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge == b.edge; }),
              sides.end());
  return sides;
}

/// Adds the edges of the faces to those given, lists the edges that are in no face, and finds which edges the faces
/// stand for.
void complete_edges(Mesh::Impl& mesh) {
  std::vector<Side> sides = sides_of(mesh.faces);
  constexpr Index kDone = StandsFor::kNone;
  mesh.stands_for.resize(mesh.faces.size());
  const auto number = [&](Side& side, std::size_t edge) {
    const auto& face = mesh.faces[side.face];
    std::size_t i = 0;
    while (in_order({face[i], face[(i + 1) % 3]}) != side.edge) ++i;
    mesh.stands_for[side.face].edges[i] = static_cast<Index>(edge);
    side.face = kDone;
  };
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Edge edge = in_order(mesh.edges[e]);
    const auto found = std::lower_bound(sides.begin(), sides.end(), edge,
                                        [](const Side& side, const Edge& other) { return side.edge < other; });
    if (found != sides.end() && found->edge == edge) {
      number(*found, e);
    } else if (mesh.dimension == 3) {
      mesh.wires.push_back(static_cast<Index>(e));
    }
  }
  const auto missing = std::count_if(sides.begin(), sides.end(), [](const Side& side) { return side.face != kDone; });
  mesh.edges.reserve(mesh.edges.size() + static_cast<std::size_t>(missing));
  for (Side& side : sides) {
    if (side.face == kDone) continue;
    mesh.edges.push_back(side.edge);
    number(side, mesh.edges.size() - 1);
  }
  mesh.edges.shrink_to_fit();
  mesh.wires.shrink_to_fit();
}

/// Completes the representatives: the faces know their edges already.
void find_representatives(Mesh::Impl& mesh) {
  mesh.stands_for.reserve(mesh::representative_count(mesh));  // or it may take twice as much
  mesh.stands_for.resize(mesh::representative_count(mesh));
  std::vector<char> seen(mesh.vertex_count, 0);
  for (Index n = 0; n < mesh.stands_for.size(); ++n) {
    const mesh::Representative representative = mesh::representative(mesh, n);
    StandsFor& stands_for = mesh.stands_for[n];
    if (representative.sort == MeshElement::edge) stands_for.edges[0] = representative.number;
    for (std::size_t i = 0; i < representative.count(); ++i) {
      if (std::exchange(seen[representative.corners[i]], 1) == 0) {
        stands_for.vertices |= static_cast<std::uint8_t>(1u << i);
      }
    }
  }
}

/// Lists the pairs of vertices that a wire joins. One wire alone is beside no other.
void find_joined(Mesh::Impl& mesh) {
  if (mesh.wires.size() < 2) return;
  mesh.joined.reserve(mesh.wires.size());
  for (const Index wire : mesh.wires) mesh.joined.push_back(mesh::unordered(mesh.edges[wire][0], mesh.edges[wire][1]));
  std::sort(mesh.joined.begin(), mesh.joined.end());
}

void find_points(Mesh::Impl& mesh, const std::optional<std::vector<Index>>& given) {
  constexpr Index kNone = std::numeric_limits<Index>::max();
  std::vector<Index> edge_of(mesh.vertex_count, kNone);
  for (std::size_t e = mesh.edges.size(); e-- > 0;) {
    for (const Index vertex : mesh.edges[e]) edge_of[vertex] = static_cast<Index>(e);
  }
  if (!given) {
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
      if (edge_of[v] == kNone) mesh.points.push_back(static_cast<Index>(v));
    }
  } else {
    std::vector<char> is_point(mesh.vertex_count, 0);
    for (std::size_t p = 0; p < given->size(); ++p) {
      const Index vertex = (*given)[p];
      const std::string who = "loose point " + text(p);
      check_index(who, vertex, mesh.vertex_count, "vertex", "vertices");
      if (edge_of[vertex] != kNone) {
        throw InvalidMesh(who + " is vertex " + text(vertex) + ", which is a corner of edge " + text(edge_of[vertex]) +
                          "; a loose point is in no edge");
      }
      if (is_point[vertex] != 0) {
        throw InvalidMesh(who + " is vertex " + text(vertex) + " again; each loose point may be given once");
      }
      is_point[vertex] = 1;
    }
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
      if (is_point[v] != 0) mesh.points.push_back(static_cast<Index>(v));
    }
  }
  mesh.points.shrink_to_fit();
  std::size_t in_edges = 0;
  for (const Index edge : edge_of) in_edges += edge != kNone ? 1 : 0;
  mesh.vertices.reserve(in_edges + mesh.points.size());
  auto point = mesh.points.begin();
  for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
    const bool is_point = point != mesh.points.end() && *point == v;
    if (is_point) ++point;
    if (is_point || edge_of[v] != kNone) mesh.vertices.push_back(static_cast<Index>(v));
  }
}

constexpr double kGreatestRadius = std::numeric_limits<double>::max() / 4;  // sums and boxes stay finite

void check_radii(const Mesh::Impl& mesh) {
  solver::validate(mesh.separation);
  if (mesh.radii.empty()) return;
  if (mesh.radii.size() != mesh.vertex_count) {
    throw InvalidMesh("there are " + text(mesh.radii.size()) + " radii, and the mesh has " +
                      counted(mesh.vertex_count, "vertex", "vertices") + "; give one radius for each vertex, or none");
  }
  if (mesh.separation.distance != 0) {
    throw InvalidMesh("there is both a separation for all pairs and a radius for each vertex; give one of them");
  }
  for (std::size_t v = 0; v < mesh.radii.size(); ++v) {
    if (mesh.radii[v] >= 0 && mesh.radii[v] <= kGreatestRadius) continue;
    throw InvalidMesh("vertex " + text(v) + " has the radius " + numbers::decimal_text(mesh.radii[v]) +
                      "; a radius must be finite, not negative, and at most a quarter of the greatest double");
  }
}

/// @throws InvalidMesh  for an element that does not exist
void check_pair(const Mesh::Impl& mesh, const std::string& who, const MeshPair& pair) {
  solver::validate_kind(pair.kind);
  const auto check = [&](MeshElement sort, Index i) {
    if (sort == MeshElement::vertex) check_index(who, i, mesh.vertex_count, "vertex", "vertices");
    if (sort == MeshElement::edge) check_index(who, i, mesh.edges.size(), "edge", "edges");
    if (sort == MeshElement::face) check_index(who, i, mesh.faces.size(), "face", "faces");
  };
  check(geometry::traits_of(pair.kind).first.sort, pair.first);
  check(geometry::traits_of(pair.kind).second.sort, pair.second);
}

void take_pair_separations(Mesh::Impl& mesh, std::vector<PairSeparation> separations) {
  for (std::size_t i = 0; i < separations.size(); ++i) {
    check_pair(mesh, "pair separation " + text(i), separations[i].pair);
    if (separations[i].distance >= 0 && separations[i].distance <= kGreatestRadius) continue;
    throw InvalidMesh("pair separation " + text(i) + " is " + numbers::decimal_text(separations[i].distance) +
                      "; it must be finite, not negative, and at most a quarter of the greatest double");
  }
  for (PairSeparation& separation : separations) separation.pair = mesh::in_order(separation.pair);
  std::stable_sort(separations.begin(), separations.end(),
                   [](const PairSeparation& a, const PairSeparation& b) { return a.pair < b.pair; });
  for (std::size_t i = 1; i < separations.size(); ++i) {
    const MeshPair& pair = separations[i].pair;
    if (pair != separations[i - 1].pair) continue;
    throw InvalidMesh("two pair separations are about one pair, " + std::string(name_of(pair.kind)) + " " +
                      text(pair.first) + " and " + text(pair.second) + "; each pair may be given once");
  }
  mesh.pair_separations = std::move(separations);
}

std::vector<std::uint64_t> sorted_pairs(const std::vector<std::array<Index, 2>>& pairs) {
  std::vector<std::uint64_t> sorted;
  sorted.reserve(pairs.size());
  for (const auto& [a, b] : pairs) sorted.push_back(mesh::unordered(a, b));
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

void take_rules(Mesh::Impl& mesh, CollisionRules rules) {
  for (std::size_t i = 0; i < rules.vertex_pairs.size(); ++i) {
    for (const Index v : rules.vertex_pairs[i]) {
      check_index("vertex pair " + text(i) + " of the rules", v, mesh.vertex_count, "vertex", "vertices");
    }
  }
  for (std::size_t i = 0; i < rules.element_pairs.size(); ++i) {
    check_pair(mesh, "element pair " + text(i) + " of the rules", rules.element_pairs[i]);
  }
  if (!rules.groups.empty() && rules.groups.size() != mesh.vertex_count) {
    throw InvalidMesh("there are " + text(rules.groups.size()) + " groups of vertices, and the mesh has " +
                      counted(mesh.vertex_count, "vertex", "vertices") + "; give one group for each vertex, or none");
  }
  if (rules.groups.empty() && (!rules.group_pairs.empty() || rules.group_rule != GroupRule::all_but_listed)) {
    throw InvalidMesh("there are rules about groups, and no vertex has a group; give one group for each vertex");
  }
  if (rules.group_rule > GroupRule::only_listed) {
    throw InvalidMesh("the rule of groups is " + text(static_cast<std::size_t>(rules.group_rule)) +
                      "; it must be 0 or 1: all_but_listed or only_listed");
  }
  mesh.vertex_pairs = sorted_pairs(rules.vertex_pairs);
  mesh.group_pairs = sorted_pairs(rules.group_pairs);
  mesh.groups = std::move(rules.groups);
  mesh.group_rule = rules.group_rule;
  for (const MeshPair& pair : rules.element_pairs) mesh.element_pairs.push_back(mesh::in_order(pair));
  std::sort(mesh.element_pairs.begin(), mesh.element_pairs.end());
}

}  // namespace

Mesh::Mesh() : impl_(std::make_shared<const Impl>()) {}

Mesh::Mesh(MeshElements elements) {
  const numbers::DefaultFloatEnvironment environment;
  auto impl = std::make_shared<Impl>();
  constexpr std::size_t kMost = std::numeric_limits<Index>::max();
  if (elements.dimension != 2 && elements.dimension != 3) {
    throw InvalidMesh("the dimension is " + std::to_string(elements.dimension) + "; it must be 2 or 3");
  }
  if (elements.dimension == 2 && !elements.faces.empty()) {
    throw InvalidMesh("a mesh in two dimensions has edges and loose points only, and there are " +
                      text(elements.faces.size()) + " faces; give their edges, or the dimension 3");
  }
  for (const auto& [name, count] :
       {std::pair{"vertices", elements.vertex_count}, std::pair{"faces", elements.faces.size()},
        std::pair{"edges", elements.edges.size() + 3 * elements.faces.size()},
        std::pair{"faces, edges and vertices in all",
                  elements.faces.size() + elements.edges.size() + elements.vertex_count}}) {
    if (count < kMost) continue;
    throw InvalidMesh("there are " + text(count) + " " + name + "; there must be fewer than " + text(kMost));
  }
  impl->vertex_count = elements.vertex_count;
  impl->dimension = elements.dimension;
  impl->faces = std::move(elements.faces);
  impl->edges = std::move(elements.edges);
  for (std::size_t i = 0; i < impl->faces.size(); ++i) check_corners("face", i, impl->faces[i], impl->vertex_count);
  for (std::size_t i = 0; i < impl->edges.size(); ++i) check_corners("edge", i, impl->edges[i], impl->vertex_count);
  check_duplicates("face", impl->faces);
  check_duplicates("edge", impl->edges);
  complete_edges(*impl);
  find_joined(*impl);
  find_points(*impl, elements.points);
  find_representatives(*impl);
  impl->separation = elements.separation;
  impl->radii = std::move(elements.radii);
  check_radii(*impl);
  take_rules(*impl, std::move(elements.rules));
  take_pair_separations(*impl, std::move(elements.pair_separations));
  impl_ = std::move(impl);
}

std::size_t Mesh::vertex_count() const noexcept { return impl_->vertex_count; }
int Mesh::dimension() const noexcept { return impl_->dimension; }
const std::vector<std::array<MeshIndex, 3>>& Mesh::faces() const noexcept { return impl_->faces; }
const std::vector<std::array<MeshIndex, 2>>& Mesh::edges() const noexcept { return impl_->edges; }
const std::vector<MeshIndex>& Mesh::points() const noexcept { return impl_->points; }
Metric Mesh::metric() const noexcept { return impl_->separation.metric; }

bool Mesh::may_collide(const MeshPair& pair) const {
  check_pair(*impl_, "the pair", pair);
  const bool in_space = impl_->dimension == 3;
  switch (pair.kind) {
    case Kind::edge_edge:
      if (!in_space) return false;
      break;
    case Kind::vertex_face:
      if (!mesh::is_in(impl_->vertices, pair.first)) return false;
      break;
    case Kind::point_edge:
      if (!mesh::is_in(impl_->vertices, pair.first)) return false;
      if (!in_space) break;
      if (!mesh::is_in(impl_->wires, pair.second)) return false;
      if (!mesh::is_in(impl_->points, pair.first) && !mesh::is_beside(*impl_, pair.first, impl_->edges[pair.second]))
        return false;
      break;
    case Kind::point_point:
      if (!mesh::is_in(impl_->points, pair.first) || !mesh::is_in(impl_->points, pair.second)) return false;
      break;
  }
  return mesh::rules_allow(*impl_, pair);
}

MeshElements Mesh::elements() const {
  const auto unpacked = [](const std::vector<std::uint64_t>& pairs) {
    std::vector<std::array<MeshIndex, 2>> vertices;
    for (const std::uint64_t pair : pairs) {
      vertices.push_back({static_cast<MeshIndex>(pair >> 32), static_cast<MeshIndex>(pair)});
    }
    return vertices;
  };
  MeshElements made;
  made.vertex_count = impl_->vertex_count;
  made.faces = impl_->faces;
  made.edges = impl_->edges;
  made.points = impl_->points;
  made.dimension = impl_->dimension;
  made.rules = {unpacked(impl_->vertex_pairs), impl_->element_pairs, impl_->groups, impl_->group_rule,
                unpacked(impl_->group_pairs)};
  made.separation = impl_->separation;
  made.radii = impl_->radii;
  made.pair_separations = impl_->pair_separations;
  return made;
}

bool Mesh::has_pairs() const {
  const Impl& mesh = *impl_;
  // A face with its edges makes no pair.
  if (mesh.points.size() + mesh.edges.size() <= (mesh.faces.empty() ? 1u : 3u)) return false;
  if (mesh.groups.empty()) return true;
  std::map<MeshIndex, std::size_t> sizes;  // of the groups
  for (const MeshIndex vertex : mesh.vertices) ++sizes[mesh.groups[vertex]];
  const auto size_of = [&](std::uint64_t group) {
    const auto found = sizes.find(static_cast<MeshIndex>(group));
    return found == sizes.end() ? std::size_t{0} : found->second;
  };
  const auto listed =
      static_cast<std::size_t>(std::count_if(mesh.group_pairs.begin(), mesh.group_pairs.end(), [&](std::uint64_t pair) {
        const std::uint64_t a = pair >> 32, b = pair & 0xFFFFFFFFu;
        return a == b ? size_of(a) > 1 : size_of(a) > 0 && size_of(b) > 0;
      }));
  if (mesh.group_rule == GroupRule::only_listed) return listed > 0;
  std::size_t all = sizes.size() * (sizes.size() - 1) / 2;
  for (const auto& [group, size] : sizes) all += size > 1 ? 1 : 0;
  return listed < all;
}

Separation Mesh::separation(const MeshPair& pair) const {
  const numbers::DefaultFloatEnvironment environment;
  check_pair(*impl_, "the pair", pair);
  return {mesh::separation_of(*impl_, pair, mesh::corners_of(*impl_, pair)), impl_->separation.metric};
}

std::array<MeshIndex, 4> Mesh::corners(const MeshPair& pair) const {
  check_pair(*impl_, "the pair", pair);
  return mesh::corners_of(*impl_, pair);
}

std::string Mesh::describe(const MeshPair& pair) const {
  const auto c = corners(pair);
  const auto named = [&](const geometry::Element& element, MeshIndex number, std::size_t first) {
    std::string all = std::string(name_of(element.sort)) + " " + text(number);
    if (element.sort == MeshElement::vertex) return all;
    for (std::size_t i = 0; i < element.corners(); ++i) all.append(i == 0 ? " (" : "-").append(text(c[first + i]));
    return all.append(")");
  };
  const auto& traits = geometry::traits_of(pair.kind);
  return named(traits.first, pair.first, 0) + " and " + named(traits.second, pair.second, traits.first.corners());
}

template <>
Names names_of<IntersectionSort>() noexcept {
  static constexpr std::string_view kNames[] = {"touches", "pierces", "folds", "inside"};
  return kNames;
}

std::string_view intersection_verb(IntersectionSort sort) noexcept {
  switch (sort) {
    case IntersectionSort::folds: return "folds onto";
    case IntersectionSort::inside: return "is inside the closed surface of";
    default: return name_of(sort);
  }
}

template <>
Names names_of<StepOutcome>() noexcept {
  static constexpr std::string_view kNames[] = {"whole", "shortened", "no-room", "contact-at-start",
                                                "intersects-at-start"};
  return kNames;
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
