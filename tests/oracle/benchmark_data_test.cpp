// Every query of the public benchmark's data with known truth, with the rationals of its rows.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/expected.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

struct KnownQuery {
  RationalQuery query;
  bool truth = false;
};

/// Eight rows a query of x_num,x_den,y_num,y_den,z_num,z_den,truth.
std::vector<KnownQuery> read_queries(const std::filesystem::path& path) {
  std::vector<KnownQuery> queries;
  std::ifstream file(path);
  std::string row;
  for (std::size_t number = 0; std::getline(file, row); ++number) {
    if (number % 8 == 0) {
      queries.emplace_back();
      queries.back().query.kind = path.parent_path().filename() == "edge-edge" ? Kind::edge_edge : Kind::vertex_face;
    }
    std::istringstream fields(row);
    KnownQuery& current = queries.back();
    auto& corners = number % 8 < 4 ? current.query.start : current.query.end;
    for (Fraction& fraction : corners[number % 4]) {
      std::getline(fields, fraction.numerator, ',');
      std::getline(fields, fraction.denominator, ',');
    }
    std::string truth;
    std::getline(fields, truth);
    current.truth = truth.substr(0, 1) == "1";
  }
  return queries;
}

}  // namespace

TEST_CASE("no query of the public data is missed or a phantom") {
  const std::string folder = TOUCHSTONE_QUERY_DATA;
  if (folder.empty()) {
    skip("TOUCHSTONE_QUERY_DATA names no folder with the public benchmark's queries");
    return;
  }
  std::size_t checked = 0;
  std::size_t contacts = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder + "/sample-queries")) {
    if (entry.path().extension() != ".csv") continue;
    std::size_t number = 0;
    for (const auto& [query, truth] : read_queries(entry.path())) {
      INFO(entry.path().string() << " query " << number++);
      const Answer answer = oracle::decide_by_oracle(query, 1);
      INFO(describe(answer));
      if (answer.contact != truth) FAIL_CHECK((truth ? "missed" : "phantom"));
      ++checked;
      contacts += answer.contact ? 1 : 0;
    }
  }
  CHECK(checked > 0);
  CHECK(contacts > 0);
}
