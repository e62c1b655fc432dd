// A batch gives the answers of its queries one by one, for any number of threads, and the same ones again.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "solver/owned_columns.hpp"
#include "support/answer_check.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 16;

struct Batch {
  std::vector<CaseId> ids;
  std::vector<Query> queries;
};

Batch mixed_batch(std::size_t count) {
  Batch batch;
  for_each_case(
      kSeed, count, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        batch.ids.push_back(id);
        batch.queries.push_back(make(id));
      });
  return batch;
}

// Answers that no solver gives, so that one that is not written shows.
std::vector<Answer> poisoned(std::size_t count) {
  Answer poison;
  poison.toi = poison.toi_upper = std::numeric_limits<double>::quiet_NaN();
  poison.weights_a = {-1, -1, -1};
  poison.weights_b = {-1, -1, -1};
  poison.nature = Nature::grazing;
  poison.feature_a = Feature::overlap;
  return std::vector<Answer>(count, poison);
}

void check_batch(const Batch& batch, Method method, double t_max) {
  Report report;
  std::vector<Answer> singles;
  for (const Query& query : batch.queries) singles.push_back(solve(query, {.t_max = t_max, .method = method}));
  for (const int threads : {1, 2, 3, 8, 0}) {
    const BatchOptions options{{.t_max = t_max, .method = method}, threads};
    const std::vector<Answer> returned = solve_batch(batch.queries, options);
    std::vector<Answer> written = poisoned(batch.queries.size() + 1);
    solve_batch(batch.queries.data(), batch.queries.size(), written.data(), options);
    REQUIRE(returned.size() == batch.queries.size());
    for (std::size_t i = 0; i < batch.queries.size(); ++i) {
      std::string wrong = bit_difference(singles[i], returned[i], true);
      if (wrong.empty()) wrong = bit_difference(singles[i], written[i], true);
      if (!wrong.empty()) wrong = std::to_string(threads) + " threads: " + wrong;
      report.add(batch.ids[i], batch.queries[i], wrong);
    }
    CHECK(written.back().weights_a[0] == -1);  // nothing past the end
    const LevelCounts counts = count_levels(returned);
    CHECK(counts.filter + counts.bracket + counts.exact + counts.oracle == batch.queries.size());
  }
  report.finish();
}

TEST_CASE("law: a batch by Method::fast is its queries one by one, for any number of threads") {
  check_batch(mixed_batch(40), Method::fast, 1);
  check_batch(mixed_batch(5), Method::fast, 0.375);
}
TEST_CASE("law: a batch by Method::exact is its queries one by one, for any number of threads") {
  check_batch(mixed_batch(20), Method::exact, 1);
}
TEST_CASE("law: a batch by Method::oracle is its queries one by one, for any number of threads") {
  check_batch(mixed_batch(3), Method::oracle, 1);
}
TEST_CASE("law: a batch by Method::fast_cgal is its queries one by one, for any number of threads") {
  check_batch(mixed_batch(5), Method::fast_cgal, 1);
  check_batch(mixed_batch(3), Method::fast_cgal, 0.375);
}

TEST_CASE("law: a batch in columns is its queries one by one, for vectors of any width and any number of threads") {
  Report report;
  for (const Kind kind : kKinds) {
    std::vector<CaseId> ids;
    std::vector<Query> queries;
    for_each_case(
        kSeed, 30, [kind](const FamilyInfo&, Kind k) { return k == kind; },
        [&](const CaseId& id) {
          ids.push_back(id);
          queries.push_back(make(id));
        });
    if (queries.empty()) continue;  // one case of another kind was chosen
    const solver::OwnedColumns columns(queries);
    for (const double t_max : {1.0, 0.375}) {
      std::vector<Answer> singles;
      for (const Query& query : queries) singles.push_back(solve(query, t_max));
      for (const VectorWidth width : {VectorWidth::none, VectorWidth::bits_128, VectorWidth::bits_256,
                                      VectorWidth::bits_512, VectorWidth::widest}) {
        if (!has_vectors(width)) {
          WARN("this machine has no vectors of width " << static_cast<int>(width) << ": left out");
          CHECK_THROWS_AS(solve_batch(columns.view(), BatchOptions{{.t_max = t_max}, 1, width}), InvalidQuery);
          continue;
        }
        for (const int threads : {1, 2, 0}) {
          const BatchOptions options{{.t_max = t_max}, threads, width};
          std::vector<Answer> answers = poisoned(queries.size() + 1);
          solve_batch(columns.view(), answers.data(), options);
          for (std::size_t i = 0; i < queries.size(); ++i) {
            report.add(ids[i], queries[i], bit_difference(singles[i], answers[i], true));
          }
          CHECK(answers.back().weights_a[0] == -1);  // nothing past the end
        }
      }
    }
  }
  report.finish();
}

TEST_CASE("law: columns by every method, and of any length") {
  std::vector<Query> queries;
  for (std::uint64_t index = 0; index < 70; ++index)
    queries.push_back(make({Family::prescribed, Kind::edge_edge, kSeed, index}));
  for (std::size_t count = 0; count <= queries.size(); ++count) {
    const solver::OwnedColumns columns(std::vector<Query>(queries.begin(), queries.begin() + static_cast<long>(count)));
    const std::vector<Answer> answers = solve_batch(columns.view());
    REQUIRE(answers.size() == count);
    for (std::size_t i = 0; i < count; ++i) REQUIRE(bit_difference(solve(queries[i]), answers[i], true) == "");
  }
  for (std::uint64_t index = 0; index < 30; ++index)  // of these the kernel proves some
    queries.push_back(make({Family::simulation, Kind::edge_edge, kSeed, index}));
  const solver::OwnedColumns columns(queries);
  for (const Method method : {Method::exact, Method::oracle, Method::fast_cgal}) {
    const std::vector<Answer> answers = solve_batch(columns.view(), BatchOptions{{.method = method}, 2});
    for (std::size_t i = 0; i < queries.size(); i += 10) {
      CHECK(bit_difference(solve(queries[i], {.method = method}), answers[i], true) == "");
    }
  }
}

TEST_CASE("law: a coordinate that is not finite is named in a batch of either form") {
  std::vector<Query> queries;
  for (std::uint64_t index = 0; index < 200; ++index)
    queries.push_back(make({Family::simulation, Kind::vertex_face, kSeed, index}));
  queries[171].end[2].y = std::numeric_limits<double>::infinity();
  queries[130].start[3].z = std::numeric_limits<double>::quiet_NaN();
  const std::string expected =
      "query 130: vertex-face query: corner f2 at t = 0 has z = nan; coordinates must be finite";
  const solver::OwnedColumns columns(queries);
  for (const int threads : {1, 2, 8}) {
    const BatchOptions options{{}, threads};
    for (int round = 0; round < 20; ++round) {
      const auto message = [](const auto& ask) -> std::string {
        try {
          ask();
        } catch (const InvalidQuery& error) {
          return error.what();
        }
        return "nothing was thrown";
      };
      CHECK(message([&] { solve_batch(columns.view(), options); }) == expected);
      CHECK(message([&] { solve_batch(queries, options); }) == expected);
    }
  }
}

TEST_CASE("law: a batch of any length") {
  const Batch batch = mixed_batch(1);
  for (const std::size_t count : {0u, 1u, 2u, 7u}) {
    for (const int threads : {1, 2, 8}) {
      const std::size_t available = std::min<std::size_t>(count, batch.queries.size());
      const std::vector<Query> queries(batch.queries.begin(), batch.queries.begin() + static_cast<long>(available));
      CHECK(solve_batch(queries, BatchOptions{{}, threads}).size() == available);
    }
  }
  solve_batch(static_cast<const Query*>(nullptr), 0, nullptr);
}

TEST_CASE("law: the typed overloads ask the same question") {
  Report report;
  for_each_case(
      kSeed, 50, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const auto& s = query.start;
        const auto& e = query.end;
        Answer typed;
        switch (query.kind) {
          case Kind::edge_edge: typed = solve(EdgeEdge{s, e}, 0.75); break;
          case Kind::vertex_face: typed = solve(VertexFace{s, e}, 0.75); break;
          case Kind::point_edge: typed = solve(PointEdge{{s[0], s[1], s[2]}, {e[0], e[1], e[2]}}, 0.75); break;
          case Kind::point_point: typed = solve(PointPoint{{s[0], s[1]}, {e[0], e[1]}}, 0.75); break;
        }
        std::string wrong = bit_difference(solve(query, 0.75), typed, true);
        if (wrong.empty()) wrong = bit_difference(solve(query, {.t_max = 0.75, .method = Method::fast}), typed, true);
        report.add(id, query, wrong);
      });
  report.finish();
}

TEST_CASE("law: corners that a kind does not have are never read") {
  Report report;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for_each_case(
      kSeed, 50, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        Query noisy = query;
        for (std::size_t i = corner_count(query.kind); i < 4; ++i) noisy.start[i] = noisy.end[i] = {kNan, kNan, kNan};
        std::string wrong;
        for (const Method method : {Method::fast, Method::exact, Method::oracle, Method::fast_cgal}) {
          if ((method == Method::oracle || method == Method::fast_cgal) && id.index >= 5) continue;
          if (wrong.empty())
            wrong = bit_difference(solve(query, {.method = method}), solve(noisy, {.method = method}), true);
        }
        report.add(id, query, wrong);
      });
  report.finish();
}

TEST_CASE("law: asking again gives the same bits") {
  const Batch batch = mixed_batch(10);
  const std::vector<Answer> first = solve_batch(batch.queries);
  Report report;
  for (std::size_t i = batch.queries.size(); i-- > 0;) {  // in another order
    report.add(batch.ids[i], batch.queries[i], bit_difference(first[i], solve(batch.queries[i]), true));
  }
  report.finish();
}

}  // namespace
}  // namespace touchstone::tests
