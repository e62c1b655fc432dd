// The bracket level over several queries at a time finds the same as over one, bit for bit, in every SIMD width, in
// every lane and for every number of queries.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "exact/exact.hpp"
#include "filters/bernstein_cubic.hpp"
#include "filters/boxes.hpp"
#include "filters/bracket.hpp"
#include "filters/bracket_columns.hpp"
#include "filters/filters.hpp"
#include "filters/root_sides.hpp"
#include "solver/owned_columns.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using filters::BernsteinCubic;
using filters::BracketedRoots;
using filters::kMostBracketed;

namespace {

constexpr VectorWidth kWidths[] = {VectorWidth::bits_128, VectorWidth::bits_256, VectorWidth::bits_512,
                                   VectorWidth::widest};

std::vector<Query> queries_of_every_family(Kind kind, std::uint64_t of_each) {
  std::vector<Query> queries;
  for (const FamilyInfo& family : all_families()) {
    for (std::uint64_t index = 0; index < of_each; ++index)
      queries.push_back(make(CaseId{family.family, kind, 91, index}));
  }
  // Most families are degenerate. These have ordinary contacts and near misses, too.
  for (const Family family : {Family::simulation, Family::prescribed, Family::near_hit}) {
    for (std::uint64_t index = 0; index < 12 * of_each; ++index)
      queries.push_back(make(CaseId{family, kind, 94, index}));
  }
  // Boxes are seldom disjoint where V has a root: here the second element is far away.
  for (std::uint64_t index = 0; index < of_each; ++index) {
    Query query = make(CaseId{Family::simulation, kind, 92, index});
    for (std::size_t i = filters::corners_of_first(kind); i < 4; ++i) {
      query.start[i].x += 100;
      query.end[i].x += 100;
    }
    queries.push_back(query);
  }
  return queries;
}

filters::Columns columns_of(const QueryColumns& queries) {
  filters::Columns columns;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      columns.start[i][k] = queries.start[i][k];
      columns.end[i][k] = queries.end[i][k];
    }
  }
  return columns;
}

/// The facts of one query, and its root, by the steps that take one query.
struct Expected {
  std::int64_t facts = 0;
  filters::SimpleRoot root{};
};

Expected one_by_one(const Query& query, double t_max) {
  const auto frame = filters::frame_of(query);
  const filters::Magnitudes m = filters::magnitudes_of(frame);
  if (!filters::within_range(m)) return {};
  const BernsteinCubic cubic(filters::coplanarity_coefficients(frame), m.u * m.w * m.r);
  if (cubic.variations(0, 1) != BernsteinCubic::Variations::one) return {};
  if (filters::boxes_disjoint(query)) return {filters::kBoxesDisjoint, {}};
  const BernsteinCubic::Root root = cubic.root_between(0, 1);
  if (!root.certain) return {};
  const bool edges = query.kind == Kind::edge_edge;
  const auto time = filters::time_of<double>(root, t_max);
  const auto values = filters::side_values(edges, frame, m, root.t, root.radius);
  const auto sides = filters::sides_of(edges, values);
  if (time.outside || sides.outside) return {filters::kNoContactAtRoot, {}};
  if (sides.unknown) return {};
  return {filters::kOneRoot | (sides.inside ? filters::kInsideElements : 0) | (time.inside ? filters::kInsideStep : 0),
          {root.t, root.radius, root.slope, cubic.slope_error(), cubic.curvature(), m, values.axis, sides.inside}};
}

bool same_bits(const filters::SimpleRoot& a, const filters::SimpleRoot& b) {
  const auto bits = [](const filters::SimpleRoot& r) {
    return std::vector<double>{r.t,         r.radius,       r.slope,        r.slope_error,
                               r.curvature, r.magnitudes.u, r.magnitudes.w, r.magnitudes.r};
  };
  const std::vector<double> x = bits(a), y = bits(b);
  return std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0 && a.axis == b.axis && a.inside == b.inside;
}

void poison(BracketedRoots& roots) { std::memset(&roots, 0x55, sizeof roots); }

}  // namespace

TEST_CASE("the bracket level in vectors of every width is the bracket level one by one") {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    const std::vector<Query> queries = queries_of_every_family(kind, 32);
    const solver::OwnedColumns owned(queries);
    const filters::Columns columns = columns_of(owned.view());
    for (const double t_max : {1.0, 0.4375, 0.0}) {
      std::vector<Expected> expected;
      std::size_t seen[32] = {};
      for (const Query& query : queries) {
        expected.push_back(one_by_one(query, t_max));
        ++seen[expected.back().facts];
      }
      CHECK(seen[0] > 100);
      CHECK(seen[filters::kBoxesDisjoint] > 0);
      CHECK(seen[filters::kNoContactAtRoot] > 20);
      const std::size_t certain = seen[filters::kOneRoot | filters::kInsideElements | filters::kInsideStep];
      CAPTURE(t_max, certain);
      CHECK((t_max == 0 ? certain == 0 : certain > 40));
      for (const VectorWidth width : kWidths) {
        const auto kernel = filters::bracket_kernel(kind, width);
        if (kernel == nullptr) {
          WARN("this machine has no vectors of width " << static_cast<int>(width) << ": left out");
          continue;
        }
        // In an order of its own, and in groups of every size: each query meets other neighbours and other lanes.
        std::vector<std::size_t> order(queries.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        Rng rng(93);
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[rng.below(i)]);
        std::size_t size = 1;
        for (std::size_t first = 0; first < order.size(); first += size, size = size % kMostBracketed + 1) {
          const std::size_t count = std::min(size, order.size() - first);
          BracketedRoots found;
          poison(found);
          kernel(columns, order.data() + first, count, t_max, found);
          for (std::size_t i = 0; i < count; ++i) {
            const Expected& one = expected[order[first + i]];
            INFO("width " << static_cast<int>(width) << ", " << i << " of " << count << ", t_max " << t_max << "\n"
                          << cpp_initializer(queries[order[first + i]]));
            REQUIRE(found.facts[i] == one.facts);
            if ((one.facts & filters::kOneRoot) != 0) REQUIRE(same_bits(found.root(i), one.root));
          }
        }
      }
    }
  }
}

TEST_CASE("facts of the bracket level in columns are decisions of the filters") {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    const std::vector<Query> queries = queries_of_every_family(kind, 16);
    const solver::OwnedColumns owned(queries);
    const filters::Columns columns = columns_of(owned.view());
    const auto kernel = filters::bracket_kernel(kind, VectorWidth::widest);
    REQUIRE(kernel != nullptr);
    std::size_t decided = 0, refined_ones = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (filters::same_side(queries[i])) continue;  // these do not come so far
      BracketedRoots found;
      kernel(columns, &i, 1, 1, found);
      if (found.facts[0] == 0) continue;
      ++decided;
      Answer answer;
      const filters::Decision decision =
          filters::decide_by_filters({queries[i], 1, exact::coplanarity_at, Wanted::all}, answer);
      INFO(cpp_initializer(queries[i]));
      if (found.facts[0] == filters::kBoxesDisjoint) {
        REQUIRE(decision.test == filters::Test::boxes);
      } else if (found.facts[0] == filters::kNoContactAtRoot) {
        REQUIRE(decision.test == filters::Test::bracket);
        REQUIRE(decision.finding == filters::Finding::no_contact);
      } else if (decision.test == filters::Test::bracket) {
        Answer refined;
        const filters::Question question = {queries[i], 1, exact::coplanarity_at, Wanted::all};
        const filters::Finding finding = filters::decide_refined(question, found.root(0), refined);
        if (finding == filters::Finding::uncertain) continue;  // the tests below decide, or this one once rescaled
        REQUIRE(finding == decision.finding);
        REQUIRE(refined.toi == answer.toi);
        ++refined_ones;
      }
    }
    CHECK(decided > 200);
    CHECK(refined_ones > 50);
  }
}

TEST_CASE("no width is no bracket kernel, and every width that the machine has is one") {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    CHECK(filters::bracket_kernel(kind, VectorWidth::none) == nullptr);
    for (const VectorWidth width : kWidths)
      CHECK((filters::bracket_kernel(kind, width) != nullptr) == filters::has_kernel(width));
  }
}
