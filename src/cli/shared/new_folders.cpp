// SPDX-License-Identifier: MIT
#include "cli/shared/new_folders.hpp"

#include <system_error>

#include "io/fail.hpp"

namespace touchstone::cli {

void NewFolders::make(const std::filesystem::path& folder) {
  std::filesystem::path path;
  for (const auto& name : folder) {
    path /= name;
    std::error_code error;
    if (std::filesystem::create_directory(path, error)) made_.push_back(path);
    if (!error) continue;
    std::error_code ignored;
    if (std::filesystem::is_symlink(path, ignored) && !std::filesystem::exists(path, ignored)) {
      io::fail(path.string(), "is a link to " + io::printable(std::filesystem::read_symlink(path, ignored).string()) +
                                  ", which does not exist; make that folder, or remove the link");
    }
    io::fail(path.string(), "no folder can be made here: " + io::system_reason(error.value()));
  }
}

NewFolders::~NewFolders() {
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) {
    std::error_code ignored;
    std::filesystem::remove(*folder, ignored);  // refuses a folder that is not empty
  }
}

}  // namespace touchstone::cli
