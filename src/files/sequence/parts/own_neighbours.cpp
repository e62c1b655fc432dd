// SPDX-License-Identifier: MIT
#include "sequence/parts/own_neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include <touchstone/error.hpp>

#include "geometry/kind_traits.hpp"
#include "geometry/union_find.hpp"

namespace touchstone::sequence {
namespace {

double length_of(const Positions& x, MeshIndex a, MeshIndex b) {
  std::array<double, 3> d{};
  for (int k = 0; k < x.dimension; ++k) {
    const auto at = [&](MeshIndex v) {
      return x.data[static_cast<std::ptrdiff_t>(v) * x.vertex_stride + k * x.coordinate_stride];
    };
    d[static_cast<std::size_t>(k)] = at(a) - at(b);
  }
  return std::hypot(d[0], d[1], d[2]);
}

/// Finds the vertices that are near some others along edges (Dijkstra's algorithm, up to a length).
class Chains {
 public:
  Chains(const Mesh& mesh, const Positions& x, double length)
      : length_(length),
        first_(mesh.vertex_count() + 1, 0),
        distance_(mesh.vertex_count(), kFar),
        sets_(mesh.vertex_count()) {
    for (const auto& [a, b] : mesh.edges()) {
      ++first_[a + std::size_t{1}], ++first_[b + std::size_t{1}];
      sets_.join(a, b);
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    next_.resize(first_.back());
    std::vector<std::size_t> end = first_;
    for (const auto& [a, b] : mesh.edges()) {
      const double apart = length_of(x, a, b);
      next_[end[a]++] = {apart, b};
      next_[end[b]++] = {apart, a};
    }
  }

  bool are_connected(MeshIndex a, MeshIndex b) { return sets_.root(a) == sets_.root(b); }

  /// Ends when all of `targets` are found, which has each vertex once, or nothing else is near.
  void search(const MeshIndex* from, std::size_t count, std::vector<MeshIndex> targets) {
    for (const MeshIndex v : seen_) distance_[v] = kFar;
    seen_.clear();
    heap_.clear();
    for (std::size_t i = 0; i < count; ++i) reach(from[i], 0);
    std::size_t left = targets.size();
    while (!heap_.empty() && left > 0) {
      std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
      const auto [distance, v] = heap_.back();
      heap_.pop_back();
      if (distance > distance_[v]) continue;
      if (std::binary_search(targets.begin(), targets.end(), v)) --left;
      for (std::size_t i = first_[v]; i < first_[v + std::size_t{1}]; ++i) {
        reach(next_[i].second, distance + next_[i].first);
      }
    }
  }

  /// Of a targets vertex: whether the search has found it.
  bool is_near(MeshIndex v) const noexcept { return distance_[v] < length_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  void reach(MeshIndex v, double distance) {
    if (!(distance < length_) || !(distance < distance_[v])) return;
    if (distance_[v] == kFar) seen_.push_back(v);
    distance_[v] = distance;
    heap_.push_back({distance, v});
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }

  double length_;
  // The edges of vertex v lead to next_[first_[v]] up to next_[first_[v + 1] - 1].
  std::vector<std::size_t> first_;
  std::vector<std::pair<double, MeshIndex>> next_;
  std::vector<double> distance_;
  std::vector<MeshIndex> seen_;  // the vertices with a distance
  std::vector<std::pair<double, MeshIndex>> heap_;
  geometry::UnionFind sets_;
};

/// A pair and its corners: the first element's before `second`.
struct Corners {
  MeshPair pair;
  std::array<MeshIndex, 4> corners;
  std::size_t second, end;

  Corners(const Mesh& mesh, const MeshPair& p)
      : pair(p), corners(mesh.corners(p)), second(geometry::corners_of_first(p.kind)), end(corner_count(p.kind)) {}

  bool have_common_vertex() const noexcept {
    return std::find_first_of(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(second),
                              corners.begin() + static_cast<std::ptrdiff_t>(second),
                              corners.begin() + static_cast<std::ptrdiff_t>(end)) !=
           corners.begin() + static_cast<std::ptrdiff_t>(second);
  }
};

}  // namespace

std::vector<MeshPair> own_neighbours(const Mesh& mesh, const Positions& x, double length, const MeshOptions& options) {
  const FirstContact start = first_contact(mesh, x, x, {{options}});
  Chains chains(mesh, x, length);
  std::vector<Corners> group;  // pairs with one first element
  std::vector<MeshPair> found;
  std::vector<MeshIndex> targets;
  const auto take_group = [&] {
    if (group.empty()) return;
    if (options.stop != nullptr && *options.stop) throw Stopped("the search for neighbours was stopped");
    targets.clear();
    for (const Corners& one : group) {
      targets.insert(targets.end(), one.corners.begin() + static_cast<std::ptrdiff_t>(one.second),
                     one.corners.begin() + static_cast<std::ptrdiff_t>(one.end));
    }
    std::sort(targets.begin(), targets.end());
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    chains.search(group.front().corners.data(), group.front().second, targets);
    for (const Corners& one : group) {
      const bool near = std::any_of(one.corners.begin() + static_cast<std::ptrdiff_t>(one.second),
                                    one.corners.begin() + static_cast<std::ptrdiff_t>(one.end),
                                    [&](MeshIndex v) { return chains.is_near(v); });
      if (near) found.push_back(one.pair);
    }
    group.clear();
  };
  for (const MeshContact& contact : start.at_start) {  // in ascending order
    if (contact.separation.distance == 0) continue;    // neighbours along a wire, which only touch
    const Corners one(mesh, contact.pair);
    if (one.have_common_vertex() || !chains.are_connected(one.corners[0], one.corners[one.second])) continue;
    if (!group.empty() && (group.front().pair.kind != one.pair.kind || group.front().pair.first != one.pair.first)) {
      take_group();
    }
    group.push_back(one);
  }
  take_group();
  return found;
}

Mesh touching_alone(const Mesh& mesh, const std::vector<MeshPair>& pairs) {
  MeshElements elements = mesh.elements();
  for (const MeshPair& pair : pairs) elements.pair_separations.push_back({pair, 0});
  return Mesh(std::move(elements));
}

std::size_t own_neighbours_among(const Mesh& mesh, const std::vector<MeshContact>& contacts) {
  std::set<std::array<MeshIndex, 2>> edges;
  if (std::any_of(contacts.begin(), contacts.end(),
                  [](const MeshContact& one) { return one.separation.distance > 0; })) {
    for (const auto& [a, b] : mesh.edges()) edges.insert({std::min(a, b), std::max(a, b)});
  }
  const auto are_connected = [&](const MeshContact& contact) {
    const auto corners = mesh.corners(contact.pair);
    const std::size_t of_first = geometry::corners_of_first(contact.pair.kind);
    for (std::size_t i = 0; i < of_first; ++i) {
      for (std::size_t k = of_first; k < corner_count(contact.pair.kind); ++k) {
        if (edges.contains({std::min(corners[i], corners[k]), std::max(corners[i], corners[k])})) return true;
      }
    }
    return false;
  };
  return static_cast<std::size_t>(std::count_if(contacts.begin(), contacts.end(), [&](const MeshContact& contact) {
    return contact.separation.distance > 0 && are_connected(contact);
  }));
}

}  // namespace touchstone::sequence
