// SPDX-License-Identifier: MIT
#include "io/queries/query_array.hpp"

#include <array>
#include <cmath>

#include "io/bytes.hpp"
#include "io/fail.hpp"
#include "io/queries/kind_of_file.hpp"
#include "io/queries/npy_header.hpp"
#include "io/times.hpp"

namespace touchstone::io {
namespace {

constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kClaimsFlag = 1;
constexpr std::uint32_t kSeparationFlag = 2;
constexpr std::string_view kExampleShape = "(100, 2, 4, 3)";

// Where the fields of the header are.
constexpr std::size_t kVersionAt = 8, kKindAt = 12, kDimensionAt = 16, kFlagsAt = 20, kCountAt = 24, kDistanceAt = 32,
                      kMetricAt = 40, kReservedAt = 44;

std::uint32_t number_at(const char* from) { return unsigned_at<std::uint32_t>(from, std::endian::little); }

template <class Unsigned>
void append(std::string& out, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i) out += static_cast<char>(value >> (8 * i) & 0xFF);
}

[[noreturn]] void refuse_field(const InputFile& file, std::size_t at, std::string_view name, const std::string& value,
                               const std::string& right) {
  fail(file.name(), "the header of the binary query file: " + std::string(name) + ", at byte " + std::to_string(at) +
                        ", is " + value + "; " + right);
}

template <class Load>
void copy_query(const char* from, Query& query, std::size_t corners, std::size_t dimension,
                const std::array<std::size_t, 3>& steps, Load load) noexcept {
  const auto [time_step, corner_step, axis_step] = steps;
  for (std::size_t i = 0; i < corners; ++i) {
    const char* const at = from + i * corner_step;
    const char* const later = at + time_step;
    query.start[i] = {load(at), load(at + axis_step), dimension == 3 ? load(at + 2 * axis_step) : 0.0};
    query.end[i] = {load(later), load(later + axis_step), dimension == 3 ? load(later + 2 * axis_step) : 0.0};
  }
}

}  // namespace

bool starts_query_array(std::string_view start) noexcept {
  return start.starts_with(kBinaryMagic) || start.starts_with(kNpyMagic);
}

std::string BinaryHeader::bytes() const {
  std::string out(kBinaryMagic);
  append(out, kVersion);
  append(out, static_cast<std::uint32_t>(kind));
  append(out, static_cast<std::uint32_t>(dimension));
  append(out, (has_claims ? kClaimsFlag : 0) | (separation ? kSeparationFlag : 0));
  append(out, count);
  append(out, std::bit_cast<std::uint64_t>(separation ? separation->distance : 0.0));
  append(out, static_cast<std::uint32_t>(separation && separation->metric == Metric::max ? 1 : 0));
  out.resize(kSize, '\0');
  return out;
}

std::string npy_query_header(Kind kind, std::uint64_t count) {
  std::string text =
      "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape_text({count, 2, corner_count(kind), 3}) + ", }";
  std::string out(kNpyMagic);
  out.append("\x01\x00", 2);
  constexpr std::size_t kAlignment = 64;
  const std::size_t before = out.size() + 2;
  text.append(kAlignment - 1 - (before + text.size()) % kAlignment, ' ').append("\n");
  append(out, static_cast<std::uint16_t>(text.size()));
  return out + text;
}

QueryArray::QueryArray(const InputFile& file) : bytes_(file) {
  if (bytes_.view().starts_with(kBinaryMagic)) {
    read_binary_header(file);
  } else {
    read_npy_shape(file);
  }
  bytes_per_query_ = 2 * corners_ * dimension_ * value_size_ + (has_claims() ? 1 : 0);
  if (count_ == 0) fail(file.name(), "holds no query");
}

void QueryArray::read_binary_header(const InputFile& file) {
  const std::string_view bytes = bytes_.view();
  if (bytes.size() < BinaryHeader::kSize) {
    fail(file.name(), "is a binary query file that ends within its header: it has " + std::to_string(bytes.size()) +
                          " bytes, and the header alone has " + std::to_string(BinaryHeader::kSize));
  }
  const char* const at = bytes.data();
  const auto field = [&](std::size_t position, std::string_view name, bool good, const std::string& right) {
    const std::uint32_t value = number_at(at + position);
    if (!good) refuse_field(file, position, name, std::to_string(value), right);
    return value;
  };
  field(kVersionAt, "the version", number_at(at + kVersionAt) == kVersion, "version 1 is read");
  const std::uint32_t kind = field(kKindAt, "the kind", number_at(at + kKindAt) < kKinds.size(),
                                   "0 is edge-edge, 1 vertex-face, 2 point-edge and 3 point-point");
  dimension_ = field(kDimensionAt, "the dimension",
                     number_at(at + kDimensionAt) == 2 || number_at(at + kDimensionAt) == 3, "it must be 2 or 3");
  const std::uint32_t flags =
      field(kFlagsAt, "the sum of the flags", number_at(at + kFlagsAt) < 4,
            "known are 1 (there is a column of claims) and 2 (the claims' separation is given)");
  kind_ = static_cast<Kind>(kind);
  corners_ = corner_count(*kind_);
  count_ = unsigned_at<std::uint64_t>(at + kCountAt, std::endian::little);

  const double distance = double_at(at + kDistanceAt, std::endian::little);
  const std::uint32_t metric = number_at(at + kMetricAt);
  const bool separation_given = (flags & kSeparationFlag) != 0;
  if (separation_given && !(std::isfinite(distance) && distance >= 0)) {
    refuse_field(file, kDistanceAt, "the separation", std::isfinite(distance) ? hexfloat(distance) : "not finite",
                 "it must be 0 or greater");
  }
  if (!separation_given && std::bit_cast<std::uint64_t>(distance) != 0) {
    refuse_field(file, kDistanceAt, "the separation", "given", "without the flag 2 these eight bytes must be 0");
  }
  field(kMetricAt, "the metric", metric < (separation_given ? 2u : 1u),
        separation_given ? "0 is euclidean and 1 max" : "without the flag 2 it must be 0");
  for (std::size_t i = kReservedAt; i < BinaryHeader::kSize; ++i) {
    if (at[i] == 0) continue;
    refuse_field(file, i, "a reserved byte", std::to_string(static_cast<unsigned char>(at[i])), "it must be 0");
  }
  if (separation_given) separation_ = Separation{distance, metric == 1 ? Metric::max : Metric::euclidean};

  const bool has_claims = (flags & kClaimsFlag) != 0;
  const std::uint64_t columns = 2 * corners_ * dimension_;
  const std::uint64_t per_query = columns * sizeof(double) + (has_claims ? 1 : 0);
  const std::uint64_t room = bytes.size() - BinaryHeader::kSize;
  if (room % per_query != 0 || room / per_query != count_) {
    fail(file.name(), "the header promises " + std::to_string(count_) + " queries of " + std::to_string(per_query) +
                          " bytes, and the file has " + std::to_string(room) +
                          " bytes for them: it is cut off or damaged");
  }
  values_ = at + BinaryHeader::kSize;
  const std::size_t column_bytes = count_ * sizeof(double);
  query_step_ = sizeof(double);
  axis_step_ = column_bytes;
  corner_step_ = dimension_ * column_bytes;
  time_step_ = corners_ * corner_step_;
  if (has_claims) claims_ = values_ + columns * column_bytes;
}

void QueryArray::read_npy_shape(const InputFile& file) {
  InputFile memory = InputFile::from_memory(file.name(), bytes_.view());
  const NpyHeader header = read_npy_header(memory, bytes_.view().size(), kExampleShape);
  if (header.kind != 'f') fail(file.name(), "holds integers; coordinates have the type float64 or float32");
  const std::vector<std::uint64_t>& extents = header.extents;
  if (!take_shape(extents)) {
    fail(file.name(), "an array of shape " + shape_text(extents) +
                          "; queries have the shape (n, 2, corners, 3): n queries, t = 0 and t = 1, 4 corners for "
                          "edge-edge and vertex-face, 3 for point-edge, 2 for point-point, and x, y, z; or 2 in place "
                          "of 3 in the plane. In the same order, they may also be rows of 24, 18 or 12 coordinates, "
                          "(n, 24), or corners, (n, 8, 3). An array has no claims");
  }
  if (corners_ == 3) kind_ = Kind::point_edge;
  if (corners_ == 2) kind_ = Kind::point_point;
  value_size_ = header.size;
  order_ = header.order;
  values_ = bytes_.view().data() + header.header_size;
  std::vector<std::size_t> steps(extents.size());
  std::size_t step = value_size_;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const std::size_t k = header.fortran ? i : extents.size() - 1 - i;
    steps[k] = step;
    step *= extents[k];
  }
  query_step_ = steps.front();
  axis_step_ = steps.back();
  corner_step_ = extents.size() == 2 ? dimension_ * axis_step_ : steps[steps.size() - 2];
  time_step_ = extents.size() == 4 ? steps[1] : corners_ * corner_step_;
}

/// @returns false for what is no shape of queries
bool QueryArray::take_shape(const std::vector<std::uint64_t>& extents) {
  if (extents.size() < 2 || extents.size() > 4) return false;
  dimension_ = extents.size() == 2 ? 3 : extents.back();
  std::uint64_t values = 1;  // of a query
  for (std::size_t i = 1; i < extents.size(); ++i) {
    if (extents[i] == 0 || extents[i] > 24) return false;
    values *= extents[i];
  }
  count_ = extents[0];
  corners_ = values / (2 * dimension_);
  return (dimension_ == 2 || dimension_ == 3) && corners_ >= 2 && corners_ <= 4 &&
         values == 2 * corners_ * dimension_ && (extents.size() < 4 || extents[1] == 2);
}

std::string QueryArray::fault_of_kind(Kind kind) const {
  if (kind_ && *kind_ == kind) return {};
  if (!kind_ && corner_count(kind) == corners_) return {};
  const std::string asked = "; " + std::string(name_of(kind)) + " was asked for";
  if (kind_) return "its queries are of the kind " + std::string(name_of(*kind_)) + asked;
  return "its queries have " + std::to_string(corners_) + " corners: edge-edge or vertex-face" + asked;
}

void QueryArray::read(std::uint64_t number, Query& query) const noexcept {
  const char* const from = values_ + number * query_step_;
  const std::array steps{time_step_, corner_step_, axis_step_};
  const std::endian order = order_;
  if (value_size_ == 4) {
    copy_query(from, query, corners_, dimension_, steps, [order](const char* at) { return float_at(at, order); });
  } else if (order == std::endian::native) {
    copy_query(from, query, corners_, dimension_, steps,
               [](const char* at) { return double_at(at, std::endian::native); });
  } else {
    copy_query(from, query, corners_, dimension_, steps, [order](const char* at) { return double_at(at, order); });
  }
}

std::optional<bool> QueryArray::claim(std::uint64_t number) const noexcept {
  if (claims_ == nullptr) return std::nullopt;
  const char claim = claims_[number];
  return claim == 0 || claim == 1 ? std::optional(claim == 1) : std::nullopt;
}

Kind kind_of_queries(const std::string& path, std::optional<Kind> given) {
  if (!InputFile::check(path)) return kind_of_file(path, given);  // a pipe can be read only once
  InputFile file = InputFile::open(path);
  std::array<char, kBinaryMagic.size()> start;
  std::size_t size = 0;
  while (size < start.size()) {
    const std::size_t count = file.read(start.data() + size, start.size() - size);
    if (count == 0) break;
    size += count;
  }
  if (!starts_query_array({start.data(), size})) return kind_of_file(path, given);
  const QueryArray array(file);
  if (!array.kind()) return kind_of_file(path, given);
  if (given) {
    if (const std::string fault = array.fault_of_kind(*given); !fault.empty()) fail(path, fault);
  } else if (const auto named = kind_of_path(path); named && *named != *array.kind() && start[0] != kBinaryMagic[0]) {
    fail(path, "its shape is that of " + std::string(name_of(*array.kind())) + " queries, and its folder or name is " +
                   std::string(name_of(*named)) + "; a query has the corners at both ends, " +
                   std::to_string(6 * corner_count(*named)) + " numbers, and --kind says which kind it is");
  }
  return *array.kind();
}

}  // namespace touchstone::io
