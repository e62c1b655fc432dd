// Pairs that are near along a surface: against every pair, by the oracle and by all chains of edges.
// SPDX-License-Identifier: MIT
#include "sequence/parts/own_neighbours.hpp"

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using namespace touchstone::sequence;

namespace {

struct Sheet {
  MeshElements elements;
  std::vector<double> x;

  Positions positions() const { return {x, elements.dimension}; }
  Vec3 at(MeshIndex v) const {
    const auto n = static_cast<std::size_t>(elements.dimension);
    return {x[n * v], x[n * v + 1], n == 3 ? x[n * v + 2] : 0};
  }
};

/// A strip that is rolled up, so that it is near itself along its edges and across them, another one, wires and points.
Sheet rolled_sheets(seeded::Rng& random, Metric metric) {
  Sheet sheet;
  sheet.elements.separation = {0.25 + random.unit(), metric};
  const auto vertex = [&](double a, double b, double c) {
    for (const double x : {a, b, c}) sheet.x.push_back(x + random.unit() / 8);
    return static_cast<MeshIndex>(sheet.elements.vertex_count++);
  };
  for (const double z : {0.0, 3.5}) {
    const auto first = static_cast<MeshIndex>(sheet.elements.vertex_count);
    for (int i = 0; i < 7; ++i) {
      const double turn = 1.1 * i, radius = 1 + 0.1 * i;
      for (int j = 0; j < 3; ++j) vertex(radius * std::cos(turn), radius * std::sin(turn), z + j);
    }
    for (MeshIndex i = 0; i < 6; ++i) {
      for (MeshIndex j = 0; j < 2; ++j) {
        const MeshIndex a = first + 3 * i + j;
        sheet.elements.faces.push_back({a, a + 1, a + 3});
        sheet.elements.faces.push_back({a + 1, a + 4, a + 3});
      }
    }
  }
  MeshIndex end = 0;
  for (int i = 0; i < 5; ++i) {
    const MeshIndex next = vertex(0.3 * i, 0.2 * (i % 2), 0);
    if (i > 0) sheet.elements.edges.push_back({end, next});
    end = next;
  }
  sheet.elements.points = {vertex(0, 0, 1), vertex(0.2, 0, 1)};
  return sheet;
}

/// The least sums of edge lengths between all vertices, by Floyd and Warshall.
std::vector<std::vector<double>> all_chains(const Mesh& mesh, const Sheet& sheet) {
  const std::size_t n = mesh.vertex_count();
  std::vector<std::vector<double>> length(n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (std::size_t v = 0; v < n; ++v) length[v][v] = 0;
  for (const auto& [a, b] : mesh.edges()) {
    const Vec3 p = sheet.at(a), q = sheet.at(b);
    const double apart = std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
    length[a][b] = length[b][a] = apart;
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) length[i][j] = std::min(length[i][j], length[i][k] + length[k][j]);
    }
  }
  return length;
}

std::vector<MeshPair> expected_neighbours(const Mesh& mesh, const Sheet& sheet, double length) {
  const Method method = has_method(Method::oracle) ? Method::oracle : Method::exact;
  const auto chains = all_chains(mesh, sheet);
  std::vector<MeshPair> found;
  const std::size_t counts[] = {mesh.edges().size(), mesh.vertex_count(), mesh.vertex_count(), mesh.vertex_count()},
                    others[] = {mesh.edges().size(), mesh.faces().size(), mesh.edges().size(), mesh.vertex_count()};
  for (const Kind kind : kKinds) {
    const auto k = static_cast<std::size_t>(kind);
    for (MeshIndex a = 0; a < counts[k]; ++a) {
      for (MeshIndex b = kind == Kind::edge_edge || kind == Kind::point_point ? a + 1 : 0; b < others[k]; ++b) {
        const MeshPair pair{kind, a, b};
        if (!mesh.may_collide(pair) || mesh.separation(pair).distance == 0) continue;
        const auto corners = mesh.corners(pair);
        const std::size_t first = kind == Kind::edge_edge ? 2 : 1, end = corner_count(kind);
        double chain = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < first; ++i) {
          for (std::size_t j = first; j < end; ++j) chain = std::min(chain, chains[corners[i]][corners[j]]);
        }
        if (!(chain < length) || chain == 0) continue;
        const Query query = query_of(mesh, pair, sheet.positions(), sheet.positions());
        if (solve(query, {.separation = mesh.separation(pair), .method = method}).contact) found.push_back(pair);
      }
    }
  }
  return found;
}

}  // namespace

TEST_CASE("own neighbours are the pairs within the separation that a short chain of edges connects") {
  seeded::Rng random(77);
  std::size_t all = 0, left = 0;
  std::set<Kind> kinds;
  for (std::size_t round = 0; round < effort(6); ++round) {
    for (const Metric metric : {Metric::euclidean, Metric::max}) {
      const Sheet sheet = rolled_sheets(random, metric);
      const Mesh mesh(sheet.elements);
      const double length = 0.5 + 3 * random.unit();
      CAPTURE(round, length, sheet.elements.separation.distance);
      const std::vector<MeshPair> found = own_neighbours(mesh, sheet.positions(), length, {1});
      CHECK(found == expected_neighbours(mesh, sheet, length));
      CHECK(found == own_neighbours(mesh, sheet.positions(), length, {3}));
      for (const MeshPair& pair : found) kinds.insert(pair.kind);
      all += found.size();

      // What is left are the other pairs within the separation, and these pairs where they touch.
      const FirstContact before = first_contact(mesh, sheet.positions(), sheet.positions()),
                         after = first_contact(touching_alone(mesh, found), sheet.positions(), sheet.positions());
      CHECK(after.at_start.size() + found.size() == before.at_start.size());
      left += after.at_start.size();
    }
  }
  CHECK(all > 100);
  CHECK(left > 100);
  CHECK(kinds.count(Kind::edge_edge) + kinds.count(Kind::vertex_face) == 2);
}

TEST_CASE("a chain of exactly the length is none, and neither is one of another piece") {
  // Edges along the border of a square, from (0, 0) over (4, 0) to (4, 1) and (0, 1), and a wire beside them.
  MeshElements elements;
  elements.vertex_count = 6;
  elements.dimension = 2;
  elements.edges = {{0, 1}, {1, 2}, {2, 3}, {4, 5}};
  elements.separation = {1, Metric::euclidean};
  const std::vector<double> x = {0, 0, 4, 0, 4, 1, 0, 1, 0, -1, 4, -1};
  const Mesh mesh(elements);
  const auto own = [&](double length) { return own_neighbours(mesh, {x, 2}, length, {1}); };
  CHECK(own(1).empty());  // the edges 0-1 and 2-3 are connected by the edge 1-2, of length 1
  // Each end against the other edge: vertex 0 and 3 are 4 + 1 away from the nearest ends 2 and 1 of these, 1 and 2 are
  // 1 away.
  CHECK(own(std::nextafter(1, 2)) == std::vector<MeshPair>{{Kind::point_edge, 1, 2}, {Kind::point_edge, 2, 0}});
  CHECK(own(4).size() == 2);
  CHECK(own(std::nextafter(4, 5)).size() == 2);
  CHECK(own(5).size() == 2);
  CHECK(own(1000).size() == 4);
}

TEST_CASE("own neighbours that touch at the start stay contacts") {
  // A wire in the plane that comes back to its start without a vertex in common.
  MeshElements elements;
  elements.vertex_count = 4;
  elements.dimension = 2;
  elements.edges = {{0, 1}, {1, 2}, {2, 3}};
  elements.separation = {0.125, Metric::euclidean};
  const std::vector<double> x = {0, 0, 2, 0, 1, 1, 1, 0};
  const Mesh mesh(elements);
  const auto pairs = own_neighbours(mesh, {x, 2}, 100, {1});
  CHECK(pairs == std::vector<MeshPair>{{Kind::point_edge, 3, 0}});
  CHECK(first_contact(touching_alone(mesh, pairs), {x, 2}, {x, 2}).at_start.size() == 1);
  const std::atomic<bool> stop = true;
  CHECK_THROWS_AS(own_neighbours(mesh, {x, 2}, 100, {1, &stop}), Stopped);
}
