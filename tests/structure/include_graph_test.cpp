// The sources include only what the table of layers allows, and the public headers include no other library.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "structure/include_rules.hpp"
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

using namespace touchstone::structure;

TEST_CASE("every source file includes only what its layer may use") {
  const auto files = cpp_files("src");
  CHECK(files.size() >= 15);  // an empty walk proves nothing
  for (const auto& file : files) {
    const auto violations =
        source_violations(file.generic_string(), text_of(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "src" / file));
    INFO(lines_of(violations));
    CHECK(violations.empty());
  }
}

namespace {

/// The functions of a source file whose bodies call a function of the same name, by itself: not that of an object or of
/// a namespace.
std::vector<std::string> recursive_functions(const std::string& text) {
  const std::regex head(R"((\w+)\([^;{}]*\)( const)? \{)");
  const std::vector<std::string> no_names = {"if", "for", "while", "switch", "catch", "return"};
  std::vector<std::string> found;
  for (std::sregex_iterator function(text.begin(), text.end(), head), none; function != none; ++function) {
    const std::string name = (*function)[1];
    if (std::find(no_names.begin(), no_names.end(), name) != no_names.end()) continue;
    const auto begin = static_cast<std::size_t>(function->position() + function->length());
    std::size_t end = begin;
    for (int depth = 1; depth > 0 && end < text.size(); ++end)
      depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
    const std::regex call("(^|[^.>:\\w])" + name + "\\(");
    if (std::regex_search(text.substr(begin, end - begin), call)) found.push_back(name);
  }
  return found;
}

}  // namespace

TEST_CASE("a planted function that calls itself is found") {
  using Names = std::vector<std::string>;
  CHECK(recursive_functions("int f(int n) {\n  if (n > 0) {\n    return 1 + f(n - 1);\n  }\n  return 0;\n}\n") ==
        Names{"f"});
  CHECK(recursive_functions("struct S {\n  void g() const { return g(); }\n};\n") == Names{"g"});
  CHECK(recursive_functions("void g() { lines.g(); std::g(); a_g(); }\nvoid h() { g(); }\n").empty());
}

TEST_CASE(
    "the checker of proofs includes nothing of the project, computes with integers, and is short enough to read") {
  constexpr std::size_t kMostLines = 450;  // of a file
  const std::regex floating_point(R"(\b(float|double) [a-z_]+( =|[(;,{])|[<(](float|double)[>)]|get_d\()");
  std::size_t total = 0;
  std::size_t files = 0;
  for (const auto& file : cpp_files("src/proofs/checker")) {
    const std::string text = text_of(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "src/proofs/checker" / file);
    for (const Include& include : includes_of(text)) {
      INFO(file << ": " << include.target);
      CHECK(include.quoted == (include.target.rfind("checker/", 0) == 0));
      CHECK(include.target.rfind("touchstone/", 0) != 0);
    }
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    INFO(file);
    CHECK(lines > 50);
    CHECK(lines <= kMostLines);
    CHECK_FALSE(std::regex_search(text, floating_point));
    CHECK(text.find("unordered_") == std::string::npos);  // its load factors are floating-point numbers
    CHECK(lines_of(recursive_functions(text)).empty());
    if (file != "mesh_files.hpp" && file != "frame_files.hpp") total += lines;  // which --frames alone needs
    ++files;
  }
  constexpr std::size_t kMostOfAll = 1990;
  CHECK(files == 12);
  CHECK(total <= kMostOfAll);
}

TEST_CASE("the page of proofs says which files of the checker to read, in their order, and how long they are") {
  const std::filesystem::path root(TOUCHSTONE_SOURCE_DIR);
  const std::string page = text_of(root / "docs/proofs.md");
  const std::regex row(R"(\n\|[^|]+\|((?: `\w+\.[ch]pp`,?)+) \| (\d+) \|)"), name(R"(`(\w+\.[ch]pp)`)");
  std::vector<std::string> seen;
  for (std::sregex_iterator found(page.begin(), page.end(), row), none; found != none; ++found) {
    const std::string names = (*found)[1];
    std::vector<std::string> texts;
    for (std::sregex_iterator file(names.begin(), names.end(), name); file != std::sregex_iterator(); ++file) {
      seen.push_back((*file)[1]);
      texts.push_back(text_of(root / "src/proofs/checker" / seen.back()));
      for (const Include& include : includes_of(texts.back())) {
        if (!include.quoted) continue;
        INFO(seen.back() << " includes " << include.target << ", which the page names after it, or not");
        CHECK(std::find(seen.begin(), seen.end(), include.target.substr(include.target.find('/') + 1)) != seen.end());
      }
    }
    std::size_t lines = 0;
    for (const std::string& text : texts) lines += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    INFO("docs/proofs.md:" << names << " have " << lines << " lines, but the page says " << (*found)[2]);
    CHECK(std::to_string(lines) == (*found)[2]);
  }
  std::sort(seen.begin(), seen.end());
  CHECK(lines_of(seen) == lines_of([] {
          std::vector<std::string> all;
          for (const auto& file : cpp_files("src/proofs/checker")) all.push_back(file.string());
          return all;
        }()));
}

TEST_CASE("public headers include the standard library and each other only") {
  const auto files = cpp_files("include/touchstone");
  CHECK(files.size() >= 9);
  for (const auto& file : files) {
    const auto violations = public_header_violations(
        file.generic_string(), text_of(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "include/touchstone" / file));
    INFO(lines_of(violations));
    CHECK(violations.empty());
  }
}

TEST_CASE("a planted violation of the layer table is found") {
  struct Planted {
    const char* path;
    const char* text;
    const char* reason;
  };
  const Planted planted = GENERATE(
      Planted{"core/exact/x.cpp", "#include \"solver/cascade.hpp\"\n", "`exact` may not use `solver`"},
      Planted{"core/oracle/x.cpp", "#include \"exact/exact.hpp\"\n", "`oracle` may not use `exact`"},
      Planted{"core/oracle/x.cpp", "#include \"filters/apart/same_side.hpp\"\n", "`oracle` may not use `filters`"},
      Planted{"core/geometry/x.hpp", "#include \"numbers/fraction.hpp\"\n", "`geometry` may not use `numbers`"},
      Planted{"files/io/x.cpp", "#include \"solver/solve.hpp\"\n", "`io` may not use `solver`"},
      Planted{"core/solver/x.cpp", "#include \"io/query_file.hpp\"\n", "`solver` may not use `io`"},
      Planted{"core/certify/x.cpp", "#include \"cli/main.hpp\"\n", "`certify` may not use `cli`"},
      Planted{"version.cpp", "#include \"geometry/x.hpp\"\n", "may not use `geometry`"},
      Planted{"core/exact/x.cpp", "#include <CGAL/Mpzf.h>\n", "only numbers, oracle and checker"},
      Planted{"core/filters/x.hpp", "  #  include <gmp.h>\n", "only numbers, oracle and checker"},
      Planted{"cli/x.cpp", "#include <mpfr.h>\n", "only numbers, oracle and checker"},
      Planted{"core/solver/x.cpp", "#include \"boost/multiprecision/gmp.hpp\"\n", "only numbers, oracle and checker"},
      Planted{"core/exact/x.cpp", "#include \"exact.hpp\"\n", "names the layer"},
      Planted{"core/exact/x.cpp", "#include \"../solver/cascade.hpp\"\n", "names the layer"},
      Planted{"core/exact/x.cpp", "#include <solver/cascade.hpp>\n", "with quotes"},
      Planted{"files/io/x.cpp", "#include <touchstone/eigen.hpp>\n", "without Eigen"},
      Planted{"simulation/sim/x.cpp", "#include \"exact/exact.hpp\"\n", "`sim` may not use `exact`"},
      Planted{"cli/bench/x.cpp", "#include \"cli/fuzz/fuzz.hpp\"\n", "`cli/bench` may not use `cli/fuzz`"},
      Planted{"cli/bench/x.cpp", "#include \"cli/solve.hpp\"\n", "`cli/bench` may not use `cli/solve`"},
      Planted{"cli/solve.cpp", "#include \"cli/report.hpp\"\n", "`cli/solve` may not use `cli/report`"},
      Planted{"cli/solve.cpp", "#include \"cli/fuzz/fuzz.hpp\"\n", "`cli/solve` may not use `cli/fuzz`"},
      Planted{"cli/shared/x.hpp", "#include \"cli/solve.hpp\"\n", "`cli/shared` may not use `cli/solve`"},
      Planted{"cli/main.cpp", "#include \"cli/solve.hpp\"\n", "`cli/main` may not use `cli/solve`"},
      Planted{"cli/fuzz/x.cpp", "#include \"cli/queries/bundled.hpp\"\n", "may not use `cli/queries`"},
      Planted{"core/solver/x.cpp", "#include \"scene/scene.hpp\"\n", "`solver` may not use `scene`"},
      Planted{"simulation/rods/x.cpp", "#include \"contact/contact.hpp\"\n", "`rods` may not use `contact`"},
      Planted{"simulation/contact/x.cpp", "#include \"dynamics/newton.hpp\"\n", "`contact` may not use `dynamics`"},
      Planted{"simulation/dynamics/x.cpp", "#include \"sim/simulation.hpp\"\n", "`dynamics` may not use `sim`"},
      Planted{"core/filters/x.hpp", "#include <touchstone/solve.hpp>\n", "`filters` may not use `solver`"},
      Planted{"core/exact/x.cpp", "#include <touchstone/contact_times.hpp>\n", "`exact` may not use `solver`"},
      Planted{"core/solver/x.cpp", "#include <touchstone/certify.hpp>\n", "`solver` may not use `certify`"},
      Planted{"core/certify/x.cpp", "#include <touchstone/fuzz.hpp>\n", "`certify` may not use `fuzz`"},
      Planted{"files/io/x.cpp", "#include <touchstone/plugin.h>\n", "`io` may not use `fuzz`"},
      Planted{"bindings/dropin/x.cpp", "#include \"exact/exact.hpp\"\n", "`dropin` may not use `exact`"},
      Planted{"bindings/dropin/x.cpp", "#include <touchstone/mesh.hpp>\n", "`dropin` may not use `mesh`"},
      Planted{"version.cpp", "#include <touchstone/solve.hpp>\n", "may not use `solver`"},
      Planted{"cli/x.cpp", "#include <touchstone/touchstone.hpp>\n", "one by one"},
      Planted{"cli/x.cpp", "#include <touchstone/none.hpp>\n", "has no `none.hpp`"},
      Planted{"proofs/x.cpp", "#include \"proofs/checker/motion.hpp\"\n", "`proofs` may not use `checker`"},
      Planted{"core/exact/x.cpp", "#include \"core/exact/exact.hpp\"\n", "names the layer"},
      Planted{"unheard_of/x.cpp", "", "has no `unheard_of`"});
  CAPTURE(planted.path, planted.text);
  const auto violations = source_violations(planted.path, planted.text);
  REQUIRE(violations.size() == 1);
  CHECK(violations[0].find(planted.reason) != std::string::npos);
}

TEST_CASE("layers keep to their wings, and every permission is used by an include") {
  INFO(lines_of(wing_violations(layer_table())));
  CHECK(wing_violations(layer_table()).empty());
  LayerTable wings;
  for (const auto& [name, wing] : wing_table()) wings[name] = wing.uses;
  CHECK(cycle_of(wings) == "");

  LayerTable used;
  for (const auto& file : cpp_files("src")) {
    const std::string path = file.generic_string(), layer = layer_of(path);
    const Layers layers = layers_used_by(path, text_of(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "src" / file));
    used[layer].insert(layers.begin(), layers.end());
  }
  for (const auto& [layer, may_use] : layer_table()) {
    for (const std::string& other : may_use) {
      INFO("`" << layer << "` may use `" << other << "`, and no file of it does");
      CHECK(used[layer].count(other) != 0);
    }
  }
  for (const auto& [name, wing] : wing_table()) {
    for (const std::string& other : wing.uses) {
      bool found = false;
      for (const std::string& layer : wing.holds) {
        for (const std::string& one : used[layer]) found = found || wing_table().at(other).holds.count(one) != 0;
      }
      INFO("the wing `" << name << "` may use `" << other << "`, and no file of it does");
      CHECK(found);
    }
  }

  LayerTable planted = layer_table();
  planted["numbers"].insert("io");
  planted["unheard_of"] = {};
  CHECK(wing_violations(planted).size() == 2);
  planted.erase("checker");
  CHECK(wing_violations(planted).size() == 3);
}

TEST_CASE("the layers have no cycle, and a planted cycle is found") {
  CHECK(cycle_of(layer_table()) == "");
  CHECK(cycle_of({{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {}}}) == "");
  CHECK(cycle_of({{"a", {"a"}}}) == "a -> a");
  CHECK(cycle_of({{"a", {"b"}}, {"b", {"c", "d"}}, {"c", {}}, {"d", {"b"}}}) == "b -> d -> b");
  LayerTable table = layer_table();
  table["geometry"].insert("cli");
  CHECK(cycle_of(table) != "");
}

TEST_CASE("an include that the table of layers allows is no violation") {
  CHECK(source_violations("core/exact/x.cpp",
                          "#include \"numbers/a.hpp\"\n#include \"exact/b.hpp\"\n#include <touchstone/query.hpp>\n")
            .empty());
  CHECK(source_violations("core/solver/x.cpp", "#include \"oracle/oracle.hpp\"\n#include <vector>\n").empty());
  CHECK(source_violations("cli/bench/x.cpp", "#include \"cli/bench/sets.hpp\"\n#include \"cli/shared/words.hpp\"\n")
            .empty());
  CHECK(source_violations("cli/solve.cpp", "#include \"cli/solve.hpp\"\n#include \"cli/shared/words.hpp\"\n").empty());
  CHECK(source_violations("cli/program.cpp", "#include \"cli/fuzz/fuzz.hpp\"\n#include \"cli/solve.hpp\"\n").empty());
  CHECK(source_violations("cli/shared/x.cpp", "#include \"cli/queries/bundled.hpp\"\n").empty());
  CHECK(source_violations("core/numbers/x.hpp", "#include <CGAL/Mpzf.h>\n#include <gmp.h>\n").empty());
  CHECK(source_violations("core/exact/x.cpp", "// #include \"solver/cascade.hpp\"\n").empty());
  CHECK(source_violations("core/filters/x.hpp", "#include <touchstone/vector_width.hpp>\n").empty());
  CHECK(source_violations("core/solver/x.cpp", "#include <touchstone/contact_times.hpp>\n").empty());
  CHECK(source_violations("simulation/contact/x.cpp", "#include <touchstone/solve.hpp>\n").empty());
}

TEST_CASE("a planted violation in a public header is found") {
  const char* text = GENERATE("#include <CGAL/Mpzf.h>\n", "#include <gmp.h>\n", "#include <mpfr.h>\n",
                              "#include <boost/version.hpp>\n", "#include <tbb/version.h>\n", "#include <Eigen/Core>\n",
                              "#include \"solver/cascade.hpp\"\n", "#include <touchstone/eigen.hpp>\n",
                              "#include <touchstone/certify.hpp>\n", "#include <touchstone/touchstone.hpp>\n",
                              "#include <touchstone/none.hpp>\n");
  CAPTURE(text);
  const auto violations = public_header_violations("solve.hpp", std::string("#include <vector>\n") + text);
  REQUIRE(violations.size() == 1);
  CHECK(violations[0].find("include/touchstone/solve.hpp:2:") == 0);
  CHECK(public_header_violations("eigen.hpp", "#include <Eigen/Core>\n").empty());
  CHECK(public_header_violations("eigen.hpp", "#include <ipc/ipc.hpp>\n").size() == 1);
  CHECK(
      public_header_violations("ipc_toolkit.hpp", "#include <ipc/ipc.hpp>\n#include <touchstone/eigen.hpp>\n").empty());
  CHECK(public_header_violations("c.h", "#include <stddef.h>\n").empty());
  CHECK(public_header_violations("certify.hpp", "#include <touchstone/solve.hpp>\n").empty());
  CHECK(public_header_violations("touchstone.hpp", "#include <touchstone/certify.hpp>\n").empty());
  CHECK(public_header_violations("query.hpp", "#include <touchstone/solve.hpp>\n").size() == 1);
  CHECK(public_header_violations("none.hpp", "").size() == 1);
}

TEST_CASE("docs/design.md has the table of layers that these tests use") {
  const std::string page = text_of(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "docs/design.md");
  const auto differences = table_differences(page);
  INFO(lines_of(differences));
  CHECK(differences.empty());

  const auto planted = [&](const std::string& there, const std::string& instead) {
    std::string other = page;
    const std::size_t at = other.find(there);
    REQUIRE(at != std::string::npos);
    return table_differences(other.replace(at, there.size(), instead)).size();
  };
  CHECK(planted("| `oracle` |", "| `oracles` |") == 2);  // one is missing, one is unknown
  CHECK(planted("| `families` |", "| `families` | planted | `geometry`, `seeded`, `solver` |\n| `families` |") == 1);
  CHECK(planted("| all of the others", "| `geometry`") == 1);
  CHECK(planted("| nothing |", "| everything |") == 1);
  CHECK(planted("| folder |", "| other |") > 10);
}
