// SPDX-License-Identifier: MIT
#include "io/input_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <utility>

#include "io/fail.hpp"

namespace touchstone::io {
namespace {

void refuse_folder(const std::string& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode))
    fail(path, "is a folder; name the files in it: " + printable(path + (path.ends_with('/') ? "*" : "/*")));
}

}  // namespace

InputFile InputFile::open(const std::string& path, Checkpoint checkpoint) {
  int descriptor = -1;
  do {
    if (checkpoint != nullptr) checkpoint();
    descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);  // waits for a pipe's writer
  } while (descriptor < 0 && errno == EINTR);
  if (descriptor < 0) fail(path, "cannot be opened: " + system_reason(errno));
  InputFile file(path, descriptor, {}, checkpoint);
  struct stat status {};
  if (::fstat(descriptor, &status) == 0) refuse_folder(path, status);
#ifdef POSIX_FADV_SEQUENTIAL
  ::posix_fadvise(descriptor, 0, 0, POSIX_FADV_SEQUENTIAL);  // only a hint: a pipe refuses it
#endif
  return file;
}

InputFile InputFile::from_memory(std::string name, std::string_view content) {
  return {std::move(name), -1, content, nullptr};
}

std::optional<std::uint64_t> InputFile::check(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || ::access(path.c_str(), R_OK) != 0) {
    fail(path, "cannot be opened: " + system_reason(errno));
  }
  refuse_folder(path, status);
  if (!S_ISREG(status.st_mode)) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

std::string_view InputFile::peek(std::size_t count) {
  if (descriptor_ < 0) return content_.substr(0, count);
  std::string bytes = std::move(ahead_);
  ahead_.clear();
  while (bytes.size() < count) {
    const std::size_t before = bytes.size();
    bytes.resize(count);
    const std::size_t got = read(bytes.data() + before, count - before);
    bytes.resize(before + got);
    if (got == 0) break;
  }
  ahead_ = std::move(bytes);
  return ahead_;
}

std::size_t InputFile::read(char* to, std::size_t capacity) {
  if (!ahead_.empty()) {
    const std::size_t count = ahead_.copy(to, capacity);
    ahead_.erase(0, count);
    return count;
  }
  if (descriptor_ < 0) {
    const std::size_t count = content_.copy(to, capacity);
    content_.remove_prefix(count);
    return count;
  }
  for (;;) {
    if (checkpoint_ != nullptr) checkpoint_();
    const ssize_t count = ::read(descriptor_, to, capacity);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) fail(name_, "cannot be read: " + system_reason(errno));
  }
}

void InputFile::skip(std::uint64_t count) {
  if (descriptor_ < 0) {
    content_.remove_prefix(static_cast<std::size_t>(std::min<std::uint64_t>(count, content_.size())));
    return;
  }
  const std::size_t known = std::min<std::uint64_t>(count, ahead_.size());
  ahead_.erase(0, known);
  count -= known;
  constexpr std::uint64_t kMost = std::numeric_limits<off_t>::max();
  if (count <= kMost && ::lseek(descriptor_, static_cast<off_t>(count), SEEK_CUR) >= 0) return;
  std::array<char, 4096> unused;
  while (count > 0) {
    const std::size_t got =
        read(unused.data(), static_cast<std::size_t>(std::min<std::uint64_t>(count, unused.size())));
    if (got == 0) return;
    count -= got;
  }
}

InputFile::InputFile(InputFile&& other) noexcept
    : name_(std::move(other.name_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      whole_(other.whole_),
      content_(other.content_),
      ahead_(std::move(other.ahead_)),
      checkpoint_(other.checkpoint_) {}

InputFile& InputFile::operator=(InputFile&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(whole_, other.whole_);
  std::swap(content_, other.content_);
  std::swap(ahead_, other.ahead_);
  std::swap(checkpoint_, other.checkpoint_);
  return *this;
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

FileBytes::FileBytes(const InputFile& file) {
  if (file.descriptor_ < 0) {
    view_ = file.whole_;
    return;
  }
  struct stat status {};
  if (::fstat(file.descriptor_, &status) != 0) fail(file.name(), "cannot be read: " + system_reason(errno));
  if (!S_ISREG(status.st_mode)) {
    fail(file.name(), "is a pipe or device; a binary query file or an .npy file is read from the disk");
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0) return;
  void* const start = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.descriptor_, 0);
  if (start == MAP_FAILED) fail(file.name(), "cannot be mapped into memory: " + system_reason(errno));
  view_ = {static_cast<const char*>(start), size};
  mapped_ = true;
}

FileBytes::~FileBytes() {
  if (mapped_) ::munmap(const_cast<char*>(view_.data()), view_.size());
}

}  // namespace touchstone::io
