// The findings of a run: failures of one class and one kind of degeneracy are one finding, shown by its simplest query.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "fuzz/case_name.hpp"
#include "fuzz/judging/degeneracy.hpp"
#include "fuzz/judging/failure.hpp"

namespace touchstone::fuzz {

/// One failing query.
struct Example {
  CaseName name;  ///< of this query, or of the query that it was shrunk from
  AnyQuery query;
  Separation separation;  ///< that the query is asked with
  double t_max = 1;       ///< and the end of its time range
  Reply reply;
  Answer truth;
  std::string detail;           ///< see Failure
  std::int64_t difficulty = 0;  ///< of the query
};

struct Finding {
  FailureClass failure = FailureClass::missed;
  Degeneracy degeneracy;
  std::uint64_t count = 0;  ///< number of queries that failed in this way
  Example example;          ///< the simplest of them, or its shrunk form
};

class Findings {
 public:
  void add(const Failure& failure, const CaseName& name, const Asked& asked, const Reply& reply, const Answer& truth);

  /// The result does not depend on the order in which findings are merged.
  void merge(Findings&& other);

  std::size_t size() const noexcept { return buckets_.size(); }

  /// At most `most` findings, 0 for all: the worst class first, within a class the most frequent first. When there are
  /// more than `most`, every class gets equally many.
  std::vector<Finding> take(std::size_t most);

 private:
  struct Key {
    FailureClass failure;
    Degeneracy degeneracy;
    auto operator<=>(const Key&) const = default;
  };
  struct Bucket {
    std::uint64_t count = 0;
    Example example;
  };
  std::map<Key, Bucket> buckets_;
};

/// Failures by family and class. The given queries count as one more family.
class FailureTable {
 public:
  FailureTable();
  void add_case(const CaseName& name) { ++row(name).cases; }
  void add_failure(const CaseName& name, FailureClass failure) { ++row(name).failures[index(failure)]; }
  void merge(const FailureTable& other);

  struct Row {
    std::uint64_t cases = 0;
    std::array<std::uint64_t, kFailureClasses> failures{};
    std::uint64_t failed() const;
  };
  const Row& of(families::Family family) const { return rows_[static_cast<std::size_t>(family)]; }
  const Row& given() const { return rows_.back(); }
  Row total() const;
  static std::size_t index(FailureClass failure) { return static_cast<std::size_t>(failure); }

 private:
  Row& row(const CaseName& name) {
    return name.given ? rows_.back() : rows_[static_cast<std::size_t>(name.start.family)];
  }
  std::vector<Row> rows_;  // of every family, and of the given queries
};

}  // namespace touchstone::fuzz
