// SPDX-License-Identifier: MIT
#include "io/queries/hdf5_layout.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>

namespace touchstone::io {
namespace {

constexpr std::uint64_t kNone = ~std::uint64_t{0};  // the address of what is not there

void append(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * i & 0xFF);
}

/// Jenkins' hash lookup3 (hashlittle of 2006), which the format prescribes for its checksums.
std::uint32_t checksum(std::string_view bytes) {
  std::array<std::uint32_t, 3> s;
  s.fill(0xDEADBEEF + static_cast<std::uint32_t>(bytes.size()));
  auto& [a, b, c] = s;
  const auto step = [](std::uint32_t& x, std::uint32_t& y, std::uint32_t& z, int turn) {
    x -= z;
    x ^= std::rotl(z, turn);
    z += y;
  };
  const auto finish = [](std::uint32_t& x, std::uint32_t y, int turn) {
    x ^= y;
    x -= std::rotl(y, turn);
  };
  for (std::size_t at = 0; at < bytes.size(); at += 12) {
    const std::string_view block = bytes.substr(at, 12);
    for (std::size_t i = 0; i < block.size(); ++i) {
      s[i / 4] += static_cast<std::uint32_t>(static_cast<unsigned char>(block[i])) << 8 * (i % 4);
    }
    if (bytes.size() - at <= 12) break;
    step(a, b, c, 4);
    step(b, c, a, 6);
    step(c, a, b, 8);
    step(a, b, c, 16);
    step(b, c, a, 19);
    step(c, a, b, 4);
  }
  finish(c, b, 14);
  finish(a, c, 11);
  finish(b, a, 25);
  finish(c, b, 16);
  finish(a, c, 4);
  finish(b, a, 14);
  finish(c, b, 24);
  return c;
}

std::string with_checksum(std::string bytes) {
  append(bytes, checksum(bytes), 4);
  return bytes;
}

/// A message of an object's header. Types: 1 extents, 2 and 10 a group, 3 type of values, 5 value of what was not
/// written, 6 link, 8 where the values are.
std::string message(int type, std::string_view content) {
  std::string out;
  append(out, static_cast<std::uint64_t>(type), 1);
  append(out, content.size(), 2);
  append(out, 0, 1);  // flags
  return out.append(content);
}

std::string object(std::string_view messages) {
  std::string out = "OHDR";
  append(out, 2, 1);  // version
  append(out, 1, 1);  // the size that follows has two bytes
  append(out, messages.size(), 2);
  return with_checksum(out.append(messages));
}

struct Link {
  std::string_view name;
  std::uint64_t address;
};

std::string group(std::initializer_list<Link> links) {
  std::string info(2, '\0');  // version and flags
  append(info, kNone, 8);     // no heap: the links are in this header
  append(info, kNone, 8);
  std::string messages = message(2, info) + message(10, std::string(2, '\0'));
  for (const auto& [name, address] : links) {
    if (address == 0) continue;
    std::string link;
    append(link, 1, 1);  // version
    append(link, 0, 1);  // a hard link, its name in ASCII, the name's length in one byte
    append(link, name.size(), 1);
    link += name;
    append(link, address, 8);
    messages += message(6, link);
  }
  return object(messages);
}

std::string dataset(std::string_view type, std::initializer_list<std::uint64_t> extents, std::uint64_t address,
                    std::uint64_t value_size) {
  std::string space;
  append(space, 2, 1);  // version
  append(space, extents.size(), 1);
  append(space, 0, 1);  // it does not grow
  append(space, 1, 1);  // an array
  std::uint64_t size = value_size;
  for (const std::uint64_t extent : extents) {
    append(space, extent, 8);
    size *= extent;
  }
  std::string layout;
  append(layout, 3, 1);  // version
  append(layout, 1, 1);  // in one piece
  append(layout, address, 8);
  append(layout, size, 8);
  constexpr std::string_view kNoFillValue("\x03\x0A", 2);  // version; room is taken late, no value is stated
  return object(message(1, space) + message(3, type) + message(5, kNoFillValue) + message(8, layout));
}

// Class and version; byte order, padding, the place of the sign; size; first bit and precision; for a double the place
// and size of its exponent and mantissa, and the bias.
constexpr std::string_view kDoubles("\x11\x20\x3F\0\x08\0\0\0\0\0\x40\0\x34\x0B\0\x34\xFF\x03\0\0", 20);
constexpr std::string_view kBytes("\x10\0\0\0\x01\0\0\0\0\0\x08\0", 12);

}  // namespace

std::string hdf5_query_header(Kind kind, std::uint64_t count, bool with_claims) {
  // The objects have fixed places, which leave room for each of them.
  constexpr std::uint64_t kRoot = 64, kGroup = 192, kPoints = 320, kResult = 512, kData = 1024;
  const std::uint64_t rows = 2 * corner_count(kind) * count;
  const std::uint64_t results = kData + rows * 3 * sizeof(double);

  std::string superblock(kHdf5Magic);
  append(superblock, 2, 1);  // version
  append(superblock, 8, 1);  // bytes of an address
  append(superblock, 8, 1);  // bytes of a length
  append(superblock, 0, 1);  // flags
  append(superblock, 0, 8);  // where the file begins
  append(superblock, kNone, 8);
  append(superblock, with_claims ? results + count : results, 8);  // where it ends
  append(superblock, kRoot, 8);

  std::string header = with_checksum(superblock);
  const auto put = [&](std::uint64_t address, const std::string& bytes) {
    header.resize(std::max<std::size_t>(header.size(), address), '\0');
    header += bytes;
  };
  put(kRoot, group({{kHdf5Group, kGroup}}));
  put(kGroup, group({{"points", kPoints}, {"result", with_claims ? kResult : 0}}));
  put(kPoints, dataset(kDoubles, {rows, 3}, kData, sizeof(double)));
  if (with_claims) put(kResult, dataset(kBytes, {count}, results, 1));
  header.resize(kData, '\0');
  return header;
}

}  // namespace touchstone::io
