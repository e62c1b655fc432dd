// Intersections at rest, as contacts in motion: the points of an edge are the places of a vertex that moves from its
// first corner to its second one, at the time that is the fraction of the edge. So the solver decides them, exactly.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include <touchstone/mesh.hpp>
#include <touchstone/solve.hpp>

#include "mesh/candidates.hpp"
#include "mesh/contacts.hpp"
#include "mesh/folds.hpp"
#include "mesh/inside_surfaces/inside.hpp"
#include "mesh/intersections.hpp"
#include "mesh/narrow.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"

namespace touchstone::mesh {
namespace {

using broad_phase::Pair;

Kind kind_of_query(MeshElement second) noexcept {
  switch (second) {
    case MeshElement::vertex: return Kind::point_point;
    case MeshElement::edge: return Kind::point_edge;
    case MeshElement::face: return Kind::vertex_face;
  }
  return Kind::point_point;
}

/// Two sorts of elements.
struct Sorts {
  MeshElement first, second;
};

/// The list of element pairs in the rules counts for pairs that are one of its kinds.
bool is_listed(const Mesh::Impl& mesh, const Sorts& sorts, const Pair& pair) noexcept {
  if (mesh.element_pairs.empty()) return false;
  if (sorts.first == MeshElement::vertex) return is_excluded(mesh, {kind_of_query(sorts.second), pair[0], pair[1]});
  return sorts.second == MeshElement::edge && is_excluded(mesh, {Kind::edge_edge, pair[0], pair[1]});
}

/// Two elements, of which an edge is traced from `from` to `to`: to a vertex that both have, where there is one.
struct Asked {
  Pair pair{};
  Index from = 0, to = 0;
  bool shared = false;
};

template <std::size_t N>
void trace(Asked& asked, const std::array<Index, 2>& edge, const std::array<Index, N>& other) noexcept {
  asked.shared = share_vertex(edge, other);
  const bool backwards = asked.shared && contains(other, edge[0]);
  asked.from = edge[backwards ? 1 : 0];
  asked.to = edge[backwards ? 0 : 1];
}

Asked asked_of(const Mesh::Impl& mesh, const Sorts& sorts, const Pair& pair) noexcept {
  Asked asked;
  asked.pair = pair;
  if (sorts.first != MeshElement::edge) {
    asked.from = asked.to = pair[0];
  } else if (sorts.second == MeshElement::edge) {
    trace(asked, mesh.edges[asked.pair[0]], mesh.edges[asked.pair[1]]);
  } else {
    trace(asked, mesh.edges[pair[0]], mesh.faces[pair[1]]);
  }
  return asked;
}

void fill(ColumnBlock& columns, const Mesh::Impl& mesh, const Motion& motion, const Sorts& sorts, const Asked& asked) {
  const auto at = [&](Index vertex) -> const Vec3& { return motion[vertex].start; };
  columns.set(0, at(asked.from), at(asked.to));
  const auto rest = [&](std::size_t c, Index vertex) { columns.set(c, at(vertex), at(vertex)); };
  const Index second = asked.pair[1];
  switch (sorts.second) {
    case MeshElement::vertex: rest(1, second); break;
    case MeshElement::edge:
      for (std::size_t i = 0; i < 2; ++i) rest(1 + i, mesh.edges[second][i]);
      break;
    case MeshElement::face:
      for (std::size_t i = 0; i < 3; ++i) rest(1 + i, mesh.faces[second][i]);
      break;
  }
  columns.finish_query();
}

/// The intersection that the answer shows, or nothing. An edge that is traced to a shared vertex touches the other
/// element there, at the time 1: a first time before that is a point that is not shared.
std::optional<Intersection> from_answer(const Mesh::Impl& mesh, const Motion& motion, const Sorts& sorts,
                                        const Asked& asked, const Answer& answer) {
  if (!answer.contact) return std::nullopt;
  Intersection found;
  found.first_element = sorts.first;
  found.first = asked.pair[0];
  found.second_element = sorts.second;
  found.second = asked.pair[1];
  found.weights_second = answer.weights_b;
  found.weights_first = {1, 0, 0};
  if (sorts.first != MeshElement::edge) return found;
  const bool forwards = asked.from == mesh.edges[found.first][0];
  found.weights_first[forwards ? 0 : 1] = 1 - answer.toi;
  found.weights_first[forwards ? 1 : 0] = answer.toi;
  if (asked.shared) {
    if (!(answer.toi < 1) || same_position(motion[asked.from].start, motion[asked.to].start)) return std::nullopt;
    found.sort = IntersectionSort::folds;
    return found;
  }
  const bool inside_edge = answer.toi_upper > 0 && answer.toi < 1;
  // The plane's side is a linear function of the fraction, so a crossing has the ends on both sides. Of two edges,
  // lines that are not parallel share a single point; on parallel ones the first common point is an end of an edge.
  const bool inside_second = sorts.second == MeshElement::face
                                 ? answer.feature_b == Feature::f && answer.nature == Nature::crossing
                                 : answer.feature_b == Feature::e && answer.nature == Nature::isolated;
  if (inside_edge && inside_second) found.sort = IntersectionSort::pierces;
  return found;
}

}  // namespace

std::vector<Intersection> find_intersections(const Mesh::Impl& mesh, const Motion& motion, int threads,
                                             const std::atomic<bool>* stop, HowMany how_many) {
  std::vector<Intersection> all;
  std::mutex lock;
  std::atomic<double> until{1};
  const auto take = [&](MeshElement first, MeshElement second, const Pair* pairs, std::size_t count) {
    check_stop(stop);
    if (until < 0) return;
    const Sorts sorts{first, second};
    ColumnBlock& columns = ColumnBlock::of_thread(kind_of_query(second));
    std::array<Asked, ColumnBlock::kQueries> asked;
    const auto ask = [&] {
      columns.solve(1, Wanted::all, Metric::euclidean, nullptr);
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto found = from_answer(mesh, motion, sorts, asked[i], columns.answers()[i]);
        if (!found) continue;
        const std::lock_guard<std::mutex> guard(lock);
        all.push_back(*found);
        if (how_many == HowMany::any) until = -1;  // no more boxes meet
      }
      columns.clear();
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (is_listed(mesh, sorts, pairs[i])) continue;
      const Asked& next = asked[columns.size()] = asked_of(mesh, sorts, pairs[i]);
      fill(columns, mesh, motion, sorts, next);
      if (columns.is_full()) ask();
    }
    ask();
  };
  for_each_resting_block(mesh, motion, {threads, &until}, take);
  if (how_many == HowMany::any && !all.empty()) return all;
  add_inside(mesh, motion, threads, stop, all);
  std::sort(all.begin(), all.end(), [](const Intersection& a, const Intersection& b) {
    return std::tie(a.first_element, a.second_element, a.first, a.second) <
           std::tie(b.first_element, b.second_element, b.first, b.second);
  });
  return all;
}

namespace {

TOUCHSTONE_BEHIND_GUARD std::vector<Intersection> intersections_at(const Mesh::Impl& mesh, const Positions& x,
                                                                   const MeshOptions& options, HowMany how_many) {
  return find_intersections(mesh, motion_of(mesh, x, x, options.threads), options.threads, options.stop, how_many);
}

}  // namespace
}  // namespace touchstone::mesh

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

std::vector<Intersection> intersections(const Mesh& mesh, const Positions& x, const MeshOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  return mesh::intersections_at(mesh.impl(), x, options, mesh::HowMany::all);
}

bool intersects(const Mesh& mesh, const Positions& x, const MeshOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  return !mesh::intersections_at(mesh.impl(), x, options, mesh::HowMany::any).empty();
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
