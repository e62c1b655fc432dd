// The header of NumPy's .npy files.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_file.hpp"

namespace touchstone::io {

/// The first bytes of every .npy file.
inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

struct NpyHeader {
  char kind = 'f';  ///< 'f', 'i', 'u' or, of booleans, 'b'
  std::size_t size = 8;
  std::endian order = std::endian::little;
  bool fortran = false;
  std::vector<std::uint64_t> extents;
  std::uint64_t values = 1;       ///< the product of the extents
  std::uint64_t header_size = 0;  ///< the number of bytes before the first value
};

/// Reads the header of an array of floats or integers, and checks that the file is as long as the header says.
/// @param file_size  the size of the whole file in bytes
/// @param example_shape  a shape that is right, for messages: "(100, 3)"
/// @throws FileError
NpyHeader read_npy_header(InputFile& file, std::uint64_t file_size, std::string_view example_shape);

/// The value at its place in memory of an array of integers or booleans; unsigned ones beyond 2^63 - 1 are that.
std::int64_t integer_at(const char* from, const NpyHeader& header);
/// The value of any array, as the nearest double.
double number_at(const char* from, const NpyHeader& header);

/// Reads exactly `count` bytes. @throws FileError  where the file ends before
void read_exactly(InputFile& file, char* to, std::size_t count);

/// "(2, 5, 3)".
std::string shape_text(const std::vector<std::uint64_t>& extents);

}  // namespace touchstone::io
