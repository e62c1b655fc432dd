// SPDX-License-Identifier: MIT
#include "cli/convert/hdf5_files.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "cli/shared/progress/interrupt.hpp"
#include "io/input_file.hpp"
#include "io/queries/hdf5_layout.hpp"

namespace touchstone::cli {
namespace {

/// A file of doubles in memory.
struct HeldArray {
  explicit HeldArray(const std::string& name, std::string content)
      : bytes(std::move(content)), array(io::InputFile::from_memory(name, bytes)) {}

  std::string bytes;
  io::QueryArray array;
};

/// The queries as a binary query file has them.
std::string binary_file_of(Kind kind, std::uint64_t count, const frames::Hdf5Queries& queries) {
  const bool has_claims = !queries.result.empty();
  std::string bytes = io::BinaryHeader{kind, 3, count, has_claims, std::nullopt}.bytes();
  const std::size_t numbers = 6 * corner_count(kind);  // of a query, in the order of the columns
  const std::size_t header = bytes.size();
  bytes.resize(header + numbers * count * sizeof(double));
  for (std::size_t column = 0; column < numbers; ++column) {
    for (std::size_t q = 0; q < count; ++q) {
      auto bits = std::bit_cast<std::uint64_t>(queries.points[q * numbers + column]);
      if constexpr (std::endian::native != std::endian::little) bits = __builtin_bswap64(bits);
      std::memcpy(bytes.data() + header + (column * count + q) * sizeof bits, &bits, sizeof bits);
    }
  }
  bytes.append(queries.result.begin(), queries.result.end());
  return bytes;
}

}  // namespace

bool is_hdf5(const Input& input) {
  if (input.bundled || !input.bytes) return false;
  io::InputFile file = input.open();
  std::array<char, io::kHdf5Magic.size()> start;
  std::size_t size = 0;
  while (size < start.size()) {
    const std::size_t count = file.read(start.data() + size, start.size() - size);
    if (count == 0) break;
    size += count;
  }
  return std::string_view(start.data(), size) == io::kHdf5Magic;
}

Hdf5Stream::Hdf5Stream(const Input& input, const std::string& group, std::size_t chunk_bytes)
    : name_(std::make_shared<const std::string>(input.name)),
      kind_(input.kind),
      reader_(input.name, group, corner_count(input.kind), throw_if_interrupted),
      queries_per_chunk_(std::max<std::uint64_t>(chunk_bytes / (6 * corner_count(input.kind) * sizeof(double)), 1)) {}

bool Hdf5Stream::next(QueryItem& item) {
  const std::uint64_t count = std::min(queries_per_chunk_, reader_.count() - next_);
  if (count == 0) return false;
  const auto held = std::make_shared<const HeldArray>(*name_, binary_file_of(kind_, count, reader_.read(next_, count)));
  item.input = 0;
  item.chunk = io::QueryChunk();
  item.chunk.file = name_;
  item.chunk.kind = kind_;
  item.chunk.first_query = item.chunk.array_start = next_;
  item.chunk.query_count = static_cast<std::size_t>(count);
  item.chunk.array = std::shared_ptr<const io::QueryArray>(held, &held->array);
  next_ += count;
  return true;
}

}  // namespace touchstone::cli
