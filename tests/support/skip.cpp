// SPDX-License-Identifier: MIT
#include "support/skip.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace touchstone::tests {
namespace {

bool skipped = false;

}  // namespace

void skip(const std::string& reason) {
  skipped = true;
  std::printf("skipped: %s\n", reason.c_str());
}

bool has_skipped() { return skipped; }

std::optional<std::string> find_tool(const std::string& tool) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    const auto program = std::filesystem::absolute(folder.empty() ? "." : folder, ignored) / tool;
    if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) {
      return program.string();
    }
  }
  return std::nullopt;
}

bool has_tool_or_skip(const std::string& tool) {
  if (find_tool(tool)) return true;
  skip("there is no " + tool + " in PATH (Debian's package is " + tool + ")");
  return false;
}

}  // namespace touchstone::tests
