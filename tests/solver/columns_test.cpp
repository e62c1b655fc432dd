// A batch in columns gives the answers of `solve` bit for bit, whatever the sizes of the coordinates are.
// SPDX-License-Identifier: MIT
#include <touchstone/solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "solver/owned_columns.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::array<VectorWidth, 5> kWidths = {VectorWidth::none, VectorWidth::bits_128, VectorWidth::bits_256,
                                                VectorWidth::bits_512, VectorWidth::widest};
constexpr std::array<Wanted, 4> kEachWanted = {Wanted::contact, Wanted::time, Wanted::features, Wanted::all};
constexpr std::uint64_t kOfEach = 60;

/// Multiplies axis k by 2^exponents[k].
void scale(Query& query, const std::array<int, 3>& exponents) {
  for (auto* corners : {&query.start, &query.end}) {
    for (Vec3& c : *corners) {
      c = {std::ldexp(c.x, exponents[0]), std::ldexp(c.y, exponents[1]), std::ldexp(c.z, exponents[2])};
    }
  }
}

/// Queries of every family of scales, and ordinary contacts and misses of other scales, in an order of its own. So
/// neighbours in a block are of different sizes.
std::vector<Query> queries_of_every_scale(Kind kind) {
  constexpr std::uint64_t kSeed = 95;
  std::vector<Query> queries;
  for (const FamilyInfo& family : all_families()) {
    if (family.group != Group::scale) continue;
    for (std::uint64_t index = 0; index < kOfEach; ++index) {
      queries.push_back(make(CaseId{family.family, kind, kSeed, index}));
    }
  }
  Rng rng(kSeed);
  for (const Family family : {Family::simulation, Family::prescribed, Family::near_hit, Family::beside_ends}) {
    for (const int most : {0, 40, 300, 1000}) {  // the largest magnitude of an exponent
      for (std::uint64_t index = 0; index < kOfEach; ++index) {
        Query query = make(CaseId{family, kind, kSeed, index});
        std::array<int, 3> exponents{};
        for (int& e : exponents) e = static_cast<int>(rng.below(2 * static_cast<std::uint64_t>(most) + 1)) - most;
        if (index % 3 == 0) exponents[1] = exponents[2] = exponents[0];  // the same for all axes
        scale(query, exponents);
        queries.push_back(query);
      }
    }
  }
  for (std::size_t i = queries.size(); i > 1; --i) std::swap(queries[i - 1], queries[rng.below(i)]);
  return queries;
}

/// `count` of the queries, from `first` on.
QueryColumns part(const QueryColumns& all, std::size_t first, std::size_t count) {
  QueryColumns result = all;
  result.count = count;
  for (std::size_t i = 0; i < corner_count(all.kind); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.start[i][k] += first;
      result.end[i][k] += first;
    }
  }
  return result;
}

/// Asks for all the queries at once where `most` is 0, and otherwise for 1, 2, ..., `most`, 1, ... of them at a time.
std::vector<Answer> in_columns(const QueryColumns& all, const BatchOptions& options, std::size_t most) {
  if (most == 0) return solve_batch(all, options);
  std::vector<Answer> answers(all.count);
  std::size_t size = 1;
  for (std::size_t first = 0; first < all.count; first += size, size = size % most + 1) {
    solve_batch(part(all, first, std::min(size, all.count - first)), answers.data() + first, options);
  }
  return answers;
}

}  // namespace

TEST_CASE("a batch in columns answers queries of every scale as solve does, bit for bit", "[slow]") {
  std::size_t compared = 0;
  for (const Kind kind : kKinds) {
    const std::vector<Query> queries = queries_of_every_scale(kind);
    const solver::OwnedColumns columns(queries);
    for (const double t_max : {1.0, 0.4375, 0.0}) {
      for (const Wanted wanted : kEachWanted) {
        std::vector<Answer> singles;
        std::size_t contacts = 0;
        for (const Query& query : queries) {
          singles.push_back(solve(query, {.t_max = t_max, .wanted = wanted}));
          contacts += singles.back().contact;
        }
        CHECK(contacts > 50);
        const LevelCounts levels = count_levels(singles);
        if (kind == Kind::edge_edge || kind == Kind::vertex_face) {
          CHECK(levels.filter > 100);
          CHECK(levels.bracket > (t_max == 0 ? 20u : 100u));
          CHECK(levels.exact > 0);
        }
        for (const VectorWidth width : kWidths) {
          if (!has_vectors(width)) {
            WARN("this machine has no vectors of width " << static_cast<int>(width) << ": left out");
            continue;
          }
          BatchOptions options;
          options.t_max = t_max;
          options.vectors = width;
          options.wanted = wanted;
          for (const std::size_t most : {0u, 40u}) {
            const std::vector<Answer> answers = in_columns(columns.view(), options, most);
            for (std::size_t i = 0; i < queries.size(); ++i) {
              const std::string difference = bit_difference(singles[i], answers[i], true);
              ++compared;
              if (difference.empty()) continue;
              INFO("width " << static_cast<int>(width) << ", wanted " << static_cast<int>(wanted) << ", t_max " << t_max
                            << ", at most " << most << "\n"
                            << cpp_initializer(queries[i]));
              REQUIRE(difference == "");
            }
          }
        }
      }
    }
  }
  CHECK(compared > 100000);
}
