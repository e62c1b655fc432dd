// Folders that lead to an output file: made when they are missing, removed again when no file is written.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace touchstone::cli {

class NewFolders {
 public:
  NewFolders() = default;

  /// Makes `folder` and its missing parents. @throws FileError
  void make(const std::filesystem::path& folder);

  /// The folders stay.
  void keep() noexcept { made_.clear(); }

  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;

  /// Removes the folders that were made here and are still empty.
  ~NewFolders();

 private:
  std::vector<std::filesystem::path> made_;  ///< outer ones first
};

}  // namespace touchstone::cli
