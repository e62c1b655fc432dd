// Query sets from files and from the seeded families.
// SPDX-License-Identifier: MIT
#include "benchmarks/query_sets.hpp"

#include <algorithm>
#include <filesystem>
#include <variant>

#include <touchstone/error.hpp>

#include "io/queries/kind_of_file.hpp"
#include "io/queries/query_parser.hpp"
#include "support/query_families.hpp"

namespace touchstone::benchmarks {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 41;

void read_file(const fs::path& path, std::vector<Query>& queries) {
  io::QueryChunkReader reader(io::InputFile::open(path.string()), io::kind_of_file(path.string(), std::nullopt));
  while (const auto chunk = reader.next()) {
    io::QueryParser parser(*chunk);
    io::QueryRecord record;
    while (parser.next(record)) {
      if (const Query* query = std::get_if<Query>(&record.query)) queries.push_back(*query);
    }
  }
}

QuerySet of_kind(const QuerySet& all, Kind kind) {
  QuerySet set{all.name + "-" + std::string(name_of(kind)), {}};
  std::copy_if(all.queries.begin(), all.queries.end(), std::back_inserter(set.queries),
               [&](const Query& query) { return query.kind == kind; });
  return set;
}

}  // namespace

std::vector<QuerySet> public_sets(const std::string& folder) {
  if (folder.empty()) return {};
  const fs::path root = fs::path(folder) / "sample-queries";
  if (!fs::is_directory(root)) throw FileError(root.string() + ": no such folder");
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  QuerySet all{"public", {}};
  for (const fs::path& file : files) read_file(file, all.queries);
  if (all.queries.empty()) throw FileError(root.string() + ": holds no query");
  return {all, of_kind(all, Kind::edge_edge), of_kind(all, Kind::vertex_face)};
}

std::vector<QuerySet> family_sets(std::size_t queries_of_each_kind) {
  std::vector<QuerySet> sets;
  for (const tests::FamilyInfo& family : tests::all_families()) {
    QuerySet set{std::string(family.name), {}};
    for (std::size_t index = 0; index < queries_of_each_kind; ++index) {
      for (const Kind kind : touchstone::kKinds)
        set.queries.push_back(make(tests::CaseId{family.family, kind, kSeed, index}));
    }
    sets.push_back(set);
    if (family.family != tests::Family::simulation) continue;
    for (const Kind kind : touchstone::kKinds) sets.push_back(of_kind(set, kind));
  }
  return sets;
}

}  // namespace touchstone::benchmarks
