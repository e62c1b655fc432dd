// SPDX-License-Identifier: MIT
#include "mesh/inside.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "broad_phase/box_tree.hpp"
#include "geometry/vector.hpp"
#include "mesh/contacts.hpp"
#include "mesh/elements.hpp"
#include "mesh/ray_passes.hpp"
#include "numbers/exact_number.hpp"

namespace touchstone::mesh {
namespace {

using numbers::Exact;
using Point = ExactPoint;

constexpr std::size_t kLeastFaces = 4;  // of a closed surface with a volume

struct Surface {
  std::vector<Index> faces;  ///< in ascending order
  Index vertex = 0;          ///< its least vertex
  broad_phase::Box box = broad_phase::empty_box();
  bool closed = false;
};

/// Sets of vertices that faces connect. The least vertex of a set stands for it.
class ConnectedVertices {
 public:
  explicit ConnectedVertices(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), Index{0}); }
  Index find(Index v) noexcept {
    while (of_[v] != v) v = of_[v] = of_[of_[v]];
    return v;
  }
  void connect(Index a, Index b) noexcept {
    a = find(a), b = find(b);
    of_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> of_;
};

bool is_closed(const Mesh::Impl& mesh, const Surface& surface) {
  std::vector<std::pair<std::uint64_t, int>> passes;  // of an edge, from its lesser to its greater vertex or back
  passes.reserve(3 * surface.faces.size());
  for (const Index face : surface.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = mesh.faces[face][i], to = mesh.faces[face][(i + 1) % 3];
      passes.emplace_back(unordered(from, to), from < to ? 1 : -1);
    }
  }
  std::sort(passes.begin(), passes.end());
  for (auto pass = passes.begin(); pass != passes.end();) {
    const std::uint64_t edge = pass->first;
    int sum = 0;
    for (; pass != passes.end() && pass->first == edge; ++pass) sum += pass->second;
    if (sum != 0) return false;
  }
  return true;
}

/// The surfaces of a mesh, and which of them a vertex belongs to.
class Surfaces {
 public:
  Surfaces(const Mesh::Impl& mesh, const Motion& motion) : mesh_(mesh), motion_(motion), sets_(mesh.vertex_count) {
    for (const auto& face : mesh.faces) {
      sets_.connect(face[0], face[1]);
      sets_.connect(face[0], face[2]);
    }
    constexpr Index kNone = std::numeric_limits<Index>::max();
    number_.assign(mesh.vertex_count, kNone);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Index least = sets_.find(mesh.faces[f][0]);
      if (number_[least] == kNone) {
        number_[least] = static_cast<Index>(all_.size());
        all_.emplace_back();
        all_.back().vertex = least;
      }
      Surface& surface = all_[number_[least]];
      surface.faces.push_back(static_cast<Index>(f));
      for (const Index corner : mesh.faces[f]) broad_phase::extend(surface.box, motion[corner].start);
    }
  }

  std::size_t size() const noexcept { return all_.size(); }
  const Surface& operator[](Index i) const noexcept { return all_[i]; }
  Index of_vertex(Index vertex) noexcept { return number_[sets_.find(vertex)]; }

  void check_closed(Index i) {
    Surface& surface = all_[i];
    if (surface.faces.size() >= kLeastFaces) surface.closed = is_closed(mesh_, surface);
  }

  /// The sign of the volume that a closed surface encloses, with its normals outwards.
  int sign_of_volume(Index i) const {
    const Point origin = exact(motion_[all_[i].vertex].start);
    Exact volume;
    for (const Index face : all_[i].faces) {
      const auto corners = corners_of_face(face);
      volume = volume + geometry::dot(corners[0] - origin, geometry::cross(corners[1] - origin, corners[2] - origin));
    }
    return numbers::sign_of(volume);
  }

  /// The winding number of a closed surface about a point that is not on it.
  int winding_about(Index i, const Vec3& place) const {
    RayPasses ray(place);
    for (const Index face : all_[i].faces) {
      const auto& f = mesh_.faces[face];
      ray.add(motion_[f[0]].start, motion_[f[1]].start, motion_[f[2]].start);
    }
    return ray.sum();
  }

 private:
  std::array<Point, 3> corners_of_face(Index face) const {
    const auto& f = mesh_.faces[face];
    return {exact(motion_[f[0]].start), exact(motion_[f[1]].start), exact(motion_[f[2]].start)};
  }

  const Mesh::Impl& mesh_;
  const Motion& motion_;
  ConnectedVertices sets_;
  std::vector<Index> number_;  ///< of a surface, by its least vertex
  std::vector<Surface> all_;
};

bool is_strictly_inside(const broad_phase::Box& inner, const broad_phase::Box& outer) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(outer.low[k] < inner.low[k] && inner.high[k] < outer.high[k])) return false;
  }
  return true;
}

/// Pairs of an inner and an outer surface by their boxes, in ascending order.
std::vector<broad_phase::Pair> nested_boxes(const Surfaces& surfaces, int threads) {
  std::vector<Index> large;
  for (Index i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].faces.size() >= kLeastFaces) large.push_back(i);
  }
  std::vector<broad_phase::Pair> nested;
  if (large.size() < 2) return nested;
  const auto box_of = [&](Index n) { return broad_phase::MovingBox{surfaces[large[n]].box, surfaces[large[n]].box}; };
  std::mutex lock;
  broad_phase::PairSearch search;
  search.threads = threads;
  broad_phase::for_each_pair_block(broad_phase::BoxTree(large.size(), box_of, threads), search,
                                   [&](const broad_phase::Pair* pairs, std::size_t count) {
                                     for (std::size_t n = 0; n < count; ++n) {
                                       const Index a = large[pairs[n][0]], b = large[pairs[n][1]];
                                       const bool first = is_strictly_inside(surfaces[a].box, surfaces[b].box);
                                       if (!first && !is_strictly_inside(surfaces[b].box, surfaces[a].box)) continue;
                                       const std::lock_guard<std::mutex> guard(lock);
                                       nested.push_back(first ? broad_phase::Pair{a, b} : broad_phase::Pair{b, a});
                                     }
                                   });
  std::sort(nested.begin(), nested.end());
  return nested;
}

Index a_vertex(const Mesh::Impl& mesh, MeshElement element, Index number) noexcept {
  if (element == MeshElement::vertex) return number;
  return element == MeshElement::edge ? mesh.edges[number][0] : mesh.faces[number][0];
}

/// The pairs of surfaces that meet, the lesser number first.
std::set<std::array<Index, 2>> meeting(const Mesh::Impl& mesh, Surfaces& surfaces,
                                       const std::vector<Intersection>& all) {
  std::set<std::array<Index, 2>> pairs;
  for (const Intersection& one : all) {
    const Index a = surfaces.of_vertex(a_vertex(mesh, one.first_element, one.first));
    const Index b = surfaces.of_vertex(a_vertex(mesh, one.second_element, one.second));
    if (a != b) pairs.insert({std::min(a, b), std::max(a, b)});
  }
  return pairs;
}

}  // namespace

void add_inside(const Mesh::Impl& mesh, const Motion& motion, int threads, const std::atomic<bool>* stop,
                std::vector<Intersection>& all) {
  if (mesh.faces.size() < 2 * kLeastFaces) return;
  Surfaces surfaces(mesh, motion);
  const std::vector<broad_phase::Pair> nested = nested_boxes(surfaces, threads);
  if (nested.empty()) return;
  std::set<Index> asked;
  for (const auto& pair : nested) asked.insert(pair.begin(), pair.end());
  for (const Index surface : asked) {
    check_stop(stop);
    surfaces.check_closed(surface);
  }
  const std::set<std::array<Index, 2>> met = meeting(mesh, surfaces, all);
  for (std::size_t i = 0; i < nested.size();) {
    const Index inner = nested[i][0];
    const Surface& surface = surfaces[inner];
    std::vector<std::pair<Index, int>> around;  // a surface, and its winding number about the inner one
    std::optional<Index> outermost;
    int sum = 0;
    for (; i < nested.size() && nested[i][0] == inner; ++i) {
      check_stop(stop);
      const Index outer = nested[i][1];
      if (!surface.closed || !surfaces[outer].closed) continue;
      if (met.count({std::min(inner, outer), std::max(inner, outer)}) != 0) continue;
      const Index face = surfaces[outer].faces.front();
      if (mesh.has_rules() && !corners_may_collide(mesh, std::array{surface.vertex}, mesh.faces[face])) continue;
      const int winding = surfaces.winding_about(outer, motion[surface.vertex].start);
      if (winding == 0) continue;
      around.emplace_back(outer, winding);
      sum += winding;
      if (!outermost || surfaces[outer].box.low[0] < surfaces[*outermost].box.low[0]) outermost = outer;
    }
    if (around.empty()) continue;
    const int sign = surfaces.sign_of_volume(inner);
    const bool in_room = surfaces.sign_of_volume(*outermost) < 0;
    if (sign == 0 || (sign > 0 ? sum + (in_room ? 1 : 0) <= 0 : sum >= 0)) continue;
    const auto outer =
        std::find_if(around.begin(), around.end(), [&](const auto& one) { return one.second * sign > 0; });
    Intersection found;
    found.first_element = MeshElement::vertex;
    found.first = surface.vertex;
    found.second_element = MeshElement::face;
    found.second = surfaces[outer->first].faces.front();
    found.sort = IntersectionSort::inside;
    all.push_back(found);
  }
}

}  // namespace touchstone::mesh
