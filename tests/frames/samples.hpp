// One mesh as the text or bytes of every format, written here without the project's own code.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::tests {

/// A file.
struct Sample {
  std::string name;  ///< with the ending of its format
  std::string content;
  bool floats = false;  ///< holds kFloats, else kDoubles
  bool edges = false;   ///< holds the edge
  bool points = false;  ///< holds the loose point
};

inline constexpr std::size_t kVertices = 6;
/// Doubles that show every loss: subnormal and huge, of 17 digits, -0.
inline constexpr std::array<double, 3 * kVertices> kDoubles = {0.1,
                                                               -1.0 / 3,
                                                               5e-324,
                                                               0x1.fffffffffffffp+1023,
                                                               2.2250738585072014e-308,
                                                               -0.0,
                                                               1,
                                                               2,
                                                               3,
                                                               -1e22 / 7,
                                                               0x1.0000000000001p0,
                                                               123456789.123456789,
                                                               4,
                                                               5,
                                                               6,
                                                               7,
                                                               8,
                                                               9};
/// Doubles that are floats, with a subnormal one.
inline constexpr std::array<double, 3 * kVertices> kFloats = {
    0.5, 0x1.99999ap-4, -0x1p-149, 0x1.fffffep+127, -1, 0, 1, 2, 3, -7, 0.25, 12, 4, 5, 6, 7, 8, 9};

/// Faces 0 1 2 and 0 2 3, the edge 3 4 and the point 5.
inline constexpr std::array<std::array<std::uint32_t, 3>, 2> kFaces = {{{0, 1, 2}, {0, 2, 3}}};

/// The bytes of a number.
template <class Number>
std::string bytes_of(Number number, std::endian order) {
  auto bytes = std::bit_cast<std::array<char, sizeof number>>(number);
  std::string text(bytes.begin(), bytes.end());
  if (order != std::endian::native) text = std::string(text.rbegin(), text.rend());
  return text;
}

/// 17 significant digits, as printf writes them, which say every double.
std::string decimal(double value);

/// The text with the first `from` in it replaced. @throws std::invalid_argument  if there is none
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// In base64.
std::string base64(std::string_view bytes);

/// A .glb file of this JSON and buffer.
std::string glb(std::string json, std::string buffer);

/// The mesh in every format that holds elements, and in several versions of them. All are valid.
std::vector<Sample> mesh_samples();

/// An .npy file.
/// @param descr    the type, for example "<f8"
/// @param shape    "(3, 4)"
/// @param version  1, 2 or 3
std::string npy(std::string_view descr, bool fortran, std::string_view shape, const std::string& values,
                int version = 1);

/// The .npy file of kDoubles.
Sample npy_sample();

}  // namespace touchstone::tests
