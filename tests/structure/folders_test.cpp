// The tree of sources can be read from its folders: none is long, and at most two have a file of one name.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "structure/source_tree.hpp"
#include "support/catch.hpp"

using namespace touchstone::structure;

namespace {

const std::filesystem::path kSources = std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "src";

}  // namespace

TEST_CASE("src lists at most ten wings, and no folder of sources more than 29 files") {
  constexpr std::size_t kMostWings = 10, kMostFiles = 29;
  std::size_t wings = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kSources)) wings += entry.is_directory() ? 1 : 0;
  CHECK(wings >= 5);
  CHECK(wings <= kMostWings);

  std::map<std::string, std::size_t> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kSources)) {
    if (entry.is_regular_file() && entry.path().extension() != ".csv") ++files[entry.path().parent_path().string()];
  }
  for (const auto& [folder, count] : files) {
    INFO(folder);
    CHECK(count <= kMostFiles);
  }
}

TEST_CASE("at most two folders have a source of one name") {
  std::map<std::string, std::set<std::string>> folders;
  for (const auto& file : cpp_files("src")) {
    folders[file.stem().string()].insert(file.parent_path().generic_string());
  }
  CHECK(folders.size() > 100);
  for (const auto& [name, of_name] : folders) {
    std::string list;
    for (const std::string& folder : of_name) list += ' ' + folder;
    INFO(name << ":" << list);
    CHECK(of_name.size() <= 2);
  }
}

TEST_CASE("constants and types of unnamed namespaces have different names in a layer, as unity builds need it") {
  const std::string begins = "\nnamespace {\n", ends = "\n}  // namespace\n";
  const std::regex name(
      R"(\n(?:(?:struct|class|enum class) (\w+)|(?:constexpr|const)[^(\n]* (k[A-Z]\w*))[^(\n]*[={;])");
  std::map<std::string, std::set<std::string>> files;  // by layer and name
  std::size_t layers = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kSources)) {
    if (entry.path().filename() != "CMakeLists.txt") continue;
    const std::string list = text_of(entry.path());
    if (list.find("touchstone_layer(") == std::string::npos) continue;
    ++layers;
    const std::filesystem::path layer = entry.path().parent_path();
    const std::regex source(R"(\s([\w/]+\.cpp)\s)");
    for (std::sregex_iterator one(list.begin(), list.end(), source), end; one != end; ++one) {
      if (!std::filesystem::exists(layer / (*one)[1].str())) continue;
      const std::string text = text_of(layer / (*one)[1].str());
      // By hand: a pattern over many lines takes a call for each letter.
      for (std::size_t from = text.find(begins), to; from != text.npos; from = text.find(begins, to)) {
        to = text.find(ends, from);
        REQUIRE(to != text.npos);
        const std::string names = text.substr(from, to - from);
        for (std::sregex_iterator found(names.begin(), names.end(), name); found != end; ++found) {
          files[layer.filename().string() + ": " + (*found)[1].str() + (*found)[2].str()].insert((*one)[1].str());
        }
      }
    }
  }
  CHECK(layers > 20);
  CHECK(files.size() > 200);
  for (const auto& [name_in_layer, its_files] : files) {
    std::string sources;
    for (const std::string& file : its_files) sources += ' ' + file;
    INFO(name_in_layer << ":" << sources);
    CHECK(its_files.size() == 1);
  }
}
