// SPDX-License-Identifier: MIT
#include "cli/doctor/found_components.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>

#include "io/fail.hpp"

namespace touchstone::cli {
namespace {

/// The program of this name that PATH finds, as an absolute path.
std::optional<std::string> find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    const auto program = std::filesystem::absolute(folder.empty() ? "." : folder, ignored) / name;
    if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) {
      return program.string();
    }
  }
  return std::nullopt;
}

/// The checker of proofs beside this program, or in PATH.
std::optional<std::string> find_checker() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto beside = self.parent_path() / "touchstone-check";
    if (std::filesystem::is_regular_file(beside, error)) return beside.string();
  }
  return find_program("touchstone-check");
}

}  // namespace

std::vector<BuildComponent> found_components() {
  const auto checker = find_checker();
  return {{"proof checker", checker.has_value(),
           checker ? io::printable(*checker) : "touchstone-check is neither beside this program nor in PATH", ""}};
}

}  // namespace touchstone::cli
