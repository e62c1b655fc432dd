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
      {"oracle", {}},
      {"solver", {"filters", "exact", "oracle", "geometry", "numbers", "threads"}},
      {"certify", {"solver", "numbers"}},
      {"baselines", {"rigid", "geometry"}},
      {"seeded", {}},
      {"families", {"geometry", "mesh", "numbers", "rigid", "seeded"}},
      {"broad_phase", {"threads"}},
      {"mesh", {"solver", "broad_phase", "filters", "threads", "geometry", "numbers"}},
      {"rigid", {"mesh", "solver", "broad_phase", "filters", "threads", "geometry", "numbers"}},
      {"frames", {"io", "json", "mesh"}},
      {"dropin", {"solver"}},
      {"c_api", {"solver", "mesh", "rigid"}},
      {"browser", {}},
      {"python",
       {"solver", "exact", "certify", "fuzz", "mesh", "rigid", "proofs", "view", "io", "frames", "sequence", "threads",
        "geometry"}},
      {"proofs", {"solver", "mesh", "broad_phase", "exact", "filters", "geometry", "io", "numbers"}},
      {"checker", {}},
      {"view", {"exact", "geometry", "io", "numbers", "proofs"}},
      {"generators", {"broad_phase", "seeded"}},
      {"fuzz",
       {"solver", "certify", "baselines", "families", "exact", "filters", "io", "mesh", "numbers", "geometry", "pipes",
        "rigid", "seeded"}},
      {"pipes", {"io", "numbers"}},
      {"io", {"numbers"}},
      {"json", {"io"}},
      {"linear", {"geometry"}},
      {"bodies", {}},
      {"scene", {"bodies", "generators", "json"}},
      {"shells", {"scene"}},
      {"rods", {"scene", "shells"}},
      {"contact", {"bodies", "broad_phase", "linear", "scene", "rods", "solver", "baselines", "geometry", "numbers"}},
      {"body_contact", {"contact", "geometry"}},
      {"dynamics", {"linear", "scene", "rods", "contact", "geometry"}},
      {"sim", {"linear", "scene", "rods", "contact", "body_contact", "dynamics", "mesh", "io", "json", "geometry"}},
      {"sequence", {"frames", "mesh", "geometry", "io", "json"}},
      {"report",
       {"solver", "certify", "baselines", "families", "generators", "io", "seeded", "bodies", "scene", "sim", "view"}},
      {"stress", {"io", "solver", "report", "seeded", "view"}},
      {"cli", {"numbers",  "filters",  "exact",  "solver", "certify",  "baselines", "generators", "io",   "report",
               "families", "fuzz",     "seeded", "scene",  "contact",  "sim",       "stress",     "mesh", "threads",
               "frames",   "sequence", "proofs", "view",   "geometry", "json",      "rigid"}},
  };
  return table;
}

const std::map<std::string, Wing>& wing_table() {
  static const std::map<std::string, Wing> table = {
      {"core",
       {{"geometry", "numbers", "threads", "filters", "exact", "oracle", "solver", "certify", "broad_phase", "mesh",
         "rigid"},
        {}}},
      {"files", {{"io", "json", "frames", "pipes", "sequence"}, {"core"}}},
      {"cases", {{"seeded", "families", "generators", "baselines"}, {"core"}}},
      {"proofs", {{"proofs", "checker"}, {"core", "files"}}},
      {"simulation",
       {{"linear", "bodies", "scene", "shells", "rods", "contact", "body_contact", "dynamics", "sim"},
        {"core", "files", "cases"}}},
      {"view", {{"view"}, {"core", "files", "proofs"}}},
      {"fuzz", {{"fuzz"}, {"core", "files", "cases"}}},
      {"measuring", {{"report", "stress"}, {"core", "files", "cases", "simulation", "view"}}},
      {"bindings", {{"c_api", "dropin", "python", "browser"}, {"core", "files", "proofs", "view", "fuzz"}}},
      {"cli", {{"cli"}, {"core", "files", "cases", "proofs", "simulation", "view", "fuzz", "measuring"}}},
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

std::string wing_of_layer(const std::string& layer) {
  for (const auto& [name, wing] : wing_table()) {
    if (wing.holds.count(layer) != 0) return name;
  }
  return {};
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
      {"answer.hpp", ""},
      {"error.hpp", ""},
      {"names.hpp", ""},
      {"kinds.h", ""},
      {"query.hpp", ""},
      {"separation.hpp", ""},
      {"vector_width.hpp", ""},
      {"version.hpp", ""},
      {"solve.hpp", "solver"},
      {"contact_times.hpp", "solver"},
      {"distance.hpp", "solver"},
      {"contact_normal.hpp", "solver"},
      {"curved.hpp", "solver"},
      {"curved_query.hpp", ""},
      {"screw.hpp", "solver"},
      {"mesh.hpp", "mesh"},
      {"bodies.hpp", "rigid"},
      {"certify.hpp", "certify"},
      {"fuzz.hpp", "fuzz"},
      {"plugin.h", "fuzz"},
      {"eigen.hpp", "*"},
      {"touchstone.hpp", "*"},
      {"c.h", "c_api"},
      {"c_bodies.h", "c_api"},
      {"ipc_toolkit.hpp", "*"},
      {"closest_approach.hpp", "mesh"},
      {"toi_gradient.hpp", "solver"},
      {"mesh_steps.hpp", "mesh"},
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

std::string layer_of(const std::string& path) {
  const std::string wing = first_part(path);
  const auto row = wing_table().find(wing);
  if (row == wing_table().end()) return wing;
  const std::string folder = first_part(path.substr(wing.size() + 1));
  return row->second.holds.count(folder) != 0 ? folder : wing;
}

std::vector<std::string> wing_violations(const LayerTable& layers) {
  std::vector<std::string> violations;
  for (const auto& [name, wing] : wing_table()) {
    for (const std::string& layer : wing.holds) {
      if (layers.count(layer) == 0)
        violations.push_back("the wing `" + name + "` holds `" + layer + "`, which is no layer");
    }
  }
  for (const auto& [layer, uses] : layers) {
    const auto held = std::count_if(wing_table().begin(), wing_table().end(), [&, &name = layer](const auto& wing) {
      return wing.second.holds.count(name) != 0;
    });
    if (held != 1) {
      violations.push_back("`" + layer + "` is in " + std::to_string(held) + " wings");
      continue;
    }
    const std::string wing = wing_of_layer(layer);
    for (const std::string& used : uses) {
      const std::string other = wing_of_layer(used);
      if (other == wing || wing_table().at(wing).uses.count(other) != 0) continue;
      violations.push_back("`" + layer + "` uses `" + used + "`, and the wing `" + wing + "` may not use `" + other +
                           "`");
    }
  }
  return violations;
}

Layers layers_used_by(const std::string& path, std::string_view text) {
  const std::string layer = layer_of(path);
  Layers used;
  for (const Include& include : includes_of(text)) {
    std::string other = include.quoted ? layer_of(include.target) : first_part(include.target);
    if (!include.quoted) {
      const auto owner =
          other == "touchstone" ? header_owners().find(include.target.substr(other.size() + 1)) : header_owners().end();
      other = owner == header_owners().end() ? std::string() : owner->second;
    }
    if (other != layer && layer_table().count(other) != 0) used.insert(other);
  }
  return used;
}

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
  const std::string layer = layer_of(path);
  const std::string file = "src/" + path;
  const auto row = layer_table().find(layer);
  if (!layer.empty() && row == layer_table().end()) {
    violations.push_back(file + ": the layer table has no `" + layer + "`");
    return violations;
  }
  for (const Include& include : includes_of(text)) {
    const std::string first = first_part(include.target);
    const std::string used = include.quoted ? layer_of(include.target) : first;
    if (is_number_library(include.target)) {
      if (kNumberLibraryLayers.count(layer) == 0) {
        violations.push_back(at(file, include, "only numbers, oracle and checker may include it"));
      }
    } else if (include.quoted) {
      if (layer_table().count(first) == 0) {
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

namespace {

/// The names between backquotes; with "all of the others but", all other names of the table.
template <class Table>
Layers named_in(const std::string& cell, const std::string& row, const Table& table) {
  static const std::regex name("`([a-z_]+)`");
  Layers named;
  for (std::sregex_iterator i(cell.begin(), cell.end(), name), none; i != none; ++i) named.insert((*i)[1]);
  if (!starts_with(cell, "all of the others")) return named;
  Layers others;
  for (const auto& entry : table) {
    if (named.count(entry.first) == 0 && entry.first != row) others.insert(entry.first);
  }
  return others;
}

/// Compares a table of the page, whose header begins with "| KIND |", with ours.
/// @param agrees  agrees(our entry, second cell, names of the last cell)
template <class Table, class Agrees>
void compare_table(std::string_view page, const std::string& kind, const Table& ours, const Agrees& agrees,
                   std::vector<std::string>& differences) {
  static const std::regex row(R"(\| `([a-z_]+)` \| (.*) \| ([^|]*) \|)");
  Layers shown;
  bool in_table = false;
  std::istringstream lines{std::string(page)};
  for (std::string line; std::getline(lines, line);) {
    if (starts_with(line, "| " + kind + " |")) in_table = true;
    if (!starts_with(line, "|")) in_table = false;
    std::smatch match;
    if (!in_table || !std::regex_match(line, match, row)) continue;
    const std::string name = match[1], uses = match[3];
    shown.insert(name);
    const auto found = ours.find(name);
    const Layers named = named_in(uses, name, ours);
    if (found == ours.end()) {
      differences.push_back("there is no " + kind + " `" + name + "`");
    } else if (named.empty() && uses != "nothing") {
      differences.push_back("`" + name + "`: " + uses + " names no " + kind);
    } else if (!agrees(found->second, match[2], named)) {
      differences.push_back("the page says other things of the " + kind + " `" + name + "`");
    }
  }
  for (const auto& entry : ours) {
    if (shown.count(entry.first) == 0) differences.push_back("the page has no " + kind + " `" + entry.first + "`");
  }
}

}  // namespace

std::vector<std::string> table_differences(std::string_view page) {
  std::vector<std::string> differences;
  compare_table(
      page, "folder", layer_table(),
      [](const Layers& uses, const std::string&, const Layers& named) { return uses == named; }, differences);
  compare_table(
      page, "wing", wing_table(),
      [](const Wing& wing, const std::string& holds, const Layers& named) {
        return wing.uses == named && wing.holds == named_in(holds, "", layer_table());
      },
      differences);
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
