// NumPy's .npy: positions of frames, and the corners of faces or edges.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "frames/arrays/array.hpp"
#include "frames/content.hpp"
#include "io/bytes.hpp"
#include "io/fail.hpp"
#include "io/queries/npy_header.hpp"

namespace touchstone::frames {
namespace {

constexpr std::string_view kExampleShape = "(100, 3)";

struct OpenArray {
  io::InputFile file;
  io::NpyHeader header;
  ArrayShape shape;
};

OpenArray open_positions(const std::string& name, const ReadOptions& options) {
  const auto size = io::InputFile::check(name);
  if (!size) io::fail(name, "is a pipe or device; an array of frames is read from a file");
  io::InputFile file = io::InputFile::open(name, options.checkpoint);
  const io::NpyHeader header = io::read_npy_header(file, *size, kExampleShape);
  if (header.kind != 'f') io::fail(name, "holds integers; positions have the type float64 or float32");
  if (header.fortran && *size > kMeshLimits.file) {
    io::fail(name, "is larger than " + io::size_text(kMeshLimits.file) +
                       " and in Fortran order, in which each frame is spread over all of it; save it in C order");
  }
  const ArrayShape shape = shape_of_positions(name, {}, header.extents);
  return {std::move(file), header, shape};
}

double value_at(const char* at, const io::NpyHeader& header) {
  return header.size == 4 ? io::float_at(at, header.order) : io::double_at(at, header.order);
}

constexpr std::size_t kChunk = std::size_t{1} << 20;

/// Calls `use(i, value)` for the `count` values that come next in the file.
template <class Use>
void for_each_value(io::InputFile& file, const io::NpyHeader& header, std::uint64_t count, Use use) {
  std::vector<char> chunk(std::min<std::uint64_t>(count * header.size, kChunk));
  for (std::uint64_t i = 0; i < count;) {
    const std::uint64_t values = std::min<std::uint64_t>(count - i, chunk.size() / header.size);
    io::read_exactly(file, chunk.data(), values * header.size);
    for (std::uint64_t k = 0; k < values; ++k, ++i) use(i, value_at(chunk.data() + k * header.size, header));
  }
}

}  // namespace

ArrayShape shape_of_positions(const std::string& file, const std::string& name,
                              const std::vector<std::uint64_t>& extents) {
  const std::size_t n = extents.size();
  const bool fits = (n == 2 || n == 3) && (extents[n - 1] == 2 || extents[n - 1] == 3);
  if (!fits || extents[n - 2] == 0 || extents[0] == 0 || extents[n - 2] > std::numeric_limits<MeshIndex>::max()) {
    io::fail(file, name + "an array of shape " + io::shape_text(extents) +
                       "; positions have the shape (vertices, 3) or (frames, vertices, 3), or 2 in place of 3");
  }
  return {n == 3 ? extents[0] : 1, extents[n - 2], extents[n - 1]};
}

ArrayShape npy_shape(const std::string& file, const ReadOptions& options) {
  return open_positions(file, options).shape;
}

ArrayFrame read_npy_frame(const std::string& name, std::size_t index, const ReadOptions& options) {
  OpenArray array = open_positions(name, options);
  const ArrayShape& shape = array.shape;
  const io::NpyHeader& header = array.header;
  ArrayFrame frame{shape, {}};
  if (index >= shape.frames) {
    io::fail(name, "has no frame " + std::to_string(index) + "; the last is " + std::to_string(shape.frames - 1));
  }
  const std::uint64_t values = shape.vertices * shape.dimension;
  std::vector<double>& positions = frame.positions;
  positions.resize(values);
  if (!header.fortran) {
    array.file.skip(index * values * header.size);
    for_each_value(array.file, header, values, [&](std::uint64_t i, double x) { positions[i] = x; });
  } else {
    // The frame's number runs fastest, then the vertex', then the coordinate's: a frame is spread over the whole file.
    std::uint64_t next = index;
    std::uint64_t to = 0;
    const auto keep = [&](std::uint64_t i, double x) {
      if (i != next) return;
      next += shape.frames;
      positions[to % shape.vertices * shape.dimension + to / shape.vertices] = x;
      ++to;
    };
    for_each_value(array.file, header, shape.frames * values, keep);
  }
  return frame;
}

IndexRows read_npy_indices(std::string_view file, std::string_view content) {
  io::InputFile memory = io::InputFile::from_memory(std::string(file), content);
  const io::NpyHeader header = io::read_npy_header(memory, content.size(), kExampleShape);
  const std::vector<std::uint64_t>& extents = header.extents;
  if (header.kind == 'f' || header.kind == 'b' || extents.size() != 2 || (extents[1] != 2 && extents[1] != 3)) {
    io::fail(file, std::string("an array of ") + (header.kind == 'f' ? "floating-point numbers" : "integers") +
                       " of shape " + io::shape_text(extents) +
                       "; a topology has integers of shape (faces, 3) or (edges, 2)");
  }
  IndexRows rows{extents[1], std::vector<std::int64_t>(header.values)};
  const char* at = content.data() + header.header_size;
  for (std::uint64_t i = 0; i < header.values; ++i, at += header.size) {
    const std::uint64_t to = header.fortran ? i % extents[0] * extents[1] + i / extents[0] : i;
    rows.values[to] = io::integer_at(at, header);
  }
  return rows;
}

}  // namespace touchstone::frames
