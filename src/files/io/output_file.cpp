// SPDX-License-Identifier: MIT
#include "io/output_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/fail.hpp"

namespace touchstone::io {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

void write_all(int descriptor, std::string_view bytes, const std::string& name) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EPIPE && descriptor == STDOUT_FILENO) {
      throw ReaderGone(name + ": nobody reads it any more");
    } else if (errno != EINTR) {
      fail(name, "cannot be written: " + system_reason(errno));
    }
  }
}

/// A descriptor that closes itself; -1 is none.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) noexcept : descriptor_(descriptor) {}
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

 private:
  int descriptor_;
};

struct Created {
  std::string path;
  int descriptor;
};

/// A process holds a lock on its temporary file for as long as the file has that name. The system releases it when the
/// process ends in any way. So a temporary file that can be locked is the leftover of a process that was killed. Where
/// locks do not work, nothing can be locked, and leftovers stay.
bool lock(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

enum class Existing : std::uint8_t { none, removed, kept };

/// Removes the file of this temporary name when it is a leftover.
Existing remove_leftover(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return errno == ENOENT ? Existing::none : Existing::kept;
  struct stat status {};
  const bool leftover = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && lock(descriptor);
  // The lock is held until the name is gone. Otherwise another process could take a new file of this name for this one,
  // and remove it.
  struct stat named {};
  const bool same =
      leftover && ::lstat(path.c_str(), &named) == 0 && named.st_ino == status.st_ino && named.st_dev == status.st_dev;
  const bool removed = same && ::unlink(path.c_str()) == 0;
  ::close(descriptor);
  return removed ? Existing::removed : Existing::kept;
}

/// A new file of this name, locked, with the permissions that the umask grants (mkstemp would make it private).
/// @returns -1, and errno, when there is none; EEXIST also when another process has taken the file for a leftover
/// before it was locked
int create_locked(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return -1;
  const bool locked = lock(descriptor);
  const bool taken = !locked && errno == EWOULDBLOCK;
  struct stat status {};
  if (!taken && ::fstat(descriptor, &status) == 0 && status.st_nlink > 0) return descriptor;
  ::close(descriptor);
  errno = EEXIST;
  return -1;
}

/// A new file beside `target`. Its name is one of a few, so that the next process that writes the same target finds the
/// leftovers of those that were killed, and removes them, without a search through the folder.
Created create_beside(const std::string& target, const std::string& name) {
  constexpr int kNames = 100;  // as many processes may write one target at a time
  const auto temporary = [&](int number) { return target + ".touchstone-" + std::to_string(number) + ".partial"; };
  for (int number = 1; number <= kNames; ++number) {
    std::string path = temporary(number);
    for (int attempt = 0; attempt < 2; ++attempt) {
      const int descriptor = create_locked(path);
      if (descriptor >= 0) {
        for (int later = number + 1; later <= kNames; ++later) {
          if (remove_leftover(temporary(later)) == Existing::none) break;
        }
        return {std::move(path), descriptor};
      }
      if (errno != EEXIST) fail(name, "cannot be written: " + system_reason(errno));
      if (remove_leftover(path) == Existing::kept) break;
    }
  }
  fail(name, "cannot be written: no temporary name beside it is free, up to " + printable(temporary(kNames)));
}

/// The path that a link leads to, one link after the other, whether there is a file or not; `path` itself when it is no
/// link.
std::string end_of_links(const std::string& path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::filesystem::path at = path;
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(at, error)); ++links) {
    if (links == kMostLinks) fail(path, "is a link that leads to no file: " + system_reason(ELOOP));
    const auto target = std::filesystem::read_symlink(at, error);
    if (error) fail(path, "is a link that cannot be followed: " + error.message());
    at = at.parent_path() / target;  // `target` alone when it is absolute
  }
  return at.string();
}

/// Refuses a link whose target cannot be made because its folder is missing.
void check_folder_of(const std::string& target, const std::string& path) {
  if (target == path) return;
  const auto folder = std::filesystem::path(target).parent_path();
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return;
  fail(path, "is a link to " + printable(target) + ", whose folder is not there");
}

/// Refuses a link whose text does not lead to the file that the system finds behind it. The link of an open descriptor,
/// such as /dev/stdout, is one when its file has been removed: its text is the old name and " (deleted)".
void check_same_file(const std::string& target, const struct stat& found, const std::string& path) {
  struct stat status {};
  const bool same =
      ::stat(target.c_str(), &status) == 0 && status.st_ino == found.st_ino && status.st_dev == found.st_dev;
  if (!same) fail(path, "leads to a file that has no name any more; name a file to write");
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : name_(path), target_(path) {
  if (path.empty()) fail("''", "is no file name");
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(path, "is a folder; name a file to write");
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(path, "cannot be written: " + system_reason(errno));
    return;
  }
  // A link stays a link: the file that it leads to is replaced, or made.
  target_ = end_of_links(path);
  check_folder_of(target_, path);
  if (exists) check_same_file(target_, status, path);
  Created created = create_beside(target_, name_);
  temporary_ = std::move(created.path);
  descriptor_ = created.descriptor;
  if (exists) ::fchmod(descriptor_, status.st_mode & 07777);  // best effort: the answers matter more than their mode
}

OutputFile OutputFile::standard_output() {
  OutputFile file;
  file.name_ = "standard output";
  file.descriptor_ = STDOUT_FILENO;
  file.owned_ = false;
  return file;
}

void OutputFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  if (buffer_.size() >= kBufferBytes) flush();
}

void OutputFile::flush() {
  write_all(descriptor_, buffer_, name_);
  buffer_.clear();
}

void OutputFile::commit() {
  flush();
  if (!owned_) return;
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail(name_, "cannot be written: " + system_reason(errno));
  // Closing may report an error, so it comes before the rename. The lock lasts until after the rename.
  const Descriptor lock(temporary_.empty() ? -1 : ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0));
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(name_, "cannot be written: " + system_reason(errno));
  if (temporary_.empty()) return;
  // Checked again directly before the rename: for root, a rename would replace a device by a plain file.
  struct stat status {};
  if (::stat(target_.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    fail(name_, "has become something else than a file; it is left alone");
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(name_, "cannot be written: " + system_reason(errno));
  temporary_.clear();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      buffer_(std::move(other.buffer_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      owned_(other.owned_) {}

OutputFile::~OutputFile() {
  // In this order: once the lock is gone, a file of this name may be another process's.
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  if (descriptor_ >= 0 && owned_) ::close(descriptor_);
}

SpoolFile::SpoolFile(const std::string& path) : name_("the temporary file of " + path) {
  struct stat status {};
  const bool beside = ::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  const std::string pattern = beside ? path : ((error ? "/tmp" : folder.string()) + "/touchstone-spool");
  Created created = create_beside(pattern, name_);
  ::unlink(created.path.c_str());
  descriptor_ = created.descriptor;
}

void SpoolFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  written_ += bytes.size();
  if (buffer_.size() < kBufferBytes) return;
  write_all(descriptor_, buffer_, name_);
  buffer_.clear();
}

void SpoolFile::copy_to(OutputFile& out) {
  write_all(descriptor_, buffer_, name_);
  buffer_.clear();
  std::string block(kBufferBytes, '\0');
  std::uint64_t copied = 0;
  while (copied < written_) {
    const ssize_t count = ::pread(descriptor_, block.data(), block.size(), static_cast<off_t>(copied));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail(name_, "cannot be read back: " + system_reason(count == 0 ? EIO : errno));
    out.write(std::string_view(block).substr(0, static_cast<std::size_t>(count)));
    copied += static_cast<std::uint64_t>(count);
  }
}

void SpoolFile::cut(std::uint64_t size) {
  write_all(descriptor_, buffer_, name_);
  buffer_.clear();
  const auto end = static_cast<off_t>(size);
  if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) != end) {
    fail(name_, "cannot be written: " + system_reason(errno));
  }
  written_ = size;
}

SpoolFile::~SpoolFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void write_whole(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace touchstone::io
