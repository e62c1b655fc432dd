// Who decides, family by family: a level that never runs is dead code, and so is its test.
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

// Families whose queries are ordinary: hardly one in thousands needs the exact level.
bool is_ordinary(Family family) { return family == Family::simulation || family == Family::near_rigid; }

// Families with contacts of the ordinary sort, inside both elements at a simple root of V, or near misses like it.
bool has_work_for_bracket(const FamilyInfo& family, Kind kind) {
  if (kind != Kind::edge_edge && kind != Kind::vertex_face) return false;
  switch (family.family) {
    case Family::at_start:
    case Family::grazing_merged:
    case Family::extreme_time: return false;
    default: return family.group != Group::coplanar && family.group != Group::scale;
  }
}

TEST_CASE("levels: each decides in every family that has work for it") {
  std::size_t contacts = 0;
  for (const FamilyInfo& family : families()) {
    for (const Kind kind : kKinds) {
      std::vector<Answer> answers;
      for (std::size_t index = 0; index < kCount; ++index) {
        answers.push_back(solve(make(CaseId{family.family, kind, kSeed, index}), Method::fast));
        contacts += answers.back().contact;
      }
      const LevelCounts counts = count_levels(answers);
      std::printf("%-15s %-12s filter %5zu  bracket %5zu  exact %5zu\n", family.name.data(), kind_name(kind).data(),
                  counts.filter, counts.bracket, counts.exact);
      INFO(family.name << " " << kind_name(kind) << ", seed " << kSeed);
      CHECK(counts.filter + counts.bracket + counts.exact == kCount);
      CHECK(counts.oracle == 0);
      if (!no_filter_can_decide(family.family, kind)) CHECK(counts.filter > 0);
      if (has_work_for_bracket(family, kind)) CHECK(counts.bracket > 0);
      if (!is_ordinary(family.family)) CHECK(counts.exact > 0);
    }
  }
  CHECK(contacts > 0);
}

}  // namespace
}  // namespace touchstone::tests
