// Folders on the way to an output file, made when they are missing and taken back when nothing comes of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace touchstone::cli {

class NewFolders {
 public:
  NewFolders() = default;

  /// Makes `folder` and what leads to it. @throws FileError
  void make(const std::filesystem::path& folder);

  /// They stay.
  void keep() noexcept { made_.clear(); }

  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;

  /// Removes the folders that were made here, those that are empty.
  ~NewFolders();

 private:
  std::vector<std::filesystem::path> made_;  ///< outer ones first
};

}  // namespace touchstone::cli
