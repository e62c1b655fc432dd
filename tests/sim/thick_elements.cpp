// SPDX-License-Identifier: MIT
#include "sim/thick_elements.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "oracle/algebra.hpp"
#include "oracle/elements_at.hpp"

namespace touchstone::sim {
namespace {

Vector3 placed(const Scene& scene, Index p) {
  const Particle& particle = scene.particles[p];
  return particle.path.empty() ? particle.position : particle.path.front().position;
}

// Pairs whose distance is more than so many sums of their radii, in doubles, need no exact measurement.
constexpr double kLook = 1.4;

/// Whether the boxes around the elements' paths are farther apart than this along an axis, as most are.
bool far_apart(const Query& query, double distance) {
  const std::size_t first = query.kind == Kind::edge_edge ? 2 : 1;
  for (const auto coordinate : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
      const int element = c < first ? 0 : 1;
      for (const Vec3& corner : {query.start[c], query.end[c]}) {
        low[element] = std::min(low[element], corner.*coordinate);
        high[element] = std::max(high[element], corner.*coordinate);
      }
    }
    if (low[0] - high[1] > distance || low[1] - high[0] > distance) return true;
  }
  return false;
}

}  // namespace

ThickElements::ThickElements(const Scene& scene) : count_(scene.particles.size()), ways_(count_ * count_, 1e300) {
  std::map<Edge, double> edges;
  std::vector<double> radius;
  for (const Particle& p : scene.particles) radius.push_back(p.radius);
  const auto add = [&](Index a, Index b, double r) {
    double& of_edge = edges.try_emplace(Edge{std::min(a, b), std::max(a, b)}, 0.0).first->second;
    of_edge = std::max(of_edge, r);
    for (const Index p : {a, b}) radius[p] = std::max(radius[p], r);
  };
  const auto join = [&](Index a, Index b) {
    const double length = (placed(scene, a) - placed(scene, b)).norm();
    ways_[a * count_ + b] = ways_[b * count_ + a] = length;
  };
  for (const Spring& s : scene.springs) {
    join(s.a, s.b);
    if (s.collides) add(s.a, s.b, s.radius);
  }
  for (const Cable& cable : scene.cables) {
    for (std::size_t i = 0; i + (cable.closed ? 0 : 1) < cable.particles.size(); ++i) {
      add(cable.particles[i], cable.particles[(i + 1) % cable.particles.size()], cable.solid ? cable.radius : 0);
    }
  }
  for (const Wire& wire : scene.wires) add(wire.particles[0], wire.particles[1], wire.radius);
  for (const Facet& f : scene.faces) {
    for (int k = 0; k < 3; ++k) add(f.particles[k], f.particles[(k + 1) % 3], f.radius);
  }
  for (const auto& [edge, r] : edges) join(edge[0], edge[1]);
  // Floyd, Warshall.
  for (std::size_t i = 0; i < count_; ++i) ways_[i * count_ + i] = 0;
  for (std::size_t via = 0; via < count_; ++via) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < count_; ++j) {
        double& way = ways_[i * count_ + j];
        way = std::min(way, ways_[i * count_ + via] + ways_[via * count_ + j]);
      }
    }
  }
  const auto offer = [&](const ThickPair& pair) {
    const std::size_t first = pair.kind == Kind::edge_edge ? 2 : 1;
    for (std::size_t a = 0; a < first; ++a) {
      for (std::size_t b = first; b < corner_count(pair.kind); ++b) {
        if (pair.particles[a] == pair.particles[b]) return;
      }
    }
    if (pair.first_radius + pair.second_radius > 0 && !are_neighbours(pair)) pairs_.push_back(pair);
  };
  std::vector<char> in_edge(count_, 0);
  for (auto e = edges.begin(); e != edges.end(); ++e) {
    in_edge[e->first[0]] = in_edge[e->first[1]] = 1;
    for (auto f = std::next(e); f != edges.end(); ++f) {
      offer({Kind::edge_edge, {e->first[0], e->first[1], f->first[0], f->first[1]}, e->second, f->second});
    }
  }
  for (Index p = 0; p < count_; ++p) {
    if (!scene.particles[p].collides) continue;
    for (const Facet& f : scene.faces) {
      offer({Kind::vertex_face, {p, f.particles[0], f.particles[1], f.particles[2]}, radius[p], f.radius});
    }
    if (in_edge[p]) continue;
    for (const auto& [edge, r] : edges) offer({Kind::point_edge, {p, edge[0], edge[1], 0}, radius[p], r});
    for (Index other = p + 1; other < count_; ++other) {
      if (!in_edge[other] && scene.particles[other].collides) {
        offer({Kind::point_point, {p, other, 0, 0}, radius[p], radius[other]});
      }
    }
  }
}

bool ThickElements::are_neighbours(const ThickPair& pair) const {
  const std::size_t first = pair.kind == Kind::edge_edge ? 2 : 1;
  double way = 1e300;
  for (std::size_t a = 0; a < first; ++a) {
    for (std::size_t b = first; b < corner_count(pair.kind); ++b) {
      way = std::min(way, ways_[pair.particles[a] * count_ + pair.particles[b]]);
    }
  }
  return way < std::numbers::pi / 2 * (pair.first_radius + pair.second_radius);
}

void ThickElements::measure(const VectorX& x0, const VectorX& x1, const std::vector<double>& times,
                            Nearness& nearness) const {
  using oracle::Rational;
  for (const ThickPair& pair : pairs_) {
    Query query;
    query.kind = pair.kind;
    for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
      query.start[c] = corner_of(x0, pair.particles[c]);
      query.end[c] = corner_of(x1, pair.particles[c]);
    }
    const double sum = pair.first_radius + pair.second_radius;
    if (far_apart(query, kLook * sum)) continue;
    for (const double t : times) {
      const auto elements = tests::elements_at<double>(query, t);
      const double distance = std::sqrt(tests::measure(elements, Metric::euclidean));
      if (distance > kLook * sum) continue;
      nearness.least_gap = std::min(nearness.least_gap, distance - sum);
      ++nearness.exact;
      const auto exactly = tests::elements_at<Rational>(query, Rational(t));
      const Rational asked = Rational(pair.first_radius) + Rational(pair.second_radius);
      if (!(tests::measure(exactly, Metric::euclidean) > asked * asked)) ++nearness.violations;
    }
  }
}

}  // namespace touchstone::sim
