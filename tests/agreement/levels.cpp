// The levels that decide, family by family: a level that never runs is dead code, and so is its test.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include <touchstone/solve.hpp>

#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 4;
constexpr std::size_t kCount = 2000;  // also in slow builds: a tally of few says little

// Families in which every query touches, or misses by so little that no filter can tell.
bool no_filter_can_decide(Family family, Kind kind) {
  switch (family) {
    case Family::shared_corner:
    case Family::prescribed:
    case Family::at_start:
    case Family::at_end:
    case Family::chain_joint:
    case Family::near_hit:
    case Family::grazing_merged:
    case Family::grazing_apart:
    case Family::triple_root: return true;
    case Family::grazing_gone: return kind == Kind::point_edge;
    default: return false;
  }
}

TEST_CASE("levels: each decides in every family or kind that has work for it") {
  std::array<LevelCounts, 4> by_kind{};
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      std::vector<Answer> answers;
      for (std::size_t index = 0; index < kCount; ++index) {
        answers.push_back(solve(make(CaseId{family.family, kind, kSeed, index}), {.method = Method::fast}));
      }
      const LevelCounts counts = count_levels(answers);
      std::printf("%-16s %-12s filter %5zu  bracket %5zu  exact %5zu\n", family.name.data(), name_of(kind).data(),
                  counts.filter, counts.bracket, counts.exact);
      INFO(family.name << " " << name_of(kind) << ", seed " << kSeed);
      CHECK(counts.filter + counts.bracket + counts.exact == kCount);
      CHECK(counts.oracle == 0);
      if (!no_filter_can_decide(family.family, kind)) CHECK(counts.filter > 0);
      LevelCounts& sum = by_kind[static_cast<std::size_t>(kind)];
      sum.filter += counts.filter;
      sum.bracket += counts.bracket;
      sum.exact += counts.exact;
    }
  }
  for (const Kind kind : kKinds) {
    const LevelCounts& sum = by_kind[static_cast<std::size_t>(kind)];
    std::printf("%-16s %-12s filter %5zu  bracket %5zu  exact %5zu\n", "all", name_of(kind).data(), sum.filter,
                sum.bracket, sum.exact);
    INFO(name_of(kind));
    CHECK(sum.filter > 0);
    if (kind == Kind::edge_edge || kind == Kind::vertex_face) CHECK(sum.bracket > 0);
    CHECK(sum.exact > 0);
  }
}

}  // namespace
}  // namespace touchstone::tests
