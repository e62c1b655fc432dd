// The candidate pairs include every pair that touches, and the same options give the same queries.
// SPDX-License-Identifier: MIT
#include "generators/candidates.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "generators/step.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::generators;

namespace {

/// FNV-1a over the bits of every coordinate.
std::uint64_t checksum(const std::vector<Query>& queries) {
  std::uint64_t sum = 0xCBF29CE484222325u;
  const auto add = [&sum](double x) { sum = (sum ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001B3u; };
  for (const Query& query : queries) {
    for (const auto* corners : {&query.start, &query.end}) {
      for (const Vec3& corner : *corners) {
        add(corner.x);
        add(corner.y);
        add(corner.z);
      }
    }
  }
  return sum;
}

CandidateOptions small(SceneName scene) {
  CandidateOptions options;
  options.scene = scene;
  options.edges = 1000;
  options.steps = 4;
  return options;
}

bool same(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Whether a corner of one element is, at both ends, where a corner of the other is.
bool shares_corner(const Query& query) {
  const std::size_t first = query.kind == Kind::edge_edge ? 2 : 1;
  for (std::size_t i = 0; i < first; ++i) {
    for (std::size_t j = first; j < 4; ++j) {
      if (same(query.start[i], query.start[j]) && same(query.end[i], query.end[j])) return true;
    }
  }
  return false;
}

using Pairs = std::set<std::pair<Index, Index>>;

bool share(const Mesh& mesh, Kind kind, Index i, Index j) {
  if (kind == Kind::vertex_face) {
    const auto& f = mesh.faces[j];
    return f[0] == i || f[1] == i || f[2] == i;
  }
  const auto &a = mesh.edges[i], &b = mesh.edges[j];
  return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

/// Every pair of the scene that touches during the step, by asking about all pairs.
Pairs touching_pairs(const Step& step, Kind kind, double separation) {
  const bool edges = kind == Kind::edge_edge;
  const auto firsts = static_cast<Index>(edges ? step.mesh().edges.size() : step.mesh().corner_count);
  const auto seconds = static_cast<Index>(edges ? step.mesh().edges.size() : step.mesh().faces.size());
  Pairs touching;
  for (Index i = 0; i < firsts; ++i) {
    for (Index j = edges ? i + 1 : 0; j < seconds; ++j) {
      if (share(step.mesh(), kind, i, j)) continue;
      if (solve(step.query(kind, i, j), {.separation = Separation{separation}}).contact) touching.emplace(i, j);
    }
  }
  return touching;
}

}  // namespace

TEST_CASE("every contact of a small scene is among the candidates") {
  const SceneName name = GENERATE(SceneName::cloth, SceneName::sheets, SceneName::cables);
  const double speed = GENERATE(1.0, 20.0);
  const double separation = GENERATE(0.0, 0.01);
  CAPTURE(scene_name(name), speed, separation);
  std::size_t contacts = 0;
  for (std::uint64_t seed = 1; seed <= tests::effort(separation == 0 ? 4 : 1); ++seed) {
    Step step(name, seed, separation == 0 ? 150 : 40, speed, separation);
    for (int i = 0; i < 3; ++i) {
      step.advance();
      for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
        Pairs candidates;
        step.for_each_candidate(kind, false, [&](Index a, Index b) {
          CHECK(candidates.emplace(a, b).second);
          CHECK_FALSE(share(step.mesh(), kind, a, b));
        });
        for (const auto& pair : touching_pairs(step, kind, separation)) {
          ++contacts;
          CAPTURE(seed, i, name_of(kind), pair.first, pair.second);
          CHECK(candidates.count(pair) == 1);
        }
      }
    }
  }
  CHECK(contacts > 0);
}

TEST_CASE("the same options give the same queries, bit for bit, on every machine") {
  const auto [name, expected] = GENERATE(std::pair(SceneName::cloth, std::uint64_t{0xB9B7478405441936}),
                                         std::pair(SceneName::sheets, std::uint64_t{0x30FE9AED96F8DF8E}),
                                         std::pair(SceneName::cables, std::uint64_t{0xEFA03AD0B44A379F}));
  CAPTURE(scene_name(name));
  CandidateOptions options = small(name);
  const std::uint64_t sum = checksum(candidates(options));
  CHECK(sum == expected);
  CHECK(checksum(candidates(options)) == sum);
  options.seed = 2;
  CHECK(checksum(candidates(options)) != sum);
  options.seed = 1;
  options.speed = 2;
  CHECK(checksum(candidates(options)) != sum);
}

TEST_CASE("about one candidate in a hundred touches") {
  const SceneName name = GENERATE(SceneName::cloth, SceneName::sheets, SceneName::cables);
  CandidateOptions options;
  options.scene = name;
  options.seed = GENERATE(1u, 2u, 3u);
  options.count = 8000;
  options.vertex_face = has_faces(name);
  std::array<std::size_t, 2> queries{}, contacts{};
  for_each_batch(options, [&](const Batch& batch) {
    const auto kind = static_cast<std::size_t>(batch.kind);
    queries[kind] += batch.queries.size();
    for (const Answer& answer : solve_batch(batch.queries)) contacts[kind] += answer.contact;
  });
  for (std::size_t kind = 0; kind < (has_faces(name) ? 2u : 1u); ++kind) {
    CAPTURE(scene_name(name), options.seed, kind, queries[kind], contacts[kind]);
    CHECK(queries[kind] == options.count);
    CHECK(1000 * contacts[kind] > 3 * queries[kind]);
    CHECK(1000 * contacts[kind] < 40 * queries[kind]);
  }
}

TEST_CASE("a count is kept to, drawn from all steps, and no query comes twice") {
  CandidateOptions options = small(SceneName::sheets);
  options.count = 101;
  std::array<std::set<std::size_t>, 2> steps;
  std::vector<Query> drawn;
  const CandidateCounts counts = for_each_batch(options, [&](const Batch& batch) {
    CHECK(batch.queries.size() <= kBatchQueries);
    steps[static_cast<std::size_t>(batch.kind)].insert(batch.step);
    for (const Query& query : batch.queries) {
      CHECK(query.kind == batch.kind);
      drawn.push_back(query);
    }
  });
  CHECK(counts.edge_edge == 101);
  CHECK(counts.vertex_face == 101);
  CHECK(drawn.size() == 202);
  for (const auto& of_kind : steps) CHECK(of_kind == std::set<std::size_t>{0, 1, 2, 3});
  std::set<std::uint64_t> sums, all_sums;
  for (const Query& query : drawn) sums.insert(checksum({query}));
  CHECK(sums.size() == drawn.size());

  options.count = 0;
  const std::vector<Query> all = candidates(options);
  for (const Query& query : all) all_sums.insert(checksum({query}));
  for (const std::uint64_t sum : sums) CHECK(all_sums.count(sum) == 1);

  options.count = all.size();  // more than there are of either kind
  CHECK(checksum(candidates(options)) == checksum(all));
  options.vertex_face = false;
  for (const Query& query : candidates(options)) CHECK(query.kind == Kind::edge_edge);
  options.edge_edge = false;
  CHECK(candidates(options).empty());
}

TEST_CASE("batches are bounded") {
  CandidateOptions options;
  options.scene = SceneName::sheets;
  options.steps = 1;
  std::size_t batches = 0;
  for_each_batch(options, [&](const Batch& batch) {
    ++batches;
    CHECK(batch.queries.size() <= kBatchQueries);
    CHECK_FALSE(batch.queries.empty());
  });
  CHECK(batches > 2);
}

TEST_CASE("pairs that share a corner come only when they are asked for, and touch from the start") {
  const SceneName name = GENERATE(SceneName::cloth, SceneName::sheets, SceneName::cables);
  CandidateOptions options = small(name);
  options.steps = 1;
  for (const Query& query : candidates(options)) CHECK_FALSE(shares_corner(query));
  options.shared_corners = true;
  std::array<std::size_t, 2> shared{};
  for (const Query& query : candidates(options)) {
    if (!shares_corner(query)) continue;
    ++shared[static_cast<std::size_t>(query.kind)];
    const Answer answer = solve(query);
    CHECK(answer.contact);
    CHECK(answer.toi == 0);
  }
  CHECK(shared[0] > 0);
  CHECK((shared[1] > 0) == has_faces(name));
}

TEST_CASE("a scene that stands still has candidates that stand still") {
  CandidateOptions options = small(SceneName::sheets);
  options.speed = 0;
  const std::vector<Query> queries = candidates(options);
  CHECK_FALSE(queries.empty());
  for (const Query& query : queries) {
    for (std::size_t i = 0; i < 4; ++i) CHECK(same(query.start[i], query.end[i]));
  }
}

TEST_CASE("options outside their ranges are refused") {
  const auto refused = [](auto change) {
    CandidateOptions options = small(SceneName::cloth);
    change(options);
    CHECK_THROWS_AS(candidates(options), InvalidQuery);
  };
  refused([](CandidateOptions& o) { o.edges = 99; });
  refused([](CandidateOptions& o) { o.edges = kMostEdges + 1; });
  refused([](CandidateOptions& o) { o.speed = -1; });
  refused([](CandidateOptions& o) { o.speed = 1001; });
  refused([](CandidateOptions& o) { o.speed = std::numeric_limits<double>::quiet_NaN(); });
}
