// SPDX-License-Identifier: MIT
#include "io/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <random>
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
    } else if (errno != EINTR) {
      fail(name, "cannot be written: " + system_reason(errno));
    }
  }
}

struct Created {
  std::string path;
  int descriptor;
};

/// A new file beside `target`, with the permissions that the umask grants (mkstemp would make it private).
Created create_beside(const std::string& target, const std::string& name) {
  std::random_device random;
  for (int attempt = 0; attempt < 100; ++attempt) {
    std::array<char, 32> suffix;
    std::snprintf(suffix.data(), suffix.size(), ".%08x.partial", static_cast<unsigned>(random()));
    std::string path = target + suffix.data();
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) return {std::move(path), descriptor};
    if (errno != EEXIST) fail(name, "cannot be written: " + system_reason(errno));
  }
  fail(name, "cannot be written: no free temporary name beside it");
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
  if (exists) {
    // A link stays a link: the file that it leads to is replaced.
    std::error_code error;
    const auto real = std::filesystem::canonical(path, error);
    if (!error) target_ = real.string();
  }
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
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(name_, "cannot be written: " + system_reason(errno));
  if (temporary_.empty()) return;
  // Once more right before it counts: for root a rename would put a plain file in the place of a device.
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
  if (descriptor_ >= 0 && owned_) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

SpoolFile::SpoolFile(const std::string& path) : name_("the temporary file of " + path) {
  struct stat status {};
  const bool beside = ::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  const std::string place = beside ? path : ((error ? "/tmp" : folder.string()) + "/touchstone-spool");
  Created created = create_beside(place, name_);
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

SpoolFile::~SpoolFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace touchstone::io
