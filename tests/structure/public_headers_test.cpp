// Each public header compiles by itself, in every mode that a user may compile it, without a warning.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "structure/include_rules.hpp"
#include "structure/shell.hpp"
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

using namespace touchstone::structure;

namespace {

/// The compiler's word on a translation unit of this text.
ShellResult compile(const std::string& text, const std::string& options) {
  std::string command = "printf '%s\\n' " + shell_quoted(text) + " | " + shell_quoted(TOUCHSTONE_COMPILER) +
                        " -x c++ " + options + " -I " + shell_quoted(std::string(TOUCHSTONE_SOURCE_DIR) + "/include");
  command += " -isystem " + shell_quoted(std::string(TOUCHSTONE_SOURCE_DIR) + "/tests/ipc_toolkit/interface");
  if (!std::string(TOUCHSTONE_EIGEN_INCLUDE).empty()) command += " -isystem " + shell_quoted(TOUCHSTONE_EIGEN_INCLUDE);
  return run_shell(command + " -");
}

// With -ffast-math what a header needs of others is the same, so that all are compiled at once.
const char* const kModes[] = {"-std=c++17", "-std=c++20", "-std=c++17 -O2 -ffast-math", "-std=c++20 -O2 -ffast-math"};
constexpr std::size_t kModesApart = 2;
const std::string kStrict = " -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -fsyntax-only";

/// Compiles each header by itself in the first modes, and all of them together in the others.
void check_headers(const std::vector<std::string>& names, const std::string& options) {
  const auto check = [&](const std::string& text, const char* mode) {
    const ShellResult result = compile(text, mode + kStrict + options);
    INFO(text << "\n" << mode << "\n" << result.output);
    CHECK(result.status == 0);
  };
  std::string all;
  for (const std::string& name : names) {
    const std::string text = "#include <" + name + ">\n";
    for (std::size_t i = 0; i < kModesApart; ++i) check(text, kModes[i]);
    all += text;
  }
  for (std::size_t i = kModesApart; i < std::size(kModes); ++i) check(all, kModes[i]);
}

bool can_be_compiled(const std::string& header) {
  return (header != "eigen.hpp" && header != "ipc_toolkit.hpp") || !std::string(TOUCHSTONE_EIGEN_INCLUDE).empty();
}

}  // namespace

TEST_CASE("each public header compiles by itself", "[slow]") {
  std::vector<std::string> names;
  for (const auto& header : cpp_files("include/touchstone")) {
    const std::string name = header.generic_string();
    if (can_be_compiled(name)) names.push_back("touchstone/" + name);
  }
  CHECK(names.size() >= 15);
  check_headers(names, "");
}

TEST_CASE("each header of the drop-ins compiles by itself", "[slow]") {
  if (std::string(TOUCHSTONE_EIGEN_INCLUDE).empty()) return;
  const std::string folder = "src/bindings/dropin/tight_inclusion/include";
  std::vector<std::string> names;
  for (const auto& header : cpp_files(folder)) names.push_back(header.generic_string());
  CHECK(names.size() >= 5);
  check_headers(names, " -I " + shell_quoted(std::string(TOUCHSTONE_SOURCE_DIR) + "/" + folder));
}

TEST_CASE("a header that does not compile by itself, or warns, is found") {
  for (const char* mode : kModes) {
    CHECK(compile("namespace touchstone { struct Ok {}; }", mode + kStrict).status == 0);
    CHECK(compile("namespace touchstone { std::string name(); }", mode + kStrict).status != 0);
    CHECK(compile("inline int unused(int parameter) { return 0; }", mode + kStrict).status != 0);
    CHECK(compile("#include <touchstone/no_such_header.hpp>", mode + kStrict).status != 0);
  }
  CHECK(compile("template <class T> concept Any = true;", "-std=c++17" + kStrict).status != 0);
}

TEST_CASE("an older standard than C++17 is told by its name") {
  const ShellResult result = compile("#include <touchstone/mesh.hpp>", "-std=c++14 -fsyntax-only");
  CHECK(result.status != 0);
  CHECK(result.output.find("Touchstone's headers need C++17 or later") != std::string::npos);
}

TEST_CASE("public headers bring no header of CGAL, GMP, MPFR or Boost along", "[slow]") {
  const auto reads_number_library = [](const std::string& header) {
    // Line markers name the files that are read. (-M of clang also lists those that __has_include only looks for.)
    const ShellResult result = compile("#include <" + header + ">", "-std=c++17 -E");
    REQUIRE(result.status == 0);
    std::istringstream lines(result.output);
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("# ", 0) != 0) continue;
      for (const char* part : {"/CGAL/", "/boost/", "/gmp", "/mpfr", "/tbb/"}) {
        if (line.find(part) != std::string::npos) return true;
      }
    }
    return false;
  };
  for (const auto& header : cpp_files("include/touchstone")) {
    CAPTURE(header.generic_string());
    if (can_be_compiled(header.generic_string())) {
      CHECK_FALSE(reads_number_library("touchstone/" + header.generic_string()));
    }
  }
  CHECK(reads_number_library("gmp.h"));
}

TEST_CASE("a question is asked by SolveOptions, and a bare separation or method does not compile", "[slow]") {
  const auto compiles = [](const std::string& expression) {
    const std::string text =
        "#include <touchstone/touchstone.hpp>\nvoid f(const touchstone::Query& query, const touchstone::RationalQuery& "
        "rational) { using namespace touchstone; (void)query; (void)rational; (void)" +
        expression + "; }";
    return compile(text, kModes[0] + kStrict).status == 0;
  };
  CHECK(compiles("solve(query, 0.5)"));
  CHECK(compiles("solve(query, 1)"));
  CHECK(compiles("solve(query, {})"));
  CHECK(compiles("solve(query, SolveOptions())"));
  CHECK(compiles("solve(query, {0.5, {0.001, Metric::max}})"));
  CHECK_FALSE(compiles("solve(query, Separation{0.001})"));
  CHECK_FALSE(compiles("solve(query, Method::exact)"));
  CHECK(compiles("contact_times(query, {0.001}, 0.5)"));
  CHECK_FALSE(compiles("contact_times(query, 0.5)"));
  CHECK_FALSE(compiles("contact_times(rational, 0.5)"));
}
