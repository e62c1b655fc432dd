// SPDX-License-Identifier: MIT
#include "fuzz/plan.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <touchstone/error.hpp>

namespace touchstone::fuzz {
namespace {

constexpr std::uint64_t kPieceCases = 256;

bool has(const std::vector<Kind>& kinds, Kind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace

std::string kind_names(const std::vector<Kind>& kinds) {
  std::string names;
  for (const Kind kind : kinds) names.append(names.empty() ? "" : ", ").append(name_of(kind));
  return names;
}

std::vector<Kind> supported_kinds(const SolverUnderTest& solver, const std::vector<Kind>& selected) {
  std::vector<Kind> kinds;
  for (const Kind kind : kKinds) {
    if ((selected.empty() || has(selected, kind)) && solver.supports(kind)) kinds.push_back(kind);
  }
  if (!kinds.empty()) return kinds;
  const std::string names = kind_names(selected);
  throw InvalidQuery(solver.name() + " takes no queries" + (names.empty() ? "" : " of this kind: " + names));
}

void check_sort(const SolverUnderTest& solver, bool curved) {
  if (!curved && !solver.takes_straight()) {
    throw InvalidQuery(solver.name() + " takes curved queries only, as those of --curved");
  }
  if (curved && !solver.takes_curves()) throw InvalidQuery(solver.name() + " takes no curved queries");
}

GivenPlan plan_of_given(const std::vector<AnyQuery>& given, const std::vector<Kind>& selected,
                        const std::vector<Kind>& asked, std::optional<std::uint64_t> most) {
  GivenPlan plan;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Kind kind = kind_of(given[i]);
    if (!selected.empty() && !has(selected, kind)) continue;
    ++plan.selected;
    if (!has(asked, kind)) {
      ++plan.not_taken;
    } else if (!most || plan.to_ask.size() < *most) {
      plan.to_ask.push_back(i);
    }
  }
  return plan;
}

Plan::Plan(std::vector<families::Family> families, std::vector<Kind> kinds, std::optional<std::uint64_t> cases)
    : families_(std::move(families)), kinds_(std::move(kinds)), cases_(cases) {
  if (cases_) rounds_ = (cases_of(0) + kPieceCases - 1) / kPieceCases;  // the first pair has the most
}

std::uint64_t Plan::cases_of(std::uint64_t pair) const {
  const std::uint64_t pairs = families_.size() * kinds_.size();
  if (pairs == 0) return 0;
  return *cases_ / pairs + (pair < *cases_ % pairs ? 1 : 0);
}

std::optional<CaseRange> Plan::piece(std::uint64_t number) const {
  const std::uint64_t pairs = families_.size() * kinds_.size();
  if (pairs == 0) return std::nullopt;
  const std::uint64_t round = number / pairs;
  const std::uint64_t pair = number % pairs;
  CaseRange piece{families_[static_cast<std::size_t>(pair / kinds_.size())],
                  kinds_[static_cast<std::size_t>(pair % kinds_.size())], round * kPieceCases, kPieceCases};
  if (!cases_) return piece;
  if (round >= rounds_) return std::nullopt;
  const std::uint64_t all = cases_of(pair);
  piece.count = piece.first_case >= all ? 0 : std::min(kPieceCases, all - piece.first_case);
  return piece;
}

}  // namespace touchstone::fuzz
