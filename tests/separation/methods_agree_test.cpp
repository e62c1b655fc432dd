// The cascade against the exact level against the oracle, in everything that an answer with a separation says.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include <touchstone/solve.hpp>

#include "separation/distances.hpp"
#include "solver/owned_columns.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

std::string against(const char* names, const Answer& one, const Answer& other) {
  std::string difference = decision_difference(one, other);
  if (difference.empty()) difference = weight_difference(one, other);
  if (difference.empty()) return "";
  return std::string(names) + ": " + difference + "\n    " + describe(one) + "\n    " + describe(other);
}

void methods_agree(Metric metric, std::size_t count) {
  Report report;
  std::size_t contacts = 0;
  const auto all = [](const FamilyInfo&, Kind) { return true; };
  for_each_case(11, count, all, [&](const CaseId& id) {
    Rng rng = rng_of(id);
    const Query query = make_sample(id.family, id.kind, rng).query;
    const Separation separation = {interesting_distance(query, metric, rng), metric};
    const double t_max = rng.one_in(4) ? rng.unit() : 1;
    const Answer fast = solve(query, {.t_max = t_max, .separation = separation, .method = Method::fast});
    const Answer exact = solve(query, {.t_max = t_max, .separation = separation, .method = Method::exact});
    const Answer oracle = solve(query, {.t_max = t_max, .separation = separation, .method = Method::oracle});
    contacts += exact.contact;
    std::string wrong = against("fast and exact", fast, exact);
    if (wrong.empty()) wrong = against("exact and oracle", exact, oracle);
    if (wrong.empty()) wrong = malformation(query.kind, exact, t_max);
    if (wrong.empty() &&
        solve(query, {.t_max = t_max, .separation = separation, .wanted = Wanted::contact}).contact != exact.contact)
      wrong = "the contact alone differs";
    report.add(id, query, wrong.empty() ? "" : "separation " + hexfloat(separation.distance) + ": " + wrong);
  });
  std::printf("%s: %zu queries by fast, exact and oracle, %zu contacts\n", std::string(name_of(metric)).c_str(),
              report.checked(), contacts);
  report.finish();
}

/// Batches, in columns and one by one, with one separation for all or one for each.
void batches_agree(Metric metric) {
  for (const Kind kind : kKinds) {
    std::vector<Query> queries;
    std::vector<double> distances;
    Rng rng(5);
    for (const FamilyInfo& family : all_families()) {
      for (int i = 0; i < 5; ++i) {
        queries.push_back(make(family.family, kind, rng));
        distances.push_back(rng.one_in(8) ? 0 : interesting_distance(queries.back(), metric, rng));
      }
    }
    const solver::OwnedColumns columns(queries);
    BatchOptions options;
    options.separation.metric = metric;
    options.separations = distances.data();
    options.separation_count = distances.size();
    for (const VectorWidth width :
         {VectorWidth::widest, VectorWidth::none, VectorWidth::bits_128, VectorWidth::bits_256}) {
      if (!has_vectors(width)) continue;
      options.vectors = width;
      const std::vector<Answer> in_columns = solve_batch(columns.view(), options);
      const std::vector<Answer> one_by_one = solve_batch(queries, options);
      for (std::size_t i = 0; i < queries.size(); ++i) {
        const Answer alone = solve(queries[i], {.separation = Separation{distances[i], metric}});
        REQUIRE(bit_difference(in_columns[i], alone, true).empty());
        REQUIRE(bit_difference(one_by_one[i], alone, true).empty());
      }
    }
    options.separations = nullptr;
    options.separation_count = 0;
    options.separation.distance = 0.25;
    const std::vector<Answer> answers = solve_batch(columns.view(), options);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      REQUIRE(bit_difference(answers[i], solve(queries[i], {.separation = options.separation}), true).empty());
    }
  }
}

}  // namespace

TEST_CASE("batches give the answers of single queries, with one separation or a column of them", "[slow]") {
  batches_agree(Metric::euclidean);
  batches_agree(Metric::max);
}
TEST_CASE("methods agree on Euclidean separations") { methods_agree(Metric::euclidean, 8); }
TEST_CASE("methods agree on largest-axis separations") { methods_agree(Metric::max, 4); }

}  // namespace touchstone::tests
