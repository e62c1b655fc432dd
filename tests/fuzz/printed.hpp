// What touchstone fuzz prints, taken apart.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace touchstone::tests {

/// The lines that have `part`.
inline std::vector<std::string> lines_with(const std::string& text, const std::string& part) {
  std::vector<std::string> lines;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    const std::size_t start = text.rfind('\n', at) + 1;
    lines.push_back(text.substr(start, text.find('\n', at) - start));
  }
  return lines;
}

inline std::string without_time(const std::string& out) { return out.substr(out.find('\n')); }

/// A printed command as arguments: blanks part them, quotes hold them together.
inline std::vector<std::string> arguments_of(const std::string& command) {
  std::vector<std::string> words;
  std::string word;
  bool quoted = false;
  for (const char c : command + " ") {
    if (c == '\'') {
      quoted = !quoted;
    } else if (c == ' ' && !quoted) {
      if (!word.empty()) words.push_back(word);
      word.clear();
    } else {
      word += c;
    }
  }
  words.erase(words.begin());  // touchstone
  return words;
}

}  // namespace touchstone::tests
