// The bracket level over several queries at a time finds the same as over one, bit for bit, in every SIMD width, in
// every lane and for every number of queries.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "exact/exact.hpp"
#include "filters/apart/boxes.hpp"
#include "filters/bernstein_cubic.hpp"
#include "filters/bracket.hpp"
#include "filters/columns/bracket_columns.hpp"
#include "filters/columns/refined_columns.hpp"
#include "filters/filters.hpp"
#include "filters/root_sides.hpp"
#include "geometry/kind_traits.hpp"
#include "solver/columns_of.hpp"
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
    for (std::size_t i = geometry::corners_of_first(kind); i < 4; ++i) {
      query.start[i].x += 100;
      query.end[i].x += 100;
    }
    queries.push_back(query);
  }
  return queries;
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
  const auto time = filters::time_of<double>(root, t_max);
  const auto values = filters::side_values(query.kind, frame, m, root.t, root.radius);
  const auto sides = filters::sides_of(query.kind, values);
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
    const filters::Columns columns = solver::columns_of(owned.view());
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
    const filters::Columns columns = solver::columns_of(owned.view());
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
        REQUIRE(decision.finding == filters::Outcome::no_contact);
      } else if (decision.test == filters::Test::bracket) {
        Answer refined;
        const filters::Question question = {queries[i], 1, exact::coplanarity_at, Wanted::all};
        const filters::Outcome finding = filters::decide_refined(question, found.root(0), refined);
        if (finding == filters::Outcome::uncertain) continue;  // the tests below decide, or this one once rescaled
        REQUIRE(finding == decision.finding);
        REQUIRE(refined.toi == answer.toi);
        ++refined_ones;
      }
    }
    CHECK(decided > 200);
    CHECK(refined_ones > 50);
  }
}

namespace {

/// What refine_root finds; nothing where it needs an exact value, or is uncertain.
filters::RefinedRoot refined_one_by_one(const Query& query, const filters::SimpleRoot& root, double t_max,
                                        Wanted wanted) {
  static bool asked = false;
  asked = false;
  const filters::ExactValue ask = [](const Query& q, double t) {
    asked = true;
    return exact::coplanarity_at(q, t);
  };
  const filters::RefinedRoot refined = filters::refine_root({query, t_max, ask, wanted}, root);
  return asked ? filters::RefinedRoot{} : refined;
}

bool same_bits(const filters::RefinedRoot& a, const filters::RefinedRoot& b, bool with_weights) {
  const auto same = [](double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  if (a.finding != b.finding) return false;
  if (a.finding != filters::Outcome::contact) return true;
  if (!same(a.toi, b.toi) || !same(a.toi_upper, b.toi_upper)) return false;
  return !with_weights ||
         (same(a.weights[0], b.weights[0]) && same(a.weights[1], b.weights[1]) && same(a.weights[2], b.weights[2]));
}

/// Queries of every family with a root to refine, in an order of its own, and their roots.
struct RootsOfQueries {
  std::vector<Query> queries;
  std::vector<filters::SimpleRoot> roots;
};

RootsOfQueries roots_of_every_family(Kind kind, double t_max) {
  RootsOfQueries result;
  std::vector<Query> queries = queries_of_every_family(kind, 160);
  Rng rng(96);
  for (std::size_t i = queries.size(); i > 1; --i) std::swap(queries[i - 1], queries[rng.below(i)]);
  for (const Query& query : queries) {
    const Expected one = one_by_one(query, t_max);
    if ((one.facts & filters::kOneRoot) == 0) continue;
    filters::SimpleRoot root = one.root;
    // Some that lie inside are looked at as if that was not known, and some with less knowledge of their slopes: then
    // doubts remain.
    if (rng.below(4) == 0) root.inside = false;
    if (rng.below(8) == 0) root.slope_error *= 0x1p40;
    if (rng.below(8) == 0) root.curvature *= 0x1p20;
    result.queries.push_back(query);
    result.roots.push_back(root);
  }
  return result;
}

void put(const filters::SimpleRoot& root, std::size_t k, BracketedRoots& roots) {
  roots.facts[k] = filters::kOneRoot | (root.inside ? filters::kInsideElements : 0);
  roots.t[k] = root.t;
  roots.radius[k] = root.radius;
  roots.slope[k] = root.slope;
  roots.slope_error[k] = root.slope_error;
  roots.curvature[k] = root.curvature;
  roots.u[k] = root.magnitudes.u;
  roots.w[k] = root.magnitudes.w;
  roots.r[k] = root.magnitudes.r;
  roots.axis[k] = static_cast<std::int64_t>(root.axis);
}

}  // namespace

TEST_CASE("roots refined in vectors of every width are those refined one by one") {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    for (const double t_max : {1.0, 0.4375}) {
      const auto [queries, roots] = roots_of_every_family(kind, t_max);
      const solver::OwnedColumns owned(queries);
      const filters::Columns columns = solver::columns_of(owned.view());
      for (const Wanted wanted : {Wanted::all, Wanted::time}) {
        const bool with_weights = wanted == Wanted::all;
        std::vector<filters::RefinedRoot> expected;
        std::size_t seen[3] = {};
        for (std::size_t i = 0; i < queries.size(); ++i) {
          expected.push_back(refined_one_by_one(queries[i], roots[i], t_max, wanted));
          ++seen[static_cast<std::size_t>(expected.back().finding)];
        }
        CAPTURE(name_of(kind), t_max, with_weights);
        CHECK(seen[static_cast<std::size_t>(filters::Outcome::contact)] > (t_max == 1 ? 200u : 80u));
        CHECK(seen[static_cast<std::size_t>(filters::Outcome::no_contact)] > 5);
        CHECK(seen[static_cast<std::size_t>(filters::Outcome::uncertain)] > 20);
        for (const VectorWidth width : kWidths) {
          const auto kernel = filters::refine_kernel(kind, width);
          if (kernel == nullptr) {
            WARN("this machine has no vectors of width " << static_cast<int>(width) << ": left out");
            continue;
          }
          // In blocks of every size. Only some roots of a block are asked for, as its queries come.
          std::size_t size = 1;
          for (std::size_t first = 0; first < queries.size(); first += size, size = size % kMostBracketed + 1) {
            const std::size_t count = std::min(size, queries.size() - first);
            BracketedRoots block;
            poison(block);
            std::vector<std::size_t> at(count);
            std::iota(at.begin(), at.end(), first);
            filters::RootsToRefine asked = {block, at.data(), {}};
            for (std::size_t k = 0; k < count; ++k) {
              put(roots[first + k], k, block);
              if ((first + k) % 3 != 0 || size % 2 == 0) asked.which[asked.count++] = k;
            }
            filters::RefinedRoots found;
            std::memset(&found, 0x55, sizeof found);
            kernel(columns, asked, t_max, with_weights, found);
            for (std::size_t j = 0; j < asked.count; ++j) {
              const std::size_t i = first + asked.which[j];
              INFO("width " << static_cast<int>(width) << ", " << j << " of " << asked.count << "\n"
                            << cpp_initializer(queries[i]));
              REQUIRE(same_bits(found.root(j, with_weights), expected[i], with_weights));
            }
          }
        }
      }
    }
  }
}

TEST_CASE("no width is no bracket kernel, and every width that the machine has is one") {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    CHECK(filters::bracket_kernel(kind, VectorWidth::none) == nullptr);
    CHECK(filters::refine_kernel(kind, VectorWidth::none) == nullptr);
    for (const VectorWidth width : kWidths) {
      CHECK((filters::bracket_kernel(kind, width) != nullptr) == filters::has_kernel(width));
      CHECK((filters::refine_kernel(kind, width) != nullptr) == filters::has_kernel(width));
    }
  }
}
