// The parts of a page that its tests read: headings, links, inline code and tables, without fenced blocks.
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::pages {

struct Found {
  int line = 0;  ///< counted from 1
  std::string text;
};

/// One line of a table: its cells without the spaces around them.
struct TableRow {
  int line = 0;
  std::string heading;  ///< of the section that the table stands in
  std::vector<std::string> cells;
};

struct Page {
  std::set<std::string> anchors;  ///< of its headings, as GitHub makes them
  std::vector<Found> links;       ///< targets of links and images
  std::vector<Found> codes;       ///< inline code
  std::vector<TableRow> rows;     ///< of all tables, rules and head lines included
};

Page parse_page(std::string_view text);

/// "`foo_bar`, and more!" -> "foo_bar-and-more".
std::string anchor_of(std::string_view heading);

/// The inline code of a cell: "`a`, `b`" -> {"a", "b"}.
std::vector<std::string> codes_of(std::string_view text);

/// The links of `page` that lead nowhere, one sentence each. A link is relative to the page's own folder.
/// @param path  of the page, relative to `root`: "docs/guide.md"
std::vector<std::string> broken_links(const std::string& root, const std::string& path, const Page& page);

/// Inline code that names a file or folder of the project which is not there.
std::vector<std::string> missing_paths(const std::string& root, const std::string& path, const Page& page);

/// Of the tables under `heading`: rows that name a file and a word (`src/a.cpp` in one cell, `word` in the next), where
/// no file of the row has the word. @param checked  how many words were looked for
std::vector<std::string> missing_words(const std::string& root, const std::string& path, const Page& page,
                                       const std::string& heading, int& checked);

}  // namespace touchstone::pages
