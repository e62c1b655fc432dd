// Failures of one kind are one finding, in whatever order they come.
// SPDX-License-Identifier: MIT
#include "fuzz/judging/findings.hpp"

#include <touchstone/solve.hpp>

#include "fuzz/shrinking/simplicity.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using families::Family;
using fuzz::FailureClass;

namespace {

struct Failing {
  fuzz::CaseName name;
  FailureClass failure;
};

void add(fuzz::Findings& findings, const Failing& failing) {
  const Query query = fuzz::query_of_case(failing.name);
  findings.add({failing.failure, ""}, failing.name, {query, {}}, {}, solve(query));
}

std::vector<Failing> some_failures() {
  std::vector<Failing> all;
  for (const Family family : {Family::lattice1, Family::planar_axis, Family::near_hit}) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      all.push_back({{{family, Kind::edge_edge, 1, i}, 0}, i % 5 == 0 ? FailureClass::late : FailureClass::missed});
    }
  }
  return all;
}

std::string text_of(std::vector<fuzz::Finding> findings) {
  std::string text;
  for (const auto& finding : findings) {
    text += std::string(name_of(finding.failure)) + " " + fuzz::degeneracy_text(finding.degeneracy) + " " +
            std::to_string(finding.count) + " " + fuzz::case_text(finding.example.name) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("the simplest example is kept, in whatever order failures come and parts are merged") {
  const std::vector<Failing> failures = some_failures();
  fuzz::Findings forwards, backwards, left, right;
  for (const Failing& failing : failures) add(forwards, failing);
  for (auto failing = failures.rbegin(); failing != failures.rend(); ++failing) add(backwards, *failing);
  for (std::size_t i = 0; i < failures.size(); ++i) add(i % 2 == 0 ? left : right, failures[i]);
  right.merge(std::move(left));
  const std::string text = text_of(forwards.take(0));
  CHECK(text == text_of(backwards.take(0)));
  CHECK(text == text_of(right.take(0)));
  CHECK(text.find("missed") < text.find("late"));
}

TEST_CASE("one finding for each class and kind of degeneracy, with all that failed counted") {
  fuzz::Findings findings;
  for (const Failing& failing : some_failures()) add(findings, failing);
  const std::size_t size = findings.size();
  const auto taken = findings.take(0);
  CHECK(taken.size() == size);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    count += taken[i].count;
    CHECK(taken[i].example.difficulty == fuzz::difficulty(std::get<Query>(taken[i].example.query)));
    for (std::size_t j = 0; j < i; ++j) {
      CHECK((taken[i].failure != taken[j].failure || taken[i].degeneracy != taken[j].degeneracy));
    }
  }
  CHECK(count == 300);
}

TEST_CASE("where only some are wanted every class has its share") {
  fuzz::Findings findings;
  for (const Failing& failing : some_failures()) add(findings, failing);
  const auto taken = findings.take(6);
  REQUIRE(taken.size() == 6);
  CHECK(taken[0].failure == FailureClass::missed);
  CHECK(taken[2].failure == FailureClass::missed);
  CHECK(taken[3].failure == FailureClass::late);
  CHECK(taken[0].count >= taken[1].count);
  CHECK(findings.size() == 0);
}
