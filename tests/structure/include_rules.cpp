// SPDX-License-Identifier: MIT
#include "structure/include_rules.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

namespace touchstone::structure {

const LayerTable& layer_table() {
  static const LayerTable table = {
      {"geometry", {}},
      {"numbers", {}},
      {"threads", {"numbers"}},
      {"filters", {"geometry", "numbers"}},
      {"exact", {"geometry", "numbers"}},
      {"oracle", {"geometry", "numbers"}},
      {"solver", {"filters", "exact", "oracle", "geometry", "numbers", "threads"}},
      {"certify", {"solver", "oracle", "geometry", "numbers"}},
      {"baselines", {"geometry"}},
      {"seeded", {}},
      {"families", {"geometry", "seeded"}},
      {"broad_phase", {"geometry", "threads"}},
      {"mesh", {"solver", "broad_phase", "threads", "geometry", "numbers"}},
      {"frames", {"geometry", "io", "mesh"}},
      {"dropin", {"solver", "geometry"}},
      {"c_api", {"solver", "mesh"}},
      {"python", {"solver", "certify", "exact", "fuzz", "mesh", "proofs", "view", "io", "threads"}},
      {"proofs", {"solver", "broad_phase", "exact", "filters", "geometry", "io", "numbers"}},
      {"checker", {}},
      {"view", {"exact", "geometry", "io", "numbers", "proofs"}},
      {"generators", {"broad_phase", "geometry", "io", "seeded"}},
      {"fuzz",
       {"solver", "certify", "baselines", "families", "exact", "filters", "io", "numbers", "geometry", "pipes",
        "seeded"}},
      {"pipes", {"geometry", "io", "numbers"}},
      {"io", {"geometry", "numbers"}},
      {"json", {"io"}},
      {"linear", {"geometry"}},
      {"bodies", {}},
      {"scene", {"bodies", "generators", "io", "json"}},
      {"shells", {"scene"}},
      {"rods", {"scene", "shells"}},
      {"contact", {"broad_phase", "linear", "scene", "rods", "solver", "baselines", "geometry", "numbers"}},
      {"body_contact", {"bodies", "broad_phase", "scene", "rods", "contact", "solver", "geometry", "numbers"}},
      {"dynamics", {"linear", "scene", "rods", "contact", "geometry"}},
      {"sim",
       {"bodies", "broad_phase", "linear", "scene", "rods", "contact", "body_contact", "dynamics", "mesh", "io",
        "json"}},
      {"sequence", {"frames", "mesh", "geometry", "io", "json"}},
      {"report",
       {"solver", "certify", "baselines", "families", "generators", "io", "geometry", "seeded", "bodies",
        "body_contact", "scene", "sim"}},
      {"stress", {"solver", "baselines", "report", "geometry", "seeded"}},
      {"cli", {"geometry",   "numbers", "filters",  "exact",        "oracle", "solver", "certify", "baselines",
               "generators", "io",      "report",   "families",     "fuzz",   "pipes",  "seeded",  "scene",
               "rods",       "contact", "dynamics", "sim",          "stress", "mesh",   "threads", "frames",
               "sequence",   "proofs",  "bodies",   "body_contact", "view"}},
  };
  return table;
}

namespace {

const Layers kNumberLibraryLayers = {"numbers", "oracle", "checker"};

bool starts_with(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

std::string first_part(const std::string& path) {
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

/// A file's room within `cli`: the folder of a command ("cli/bench/sets.hpp": "bench"), or, for a file that lies in
/// `cli` itself, the name that it shares with its header ("cli/solve.cpp": "solve").
std::string room_in_cli(const std::string& path) {
  const std::string rest = path.substr(path.find('/') + 1);
  const std::string folder = first_part(rest);
  return folder.empty() ? rest.substr(0, rest.find('.')) : folder;
}

/// A command uses its own files and the shared ones, so that each command can be read and changed alone. The program
/// knows every command, main knows the program, and the shared files find the bundled queries.
bool may_use_in_cli(const std::string& room, const std::string& used) {
  if (room == used || used == "shared" || room == "program") return true;
  return (room == "main" && used == "program") || (room == "shared" && used == "queries");
}

std::string at(const std::string& file, const Include& include, const std::string& reason) {
  return file + ":" + std::to_string(include.line) + ": " + include.target + ": " + reason;
}

/// The layer that defines the functions of a public header. The layers that may use it may include the header. A header
/// with the owner "" declares types that every layer shares. A header with the owner "*" is for users alone.
const std::map<std::string, std::string>& header_owners() {
  static const std::map<std::string, std::string> owners = {
      {"answer.hpp", ""},         {"error.hpp", ""},
      {"query.hpp", ""},          {"separation.hpp", ""},
      {"vector_width.hpp", ""},   {"version.hpp", ""},
      {"solve.hpp", "solver"},    {"contact_times.hpp", "solver"},
      {"distance.hpp", "solver"}, {"contact_normal.hpp", "solver"},
      {"curved.hpp", "solver"},   {"curved_query.hpp", ""},
      {"screw.hpp", "solver"},    {"mesh.hpp", "mesh"},
      {"certify.hpp", "certify"}, {"fuzz.hpp", "fuzz"},
      {"plugin.h", "fuzz"},       {"eigen.hpp", "*"},
      {"touchstone.hpp", "*"},    {"c.h", "c_api"},
      {"ipc_toolkit.hpp", "*"},
  };
  return owners;
}

/// The reason why a file of this layer may not include a public header ("solve.hpp"); empty when it may.
std::string fault_of_public_include(const std::string& layer, const std::string& header) {
  if (header == "eigen.hpp") return "the library does without Eigen";
  const auto found = header_owners().find(header);
  if (found == header_owners().end()) return "the table of public headers has no `" + header + "`";
  const std::string& owner = found->second;
  if (owner == "*") return "the library includes the headers that it needs, one by one";
  const auto row = layer_table().find(layer);
  const bool allowed = owner.empty() || owner == layer || (row != layer_table().end() && row->second.count(owner) != 0);
  return allowed ? "" : "`" + layer + "` may not use `" + owner + "`, which defines the functions of this header";
}

/// Follows the layers that `layer` uses. `path` holds the layers on the way here, and `finished` those without a cycle
/// below them.
std::string cycle_from(const LayerTable& table, const std::string& layer, std::vector<std::string>& path,
                       Layers& finished) {
  const auto on_path = std::find(path.begin(), path.end(), layer);
  if (on_path != path.end()) {
    std::string cycle;
    for (auto i = on_path; i != path.end(); ++i) cycle += *i + " -> ";
    return cycle + layer;
  }
  const auto row = table.find(layer);
  if (row == table.end() || finished.count(layer) != 0) return {};
  path.push_back(layer);
  for (const std::string& used : row->second) {
    const std::string cycle = cycle_from(table, used, path, finished);
    if (!cycle.empty()) return cycle;
  }
  path.pop_back();
  finished.insert(layer);
  return {};
}

}  // namespace

std::string cycle_of(const LayerTable& table) {
  Layers finished;
  for (const auto& row : table) {
    std::vector<std::string> path;
    const std::string cycle = cycle_from(table, row.first, path, finished);
    if (!cycle.empty()) return cycle;
  }
  return {};
}

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
        violations.push_back(at(file, include, "only numbers, oracle and checker may include it"));
      }
    } else if (include.quoted) {
      if (layer_table().count(used) == 0) {
        violations.push_back(at(file, include, "a quoted include names the layer and the file"));
      } else if (layer.empty() || (used != layer && row->second.count(used) == 0)) {
        violations.push_back(at(file, include, "`" + layer + "` may not use `" + used + "`"));
      } else if (layer == "cli" && used == "cli" && !may_use_in_cli(room_in_cli(path), room_in_cli(include.target))) {
        violations.push_back(at(file, include,
                                "`cli/" + room_in_cli(path) + "` may not use `cli/" + room_in_cli(include.target) +
                                    "`; a command uses its own files and those of cli/shared"));
      }
    } else if (layer_table().count(used) != 0) {
      violations.push_back(at(file, include, "the project's own layers are included with quotes"));
    } else if (used == "touchstone") {
      const std::string fault = fault_of_public_include(layer, include.target.substr(used.size() + 1));
      if (!fault.empty()) violations.push_back(at(file, include, fault));
    }
  }
  return violations;
}

std::vector<std::string> layer_table_differences(std::string_view page) {
  // | `folder` | what lives there | `layer`, `layer` |    or: nothing, or: all of the others but `layer`
  static const std::regex row(R"(\| `([a-z_]+)` \|.*\| ([^|]*) \|)");
  static const std::regex name("`([a-z_]+)`");
  std::vector<std::string> differences;
  std::map<std::string, Layers> shown;
  bool in_table = false;
  std::istringstream lines{std::string(page)};
  for (std::string line; std::getline(lines, line);) {
    if (starts_with(line, "| folder |")) in_table = true;
    if (!starts_with(line, "|")) in_table = false;
    std::smatch match;
    if (!in_table || !std::regex_match(line, match, row)) continue;
    const std::string folder = match[1], uses = match[2];
    Layers& layers = shown[folder];
    Layers named;
    for (std::sregex_iterator i(uses.begin(), uses.end(), name), none; i != none; ++i) named.insert((*i)[1]);
    if (starts_with(uses, "all of the others")) {
      named.insert(folder);
      for (const auto& entry : layer_table()) {
        if (named.count(entry.first) == 0) layers.insert(entry.first);
      }
    } else {
      layers.insert(named.begin(), named.end());
    }
    if (layers.empty() && uses != "nothing") differences.push_back("`" + folder + "`: " + uses + " names no layer");
  }
  for (const auto& [folder, uses] : layer_table()) {
    const auto found = shown.find(folder);
    if (found == shown.end()) {
      differences.push_back("the page has no `" + folder + "`");
    } else if (found->second != uses) {
      differences.push_back("the page lets `" + folder + "` use other layers");
    }
  }
  for (const auto& entry : shown) {
    if (layer_table().count(entry.first) == 0) differences.push_back("there is no layer `" + entry.first + "`");
  }
  return differences;
}

std::vector<std::string> public_header_violations(const std::string& name, std::string_view text) {
  static const std::regex standard_header("[a-z_]+|std(def|int)\\.h");  // with .h for C
  std::vector<std::string> violations;
  const std::string file = "include/touchstone/" + name;
  const auto owner = header_owners().find(name);
  if (owner == header_owners().end()) return {file + ": the table of public headers has no `" + name + "`"};
  for (const Include& include : includes_of(text)) {
    const bool for_ipc_toolkit = name == "ipc_toolkit.hpp";
    const bool own =
        starts_with(include.target, "touchstone/") && (for_ipc_toolkit || include.target != "touchstone/eigen.hpp");
    const bool eigen = (name == "eigen.hpp" || for_ipc_toolkit) && starts_with(include.target, "Eigen/");
    const bool ipc = for_ipc_toolkit && starts_with(include.target, "ipc/");
    const bool standard = std::regex_match(include.target, standard_header);
    if (include.quoted || !(own || eigen || ipc || standard)) {
      violations.push_back(
          at(file, include, "a public header includes the standard library and <touchstone/...> only"));
    } else if (own && owner->second != "*") {
      const std::string fault = fault_of_public_include(owner->second, include.target.substr(sizeof "touchstone"));
      if (!fault.empty()) violations.push_back(at(file, include, fault));
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
