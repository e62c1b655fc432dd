// The queries that are measured: the public benchmark's, and each seeded family.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <touchstone/query.hpp>

namespace touchstone::benchmarks {

struct QuerySet {
  std::string name;
  std::vector<Query> queries;
};

/// The queries under `folder`/sample-queries, as three sets: all of them, and those of either kind. A query that
/// doubles do not hold is left out. Empty when the folder's name is. @throws FileError
std::vector<QuerySet> public_sets(const std::string& folder);

/// Every family with queries of all kinds, and the simulation family by kind.
std::vector<QuerySet> family_sets(std::size_t queries_of_each_kind);

}  // namespace touchstone::benchmarks
