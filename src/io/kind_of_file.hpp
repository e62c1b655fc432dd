// Which kind of query a file holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <touchstone/query.hpp>

namespace touchstone::io {

/// The kind of this name ("edge-edge", ...), or nothing.
std::optional<Kind> kind_from_name(std::string_view name) noexcept;

/// The four names, for messages: "edge-edge, vertex-face, point-edge or point-point".
std::string kind_names();

/// The kind that the folder just above the file is named after, or nothing. A bare file name is looked up in the
/// working folder.
std::optional<Kind> kind_of_folder(const std::string& path);

/// The kind a query file is read as: `given` (an option of the caller) or else its folder's.
/// @throws FileError when neither says
Kind kind_of_file(const std::string& path, std::optional<Kind> given);

}  // namespace touchstone::io
