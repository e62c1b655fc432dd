// Links between README and docs lead somewhere, and the files and names on the pages exist.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "io/temporary_folder.hpp"
#include "pages/markdown.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::pages;

namespace {

const std::string kRoot = TOUCHSTONE_SOURCE_DIR;

std::string text_of(const std::string& path) {
  std::ifstream in(kRoot + "/" + path, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// README.md and every page of docs/, as paths relative to the project.
std::vector<std::string> all_pages() {
  std::vector<std::string> pages{"README.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot + "/docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path().lexically_relative(kRoot).generic_string());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace

TEST_CASE("every link and image of a page leads somewhere") {
  const auto pages = all_pages();
  CHECK(pages.size() >= 9);
  std::size_t links = 0;
  for (const std::string& path : pages) {
    const Page page = parse_page(text_of(path));
    links += page.links.size();
    const auto broken = broken_links(kRoot, path, page);
    INFO(joined(broken));
    CHECK(broken.empty());
  }
  CHECK(links >= 30);  // the parser found them
}

TEST_CASE("every file and folder that a page names is there") {
  std::size_t codes = 0;
  for (const std::string& path : all_pages()) {
    const Page page = parse_page(text_of(path));
    codes += page.codes.size();
    const auto missing = missing_paths(kRoot, path, page);
    INFO(joined(missing));
    CHECK(missing.empty());
  }
  CHECK(codes >= 100);
}

TEST_CASE("the table of where things live names what is there") {
  const std::string path = "docs/design.md";
  int checked = 0;
  const auto missing = missing_words(kRoot, path, parse_page(text_of(path)), "Where things live", checked);
  INFO(joined(missing));
  CHECK(missing.empty());
  CHECK(checked >= 30);
}

TEST_CASE("the README is short") {
  const std::string text = text_of("README.md");
  CHECK(std::count(text.begin(), text.end(), '\n') < 130);
}

TEST_CASE("anchors are GitHub's") {
  CHECK(anchor_of("Where things live") == "where-things-live");
  CHECK(anchor_of("What it costs: `report`, and more!") == "what-it-costs-report-and-more");
  CHECK(parse_page("# A\n# A\n").anchors == std::set<std::string>{"a", "a-1"});
}

TEST_CASE("a planted mistake on a page is found") {
  const tests::TemporaryFolder folder;
  folder.write("docs/other.md", "# Here\n");
  folder.write("src/a.cpp", "int right_word;\n");
  const std::string root = folder.path(".");
  const auto broken = [&](const std::string& text) {
    return broken_links(root, "docs/page.md", parse_page(text)).size();
  };
  CHECK(broken("[x](other.md) [y](other.md#here) [z](https://example.org/nothing) ![i](../src/a.cpp)\n") == 0);
  CHECK(broken("[x](none.md)\n") == 1);
  CHECK(broken("# Own\n[x](#own) [y](#other)\n") == 1);
  CHECK(broken("[x](other.md#there)\n") == 1);
  CHECK(broken("![x](picture.svg)\n") == 1);
  CHECK(broken("`[x](none.md)`\n```\n[y](none.md)\n```\n") == 0);
  CHECK_THROWS(parse_page("```sh\n"));

  const auto missing = [&](const std::string& text) {
    return missing_paths(root, "docs/page.md", parse_page(text)).size();
  };
  CHECK(missing("`src/a.cpp` and `src/` and `other/b.cpp`\n") == 0);
  CHECK(missing("`src/b.cpp`\n") == 1);

  int checked = 0;
  const auto words = [&](const std::string& row) {
    return missing_words(root, "docs/page.md", parse_page("## T\n| a | b |\n|---|---|\n" + row), "T", checked).size();
  };
  CHECK(words("| `src/a.cpp` | `right_word` |\n") == 0);
  CHECK(words("| `src/` | `right_word` |\n") == 0);
  CHECK(words("| `src/a.cpp` | `wrong_word`, `right_word` |\n") == 1);
  CHECK(checked == 4);
}
