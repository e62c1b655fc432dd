// From the name of a file to a frame.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <mutex>

#include "frames/arrays/array.hpp"
#include "frames/content.hpp"
#include "frames/formats.hpp"
#include "io/fail.hpp"
#include "io/sha256.hpp"

namespace touchstone::frames {
namespace {

bool is_mesh_format(Format format) { return format < Format::npy; }

void check_options(const std::string& file, Format format, const ReadOptions& options) {
  if (is_mesh_format(format) && !options.topology_file.empty()) {
    io::fail(file, "has elements of its own; a topology file is for .npy, .h5, .hdf5, .pc2 and .mdd");
  }
  if (format != Format::hdf5 && !options.dataset.empty()) {
    io::fail(file, "has no data sets with names; they are for .h5 and .hdf5");
  }
}

/// The topology of arrays, and the digest of the bytes that it was read from.
struct SharedTopology {
  std::shared_ptr<const Topology> topology;
  std::string digest;
};

/// What tells whether a file is the same as before.
struct FileState {
  std::string name;
  bool triangulate = false;
  std::size_t vertices = 0;
  std::size_t dimension = 0;
  std::uint64_t device = 0, number = 0, size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;

  bool operator==(const FileState&) const = default;
};

FileState state_of(const std::string& name, bool triangulate, const ArrayShape& shape) {
  const auto size = io::InputFile::check(name);
  if (!size) io::fail(name, "is a pipe or device; a topology is read from a file, for each frame again");
  struct stat status {};
  if (::stat(name.c_str(), &status) != 0) io::fail(name, "cannot be opened: " + io::system_reason(errno));
  return {name,          triangulate, shape.vertices,        shape.dimension,       status.st_dev,
          status.st_ino, *size,       status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

SharedTopology read_topology(const ArrayShape& shape, const ReadOptions& options) {
  const std::string& file = options.topology_file;
  const io::WholeFile content = read_content(file, options.checkpoint);
  return {std::make_shared<const Topology>(topology_from(file, content.bytes(), shape, options.triangulate)),
          io::sha256(content.bytes())};
}

/// The topology file's topology. The one that was read last is kept, because every frame of an array asks for it.
SharedTopology shared_topology(const ArrayShape& shape, const ReadOptions& options) {
  if (options.topology_file.empty()) return {std::make_shared<const Topology>(loose_points(shape)), {}};
  static std::mutex mutex;
  static FileState kept_state;
  static SharedTopology kept;
  const FileState state = state_of(options.topology_file, options.triangulate, shape);
  const std::lock_guard lock(mutex);
  if (kept.topology == nullptr || state != kept_state) {
    kept = read_topology(shape, options);
    kept_state = state;
  }
  return kept;
}

/// The digest of positions as doubles in little-endian order.
std::string digest_of(const std::vector<double>& positions) {
  if constexpr (std::endian::native == std::endian::little) {
    return io::sha256({reinterpret_cast<const char*>(positions.data()), positions.size() * sizeof(double)});
  }
  std::string bytes;
  for (const double x : positions) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(bits >> shift & 0xFF);
  }
  return io::sha256(bytes);
}

Frame frame_of(const std::string& file, std::size_t index, ArrayFrame array, const ReadOptions& options) {
  const auto not_finite =
      std::find_if_not(array.positions.begin(), array.positions.end(), [](double x) { return std::isfinite(x); });
  if (not_finite != array.positions.end()) {
    const auto at = static_cast<std::size_t>(not_finite - array.positions.begin());
    io::fail(file, "vertex " + std::to_string(at / array.shape.dimension) + " of frame " + std::to_string(index) +
                       " has a coordinate that is not finite");
  }
  SharedTopology shared = shared_topology(array.shape, options);
  std::string digest =
      io::sha256(std::to_string(array.shape.dimension) + ' ' + digest_of(array.positions) + ' ' + shared.digest);
  return {std::move(shared.topology), std::move(array.positions), std::move(digest)};
}

ArrayShape shape_of(Format format, const std::string& file, const ReadOptions& options) {
  if (format == Format::npy) return npy_shape(file, options);
  if (format == Format::hdf5) return hdf5_shape(file, options);
  return cache_shape(file, format == Format::pc2 ? PointCache::pc2 : PointCache::mdd, options);
}

ArrayFrame read_array_frame(Format format, const std::string& file, std::size_t index, const ReadOptions& options) {
  if (format == Format::npy) return read_npy_frame(file, index, options);
  if (format == Format::hdf5) return read_hdf5_frame(file, index, options);
  return read_cache_frame(file, format == Format::pc2 ? PointCache::pc2 : PointCache::mdd, index, options);
}

}  // namespace

std::size_t frame_count(const std::string& file, const ReadOptions& options) {
  const Format format = format_of(file);
  check_options(file, format, options);
  if (!is_mesh_format(format)) return shape_of(format, file, options).frames;
  io::InputFile::check(file);
  return 1;
}

Frame read_text_frame(const std::string& file, const ReadOptions& options) {
  return frame_of(file, 0, read_text_rows(file, options), options);
}

Frame read_frame(const std::string& file, std::size_t index, const ReadOptions& options,
                 const std::shared_ptr<const Topology>& earlier) {
  const Format format = format_of(file);
  check_options(file, format, options);
  Frame frame;
  if (!is_mesh_format(format)) {
    frame = frame_of(file, index, read_array_frame(format, file, index, options), options);
  } else {
    if (index != 0) io::fail(file, "has one frame, and no frame " + std::to_string(index));
    const io::WholeFile content = read_content(file, options.checkpoint);
    MeshFile mesh = read_mesh(format, file, content.bytes(), options.triangulate);
    std::string digest = io::sha256(content.bytes());
    if (!mesh.beside.empty()) digest = io::sha256(digest + mesh.beside);
    frame = {std::make_shared<const Topology>(std::move(mesh.topology)), std::move(mesh.positions), std::move(digest)};
  }
  if (earlier != nullptr && (earlier == frame.topology || *earlier == *frame.topology)) frame.topology = earlier;
  return frame;
}

}  // namespace touchstone::frames
