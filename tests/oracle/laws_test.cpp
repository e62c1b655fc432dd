// Parts of an answer that must not change when a query is written in another way.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "oracle/expected.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::uint64_t kSeed = 20211;

bool same_when(const Answer& one, const Answer& other) {
  return one.contact == other.contact && one.nature == other.nature && one.toi == other.toi &&
         one.toi_upper == other.toi_upper;
}

bool same_where(const Answer& one, const Answer& other) {
  return one.feature_a == other.feature_a && one.feature_b == other.feature_b;
}

template <class Law>
void check_law(Law&& law) {
  Report report;
  std::size_t contacts = 0;
  const auto wanted = [](const FamilyInfo& family, Kind) { return family.group != Group::scale; };
  for_each_case(kSeed, 6, wanted, [&](const CaseId& id) {
    const Query query = make(id);
    const Answer answer = oracle::decide_by_oracle(query, 1);
    contacts += answer.contact ? 1 : 0;
    report.add(id, query, law(query, answer));
  });
  CHECK((chosen_case() || contacts > 50));
  report.finish();
}

}  // namespace

TEST_CASE("mirroring, permuting and scaling the axes changes nothing") {
  check_law([](const Query& query, const Answer& answer) {
    const Query other = mapped_corners(query, [](const Vec3& x) { return Vec3{-4 * x.z, x.x, 2 * x.y}; });
    const Answer told = oracle::decide_by_oracle(other, 1);
    return same_when(answer, told) && same_where(answer, told) ? "" : "mirrored and permuted: " + describe(told);
  });
}

TEST_CASE("swapping the elements swaps the features") {
  check_law([](Query query, const Answer& answer) -> std::string {
    if (query.kind != Kind::edge_edge) return "";
    for (auto* corners : {&query.start, &query.end}) {
      std::swap((*corners)[0], (*corners)[2]);
      std::swap((*corners)[1], (*corners)[3]);
    }
    const Answer told = oracle::decide_by_oracle(query, 1);
    const auto name_in_b = [](Feature feature) {
      return feature == Feature::a0   ? Feature::b0
             : feature == Feature::a1 ? Feature::b1
             : feature == Feature::a  ? Feature::b
                                      : feature;
    };
    const bool same = same_when(answer, told) && name_in_b(answer.feature_a) == told.feature_b &&
                      name_in_b(told.feature_a) == answer.feature_b;
    return same ? "" : "swapped: " + describe(told);
  });
}

TEST_CASE("another first corner changes only names") {
  check_law([](Query query, const Answer& answer) {
    for (auto* corners : {&query.start, &query.end}) {
      const std::size_t first = query.kind == Kind::edge_edge ? 2 : query.kind == Kind::point_point ? 0 : 1;
      std::rotate(corners->begin() + static_cast<std::ptrdiff_t>(first),
                  corners->begin() + static_cast<std::ptrdiff_t>(first + 1),
                  corners->begin() + static_cast<std::ptrdiff_t>(corner_count(query.kind)));
    }
    const Answer told = oracle::decide_by_oracle(query, 1);
    return same_when(answer, told) ? "" : "relabelled: " + describe(told);
  });
}

TEST_CASE("backwards in time the elements touch as well") {
  check_law([](Query query, const Answer& answer) {
    std::swap(query.start, query.end);
    const Answer told = oracle::decide_by_oracle(query, 1);
    if (told.contact != answer.contact) return "backwards: " + describe(told);
    // The first contact backwards is the last one forwards, which is not before the first.
    return !told.contact || 1 - told.toi >= answer.toi - 0x1p-52 ? std::string()
                                                                 : "backwards too late: " + describe(told);
  });
}

TEST_CASE("a shorter time range cuts later contacts off and keeps earlier ones") {
  check_law([](const Query& query, const Answer& answer) -> std::string {
    if (!answer.contact) return oracle::decide_by_oracle(query, 0.5).contact ? "a contact only before 1/2" : "";
    const Answer kept = oracle::decide_by_oracle(query, answer.toi_upper);
    const bool same =
        kept.contact && kept.toi == answer.toi && kept.toi_upper == answer.toi_upper && same_where(kept, answer);
    if (!same) return "up to toi_upper: " + describe(kept);
    if (answer.toi == 0) return "";
    const Answer cut = oracle::decide_by_oracle(query, std::nextafter(answer.toi, 0));
    return cut.contact ? "before toi: " + describe(cut) : "";
  });
}
