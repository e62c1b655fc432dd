// Parts of an answer with a separation that must not change when the query is told in another way, and how answers with
// different separations relate.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "oracle/elements_at.hpp"
#include "oracle/expected.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::uint64_t kSeed = 31212;

bool same_when(const Answer& one, const Answer& other) {
  return one.contact == other.contact && one.nature == other.nature && one.trend == other.trend &&
         one.starts_within == other.starts_within && one.toi == other.toi && one.toi_upper == other.toi_upper;
}

bool same_where(const Answer& one, const Answer& other) {
  const auto close = [](const Weights& a, const Weights& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return std::abs(x - y) <= 0x1p-49; });
  };
  return one.feature_a == other.feature_a && one.feature_b == other.feature_b &&
         close(one.weights_a, other.weights_a) && close(one.weights_b, other.weights_b);
}

std::string wrong_unless(bool right, const char* law, const Answer& told) {
  return right ? "" : std::string(law) + ": " + describe(told);
}

/// A separation that matters: about the distance at some time of the step.
double separation_for(const Query& query, Metric metric, Rng& rng) {
  const auto elements = elements_at(query, rng.between(0, 4) / 4.0);
  const double measured = measure(elements, metric);
  const double distance = (metric == Metric::euclidean ? std::sqrt(measured) : measured) * (rng.one_in(2) ? 1 : 0.75);
  return distance > 0x1p-500 && distance < 0x1p500 ? distance : 0.5;  // it is measured in doubles, which may overflow
}

/// @param law  what is wrong about a query, its separation and its answer; empty when nothing is
template <class Law>
void check_law(Law&& law) {
  Report report;
  std::size_t contacts = 0;
  const auto wanted = [](const FamilyInfo& family, Kind) { return family.group != Group::scale; };
  for_each_case(kSeed, 2, wanted, [&](const CaseId& id) {
    const Query query = make(id);
    Rng rng(seeded::seed_of_stream(kSeed + id.index, static_cast<std::uint64_t>(id.family)));
    for (const Metric metric : {Metric::euclidean, Metric::max}) {
      const Separation separation = {separation_for(query, metric, rng), metric};
      const Answer answer = oracle::decide_by_oracle(query, 1, separation);
      contacts += answer.contact ? 1 : 0;
      const std::string wrong = law(query, separation, answer);
      report.add(id, query,
                 wrong.empty() ? wrong
                               : std::string(name_of(metric)) + " " + hexfloat(separation.distance) + " " +
                                     describe(answer) + "; " + wrong);
    }
  });
  CHECK((chosen_case() || contacts > 50));
  report.finish();
}

/// The exact decimal expansion of a double ends after 1074 digits at the latest.
Fraction fraction_of(double value) {
  constexpr int digits = 1074;
  std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, "%.*f", digits, value)) + 1, '\0');
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  text.pop_back();
  text.erase(text.find('.'), 1);
  Fraction fraction;
  fraction.numerator = text;
  fraction.denominator = "1" + std::string(digits, '0');
  return fraction;
}

RationalQuery as_fractions(const Query& query) {
  RationalQuery told;
  told.kind = query.kind;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const Vec3& x0 = query.start[i];
    const Vec3& x1 = query.end[i];
    told.start[i] = {fraction_of(x0.x), fraction_of(x0.y), fraction_of(x0.z)};
    told.end[i] = {fraction_of(x1.x), fraction_of(x1.y), fraction_of(x1.z)};
  }
  return told;
}

}  // namespace

TEST_CASE("with a separation, mirroring and permuting the axes and one scale for all change nothing", "[slow]") {
  check_law([](const Query& query, const Separation& separation, const Answer& answer) {
    const Query other = mapped_corners(query, [](const Vec3& x) { return Vec3{-4 * x.z, 4 * x.x, 4 * x.y}; });
    const Answer told = oracle::decide_by_oracle(other, 1, {4 * separation.distance, separation.metric});
    return wrong_unless(same_when(answer, told) && same_where(answer, told), "mirrored and permuted", told);
  });
}

TEST_CASE("with a separation, coordinates told as fractions change nothing", "[slow]") {
  check_law([](const Query& query, const Separation& separation, const Answer& answer) {
    const Answer told = oracle::decide_by_oracle(as_fractions(query), 1, separation);
    return wrong_unless(same_when(answer, told) && same_where(answer, told), "as fractions", told);
  });
}

TEST_CASE("with a separation, swapping the edges swaps the features of a unique closest pair") {
  check_law([](Query query, const Separation& separation, const Answer& answer) -> std::string {
    if (query.kind != Kind::edge_edge) return "";
    for (auto* corners : {&query.start, &query.end}) {
      std::swap((*corners)[0], (*corners)[2]);
      std::swap((*corners)[1], (*corners)[3]);
    }
    const Answer told = oracle::decide_by_oracle(query, 1, separation);
    if (!same_when(answer, told)) return wrong_unless(false, "swapped", told);
    if (!answer.contact || separation.metric != Metric::euclidean) return "";
    if (answer.feature_a == Feature::overlap) {
      return wrong_unless(told.feature_a == Feature::overlap && told.feature_b == Feature::overlap, "swapped", told);
    }
    const auto name_in_b = [](Feature feature) {
      return feature == Feature::a0 ? Feature::b0 : feature == Feature::a1 ? Feature::b1 : Feature::b;
    };
    return wrong_unless(name_in_b(answer.feature_a) == told.feature_b && name_in_b(told.feature_a) == answer.feature_b,
                        "swapped", told);
  });
}

TEST_CASE("with a separation, another first corner changes only names", "[slow]") {
  check_law([](Query query, const Separation& separation, const Answer& answer) {
    for (auto* corners : {&query.start, &query.end}) {
      const std::size_t first = query.kind == Kind::edge_edge ? 2 : query.kind == Kind::point_point ? 0 : 1;
      std::rotate(corners->begin() + static_cast<std::ptrdiff_t>(first),
                  corners->begin() + static_cast<std::ptrdiff_t>(first + 1),
                  corners->begin() + static_cast<std::ptrdiff_t>(corner_count(query.kind)));
    }
    const Answer told = oracle::decide_by_oracle(query, 1, separation);
    return wrong_unless(same_when(answer, told), "relabelled", told);
  });
}

TEST_CASE("with a separation, a shorter time range cuts later contacts off and keeps earlier ones", "[slow]") {
  check_law([](const Query& query, const Separation& separation, const Answer& answer) -> std::string {
    if (!answer.contact) {
      return wrong_unless(!oracle::decide_by_oracle(query, 0.5, separation).contact, "only before 1/2", answer);
    }
    const Answer kept = oracle::decide_by_oracle(query, answer.toi_upper, separation);
    if (!same_when(kept, answer) || !same_where(kept, answer)) return wrong_unless(false, "up to toi_upper", kept);
    if (answer.toi == 0) return "";
    const Answer cut = oracle::decide_by_oracle(query, std::nextafter(answer.toi, 0), separation);
    return wrong_unless(!cut.contact, "before toi", cut);
  });
}

TEST_CASE("a larger separation is reached no later, and a touching is within every separation", "[slow]") {
  check_law([](const Query& query, const Separation& separation, const Answer& answer) -> std::string {
    const auto no_later = [](const Answer& early, const Answer& late) {
      return !late.contact || (early.contact && early.toi <= late.toi && early.toi_upper <= late.toi_upper);
    };
    const Answer larger =
        oracle::decide_by_oracle(query, 1, {std::nextafter(separation.distance, HUGE_VAL), separation.metric});
    if (!no_later(larger, answer)) return wrong_unless(false, "one ulp larger", larger);
    const Answer touching = oracle::decide_by_oracle(query, 1);
    return wrong_unless(no_later(answer, touching), "touching", touching);
  });
}

TEST_CASE("the largest axis is at most the length, and the length at most twice the largest axis", "[slow]") {
  check_law([](const Query& query, const Separation& separation, const Answer& answer) -> std::string {
    const bool euclidean = separation.metric == Metric::euclidean;
    const Answer other = oracle::decide_by_oracle(
        query, 1,
        {euclidean ? separation.distance : 2 * separation.distance, euclidean ? Metric::max : Metric::euclidean});
    return wrong_unless(!answer.contact || (other.contact && other.toi <= answer.toi), "in the other metric", other);
  });
}
