// The bytes of an HDF5 file of queries around its numbers. They are written here, and libhdf5 is not used.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <touchstone/query.hpp>

namespace touchstone::io {

/// The first bytes of an HDF5 file.
inline constexpr std::string_view kHdf5Magic = "\x89HDF\r\n\x1a\n";

/// The group of the public benchmark's coordinates that are doubles.
inline constexpr std::string_view kHdf5Group = "rounded";

/// What comes before the numbers in a file of `count` > 0 queries. The file goes on with the data set
/// kHdf5Group/points, 3 doubles in little-endian order for each corner at t = 0 and then at t = 1, query after query;
/// and, if there are claims, with kHdf5Group/result, a byte for each query. Format: HDF5 File Format Specification 3.0,
/// superblock of version 2, which libhdf5 reads since 1.8.0. There is no time and nothing else that differs from run to
/// run.
std::string hdf5_query_header(Kind kind, std::uint64_t count, bool with_claims);

}  // namespace touchstone::io
