// SPDX-License-Identifier: MIT
#include "fuzz/scenes/scene_search.hpp"

#include <charconv>

namespace touchstone::fuzz {

std::string headline_of(const SceneFailure& failure, std::uint64_t count) {
  return std::string(name_of(failure.failure)) + " " + std::to_string(count) + " time" + (count == 1 ? "" : "s") +
         ", " + failure.question + ": " + failure.detail + "\n";
}

void check_step_options(const StepFuzzOptions& options, const std::vector<std::string_view>& families) {
  const auto require = [](bool holds, const std::string& reason) {
    if (!holds) throw InvalidQuery(reason);
  };
  const auto is_fraction = [](double x) { return x >= 0 && x <= 1; };
  require(options.cases > 0, "there are 0 cases; there must be 1 or more");
  require(options.threads >= 1 && options.threads <= 1024,
          "there are " + std::to_string(options.threads) + " threads; there must be 1 to 1024");
  require(is_fraction(options.stall), "stall must be in [0, 1]");
  require(is_fraction(options.late_fraction), "late_fraction must be in [0, 1]");
  require(!options.early_fraction || is_fraction(*options.early_fraction), "early_fraction must be in [0, 1]");
  require(!options.seconds || (*options.seconds > 0 && *options.seconds <= 1e9), "seconds must be in (0, 1e9]");
  for (const std::string& name : options.families) {
    require(std::find(families.begin(), families.end(), name) != families.end(),
            "'" + name + "' is no family of steps");
  }
}

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
