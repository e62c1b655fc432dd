// SPDX-License-Identifier: MIT
#include "pages/markdown.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace touchstone::pages {
namespace {

namespace fs = std::filesystem;

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") + 1 - first));
}

std::string file_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Spaces in place of inline code, so that no link is looked for in it; the code goes to `codes`.
std::string without_code(std::string line, int number, std::vector<Found>& codes) {
  for (std::size_t begin = line.find('`'); begin != std::string::npos; begin = line.find('`', begin)) {
    const std::size_t end = line.find('`', begin + 1);
    if (end == std::string::npos) break;
    codes.push_back({number, line.substr(begin + 1, end - begin - 1)});
    line.replace(begin, end + 1 - begin, end + 1 - begin, ' ');
  }
  return line;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream parts(line.substr(1));
  for (std::string cell; std::getline(parts, cell, '|');) cells.push_back(trimmed(cell));
  return cells;
}

bool is_own_path(const std::string& code) {
  static const std::regex own(
      R"((src|tests|include|fuzz|docs|\.ci)/[A-Za-z0-9_./-]*|README\.md|LICENSE|CMakeLists\.txt|CMakePresets\.json)");
  return std::regex_match(code, own);
}

std::string at(const std::string& path, int line, const std::string& what) {
  return path + ":" + std::to_string(line) + ": " + what;
}

bool has_word(const fs::path& place, const std::string& word) {
  if (fs::is_regular_file(place)) return file_text(place).find(word) != std::string::npos;
  for (const auto& entry : fs::recursive_directory_iterator(place)) {
    if (entry.is_regular_file() && file_text(entry.path()).find(word) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

Page parse_page(std::string_view text) {
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  Page page;
  std::map<std::string, int> used;
  std::istringstream lines{std::string(text)};
  std::string line, heading;
  bool fenced = false;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (trimmed(line).rfind("```", 0) == 0) fenced = !fenced;
    if (fenced) continue;
    if (line.rfind('#', 0) == 0) {
      heading = trimmed(line.substr(line.find_first_not_of('#')));
      const std::string anchor = anchor_of(heading);
      const int before = used[anchor]++;
      page.anchors.insert(before == 0 ? anchor : anchor + "-" + std::to_string(before));
    }
    if (line.rfind('|', 0) == 0) page.rows.push_back({number, heading, cells_of(line)});
    const std::string plain = without_code(line, number, page.codes);
    for (std::sregex_iterator match(plain.begin(), plain.end(), link), none; match != none; ++match) {
      page.links.push_back({number, (*match)[1]});
    }
  }
  if (fenced) throw std::runtime_error("a fenced block has no end");
  return page;
}

std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') {
      anchor += '-';
    } else if (std::isalnum(byte) || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(byte));
    }
  }
  return anchor;
}

std::vector<std::string> codes_of(std::string_view text) {
  std::vector<Found> found;
  without_code(std::string(text), 0, found);
  std::vector<std::string> codes;
  for (const Found& code : found) codes.push_back(code.text);
  return codes;
}

std::vector<std::string> broken_links(const std::string& root, const std::string& path, const Page& page) {
  std::vector<std::string> broken;
  for (const auto& [line, target] : page.links) {
    if (target.rfind("https://", 0) == 0 || target.rfind("http://", 0) == 0) continue;
    const std::size_t hash = target.find('#');
    const std::string file = target.substr(0, hash);
    const fs::path there = file.empty() ? fs::path(root) / path : (fs::path(root) / path).parent_path() / file;
    if (!file.empty() && !fs::exists(there)) {
      broken.push_back(at(path, line, "nothing is at " + target));
    } else if (hash != std::string::npos) {
      const Page other = file.empty() ? page : parse_page(file_text(there));
      if (other.anchors.count(target.substr(hash + 1)) == 0)
        broken.push_back(at(path, line, "no heading is at " + target));
    }
  }
  return broken;
}

std::vector<std::string> missing_paths(const std::string& root, const std::string& path, const Page& page) {
  std::vector<std::string> missing;
  for (const auto& [line, code] : page.codes) {
    if (is_own_path(code) && !fs::exists(fs::path(root) / code))
      missing.push_back(at(path, line, "there is no " + code));
  }
  return missing;
}

std::vector<std::string> missing_words(const std::string& root, const std::string& path, const Page& page,
                                       const std::string& heading, int& checked) {
  std::vector<std::string> missing;
  for (const TableRow& row : page.rows) {
    if (row.heading != heading) continue;
    std::vector<std::string> places, words;
    for (const std::string& cell : row.cells) {
      for (const std::string& code : codes_of(cell)) (is_own_path(code) ? places : words).push_back(code);
    }
    if (places.empty()) continue;
    for (const std::string& word : words) {
      ++checked;
      bool found = false;
      for (const std::string& place : places) {
        const fs::path there = fs::path(root) / place;
        found = found || (fs::exists(there) && has_word(there, word));
      }
      if (!found) missing.push_back(at(path, row.line, "none of the row's files has " + word));
    }
  }
  return missing;
}

}  // namespace touchstone::pages
