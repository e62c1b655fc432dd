// Point caches: PC2 of 3ds Max and Blender, and MDD of LightWave. Floats of three coordinates, frame after frame.
// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <string>

#include "frames/arrays/array.hpp"
#include "io/bytes.hpp"
#include "io/fail.hpp"
#include "io/queries/npy_header.hpp"

namespace touchstone::frames {
namespace {

constexpr std::size_t kFloat = 4;

struct OpenCache {
  io::InputFile file;  ///< at the first frame
  ArrayShape shape;
  std::endian order;
};

/// @param header  the bytes before the first frame
ArrayShape checked_shape(const std::string& name, std::uint64_t frames, std::uint64_t vertices, std::uint64_t header,
                         std::uint64_t size) {
  if (frames == 0 || vertices == 0 || vertices > std::numeric_limits<MeshIndex>::max()) {
    io::fail(name, "says that it has " + std::to_string(frames) + " frames of " + std::to_string(vertices) +
                       " vertices; both must be 1 or more");
  }
  const std::uint64_t frame = vertices * 3 * kFloat;
  if (size < header || (size - header) / frame != frames || (size - header) % frame != 0) {
    io::fail(name, "has " + std::to_string(size) + " bytes; a header of " + std::to_string(header) + " bytes and " +
                       std::to_string(frames) + " frames of " + std::to_string(frame) + " bytes must make up the file");
  }
  return {frames, vertices, 3};
}

/// magic, version, vertices, first frame and sample rate as floats, frames; all little-endian
OpenCache open_pc2(const std::string& name, io::InputFile file, std::uint64_t size) {
  constexpr std::string_view kMagic("POINTCACHE2\0", 12);
  std::array<char, 32> header;
  if (size < header.size()) io::fail(name, "is no PC2 file: it is shorter than a header of 32 bytes");
  io::read_exactly(file, header.data(), header.size());
  if (std::string_view(header.data(), kMagic.size()) != kMagic) {
    io::fail(name, "is no PC2 file: it does not begin with POINTCACHE2");
  }
  const auto number = [&](std::size_t at) {
    return io::unsigned_at<std::uint32_t>(header.data() + at, std::endian::little);
  };
  if (number(12) != 1) io::fail(name, "has version " + std::to_string(number(12)) + " of PC2; right is 1");
  const ArrayShape shape = checked_shape(name, number(28), number(16), header.size(), size);
  return {std::move(file), shape, std::endian::little};
}

/// frames, vertices, the time of each frame as a float; all big-endian
OpenCache open_mdd(const std::string& name, io::InputFile file, std::uint64_t size) {
  std::array<char, 8> header;
  if (size < header.size()) io::fail(name, "is no MDD file: it is shorter than a header of 8 bytes");
  io::read_exactly(file, header.data(), header.size());
  const auto number = [&](std::size_t at) {
    return io::unsigned_at<std::uint32_t>(header.data() + at, std::endian::big);
  };
  const std::uint64_t before = header.size() + number(0) * std::uint64_t{kFloat};
  const ArrayShape shape = checked_shape(name, number(0), number(4), before, size);
  file.skip(before - header.size());
  return {std::move(file), shape, std::endian::big};
}

OpenCache open_cache(const std::string& name, PointCache sort, const ReadOptions& options) {
  const auto size = io::InputFile::check(name);
  if (!size) io::fail(name, "is a pipe or device; a point cache is read from a file");
  io::InputFile file = io::InputFile::open(name, options.checkpoint);
  return sort == PointCache::pc2 ? open_pc2(name, std::move(file), *size) : open_mdd(name, std::move(file), *size);
}

}  // namespace

ArrayShape cache_shape(const std::string& file, PointCache sort, const ReadOptions& options) {
  return open_cache(file, sort, options).shape;
}

ArrayFrame read_cache_frame(const std::string& name, PointCache sort, std::size_t index, const ReadOptions& options) {
  OpenCache cache = open_cache(name, sort, options);
  const ArrayShape& shape = cache.shape;
  if (index >= shape.frames) {
    io::fail(name, "has no frame " + std::to_string(index) + "; the last is " + std::to_string(shape.frames - 1));
  }
  const std::size_t values = shape.vertices * 3;
  std::vector<char> bytes(values * kFloat);
  cache.file.skip(std::uint64_t{index} * bytes.size());
  io::read_exactly(cache.file, bytes.data(), bytes.size());
  ArrayFrame frame{shape, std::vector<double>(values)};
  for (std::size_t i = 0; i < values; ++i) frame.positions[i] = io::float_at(&bytes[i * kFloat], cache.order);
  return frame;
}

}  // namespace touchstone::frames
