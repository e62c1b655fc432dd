// A folder of files that appears whole or not at all.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::cli {

/// The files go into a temporary folder beside the target; commit() gives it the target's name. So there may be any
/// number of files, and none is open while the next one is written. An object that is destroyed without a commit
/// removes the temporary folder. A process that is killed cannot. Then TARGET.touchstone-N.partial stays, until the
/// same target is written again.
class WholeFolder {
 public:
  /// @throws FileError when there is something of this name that is no empty folder, or no folder can be made beside it
  explicit WholeFolder(std::filesystem::path target);

  std::string name() const { return target_.string(); }

  /// Where a file of this name is written before the commit.
  std::string path(const std::string& file) const { return (temporary_ / file).string(); }

  /// Puts the folder in the target's place. The files in it are complete. @throws FileError
  void commit();

  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;
  ~WholeFolder();

 private:
  std::filesystem::path target_, temporary_;  ///< temporary_ is empty after the commit
  int descriptor_ = -1;                       ///< of the temporary folder, locked
};

}  // namespace touchstone::cli
