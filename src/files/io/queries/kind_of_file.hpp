// The kinds of queries, by name, and the kind that a file holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <touchstone/query.hpp>

namespace touchstone::io {

/// The four names, for messages: "edge-edge, vertex-face, point-edge or point-point".
std::string kind_names();

/// The kind that the file's folder is named after, or else the one that its name says as the public benchmark's do:
/// 227ee.csv and 227vf.csv. Or nothing. The folder of a bare file name is the working folder.
std::optional<Kind> kind_of_path(const std::string& path);

/// The kind of the queries of a file: `given` (an option of the caller), or else kind_of_path.
/// @throws FileError when there is neither
Kind kind_of_file(const std::string& path, std::optional<Kind> given);

}  // namespace touchstone::io
