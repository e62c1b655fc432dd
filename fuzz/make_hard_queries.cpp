// Writes query files for `touchstone certify --proofs` that attack the error bounds of the filters:
//
//     make_hard_queries FOLDER SEED STARTS STEPS [METRIC]
//
// FOLDER/KIND/FAMILY-N.csv begins with query N of a family, for N below STARTS. The queries of a walk of STEPS steps
// follow, towards queries on which the filters are only just certain. With a METRIC each file is about a separation of
// its own, and names it. The truth column is that of exact arithmetic, without filters.
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "families/families.hpp"
#include "fuzz/climb.hpp"
#include "io/queries/query_writer.hpp"
#include "io/queries/separation_text.hpp"
#include "numbers/doubles/float_environment.hpp"

namespace {

using namespace touchstone;
using families::CaseId;

struct Options {
  std::filesystem::path folder;
  std::uint64_t seed = 0, starts = 0, steps = 0;
  std::optional<Metric> metric;  ///< nothing: the queries are about touching
};

std::uint64_t number(const std::string& text) {
  std::size_t used = 0;
  const std::uint64_t value = std::stoull(text, &used);
  if (used != text.size() || text[0] == '-') throw std::invalid_argument(text + " is no whole number");
  return value;
}

std::string queries_of(const CaseId& id, const Options& options) {
  Query query;
  Separation separation;
  if (options.metric) {
    const families::Separated separated = families::make_separated(id, *options.metric);
    query = separated.query;
    separation = {separated.distance, *options.metric};
  } else {
    query = families::make(id);
  }
  std::string text = options.metric ? io::separation_comment(separation) : std::string();
  fuzz::Climb climb(query, families::rng_of(id), separation);
  for (std::uint64_t step = 0; step <= options.steps; ++step) {
    io::append_query(text, query, solve(query, {.separation = separation, .method = Method::exact}).contact);
    query = std::get<Query>(climb.next());
  }
  return text;
}

std::size_t write_queries(const Options& options) {
  const numbers::DefaultFloatEnvironment environment;
  std::size_t files = 0;
  for (const Kind kind : kKinds) {
    const std::filesystem::path folder = options.folder / name_of(kind);
    std::filesystem::create_directories(folder);
    for (const families::FamilyInfo& family : families::all_families()) {
      for (std::uint64_t i = 0; i < options.starts; ++i, ++files) {
        const auto path = folder / (std::string(family.name) + "-" + std::to_string(i) + ".csv");
        std::ofstream file(path, std::ios::binary);
        file << queries_of(CaseId{family.family, kind, options.seed, i}, options);
        if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
      }
    }
  }
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() != 4 && words.size() != 5) {
      throw std::invalid_argument("usage: make_hard_queries FOLDER SEED STARTS STEPS [METRIC]");
    }
    Options options{words[0], number(words[1]), number(words[2]), number(words[3]), std::nullopt};
    if (words.size() == 5) options.metric = from_name<Metric>(words[4]);
    if (words.size() == 5 && !options.metric) throw std::invalid_argument(words[4] + " is neither euclidean nor max");
    const std::size_t files = write_queries(options);
    std::printf("%zu files of %llu queries\n", files, static_cast<unsigned long long>(options.steps + 1));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_hard_queries: %s\n", error.what());
    return 2;
  }
}
