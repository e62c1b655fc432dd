// Files of arrays: the positions of many frames, without elements.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frames/frame.hpp"

namespace touchstone::frames {

/// The shape of an array of positions.
struct ArrayShape {
  std::size_t frames = 1;
  std::size_t vertices = 0;
  std::size_t dimension = 3;  ///< 2 or 3
};

/// (vertices, 2 or 3) or (frames, vertices, 2 or 3), all at least 1.
/// @param name  the file, and the data set in it, for messages
/// @throws FileError  for other shapes
ArrayShape shape_of_positions(const std::string& file, const std::string& name,
                              const std::vector<std::uint64_t>& extents);

/// The positions of one frame of an array.
struct ArrayFrame {
  ArrayShape shape;
  std::vector<double> positions;
};

/// NumPy's .npy. Only the frame that is asked for is held in memory.
ArrayShape npy_shape(const std::string& file, const ReadOptions& options);
ArrayFrame read_npy_frame(const std::string& file, std::size_t index, const ReadOptions& options);

/// The rows of an .npy array of integers of shape (n, 2) or (n, 3).
struct IndexRows {
  std::size_t width = 0;  ///< 2 or 3
  std::vector<std::int64_t> values;
};
/// @param content  the bytes of the file
IndexRows read_npy_indices(std::string_view file, std::string_view content);

/// Text with a row x,y,z for each vertex, or x,y: one frame.
ArrayFrame read_text_rows(const std::string& file, const ReadOptions& options);

/// A PC2 or MDD file, which has floats.
enum class PointCache : std::uint8_t { pc2, mdd };
ArrayShape cache_shape(const std::string& file, PointCache sort, const ReadOptions& options);
ArrayFrame read_cache_frame(const std::string& file, PointCache sort, std::size_t index, const ReadOptions& options);

/// HDF5.
ArrayShape hdf5_shape(const std::string& file, const ReadOptions& options);
ArrayFrame read_hdf5_frame(const std::string& file, std::size_t index, const ReadOptions& options);

}  // namespace touchstone::frames
