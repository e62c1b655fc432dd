// Queries from bytes: every query can be made, and random bytes often make the degenerate ones.
// SPDX-License-Identifier: MIT
#include "query_bytes.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "families/families.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::fuzzing;

namespace {

Bytes bytes_of(const std::string& text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

}  // namespace

TEST_CASE("the bytes for a query make that query, bit for bit") {
  std::size_t longest = 0;
  for (const auto& family : families::all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t i = 0; i < 20; ++i) {
        const Query query = families::make({family.family, kind, 77, i});
        const std::string bytes = bytes_for(query);
        longest = std::max(longest, bytes.size());
        const Question question = question_from(bytes_of(bytes));
        CAPTURE(family.name, name_of(kind), i);
        REQUIRE(question.query.kind == kind);
        REQUIRE(question.t_max == 1);
        for (std::size_t k = 0; k < corner_count(kind); ++k) {
          REQUIRE(std::memcmp(&question.query.start[k], &query.start[k], sizeof(Vec3)) == 0);
          REQUIRE(std::memcmp(&question.query.end[k], &query.end[k], sizeof(Vec3)) == 0);
        }
      }
    }
  }
  CHECK(longest <= 256);
}

TEST_CASE("random bytes make finite queries, of every kind and nature and decided by every level") {
  seeded::Rng rng(5);
  std::map<std::pair<Kind, Nature>, int> natures;
  std::map<Level, int> levels;
  std::set<double> ends;
  constexpr int kInputs = 40000;
  for (int i = 0; i < kInputs; ++i) {
    std::string bytes(static_cast<std::size_t>(rng.between(0, 120)), '\0');
    for (char& byte : bytes) byte = static_cast<char>(rng.bits() & (rng.one_in(3) ? 0xff : 0x7f));
    const Question question = question_from(bytes_of(bytes));
    for (std::size_t k = 0; k < corner_count(question.query.kind); ++k) {
      for (const Vec3& c : {question.query.start[k], question.query.end[k]}) {
        REQUIRE((std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z)));
      }
    }
    REQUIRE((question.t_max >= 0 && question.t_max <= 1));
    ends.insert(question.t_max);
    const Answer answer = solve(question.query, question.t_max);
    ++natures[{question.query.kind, answer.nature}];
    ++levels[answer.level];
  }
  for (const Kind kind : kKinds) {
    for (const Nature nature : {Nature::none, Nature::crossing, Nature::grazing, Nature::sustained, Nature::isolated}) {
      const bool has_cubic = kind == Kind::edge_edge || kind == Kind::vertex_face;
      if (!has_cubic && (nature == Nature::crossing || nature == Nature::grazing)) continue;
      const int count = natures[{kind, nature}];
      std::printf("%s %s: %d of %d\n", std::string(name_of(kind)).c_str(), std::string(name_of(nature)).c_str(), count,
                  kInputs);
      CHECK(count >= 5);
    }
  }
  CHECK(levels[Level::filter] > 1000);
  CHECK(levels[Level::bracket] > 10);
  CHECK(levels[Level::exact] > 1000);
  CHECK(ends.size() > 100);
}
