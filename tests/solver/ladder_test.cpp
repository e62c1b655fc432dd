// The ladder: each rung decides some queries, tells the answer of `solve`, and is what the design page says.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "solver/ladder.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

namespace touchstone::tests {
namespace {

using solver::kLadder;

/// The cells of the rows of the page's table of rungs.
std::vector<std::vector<std::string>> rows_of_page() {
  std::ifstream page(TOUCHSTONE_SOURCE_DIR "/docs/design.md");
  std::vector<std::vector<std::string>> rows;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line == "| rung | name | applies to | proves | level |") {
      inside = true;
    } else if (inside && (line.empty() || line[0] != '|')) {
      return rows;
    } else if (inside && line.rfind("|--", 0) != 0) {
      std::vector<std::string> cells;
      for (std::size_t at = 2, end = 0; (end = line.find(" |", at)) != std::string::npos; at = end + 3) {
        cells.push_back(line.substr(at, end - at));
      }
      rows.push_back(cells);
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("the ladder on the design page is the solver's") {
  const auto rows = rows_of_page();
  REQUIRE(rows.size() == kLadder.size());
  for (std::size_t i = 0; i < kLadder.size(); ++i) {
    const auto& rung = kLadder[i];
    const std::vector<std::string> expected = {std::to_string(i + 1), std::string(rung.name), std::string(rung.applies),
                                               std::string(rung.proves), std::string(name_of(rung.level))};
    CHECK(rows[i] == expected);
  }
}

TEST_CASE("each rung of the ladder decides some queries, at its level, with the answer of solve") {
  std::array<std::size_t, kLadder.size()> tally{};
  const auto ask = [&](Family family, Kind kind, std::uint64_t index) {
    const Query query = make(CaseId{family, kind, 5, index});
    const double t_max = index % 4 == 0 ? 0.5 : 1;
    const auto [answer, rung] = solver::answer_and_rung(query, t_max);
    REQUIRE(rung < kLadder.size());
    ++tally[rung];
    INFO(case_name({family, kind, 5, index}) << ": " << kLadder[rung].name);
    if (kLadder[rung].name != "rescaled") REQUIRE(answer.level == kLadder[rung].level);
    if (kLadder[rung].proves == "no contact") REQUIRE_FALSE(answer.contact);
    const Answer expected = solve(query, t_max);
    REQUIRE(answer.level == expected.level);
    REQUIRE(decision_difference(answer, expected) == "");
    REQUIRE(weight_difference(answer, expected) == "");
  };
  for (const FamilyInfo& one : all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < 20; ++index) ask(one.family, kind, index);
    }
  }
  // A doubt at few bits is rare.
  for (std::uint64_t index = 0; index < 4000; ++index) {
    ask(Family::grazing_apart, Kind::point_edge, index);
    ask(Family::extreme_time, Kind::vertex_face, index);
  }
  CAPTURE(tally);
  for (std::size_t i = 0; i < kLadder.size(); ++i) {
    INFO(kLadder[i].name);
    CHECK(tally[i] > 0);
  }
}

}  // namespace touchstone::tests
