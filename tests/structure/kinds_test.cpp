// What a new kind of query touches: the page has every switch over the kinds.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "structure/source_tree.hpp"
#include "support/catch.hpp"

using namespace touchstone::structure;

TEST_CASE("docs/design.md names the files that have a switch over the kinds of query, and no others") {
  const std::filesystem::path root = TOUCHSTONE_SOURCE_DIR;
  const std::string page = text_of(root / "docs/design.md");
  const std::size_t table = page.find("| step | its switches |");
  REQUIRE(table != std::string::npos);
  std::set<std::string> named, found;
  std::istringstream lines(page.substr(table));
  const std::regex file("`(src/[^`]+)`");
  for (std::string line; std::getline(lines, line) && !line.empty();) {
    const std::size_t cell = line.find('|', 1);
    const std::string switches = line.substr(cell, line.find('|', cell + 1) - cell);
    for (std::sregex_iterator i(switches.begin(), switches.end(), file), end; i != end; ++i) named.insert((*i)[1]);
  }
  for (const auto& source : cpp_files("src")) {
    if (text_of(root / "src" / source).find("case Kind::") != std::string::npos) {
      found.insert("src/" + source.generic_string());
    }
  }
  CHECK(found.size() > 10);
  CHECK(named == found);
}
