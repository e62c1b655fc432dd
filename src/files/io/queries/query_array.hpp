// Query files of doubles: the binary format, a header and columns, and NumPy's .npy. docs/program.md defines both.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "io/input_file.hpp"

namespace touchstone::io {

/// The first bytes of every binary query file. The first is no text, and the others change when a program takes the
/// file for text and converts its line ends.
inline constexpr std::string_view kBinaryMagic = "\x89TSQ\r\n\x1a\n";

/// Whether a file that starts with these bytes is a file of doubles. `start` has at least kBinaryMagic.size() bytes,
/// or all bytes of a shorter file.
bool starts_query_array(std::string_view start) noexcept;

/// What the header of a binary query file says.
struct BinaryHeader {
  Kind kind = Kind::edge_edge;
  std::size_t dimension = 3;
  std::uint64_t count = 0;
  bool has_claims = false;
  std::optional<Separation> separation;  ///< what the claims are about; nothing: the file does not say it

  static constexpr std::size_t kSize = 64;
  std::string bytes() const;  ///< kSize bytes
};

/// The header of an .npy file of `count` queries, as NumPy itself writes it.
std::string npy_query_header(Kind kind, std::uint64_t count);

/// The queries of a file of doubles. The file is mapped into memory, and read where a query is asked for.
class QueryArray {
 public:
  /// Checks all of the header, and the size of the file. The claims and coordinates are checked when they are read.
  /// @throws FileError  also for a pipe or device, which cannot be mapped
  explicit QueryArray(const InputFile& file);

  /// Nothing when the file does not tell: .npy with four corners.
  std::optional<Kind> kind() const noexcept { return kind_; }

  /// Why the queries cannot be of this kind, or an empty text.
  std::string fault_of_kind(Kind kind) const;

  std::uint64_t count() const noexcept { return count_; }
  bool has_claims() const noexcept { return claims_ != nullptr; }
  std::optional<Separation> separation() const noexcept { return separation_; }
  std::uint64_t bytes_per_query() const noexcept { return bytes_per_query_; }

  /// Copies query `number` < count(). Its kind is the caller's. A coordinate may be infinite or no number.
  void read(std::uint64_t number, Query& query) const noexcept;

  /// The claim about query `number`. @returns nothing when the byte is neither 0 nor 1, or there are no claims
  std::optional<bool> claim(std::uint64_t number) const noexcept;

 private:
  void read_binary_header(const InputFile& file);
  void read_npy_shape(const InputFile& file);
  bool take_shape(const std::vector<std::uint64_t>& extents);

  FileBytes bytes_;
  std::optional<Kind> kind_;
  std::size_t corners_ = 0;
  std::size_t dimension_ = 3;
  std::uint64_t count_ = 0;
  std::optional<Separation> separation_;
  std::uint64_t bytes_per_query_ = 0;

  const char* values_ = nullptr;
  const char* claims_ = nullptr;
  std::size_t value_size_ = 8;
  std::endian order_ = std::endian::little;
  // The distances in bytes between neighbouring queries, times, corners and axes.
  std::size_t query_step_ = 0, time_step_ = 0, corner_step_ = 0, axis_step_ = 0;
};

/// The kind of the queries of a file that exists: the one that a file of doubles states, or else kind_of_file(path,
/// given). @throws FileError  when the file states another kind than `given`, and as kind_of_file does
Kind kind_of_queries(const std::string& path, std::optional<Kind> given);

}  // namespace touchstone::io
