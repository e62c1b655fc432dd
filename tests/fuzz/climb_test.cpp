// Hill climbing reaches queries on which the filters are only just certain.
// SPDX-License-Identifier: MIT
#include "fuzz/climb.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fuzz/case_name.hpp"
#include "fuzz/margin.hpp"
#include "support/catch.hpp"

using namespace touchstone;

namespace {

double height(const fuzz::AnyQuery& query, const Separation& separation = {}) {
  return std::fabs(std::log2(std::fabs(fuzz::filter_margin(query, separation))));
}

}  // namespace

TEST_CASE("from most queries of most families, climbing comes within a factor of two of a filter's bound") {
  constexpr std::uint64_t kCases = 20;
  constexpr int kSteps = 400;
  std::size_t all = 0, before = 0, after = 0;
  for (const families::FamilyInfo& family : families::all_families()) {
    if (family.group == families::Group::scale) continue;
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < kCases; ++index) {
        const families::CaseId id{family.family, kind, 5, index};
        fuzz::Climb climb(id);
        double least = height(families::make(id));
        ++all;
        before += least <= 1;
        for (int i = 0; i < kSteps && !(least <= 1); ++i) least = std::min(least, height(climb.next()));
        after += least <= 1;
      }
    }
  }
  CAPTURE(all, before, after);
  CHECK(before < all / 10);
  CHECK(10 * after > 9 * all);
}

TEST_CASE("with separations, too, climbing comes within a factor of two of a filter's bound", "[slow]") {
  constexpr std::uint64_t kCases = 10;
  constexpr int kSteps = 400;
  std::size_t all = 0, before = 0, after = 0;
  for (const families::FamilyInfo& family : families::all_families()) {
    if (family.group == families::Group::scale || family.family == families::Family::gap_scale ||
        family.family == families::Family::gap_extreme) {
      continue;
    }
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < kCases; ++index) {
        const fuzz::CaseName name{{family.family, kind, 5, index}};
        const fuzz::CaseSource source{{}, {1, Metric::euclidean}, true};
        const fuzz::Asked start = fuzz::start_of_case(name, source);
        fuzz::Climb climb = fuzz::climb_from(name, source);
        double least = height(start.query, start.separation);
        ++all;
        before += least <= 1;
        for (int i = 0; i < kSteps && !(least <= 1); ++i) {
          least = std::min(least, height(climb.next(), start.separation));
        }
        after += least <= 1;
      }
    }
  }
  CAPTURE(all, before, after);
  CHECK(before < all / 10);
  CHECK(10 * after > 9 * all);
}

TEST_CASE("every query that climbing comes to is finite") {
  for (const families::FamilyInfo& family : families::all_families()) {
    for (const Kind kind : kKinds) {
      fuzz::Climb climb({family.family, kind, 6, 0});
      for (int i = 0; i < 200; ++i) {
        const auto query = std::get<Query>(climb.next());
        for (std::size_t corner = 0; corner < corner_count(kind); ++corner) {
          for (const Vec3& v : {query.start[corner], query.end[corner]}) {
            REQUIRE((std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)));
          }
        }
      }
    }
  }
}

TEST_CASE("the margin is that of the tightest comparison") {
  // V = 4 - 8 t for edges of length 2 that cross: far from every bound, and exactly on one when b0 touches a's end.
  Query query;
  query.start = {Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, -1, 1}, Vec3{0, 1, 1}};
  query.end = {Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, -1, -1}, Vec3{0, 1, -1}};
  CHECK(std::fabs(fuzz::filter_margin(query)) > 1e10);
  Query at_end = query;
  for (auto* corners : {&at_end.start, &at_end.end}) {
    for (const std::size_t i : {2u, 3u}) (*corners)[i].x = 1;
  }
  CHECK(std::fabs(fuzz::filter_margin(at_end)) < 16);
  for (auto* corners : {&at_end.start, &at_end.end}) {
    for (const std::size_t i : {2u, 3u}) (*corners)[i].x = 1 - 0x1p-30;
  }
  CHECK(std::fabs(fuzz::filter_margin(at_end)) > 1000);
  CHECK(std::fabs(fuzz::filter_margin(at_end)) < 1e7);
}
