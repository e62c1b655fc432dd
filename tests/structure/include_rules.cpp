// SPDX-License-Identifier: MIT
#include "structure/include_rules.hpp"

#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace touchstone::structure {
namespace {

using Layers = std::set<std::string>;

/// The "may use" column. `cli` may use all of it.
const std::map<std::string, Layers>& layer_table() {
  static const std::map<std::string, Layers> table = {
      {"geometry", {}},
      {"numbers", {}},
      {"filters", {"geometry", "numbers"}},
      {"exact", {"geometry", "numbers"}},
      {"oracle", {"geometry", "numbers"}},
      {"solver", {"filters", "exact", "oracle", "geometry", "numbers"}},
      {"certify", {"solver", "oracle", "geometry", "numbers"}},
      {"baselines", {"geometry"}},
      {"seeded", {}},
      {"families", {"geometry", "seeded"}},
      {"broad_phase", {"geometry"}},
      {"generators", {"broad_phase", "geometry", "io", "seeded"}},
      {"fuzz", {"solver", "certify", "baselines", "families", "filters", "io", "numbers", "geometry", "seeded"}},
      {"io", {"geometry", "numbers"}},
      {"linear", {}},
      {"scene", {"generators", "io"}},
      {"rods", {"scene"}},
      {"contact", {"broad_phase", "linear", "scene", "rods", "solver", "baselines", "geometry"}},
      {"dynamics", {"linear", "scene", "rods", "contact"}},
      {"sim", {"linear", "scene", "rods", "contact", "dynamics", "io"}},
      {"report", {"solver", "baselines", "generators", "io", "geometry", "seeded", "scene", "sim"}},
      {"stress", {"solver", "baselines", "report", "geometry", "seeded"}},
      {"cli", {"geometry",  "numbers",    "filters", "exact",    "oracle",   "solver", "certify",
               "baselines", "generators", "io",      "report",   "families", "fuzz",   "seeded",
               "scene",     "rods",       "contact", "dynamics", "sim",      "stress"}},
  };
  return table;
}

const Layers kNumberLibraryLayers = {"numbers", "oracle"};

bool starts_with(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

std::string first_part(const std::string& path) {
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

std::string at(const std::string& file, const Include& include, const std::string& reason) {
  return file + ":" + std::to_string(include.line) + ": " + include.target + ": " + reason;
}

}  // namespace

std::vector<Include> includes_of(std::string_view text) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> includes;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_match(line, match, pattern)) includes.push_back({number, match[2], match[1] == "\""});
  }
  return includes;
}

std::vector<std::string> source_violations(const std::string& path, std::string_view text) {
  std::vector<std::string> violations;
  const std::string layer = first_part(path);
  const std::string file = "src/" + path;
  const auto row = layer_table().find(layer);
  if (!layer.empty() && row == layer_table().end()) {
    violations.push_back(file + ": the layer table has no `" + layer + "`");
    return violations;
  }
  for (const Include& include : includes_of(text)) {
    const std::string used = first_part(include.target);
    if (is_number_library(include.target)) {
      if (kNumberLibraryLayers.count(layer) == 0) {
        violations.push_back(at(file, include, "only numbers and oracle may include it"));
      }
    } else if (include.quoted) {
      if (layer_table().count(used) == 0) {
        violations.push_back(at(file, include, "a quoted include names the layer and the file"));
      } else if (layer.empty() || (used != layer && row->second.count(used) == 0)) {
        violations.push_back(at(file, include, "`" + layer + "` may not use `" + used + "`"));
      }
    } else if (layer_table().count(used) != 0) {
      violations.push_back(at(file, include, "the project's own layers are included with quotes"));
    } else if (include.target == "touchstone/eigen.hpp") {
      violations.push_back(at(file, include, "the library does without Eigen"));
    }
  }
  return violations;
}

std::vector<std::string> public_header_violations(const std::string& name, std::string_view text) {
  static const std::regex standard_header("[a-z_]+");
  std::vector<std::string> violations;
  const std::string file = "include/touchstone/" + name;
  for (const Include& include : includes_of(text)) {
    const bool own = starts_with(include.target, "touchstone/") && include.target != "touchstone/eigen.hpp";
    const bool eigen = name == "eigen.hpp" && starts_with(include.target, "Eigen/");
    const bool standard = std::regex_match(include.target, standard_header);
    if (include.quoted || !(own || eigen || standard)) {
      violations.push_back(
          at(file, include, "a public header includes the standard library and <touchstone/...> only"));
    }
  }
  return violations;
}

bool is_number_library(std::string_view header) {
  if (header == "gmp.h" || header == "gmpxx.h" || header == "mpfr.h" || header == "mpf2mpfr.h") return true;
  return starts_with(header, "CGAL/") || starts_with(header, "boost/");
}

std::string licence_of(std::string_view text) {
  constexpr std::string_view kTag = "SPDX-License-Identifier:";
  const std::size_t tag = text.find(kTag);
  if (tag == std::string_view::npos) return {};
  std::string_view rest = text.substr(tag + kTag.size());
  rest = rest.substr(0, rest.find_first_of("\r\n"));
  const std::size_t first = rest.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string() : std::string(rest.substr(first));
}

bool is_forbidden_licence(std::string_view expression) {
  static const std::regex gpl(R"((^|[^A-Za-z])A?GPL)");
  return expression.empty() || std::regex_search(expression.begin(), expression.end(), gpl);
}

}  // namespace touchstone::structure
