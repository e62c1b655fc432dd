// The story that `explain` tells: the cubic, the candidates and the signs that decide.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include <touchstone/query.hpp>

#include "exact/exact.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;

TEST_CASE("the story of an ordinary crossing") {
  const Query query(
      EdgeEdge{{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}}, {{{-1, 0, 0}, {1, 0, 0}, {0, -1, -1}, {0, 1, -1}}}});
  const exact::Story story = exact::explain(query, 1);
  CHECK(story.has_cubic);
  // u = (2, 0, 0), w = (0, 2, 0), n = (0, 0, 4), r_z = 1 - 2t: V = 4 - 8t.
  CHECK(story.coefficients == std::vector<std::string>{"4", "-8", "0", "0"});
  REQUIRE(story.candidates.size() == 1);
  const exact::CandidateStory& candidate = story.candidates[0];
  CHECK(candidate.time == "1/2");
  CHECK(candidate.multiplicity == 1);
  CHECK(candidate.touching);
  const auto sign_of = [&](const std::string& name) {
    const auto found = std::find_if(candidate.conditions.begin(), candidate.conditions.end(),
                                    [&](const auto& condition) { return condition.name == name; });
    return found == candidate.conditions.end() ? 9 : found->sign;
  };
  CHECK(sign_of("n_x") == 0);
  CHECK(sign_of("n_z") == 1);
  CHECK(sign_of("(r x w)_z") == 1);
  CHECK(story.answer.contact);
}

TEST_CASE("the story of a planar motion names its candidates and is the decision's") {
  const Query query(
      EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 0, 0}}}, {{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {1, 0, 0}}}});
  const exact::Story story = exact::explain(query, 1);
  CHECK(story.coefficients == std::vector<std::string>{"0", "0", "0", "0"});
  CHECK(story.why.find("identically zero") != std::string::npos);
  REQUIRE(story.candidates.size() >= 2);
  CHECK_FALSE(story.candidates[0].touching);
  CHECK(story.candidates.back().time == "1/2");
  CHECK(story.candidates.back().touching);
  CHECK(story.candidates.back().multiplicity == 0);
}

TEST_CASE("the story of a separation names the pair of features that comes within it") {
  const Query query(
      EdgeEdge{{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}}, {{{-1, 0, 0}, {1, 0, 0}, {0, -1, -2}, {0, 1, -2}}}});
  const exact::Story story = exact::explain(query, 1, Separation{0.25});
  CHECK_FALSE(story.has_cubic);
  REQUIRE(story.polynomials.size() == 1);
  CHECK(story.polynomials[0].name == "a against b");
  // (n . r)^2 - d^2 |n|^2 with n = (0, 0, 4) and r_z = 1 - 3 t: 16 (1 - 3 t)^2 - 1.
  CHECK(story.polynomials[0].coefficients == std::vector<std::string>{"15", "-96", "144", "0", "0", "0", "0"});
  CHECK(story.without_root.size() == 8);
  REQUIRE(story.candidates.size() == 2);
  CHECK(story.candidates[0].time == "0");
  CHECK_FALSE(story.candidates[0].touching);
  CHECK(story.candidates[1].time == "1/4");
  CHECK(story.candidates[1].polynomial == "a against b");
  CHECK(story.candidates[1].conditions.size() == 5);
  CHECK(story.candidates[1].touching);
}

TEST_CASE("the story's answer with a separation is the decision in every family") {
  for (const tests::FamilyInfo& family : tests::all_families()) {
    for (const Kind kind : touchstone::kKinds) {
      for (const Metric metric : {Metric::euclidean, Metric::max}) {
        const tests::CaseId id{family.family, kind, 43, 0};
        const Query query = tests::make(id);
        const Separation separation = {0.25, metric};
        INFO(tests::case_name(id) << ", " << name_of(metric));
        const exact::Story story = exact::explain(query, 1, separation);
        REQUIRE(tests::bit_difference(story.answer, exact::decide_exactly(query, 1, separation), true).empty());
        REQUIRE_FALSE(story.candidates.empty());
        REQUIRE(story.candidates.back().touching == story.answer.contact);
      }
    }
  }
}

TEST_CASE("the story's answer is the decision in every family") {
  for (const tests::FamilyInfo& family : tests::all_families()) {
    for (const Kind kind : touchstone::kKinds) {
      for (std::uint64_t index = 0; index < 20; ++index) {
        const tests::CaseId id{family.family, kind, 41, index};
        const Query query = tests::make(id);
        INFO(tests::case_name(id));
        REQUIRE(tests::bit_difference(exact::explain(query, 1).answer, exact::decide_exactly(query, 1), true).empty());
      }
    }
  }
}
