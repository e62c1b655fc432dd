// SPDX-License-Identifier: MIT
#include "contact/separations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

#include <touchstone/error.hpp>

#include "numbers/doubles/rounded_sum.hpp"

namespace touchstone::sim {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

// The arc between two points of a circle over their distance, where they lie opposite each other.
constexpr double kArc = std::numbers::pi / 2;

// For each particle and in all, of 16 bytes each. Radii that are very many times as long as the edges have more, and
// are hardly meant.
constexpr std::size_t kMostNeighbours = 256, kMostNeighboursInAll = 50'000'000;

/// The ways that lead from each particle.
class Graph {
 public:
  Graph(const Scene& scene, std::span<const Edge> edges, const VectorX& placed)
      : from_(scene.particles.size()), length_(scene.particles.size(), kUnreached) {
    const auto add = [&](Index a, Index b) {
      const double length = (position(placed, a) - position(placed, b)).norm();
      from_[a].emplace_back(b, length);
      from_[b].emplace_back(a, length);
    };
    for (const Edge& edge : edges) add(edge[0], edge[1]);
    for (const Spring& spring : scene.springs) {
      if (!spring.collides) add(spring.a, spring.b);
    }
  }

  /// Calls found(q, length) for each particle q to which a way shorter than `limit` leads from p.
  template <class Found>
  void for_each_near(Index p, double limit, Found found) {
    using Reached = std::pair<double, Index>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    reached_.assign(1, p);
    length_[p] = 0;
    open.emplace(0, p);
    while (!open.empty()) {
      const auto [length, q] = open.top();
      open.pop();
      if (length > length_[q]) continue;
      if (q != p) found(q, length);
      for (const auto& [next, step] : from_[q]) {
        const double there = length + step;
        if (!(there < limit && there < length_[next])) continue;
        if (length_[next] == kUnreached) reached_.push_back(next);
        length_[next] = there;
        open.emplace(there, next);
      }
    }
    for (const Index q : reached_) length_[q] = kUnreached;
  }

 private:
  std::vector<std::vector<std::pair<Index, double>>> from_;
  std::vector<double> length_;  // of the shortest way known so far
  std::vector<Index> reached_;
};

}  // namespace

Neighbours::Neighbours(const Scene& scene, std::span<const Edge> edges, const std::vector<double>& radius,
                       const VectorX& placed) {
  const double largest = *std::max_element(radius.begin(), radius.end());
  const auto reach = [](double a, double b) { return kArc * numbers::sum_rounded_up(a, b); };
  Graph graph(scene, edges, placed);
  std::vector<std::vector<Way>> ways(radius.size());
  const std::size_t most = std::min(kMostNeighbours * radius.size(), kMostNeighboursInAll);
  std::size_t all = 0;
  for (Index p = 0; p < radius.size(); ++p) {
    if (radius[p] == 0) continue;
    graph.for_each_near(p, reach(radius[p], largest), [&](Index q, double length) {
      // Where both have a radius, the other one is found from q, too.
      if (!(length < reach(radius[p], radius[q])) || (radius[q] > 0 && q < p)) return;
      if (++all > most) {
        throw Error(
            fmt::format("particles[{}]: radii of up to {} m are too long for elements so small: more than {} "
                        "pairs of particles are neighbours",
                        p, largest, most));
      }
      ways[std::min(p, q)].push_back({std::max(p, q), length});
    });
  }
  first_.reserve(radius.size() + 1);
  others_.reserve(all);
  for (auto& of_one : ways) {
    first_.push_back(others_.size());
    std::sort(of_one.begin(), of_one.end(), [](const Way& a, const Way& b) { return a.to < b.to; });
    others_.insert(others_.end(), of_one.begin(), of_one.end());
    of_one = {};
  }
  first_.push_back(others_.size());
}

bool Neighbours::near(Index a, Index b, double d) const noexcept {
  if (others_.empty()) return false;
  const auto [low, high] = std::minmax(a, b);
  const auto begin = others_.begin() + static_cast<std::ptrdiff_t>(first_[low]);
  const auto end = others_.begin() + static_cast<std::ptrdiff_t>(first_[low + 1]);
  const auto found = std::lower_bound(begin, end, high, [](const Way& way, Index to) { return way.to < to; });
  return found != end && found->to == high && found->length < kArc * d;
}

Radii::Radii(const Scene& scene, const std::vector<Edge>& edges) {
  if (!has_radii(scene)) return;
  edge.assign(edges.size(), 0);
  face.reserve(scene.faces.size());
  particle.reserve(scene.particles.size());
  for (const Particle& p : scene.particles) particle.push_back(p.radius);
  const auto add_edge = [&](Index a, Index b, double radius) {
    const Edge sorted{std::min(a, b), std::max(a, b)};
    const auto at = std::lower_bound(edges.begin(), edges.end(), sorted) - edges.begin();
    double& known = edge[static_cast<std::size_t>(at)];
    known = std::max(known, radius);
    for (const Index p : sorted) particle[p] = std::max(particle[p], radius);
  };
  for (const Spring& spring : scene.springs) {
    if (spring.collides) add_edge(spring.a, spring.b, spring.radius);
  }
  for (const Cable& cable : scene.cables) {
    for (std::size_t j = 0; cable.solid && j < cable.edge_count(); ++j) {
      add_edge(cable.particles[j], cable.particles[(j + 1) % cable.particles.size()], cable.radius);
    }
  }
  for (const Wire& wire : scene.wires) add_edge(wire.particles[0], wire.particles[1], wire.radius);
  const auto add_face = [&](const Face& particles, double radius) {
    face.push_back(radius);
    for (std::size_t k = 0; k < 3; ++k) add_edge(particles[k], particles[(k + 1) % 3], radius);
  };
  for (const Facet& of_scene : scene.faces) add_face(of_scene.particles, of_scene.radius);
  for (const Surface& surface : scene.surfaces) {
    for (const Face& particles : surface.faces) add_face(particles, surface.radius);
  }
}

}  // namespace touchstone::sim
