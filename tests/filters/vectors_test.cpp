// The first filter over columns gives the same verdict as over one query, in every SIMD width and in every lane.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <vector>

#include "filters/columns/same_side_columns.hpp"
#include "filters/filters.hpp"
#include "solver/columns_of.hpp"
#include "solver/owned_columns.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr VectorWidth kVectorWidths[] = {VectorWidth::none, VectorWidth::bits_128, VectorWidth::bits_256,
                                         VectorWidth::bits_512, VectorWidth::widest};

/// Checks every width that the machine has; returns how many queries the filter proves.
std::size_t check_all_widths(const std::vector<Query>& queries) {
  const solver::OwnedColumns owned(queries);
  const filters::Columns columns = solver::columns_of(owned.view());
  std::vector<bool> proved;
  for (const Query& query : queries) proved.push_back(filters::same_side(query));
  for (const VectorWidth width : kVectorWidths) {
    const auto kernel = filters::same_side_kernel(queries.front().kind, width);
    if (kernel == nullptr) {
      WARN("this machine has no vectors of width " << static_cast<int>(width) << ": left out");
      continue;
    }
    for (const std::size_t first : {0u, 1u, 3u}) {
      std::vector<std::int64_t> found(queries.size() - first + 1, 77);
      kernel(columns, first, queries.size() - first, found.data());
      for (std::size_t i = first; i < queries.size(); ++i) {
        CAPTURE(static_cast<int>(width), first, i);
        REQUIRE((found[i - first] != 0) == proved[i]);
      }
      REQUIRE(found.back() == 77);  // nothing past the end
    }
  }
  return static_cast<std::size_t>(std::count(proved.begin(), proved.end(), true));
}

}  // namespace

TEST_CASE("same side in vectors of every width is same side one by one") {
  CHECK(has_vectors(VectorWidth::none));
  CHECK(has_vectors(VectorWidth::bits_128));
  CHECK(has_vectors(VectorWidth::widest));
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    std::vector<Query> queries;
    for (const FamilyInfo& family : all_families()) {
      for (std::uint64_t index = 0; index < 51; ++index)
        queries.push_back(make(CaseId{family.family, kind, 77, index}));
    }
    const std::size_t proved = check_all_widths(queries);
    CHECK(proved > queries.size() / 20);
    CHECK(proved < queries.size() / 2);
  }
}

TEST_CASE("same side never proves anything of coordinates that are not finite") {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::size_t spoilt = 0;
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    Rng rng(78);
    std::vector<Query> good;
    while (good.size() < 40) {
      const Query query = make(Family::simulation, kind, rng);
      if (filters::same_side(query)) good.push_back(query);
    }
    std::vector<Query> bad;
    const auto spoil = [&](Query query, std::size_t place, double value) {
      const auto set = [&query](std::size_t at, double x) {
        Vec3& corner = (at < 12 ? query.start : query.end)[at % 12 / 3];
        (at % 3 == 0 ? corner.x : at % 3 == 1 ? corner.y : corner.z) = x;
      };
      set(place, value);
      for (std::size_t i = 0; i < 24; ++i) {  // zeros and infinities beside it, which products turn into NaN
        if (rng.one_in(3)) set(i, rng.one_in(2) ? 0.0 : value);
      }
      set(place, value);
      return query;
    };
    for (const Query& query : good) {
      for (std::size_t place = 0; place < 24; ++place) {
        for (const double value : {kInf, -kInf, kNan, -kNan}) {
          bad.push_back(query);
          Vec3& corner = (place < 12 ? bad.back().start : bad.back().end)[place % 12 / 3];
          (place % 3 == 0 ? corner.x : place % 3 == 1 ? corner.y : corner.z) = value;
          bad.push_back(spoil(query, place, value));
        }
      }
    }
    for (const Query& query : bad) REQUIRE_FALSE(filters::same_side(query));
    CHECK(check_all_widths(bad) == 0);
    spoilt += bad.size();
  }
  CHECK(spoilt == 2 * 40 * 24 * 4 * 2);
}
