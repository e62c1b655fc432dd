// The bundled queries are enough, of every sort, and embedded as they stand in
// src/cli/queries. The program's reader and the test's own reader read the same queries.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <variant>

#include <touchstone/answer.hpp>

#include "bundled/expected_query.hpp"
#include "cli/queries/bundled.hpp"
#include "io/input_file.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/queries/query_parser.hpp"
#include "support/catch.hpp"
#include "support/curved_query.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  return text;
}

bool same(const Query& a, const Query& b) {
  for (std::size_t corner = 0; corner < corner_count(a.kind); ++corner) {
    for (const auto& [one, other] : {std::pair{a.start[corner], b.start[corner]}, {a.end[corner], b.end[corner]}}) {
      if (one.x != other.x || one.y != other.y || one.z != other.z) return false;
    }
  }
  return a.kind == b.kind;
}

bool same(const RationalQuery& a, const RationalQuery& b) {
  for (std::size_t corner = 0; corner < corner_count(a.kind); ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const auto& [one, other] :
           {std::pair{a.start[corner][axis], b.start[corner][axis]}, {a.end[corner][axis], b.end[corner][axis]}}) {
        if (one.numerator != other.numerator || one.denominator != other.denominator) return false;
      }
    }
  }
  return a.kind == b.kind;
}

}  // namespace

TEST_CASE("there are hundreds of bundled queries, of every kind, nature and feature, with and without contact") {
  const auto& queries = expected_queries();
  CHECK(queries.size() >= 300);
  CHECK(std::count_if(queries.begin(), queries.end(), [](const auto& query) { return query.curved.has_value(); }) >=
        60);

  std::map<Kind, std::map<std::string, std::size_t>> contacts;
  std::map<std::string, std::size_t> natures;
  std::map<std::string, std::size_t> features;
  for (const auto& query : queries) {
    ++contacts[query.query.kind][query.expect.at("contact")];
    for (const auto& [field, value] : query.expect) {
      if (field == "nature") ++natures[value];
      if (field == "feature_a" || field == "feature_b") ++features[value];
    }
  }
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point}) {
    INFO(name_of(kind));
    CHECK(contacts[kind]["0"] > 0);
    CHECK(contacts[kind]["1"] > 0);
  }
  for (const Nature nature :
       {Nature::crossing, Nature::entering, Nature::grazing, Nature::sustained, Nature::isolated}) {
    INFO(name_of(nature));
    CHECK(natures[std::string(name_of(nature))] > 0);
  }
  CHECK(natures.size() == 5);
  std::size_t names = 0;
  for (int i = 1; i <= static_cast<int>(Feature::overlap); ++i) {
    const auto feature = static_cast<Feature>(i);
    INFO(name_of(feature));
    CHECK(features[std::string(name_of(feature))] > 0);
    ++names;
  }
  CHECK(features.size() == names);
}

TEST_CASE("every bundled file says how its answers are known") {
  for (const auto& file : cli::bundled_files()) {
    INFO(file.name);
    std::istringstream lines{std::string(file.content)};
    std::string first, second, third, fourth;
    std::getline(lines, first);
    std::getline(lines, second);
    std::getline(lines, third);
    std::getline(lines, fourth);
    CHECK(first.rfind("# Touchstone's own queries: ", 0) == 0);
    CHECK(second == "# SPDX-License-Identifier: MIT");
    CHECK(third == "#");
    CHECK(fourth.rfind("# ", 0) == 0);
  }
}

TEST_CASE("the bundled files are those of the source folder, in order") {
  const std::filesystem::path folder = std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "src/cli/queries";
  std::map<std::string, std::string> on_disk;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    on_disk["bundled/" + std::filesystem::relative(entry.path(), folder).generic_string()] = text_of(entry.path());
  }
  REQUIRE(!on_disk.empty());
  const auto& files = cli::bundled_files();
  CHECK(files.size() == on_disk.size());
  CHECK(std::is_sorted(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
  for (const auto& file : files) {
    INFO(file.name);
    const auto found = on_disk.find(std::string(file.name));
    REQUIRE(found != on_disk.end());
    CHECK(found->second == file.content);
  }
}

TEST_CASE("the program reads the same queries from the bundled files") {
  for (const auto& file : cli::bundled_files()) {
    const auto expected = parse_bundled_file(file);
    REQUIRE(!expected.empty());
    io::QueryChunkReader reader(io::InputFile::from_memory(std::string(file.name), file.content),
                                expected.front().query.kind, io::kChunkBytes, io::Motions::any);
    std::size_t count = 0;
    while (const auto chunk = reader.next()) {
      io::QueryParser parser(*chunk);
      for (io::QueryRecord record; parser.next(record); ++count) {
        REQUIRE(count < expected.size());
        INFO(expected[count].name());
        CHECK(record.number == expected[count].number);
        CHECK(record.truth == expected[count].truth);
        if (expected[count].curved) {
          REQUIRE(std::holds_alternative<CurvedQuery>(record.query));
          CHECK(same(std::get<CurvedQuery>(record.query), *expected[count].curved));
          continue;
        }
        const auto doubles = in_doubles(expected[count].query);
        REQUIRE(doubles.has_value() == std::holds_alternative<Query>(record.query));
        CHECK((doubles ? same(std::get<Query>(record.query), *doubles)
                       : same(std::get<RationalQuery>(record.query), expected[count].query)));
      }
    }
    CHECK(count == expected.size());
  }
}
