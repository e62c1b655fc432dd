// SPDX-License-Identifier: MIT
#include "fuzz/judging/findings.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include "fuzz/shrinking/simplicity.hpp"

namespace touchstone::fuzz {
namespace {

auto order(const Example& e) {
  const families::CaseId& start = e.name.start;
  return std::tuple(e.difficulty, start.family, start.kind, start.index, e.name.step);
}

std::int64_t difficulty_of(const AnyQuery& query) {
  return std::visit([](const auto& q) { return difficulty(q); }, query);
}

}  // namespace

void Findings::add(const Failure& failure, const CaseName& name, const Asked& asked, const Reply& reply,
                   const Answer& truth) {
  Bucket& bucket = buckets_[{failure.failure, degeneracy_of(asked.query, truth)}];
  Example example;
  example.name = name;
  example.query = asked.query;
  example.separation = asked.separation;
  example.t_max = asked.t_max;
  example.truth = truth;
  example.difficulty = difficulty_of(asked.query);
  if (++bucket.count > 1 && order(bucket.example) <= order(example)) return;
  example.reply = reply;
  example.detail = failure.detail;
  bucket.example = std::move(example);
}

void Findings::merge(Findings&& other) {
  for (auto& [key, bucket] : other.buckets_) {
    Bucket& mine = buckets_[key];
    const bool first = mine.count == 0;
    mine.count += bucket.count;
    if (first || order(bucket.example) < order(mine.example)) mine.example = std::move(bucket.example);
  }
}

std::vector<Finding> Findings::take(std::size_t most) {
  std::array<std::vector<Finding>, kFailureClasses> by_class;
  for (auto& [key, bucket] : buckets_) {
    by_class[FailureTable::index(key.failure)].push_back(
        {key.failure, key.degeneracy, bucket.count, std::move(bucket.example)});
  }
  buckets_.clear();
  const auto frequent_first = [](const Finding& a, const Finding& b) { return a.count > b.count; };
  for (auto& findings : by_class) std::stable_sort(findings.begin(), findings.end(), frequent_first);

  // Each class gives one finding in turn, until there are enough.
  std::array<std::size_t, kFailureClasses> quota{};
  std::size_t left = most;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < kFailureClasses; ++i) {
      if (quota[i] == by_class[i].size() || (most > 0 && left == 0)) continue;
      ++quota[i];
      --left;
      more = true;
    }
  }
  std::vector<Finding> taken;
  for (std::size_t i = 0; i < kFailureClasses; ++i) {
    std::move(by_class[i].begin(), by_class[i].begin() + static_cast<std::ptrdiff_t>(quota[i]),
              std::back_inserter(taken));
  }
  return taken;
}

FailureTable::FailureTable() : rows_(families::all_families().size() + families::curved_families().size() + 1) {}

std::uint64_t FailureTable::Row::failed() const {
  return std::accumulate(failures.begin(), failures.end(), std::uint64_t{0});
}

void FailureTable::merge(const FailureTable& other) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].cases += other.rows_[i].cases;
    for (std::size_t j = 0; j < kFailureClasses; ++j) rows_[i].failures[j] += other.rows_[i].failures[j];
  }
}

FailureTable::Row FailureTable::total() const {
  Row sum;
  for (const Row& row : rows_) {
    sum.cases += row.cases;
    for (std::size_t j = 0; j < kFailureClasses; ++j) sum.failures[j] += row.failures[j];
  }
  return sum;
}

}  // namespace touchstone::fuzz
