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

TEST_CASE("the story's answer is the decision in every family") {
  for (const tests::FamilyInfo& family : tests::all_families()) {
    for (const Kind kind : tests::kKinds) {
      for (std::uint64_t index = 0; index < 20; ++index) {
        const tests::CaseId id{family.family, kind, 41, index};
        const Query query = tests::make(id);
        INFO(tests::case_name(id));
        REQUIRE(tests::bit_difference(exact::explain(query, 1).answer, exact::decide_exactly(query, 1), true).empty());
      }
    }
  }
}
