// The names that others have for kinds.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include <touchstone/query.hpp>

namespace touchstone::geometry {

/// The kind of its own name, as from_name<Kind>, or of one that other programs use, in any case and with '_' for '-':
/// "vertex-triangle", "point-triangle", "EE", "VF" and so on. Nothing for any other name.
/// @throws InvalidQuery  for "face-vertex" and its like: such a name says that the face's corners come first, and they
///                       would be read as others
std::optional<Kind> kind_named(std::string_view name);

}  // namespace touchstone::geometry
