// SPDX-License-Identifier: MIT
#include "io/whole_file.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>

#include "io/fail.hpp"

namespace touchstone::io {
namespace {

std::unique_ptr<char[]> room(const std::string& path, std::size_t size) {
  try {
    return std::make_unique_for_overwrite<char[]>(size);
  } catch (const std::bad_alloc&) {
    fail(path, "is read as a whole, and there is no memory for its " + std::to_string(size) + " bytes");
  }
}

/// Finds lines that are too long while a file is being read.
class LineLengths {
 public:
  LineLengths(const std::string& path, std::uint64_t most) : path_(path), most_(most) {}

  /// @param text  the file so far, of which the bytes from `first` on are new: fewer than the limit
  void check(std::string_view text, std::size_t first) {
    if (most_ == 0) return;
    const std::size_t end = std::min(text.find('\n', first), text.size());
    if (end - line_ > most_) {
      const auto row = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(line_), '\n');
      fail(path_, static_cast<std::uint64_t>(row) + 1, "a line of more than " + size_text(most_));
    }
    if (end < text.size()) line_ = text.rfind('\n') + 1;
  }

 private:
  const std::string& path_;
  std::uint64_t most_;
  std::size_t line_ = 0;  ///< where the line begins that has not ended yet
};

}  // namespace

WholeFile WholeFile::read(const std::string& path, const FileLimits& limits, InputFile::Checkpoint checkpoint) {
  InputFile::check(path);
  return read(InputFile::open(path, checkpoint), limits);
}

WholeFile WholeFile::read(InputFile input, const FileLimits& limits) {
  const std::string& path = input.name();
  const std::optional<std::uint64_t> stated = InputFile::check(path);
  const std::uint64_t most = stated ? limits.file : limits.stream;
  const auto too_large = [&] {
    fail(path, stated
                   ? "is larger than " + size_text(most)
                   : "is a pipe or device, and has more than " + size_text(most) + "; such data are read from a file");
  };
  if (stated.value_or(0) > most) too_large();
  constexpr std::size_t kLeast = std::size_t{1} << 16;
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 20;  // between two looks at the limits
  std::size_t capacity = static_cast<std::size_t>(stated.value_or(kLeast)) + 1;
  auto bytes = room(path, capacity);
  std::size_t size = 0;
  LineLengths lines(path, limits.line);
  for (;;) {
    if (size == capacity) {
      auto larger = room(path, 2 * capacity);
      std::memcpy(larger.get(), bytes.get(), size);
      bytes = std::move(larger);
      capacity *= 2;
    }
    const std::size_t count = input.read(bytes.get() + size, std::min(capacity - size, kMostAtOnce));
    if (count == 0) return {std::move(bytes), size};
    size += count;
    if (size > most) too_large();
    lines.check({bytes.get(), size}, size - count);
  }
}

std::string size_text(std::uint64_t bytes) {
  constexpr std::uint64_t kGiB = std::uint64_t{1} << 30, kMiB = std::uint64_t{1} << 20;
  return bytes % kGiB == 0 ? std::to_string(bytes / kGiB) + " GiB" : std::to_string(bytes / kMiB) + " MiB";
}

}  // namespace touchstone::io
