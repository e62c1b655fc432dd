// The oracle called from several threads at once, and the floating-point environment after a call.
// SPDX-License-Identifier: MIT
#include <cfenv>
#include <thread>
#include <vector>

#include "oracle/expected.hpp"
#include "support/answer_check.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

std::vector<Query> mixed_queries() {
  std::vector<Query> queries;
  for (const Family family :
       {Family::lattice2, Family::planar_general, Family::grazing_merged, Family::random_doubles}) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < 12; ++index) queries.push_back(make(CaseId{family, kind, 7, index}));
    }
  }
  return queries;
}

}  // namespace

TEST_CASE("answers are the same from four threads at once") {
  const std::vector<Query> queries = mixed_queries();
  std::vector<Answer> alone;
  std::size_t contacts = 0;
  for (const Query& query : queries) {
    alone.push_back(oracle::decide_by_oracle(query, 1));
    contacts += alone.back().contact ? 1 : 0;
  }
  CHECK(contacts > 20);
  CHECK(contacts < queries.size());

  std::vector<std::vector<Answer>> together(4, std::vector<Answer>(queries.size()));
  std::vector<std::thread> threads;
  for (auto& answers : together) {
    threads.emplace_back([&queries, &answers] {
      for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = oracle::decide_by_oracle(queries[i], 1);
    });
  }
  for (auto& thread : threads) thread.join();
  for (const auto& answers : together) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      INFO(cpp_initializer(queries[i]));
      CHECK(bit_difference(alone[i], answers[i], true) == "");
    }
  }
}

TEST_CASE("the rounding mode is left as it was") {
  for (const Query& query : mixed_queries()) {
    oracle::decide_by_oracle(query, 1);
    REQUIRE(std::fegetround() == FE_TONEAREST);
  }
}
