// Intersections at rest, as contacts in motion: the points of an edge are the places of a vertex that moves from its
// first corner to its second one, at the time that is the fraction of the edge. So the solver decides them, exactly.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include <touchstone/mesh.hpp>
#include <touchstone/solve.hpp>

#include "mesh/candidates.hpp"
#include "mesh/contacts.hpp"
#include "mesh/narrow.hpp"
#include "numbers/float_environment.hpp"
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

/// The list of element pairs in the rules counts for pairs that are one of its kinds.
bool is_listed(const Mesh::Impl& mesh, const RestingPass& pass, const Pair& pair) noexcept {
  if (mesh.element_pairs.empty()) return false;
  if (pass.first == MeshElement::vertex) return is_excluded(mesh, {kind_of_query(pass.second), pair[0], pair[1]});
  return pass.second == MeshElement::edge && is_excluded(mesh, {Kind::edge_edge, pair[0], pair[1]});
}

void fill(ColumnBlock& columns, const Mesh::Impl& mesh, const Motion& motion, const RestingPass& pass,
          const Pair& pair) {
  const auto at = [&](Index vertex) -> const Vec3& { return motion[vertex].start; };
  if (pass.first == MeshElement::edge) {
    columns.set(0, at(mesh.edges[pair[0]][0]), at(mesh.edges[pair[0]][1]));
  } else {
    columns.set(0, at(pair[0]), at(pair[0]));
  }
  const auto rest = [&](std::size_t c, Index vertex) { columns.set(c, at(vertex), at(vertex)); };
  switch (pass.second) {
    case MeshElement::vertex: rest(1, pair[1]); break;
    case MeshElement::edge:
      for (std::size_t i = 0; i < 2; ++i) rest(1 + i, mesh.edges[pair[1]][i]);
      break;
    case MeshElement::face:
      for (std::size_t i = 0; i < 3; ++i) rest(1 + i, mesh.faces[pair[1]][i]);
      break;
  }
  columns.finish_query();
}

Intersection from_answer(const RestingPass& pass, const Pair& pair, const Answer& answer) {
  Intersection found;
  found.first_element = pass.first;
  found.first = pair[0];
  found.second_element = pass.second;
  found.second = pair[1];
  found.weights_second = answer.weights_b;
  found.weights_first = {1, 0, 0};
  if (pass.first != MeshElement::edge) return found;
  found.weights_first = {1 - answer.toi, answer.toi, 0};
  const bool inside_edge = answer.toi_upper > 0 && answer.toi < 1;
  // The plane's side is a linear function of the fraction, so a crossing has the ends on both sides. Of two edges,
  // lines that are not parallel share a single point; on parallel ones the first common point is an end of an edge.
  const bool inside_second = pass.second == MeshElement::face
                                 ? answer.feature_b == Feature::f && answer.nature == Nature::crossing
                                 : answer.feature_b == Feature::e && answer.nature == Nature::isolated;
  found.pierces = inside_edge && inside_second;
  return found;
}

std::vector<RestingPass> passes_of(const Mesh::Impl& mesh) {
  using E = MeshElement;
  if (mesh.dimension == 2) return {{E::vertex, E::vertex}, {E::vertex, E::edge}, {E::edge, E::edge}};
  return {{E::vertex, E::vertex},
          {E::vertex, E::edge, false, true},
          {E::vertex, E::face},
          {E::edge, E::edge, true, false},
          {E::edge, E::face}};
}

/// Of two wires, each pair comes in both orders when wires are compared with all edges.
bool comes_twice(const Mesh::Impl& mesh, const RestingPass& pass, const Pair& pair) noexcept {
  return pass.only_wires_first && !pass.only_wires_second && pair[1] < pair[0] &&
         std::binary_search(mesh.wires.begin(), mesh.wires.end(), pair[1]);
}

TOUCHSTONE_BEHIND_GUARD std::vector<Intersection> find_intersections(const Mesh::Impl& mesh, const Positions& x,
                                                                     const MeshOptions& options) {
  const int threads = options.threads;
  const Motion motion = motion_of(mesh, x, x, threads);
  std::vector<Intersection> all;
  std::mutex lock;
  for (const RestingPass& pass : passes_of(mesh)) {
    for_each_resting_block(mesh, motion, pass, threads, [&](const Pair* pairs, std::size_t count) {
      check_stop(options.stop);
      const auto columns = std::make_unique<ColumnBlock>(kind_of_query(pass.second));
      std::array<Pair, ColumnBlock::kQueries> asked;
      const auto ask = [&] {
        columns->solve(1, Wanted::all, Metric::euclidean, nullptr);
        for (std::size_t i = 0; i < columns->size(); ++i) {
          if (!columns->answers()[i].contact) continue;
          const Intersection found = from_answer(pass, asked[i], columns->answers()[i]);
          const std::lock_guard<std::mutex> guard(lock);
          all.push_back(found);
        }
        columns->clear();
      };
      for (std::size_t i = 0; i < count; ++i) {
        if (comes_twice(mesh, pass, pairs[i]) || is_listed(mesh, pass, pairs[i])) continue;
        asked[columns->size()] = pairs[i];
        fill(*columns, mesh, motion, pass, pairs[i]);
        if (columns->is_full()) ask();
      }
      ask();
    });
  }
  std::sort(all.begin(), all.end(), [](const Intersection& a, const Intersection& b) {
    return std::tie(a.first_element, a.second_element, a.first, a.second) <
           std::tie(b.first_element, b.second_element, b.first, b.second);
  });
  return all;
}

}  // namespace
}  // namespace touchstone::mesh

namespace touchstone {

std::vector<Intersection> intersections(const Mesh& mesh, const Positions& x, const MeshOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  return mesh::find_intersections(mesh.impl(), x, options);
}

}  // namespace touchstone
