// Every query of the public benchmark's data with known truth: none missed, none a phantom, by any method.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include <touchstone/contact_times.hpp>
#include <touchstone/solve.hpp>

#include "io/queries/kind_of_file.hpp"
#include "io/queries/query_parser.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"
#include "support/skip.hpp"
#include "support/static_contact.hpp"

namespace touchstone::tests {
namespace {

namespace fs = std::filesystem;

struct KnownQuery {
  std::string name;  ///< "erleben-spikes/edge-edge/data_0_0.csv query 12"
  std::variant<Query, RationalQuery> query;
  bool truth = false;
};

std::size_t count_lines(const fs::path& path) {
  std::ifstream file(path);
  return static_cast<std::size_t>(std::count(std::istreambuf_iterator<char>(file), {}, '\n'));
}

void read_file(const fs::path& root, const fs::path& path, std::vector<KnownQuery>& queries) {
  const Kind kind = io::kind_of_file(path.string(), std::nullopt);
  const std::size_t before = queries.size();
  io::QueryChunkReader reader(io::InputFile::open(path.string()), kind);
  while (const auto chunk = reader.next()) {
    io::QueryParser parser(*chunk);
    io::QueryRecord record;
    while (parser.next(record)) {
      const std::string name = fs::relative(path, root).string() + " query " + std::to_string(record.number);
      if (const auto* const doubles = std::get_if<Query>(&record.query)) {
        queries.push_back({name, *doubles, record.truth.value()});
      } else {
        queries.push_back({name, std::get<RationalQuery>(record.query), record.truth.value()});
      }
    }
  }
  INFO(path.string());
  CHECK(queries.size() - before == count_lines(path) / 8);  // every row belongs to a query that was read
}

// All queries of the folder's files; fails when a folder is given and holds none. Nothing, and a warning, when no
// folder is given.
std::vector<KnownQuery> public_queries() {
  const fs::path root = TOUCHSTONE_QUERY_DATA;
  std::vector<KnownQuery> queries;
  if (root.empty()) {
    skip("TOUCHSTONE_QUERY_DATA names no folder with the public benchmark's queries");
    return queries;
  }
  REQUIRE(fs::is_directory(root / "sample-queries"));
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / "sample-queries")) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) read_file(root / "sample-queries", file, queries);
  std::printf("%zu queries in %zu files\n", queries.size(), files.size());
  REQUIRE_FALSE(queries.empty());
  return queries;
}

void check_truth(Method method) {
  std::size_t missed = 0, phantom = 0, contacts = 0, checked = 0;
  for (const KnownQuery& known : public_queries()) {
    const Answer answer = std::visit([&](const auto& query) { return solve(query, {.method = method}); }, known.query);
    contacts += answer.contact;
    ++checked;
    if (answer.contact == known.truth) continue;
    ++(known.truth ? missed : phantom);
    FAIL_CHECK(known.name << (known.truth ? " is missed: " : " is a phantom: ") << describe(answer));
  }
  if (checked == 0) return;
  std::printf("%zu contacts of %zu, %zu missed, %zu phantom\n", contacts, checked, missed, phantom);
  CHECK(missed == 0);
  CHECK(phantom == 0);
  CHECK(contacts > 0);
  CHECK(contacts < checked);
}

TEST_CASE("public queries: none missed, none a phantom, by Method::fast") { check_truth(Method::fast); }
TEST_CASE("public queries: none missed, none a phantom, by Method::exact") { check_truth(Method::exact); }
TEST_CASE("public queries: none missed, none a phantom, by Method::oracle") { check_truth(Method::oracle); }

TEST_CASE("public queries: the methods agree in everything, and contact_times with them") {
  for (const KnownQuery& known : public_queries()) {
    INFO(known.name);
    std::visit(
        [&](const auto& query) {
          const Answer fast = solve(query, {.method = Method::fast});
          const Answer exact = solve(query, {.method = Method::exact});
          const Answer oracle = solve(query, {.method = Method::oracle});
          CHECK(decision_difference(fast, exact) == "");
          CHECK(weight_difference(fast, exact) == "");
          CHECK(decision_difference(exact, oracle) == "");
          CHECK(weight_difference(exact, oracle) == "");
          CHECK(malformation(query.kind, fast, 1) == "");
          const std::vector<ContactInterval> times = contact_times(query);
          REQUIRE(times.empty() == !exact.contact);
          if (times.empty()) return;
          CHECK(times.front().first.lower() == exact.toi);
          CHECK(times.front().first.upper() == exact.toi_upper);
        },
        known.query);
  }
}

TEST_CASE(
    "public queries: the third opinion finds every contact that happens at a double, and no other at sixteenths") {
  for (const KnownQuery& known : public_queries()) {
    const Query* query = std::get_if<Query>(&known.query);
    if (query == nullptr) continue;
    INFO(known.name);
    const Answer answer = solve(*query);
    if (answer.contact && answer.toi == answer.toi_upper) CHECK(touching_at(*query, mpq_class(answer.toi)));
    for (int k = 0; k <= 16 && (!answer.contact || k / 16.0 < answer.toi); ++k) {
      CHECK_FALSE(touching_at(*query, mpq_class(k / 16.0)));
    }
  }
}

}  // namespace
}  // namespace touchstone::tests
