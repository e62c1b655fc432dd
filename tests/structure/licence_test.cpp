// No GPL part of CGAL reaches any source file, directly or through other headers: the compiler lists what each one
// reads, and each CGAL header says its licence in its first lines.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "structure/include_rules.hpp"
#include "structure/shell.hpp"
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

using namespace touchstone::structure;
namespace fs = std::filesystem;

namespace {

/// A folder of its own that goes away with it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "touchstone-structure-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + name);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// The prerequisites in a make rule as compilers write it: "target: a b \<newline> c"; a space in a name is "\ ".
std::vector<std::string> prerequisites(const std::string& rule) {
  std::vector<std::string> names;
  std::string name;
  const auto finish = [&] {
    if (!name.empty()) names.push_back(name);
    name.clear();
  };
  for (std::size_t i = rule.find(": ") + 1; i < rule.size(); ++i) {
    if (rule[i] == '\\' && i + 1 < rule.size() && rule[i + 1] != '\n') {
      name += rule[++i];
    } else if (rule[i] == '\\' || rule[i] == ' ' || rule[i] == '\n') {
      finish();
    } else {
      name += rule[i];
    }
  }
  finish();
  return names;
}

/// Every file that the compiler reads for one translation unit, given its command line "... -o OBJECT -c SOURCE".
std::vector<std::string> files_read(const std::string& directory, const std::string& command) {
  const ScratchFolder scratch;
  const fs::path rule = scratch.path() / "rule.d";
  const std::size_t object = command.rfind(" -o ");
  const std::size_t source = command.rfind(" -c ");
  INFO(command);
  REQUIRE(object != std::string::npos);
  REQUIRE(source != std::string::npos);
  REQUIRE(object < source);
  const ShellResult result = run_shell("cd " + shell_quoted(directory) + " && " + command.substr(0, object) +
                                       " -M -MF " + shell_quoted(rule.string()) + " " + command.substr(source + 4));
  INFO(result.output);
  REQUIRE(result.status == 0);
  std::vector<std::string> files = prerequisites(text_of(rule));
  for (std::string& file : files) file = (fs::path(directory) / file).string();
  return files;
}

bool is_cgal_header(const std::string& file) { return file.find("/CGAL/") != std::string::npos; }

/// Of the files read, the CGAL headers whose licence the library may not build on, each with that licence.
std::set<std::string> forbidden_headers(const std::vector<std::string>& files) {
  std::set<std::string> forbidden;
  for (const std::string& file : files) {
    if (!is_cgal_header(file)) continue;
    const std::string licence = licence_of(text_of(file));
    if (is_forbidden_licence(licence)) forbidden.insert(file + ": " + (licence.empty() ? "no licence" : licence));
  }
  return forbidden;
}

struct CompileCommand {
  std::string directory, file, command;
};

/// Of a unity build, too: its sources are in the same folder of the build.
std::vector<CompileCommand> compile_commands_below(const std::string& folder) {
  std::ifstream in(TOUCHSTONE_COMPILE_COMMANDS);
  REQUIRE(in);
  std::vector<CompileCommand> commands;
  const std::string build = fs::path(TOUCHSTONE_COMPILE_COMMANDS).parent_path().string();
  const auto is_below = [&](const std::string& root, const std::string& file) {
    return file.rfind(root + "/" + folder + "/", 0) == 0;
  };
  for (const auto& entry : nlohmann::json::parse(in)) {
    const std::string file = entry.at("file");
    if (is_below(TOUCHSTONE_SOURCE_DIR, file) || is_below(build, file)) {
      commands.push_back({entry.at("directory"), file, entry.at("command")});
    }
  }
  return commands;
}

}  // namespace

TEST_CASE("no source file reads a GPL header of CGAL", "[slow]") {
  const auto commands = compile_commands_below("src");
  // Each layer with CGAL is read, whether its sources are compiled by themselves or in a unity build.
  for (const char* const layer : {"/src/core/oracle/", "/src/core/exact/"}) {
    CHECK(std::any_of(commands.begin(), commands.end(),
                      [&](const auto& command) { return command.file.find(layer) != std::string::npos; }));
  }
  std::size_t cgal_headers = 0;
  for (const auto& [directory, file, command] : commands) {
    const auto files = files_read(directory, command);
    for (const std::string& header : files) cgal_headers += is_cgal_header(header) ? 1 : 0;
    for (const std::string& header : forbidden_headers(files)) FAIL_CHECK(file << " reads " << header);
  }
  CHECK(cgal_headers >= 100);  // the compiler's list was read, and it is not empty
}

TEST_CASE("a planted GPL header of CGAL is found, however deep") {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "include dir/CGAL");
  const auto write = [&](const char* name, const char* text) { std::ofstream(scratch.path() / name) << text; };
  write("include dir/CGAL/Shell.h",
        "// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial\n#include <CGAL/Kernel.h>\n");
  write("include dir/CGAL/Kernel.h", "// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial\n");
  write("include dir/CGAL/Silent.h", "// a header that does not say\n");
  write("deep.cpp", "#include <CGAL/Shell.h>\n");
  write("silent.cpp", "#include <CGAL/Silent.h>\n");
  const auto forbidden = [&](const char* source) {
    return forbidden_headers(files_read(scratch.path().string(),
                                        shell_quoted(TOUCHSTONE_COMPILER) + " -I'include dir' -o out.o -c " + source));
  };

  const std::set<std::string> deep = forbidden("deep.cpp");
  REQUIRE(deep.size() == 1);
  CHECK(deep.begin()->find("CGAL/Kernel.h: GPL-3.0-or-later") != std::string::npos);
  CHECK(forbidden("silent.cpp").size() == 1);
  CHECK(!fs::exists(scratch.path() / "out.o"));
}

TEST_CASE("CGAL's own GPL packages would be found in a source file of numbers", "[slow]") {
  const char* header = GENERATE("AABB_tree.h", "box_intersection_d.h", "Polygon_mesh_processing/distance.h");
  CAPTURE(header);
  const ScratchFolder scratch;
  const fs::path source = scratch.path() / "planted.cpp";
  std::ofstream(source) << "#include <CGAL/" << header << ">\n";
  const auto commands = compile_commands_below("src/core/numbers");
  REQUIRE(!commands.empty());
  const std::string& command = commands.front().command;
  const std::string planted = command.substr(0, command.rfind(" -c ") + 4) + shell_quoted(source.string());
  CHECK(!forbidden_headers(files_read(commands.front().directory, planted)).empty());
}

TEST_CASE("licences are told apart") {
  CHECK(is_forbidden_licence("GPL-3.0-or-later OR LicenseRef-Commercial"));
  CHECK(is_forbidden_licence("( GPL-3.0-or-later OR LicenseRef-Commercial ) AND MIT"));
  CHECK(is_forbidden_licence("GPL-2.0-or-later"));
  CHECK(is_forbidden_licence("AGPL-3.0-only"));
  CHECK(is_forbidden_licence(""));
  CHECK_FALSE(is_forbidden_licence("LGPL-3.0-or-later OR LicenseRef-Commercial"));
  CHECK_FALSE(is_forbidden_licence("LGPL-3.0-only"));
  CHECK_FALSE(is_forbidden_licence("BSL-1.0"));
  CHECK(licence_of("// x\n * SPDX-License-Identifier: MIT\r\n// y") == "MIT");
  CHECK(licence_of("// no tag").empty());
}
