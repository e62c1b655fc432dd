// Writes a query file of simulation-like queries with true answers, for measuring how fast `certify` reads and judges.
//
//     make_query_file KIND COUNT SEED FILE
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "io/queries/kind_of_file.hpp"
#include "io/queries/query_writer.hpp"
#include "support/query_families.hpp"

namespace touchstone::benchmarks {
namespace {

std::uint64_t number(const std::string& text, const char* what) {
  std::size_t used = 0;
  const std::uint64_t value = std::stoull(text, &used);
  if (used != text.size()) throw Error(std::string(what) + " is no number: " + text);
  return value;
}

void write_queries(Kind kind, std::uint64_t count, std::uint64_t seed, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  constexpr std::uint64_t kPiece = 10000;
  std::size_t contacts = 0;
  for (std::uint64_t first = 0; first < count; first += kPiece) {
    std::vector<Query> queries;
    for (std::uint64_t i = first; i < std::min(count, first + kPiece); ++i) {
      queries.push_back(make(tests::CaseId{tests::Family::simulation, kind, seed, i}));
    }
    const std::vector<Answer> answers = solve_batch(queries);
    std::string text;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      io::append_query(text, queries[i], answers[i].contact);
      contacts += answers[i].contact;
    }
    file << text;
  }
  file.close();
  if (!file) throw Error(path + ": cannot be written");
  std::printf("%s: %llu %s queries of seed %llu, %zu contacts\n", path.c_str(), static_cast<unsigned long long>(count),
              name_of(kind).data(), static_cast<unsigned long long>(seed), contacts);
}

int run(const std::vector<std::string>& arguments) {
  const auto kind = arguments.size() == 4 ? from_name<Kind>(arguments[0]) : std::nullopt;
  if (!kind) {
    std::cerr << "usage: make_query_file KIND COUNT SEED FILE, where KIND is " << io::kind_names() << "\n";
    return 2;
  }
  write_queries(*kind, number(arguments[1], "COUNT"), number(arguments[2], "SEED"), arguments[3]);
  return 0;
}

}  // namespace
}  // namespace touchstone::benchmarks

int main(int argc, char** argv) {
  try {
    return touchstone::benchmarks::run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    std::cerr << "make_query_file: " << error.what() << "\n";
    return 2;
  }
}
