// Query files for tests of the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "io/queries/query_writer.hpp"
#include "support/query_families.hpp"

namespace touchstone::tests {

struct SampleFile {
  std::vector<Query> queries;
  std::vector<Answer> answers;
  std::string text;  ///< with the true truth column
};

/// `per_family` seeded queries of each family.
inline SampleFile sample_file(Kind kind, std::uint64_t seed, int per_family) {
  SampleFile file;
  Rng rng(seed);
  for (const auto& family : all_families()) {
    for (int i = 0; i < per_family; ++i) {
      file.queries.push_back(make(family.family, kind, rng));
      file.answers.push_back(solve(file.queries.back()));
      io::append_query(file.text, file.queries.back(), file.answers.back().contact);
    }
  }
  return file;
}

/// Two points that meet at t = 1/3, four points that never do: queries 0 and 1 of a point-point file.
inline std::string two_point_queries() {
  return "0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n1,1,0,1,0,1,1\n-1,1,0,1,0,1,1\n"
         "0,1,0,1,0,1,0\n1,1,0,1,0,1,0\n0,1,0,1,0,1,0\n1,1,0,1,0,1,0\n";
}

}  // namespace touchstone::tests
