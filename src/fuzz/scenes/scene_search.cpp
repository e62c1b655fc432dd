// SPDX-License-Identifier: MIT
#include "fuzz/scenes/scene_search.hpp"

#include <charconv>

namespace touchstone::fuzz {

std::string case_text(const std::vector<std::string_view>& families, const SceneCase& name) {
  return std::string(families.at(name.family)) + " " + std::to_string(name.seed) + " " + std::to_string(name.index);
}

std::optional<SceneCase> parse_scene_case(const std::vector<std::string_view>& families, std::string_view text) {
  const std::size_t first = text.find(' '), second = text.find(' ', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return std::nullopt;
  const auto family = std::find(families.begin(), families.end(), text.substr(0, first));
  SceneCase name;
  const auto read = [](std::string_view digits, std::uint64_t& number) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return error == std::errc() && end == digits.data() + digits.size();
  };
  if (family == families.end() || !read(text.substr(first + 1, second - first - 1), name.seed) ||
      !read(text.substr(second + 1), name.index)) {
    return std::nullopt;
  }
  name.family = static_cast<std::size_t>(family - families.begin());
  return name;
}

}  // namespace touchstone::fuzz
