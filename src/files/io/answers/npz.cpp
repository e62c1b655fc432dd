// SPDX-License-Identifier: MIT
#include "io/answers/npz.hpp"

#include <bit>

#include "io/bytes.hpp"
#include "io/fail.hpp"

namespace touchstone::io {
namespace {

std::uint64_t number(std::string_view archive, std::size_t at, std::size_t size) {
  return size == 2 ? unsigned_at<std::uint16_t>(archive.data() + at, std::endian::little)
                   : unsigned_at<std::uint32_t>(archive.data() + at, std::endian::little);
}

}  // namespace

// The end of the archive says where its directory is. Each entry says where the file's own header is, whose length
// depends on the name and the extra field there. PKWARE, APPNOTE.TXT, 4.3.
std::vector<NpzArray> npz_arrays(const std::string& file, std::string_view archive) {
  constexpr std::string_view kEnd("PK\x05\x06", 4), kEntry("PK\x01\x02", 4), kLocal("PK\x03\x04", 4);
  constexpr std::size_t kEndSize = 22, kEntrySize = 46, kLocalSize = 30;
  const auto damaged = [&]() { fail(file, "is no .npz file of less than 4 GiB, or is cut off or damaged"); };
  const std::size_t end = archive.rfind(kEnd);
  if (!archive.starts_with("PK") || end == std::string_view::npos || archive.size() - end < kEndSize) damaged();
  const std::uint64_t count = number(archive, end + 10, 2);
  std::uint64_t at = number(archive, end + 16, 4);
  std::vector<NpzArray> arrays;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (at + kEntrySize > archive.size() || archive.substr(at, 4) != kEntry) damaged();
    const std::uint64_t method = number(archive, at + 10, 2), packed = number(archive, at + 20, 4),
                        size = number(archive, at + 24, 4), name_size = number(archive, at + 28, 2),
                        extra = number(archive, at + 30, 2), comment = number(archive, at + 32, 2),
                        local = number(archive, at + 42, 4);
    std::string name(archive.substr(at + kEntrySize, name_size));
    if (name.size() != name_size || local + kLocalSize > archive.size() || archive.substr(local, 4) != kLocal) {
      damaged();
    }
    if (method != 0) fail(file, "is compressed; numpy.savez, not savez_compressed, writes what is read");
    const std::uint64_t content = local + kLocalSize + number(archive, local + 26, 2) + number(archive, local + 28, 2);
    if (packed != size || content + size > archive.size()) damaged();
    constexpr std::string_view kSuffix = ".npy";
    if (name.ends_with(kSuffix)) {
      name.resize(name.size() - kSuffix.size());
      arrays.push_back({std::move(name), archive.substr(content, size)});
    }
    at += kEntrySize + name_size + extra + comment;
  }
  return arrays;
}

}  // namespace touchstone::io
