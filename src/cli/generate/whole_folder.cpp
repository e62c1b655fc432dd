// SPDX-License-Identifier: MIT
#include "cli/generate/whole_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "io/fail.hpp"

namespace touchstone::cli {
namespace {

namespace fs = std::filesystem;

/// The folder's files and the folder, or nothing of it that is more than that: a folder inside it stays, and it, too.
void remove_with_files(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
    std::error_code ignored;
    if (fs::is_regular_file(file->symlink_status(ignored))) fs::remove(file->path(), ignored);
  }
  fs::remove(folder, error);
}

/// Opens a folder and locks it: its maker holds the lock while it has this name, so that a folder that can be locked
/// is the leftover of a process that was killed. @returns -1 when it is locked, gone, or no folder
int open_locked(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat opened {
  }, named{};
  const bool held = descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
                    ::fstat(descriptor, &opened) == 0 && ::lstat(folder.c_str(), &named) == 0 &&
                    opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
  if (held) return descriptor;
  if (descriptor >= 0) ::close(descriptor);
  return -1;
}

}  // namespace

WholeFolder::WholeFolder(fs::path target) : target_(std::move(target)) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(target_, error);
  if (fs::exists(status) && !(fs::is_directory(status) && fs::is_empty(target_, error))) {
    io::fail(name(), "is there already; the frames of a run go into a new folder, so that no other frames are in it");
  }
  constexpr int kNames = 100;  // as many processes may write one target at a time
  for (int number = 1; number <= kNames; ++number) {
    const fs::path path = name() + ".touchstone-" + std::to_string(number) + ".partial";
    for (int attempt = 0; attempt < 2; ++attempt) {
      if (::mkdir(path.c_str(), 0777) == 0) {
        descriptor_ = open_locked(path);
        if (descriptor_ >= 0) {
          temporary_ = path;
          return;
        }
      } else if (errno != EEXIST) {
        io::fail(name(), "no folder can be made here: " + io::system_reason(errno));
      } else if (const int leftover = open_locked(path); leftover >= 0) {
        remove_with_files(path);
        ::close(leftover);
      }
    }
  }
  io::fail(name(), "no folder can be made here: no temporary name beside it is free");
}

void WholeFolder::commit() {
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    io::fail(name(), "no folder can be made here: " + io::system_reason(errno));
  }
  temporary_.clear();
}

WholeFolder::~WholeFolder() {
  // In this order: once the lock is gone, a folder of this name may be another process's.
  if (!temporary_.empty()) remove_with_files(temporary_);
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace touchstone::cli
