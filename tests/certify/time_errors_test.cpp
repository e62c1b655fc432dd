// How early claims are: counts in buckets against a sorted list of the same distances.
// SPDX-License-Identifier: MIT
#include "certify/time_errors.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "certify/tally.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using certify::ulps_between;

namespace {

template <class Distance>
bool holds(const certify::ErrorBucket<Distance>& bucket, Distance value) {
  return bucket.from <= value && (!bucket.below || value < *bucket.below);
}

template <class Distance>
void check_buckets(const std::vector<certify::ErrorBucket<Distance>>& buckets, const std::vector<Distance>& values) {
  std::uint64_t claims = 0;
  for (std::size_t i = 0; i < buckets.size(); ++i) {
    const auto& bucket = buckets[i];
    const auto inside = std::count_if(values.begin(), values.end(), [&](Distance v) { return holds(bucket, v); });
    CHECK(bucket.claims == static_cast<std::uint64_t>(inside));
    CHECK(bucket.claims > 0);
    if (i > 0) CHECK(*buckets[i - 1].below <= bucket.from);
    claims += bucket.claims;
  }
  CHECK(claims == values.size());
}

}  // namespace

TEST_CASE("ulps count the doubles from one to the other") {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  CHECK(ulps_between(0.5, 0.5) == 0);
  CHECK(ulps_between(0.5, std::nextafter(0.5, 1.0)) == 1);
  CHECK(ulps_between(0.5, 1.0) == std::uint64_t{1} << 52);
  CHECK(ulps_between(0.0, kLeast) == 1);
  CHECK(ulps_between(-0.0, kLeast) == 1);
  CHECK(ulps_between(-0.0, 0.0) == 0);
  CHECK(ulps_between(0.0, -0.0) == 0);
  CHECK(ulps_between(-kLeast, kLeast) == 2);
  CHECK(ulps_between(-1.0, -0.5) == std::uint64_t{1} << 52);
  CHECK(ulps_between(-DBL_MAX, 1.0) > ulps_between(0.0, 1.0));
}

TEST_CASE("buckets, median and extremes are those of the sorted distances, in however many parts they are counted") {
  constexpr std::uint64_t kSeed = 77;
  CAPTURE(kSeed);
  tests::Rng rng(kSeed);
  for (const int count : {1, 2, 3, 10, 1001}) {
    CAPTURE(count);
    certify::TimeErrors whole;
    std::array<certify::TimeErrors, 3> parts;
    std::vector<std::uint64_t> ulps;
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
      const double toi = rng.one_in(10) ? 0.0 : rng.unit();
      double claimed = toi;
      switch (rng.between(0, 3)) {
        case 0: claimed = std::nextafter(toi, -1.0); break;
        case 1: claimed = toi * rng.unit(); break;
        case 2: claimed = toi - std::ldexp(rng.unit(), rng.between(-60, 3)); break;
        default: break;
      }
      if (rng.one_in(100)) claimed = -DBL_MAX;
      whole.add(claimed, toi);
      parts[static_cast<std::size_t>(rng.between(0, 2))].add(claimed, toi);
      ulps.push_back(ulps_between(claimed, toi));
      times.push_back(toi - claimed);
    }
    certify::TimeErrors merged;
    for (const auto& part : parts) merged.merge(part);
    std::sort(ulps.begin(), ulps.end());
    std::sort(times.begin(), times.end());
    const std::size_t middle = (ulps.size() - 1) / 2;
    for (const auto* tally : {&whole, &merged}) {
      CHECK(tally->claims() == ulps.size());
      CHECK(tally->least_ulps() == ulps.front());
      CHECK(tally->most_ulps() == ulps.back());
      CHECK(tally->least_time() == times.front());
      CHECK(tally->most_time() == times.back());
      CHECK(holds(tally->median_ulps(), ulps[middle]));
      CHECK(holds(tally->median_time(), times[middle]));
      check_buckets(tally->ulps(), ulps);
      check_buckets(tally->times(), times);
    }
  }
}

TEST_CASE("the widest distances have a bucket") {
  certify::TimeErrors tally;
  tally.add(-DBL_MAX, 1.0);
  tally.add(0.0, std::numeric_limits<double>::denorm_min());
  REQUIRE(tally.ulps().size() == 2);
  CHECK(tally.ulps().front().from == 1);
  CHECK(tally.ulps().front().below == 2u);
  CHECK(tally.ulps().back().from == std::uint64_t{1} << 63);
  CHECK_FALSE(tally.ulps().back().below);
  REQUIRE(tally.times().size() == 2);
  CHECK(tally.times().front().from == std::numeric_limits<double>::denorm_min());
  CHECK(tally.times().back().from == 0x1p1023);
  CHECK_FALSE(tally.times().back().below);
}

TEST_CASE("a limit allows what is no farther, in doubles or in parts of the step") {
  certify::TimeLimit limit;
  CHECK(limit.allows(0, 1));
  limit.ulps = 2;
  const double next = std::nextafter(0.5, 1), after = std::nextafter(next, 1);
  CHECK(limit.allows(0.5, after));
  CHECK_FALSE(limit.allows(0.5, std::nextafter(after, 1)));
  CHECK_FALSE(limit.allows(0.5, std::numeric_limits<double>::infinity()));
  limit = {};
  limit.fraction = 0.25;
  CHECK(limit.allows(0.5, 0.75));
  CHECK_FALSE(limit.allows(0.5, std::nextafter(0.75, 1)));
  CHECK_FALSE(limit.allows(0.5, std::numeric_limits<double>::infinity()));
}

TEST_CASE("a wrong claim counts unless it is of another class, or late within the limit") {
  Answer answer;
  answer.contact = true;
  answer.toi = 0.5;
  Claim late{true, std::nextafter(std::nextafter(0.5, 1), 1)};
  certify::Counting<Verdict> counting;
  certify::NotCounted others;
  const auto counted = [&](Verdict verdict) { return certify::counts(counting, late, answer, verdict, others); };
  CHECK(counted(Verdict::late));
  counting.late = certify::TimeLimit{1, std::nullopt};
  CHECK(counted(Verdict::late));
  counting.late->ulps = 2;
  CHECK_FALSE(counted(Verdict::late));
  counting.late->fraction = 0;
  CHECK(counted(Verdict::late));
  CHECK(counted(Verdict::missed));
  counting.classes = {Verdict::late, Verdict::phantom};
  CHECK_FALSE(counted(Verdict::missed));
  CHECK(counted(Verdict::phantom));
  // A time as written is late by a double at most where its double is not late.
  late.toi = 0.5;
  counting.late = certify::TimeLimit{1, std::nullopt};
  CHECK_FALSE(counted(Verdict::late));
  CHECK(others.late == 2);
  CHECK(others.other == 1);
}
