// NumPy's .npz files: archives of .npy files, as numpy.savez writes them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/queries/npy_header.hpp"

namespace touchstone::io {

struct NpzArray {
  std::string name;          ///< without .npy
  std::string_view content;  ///< a whole .npy file, in the archive's bytes
};

/// The arrays of an archive that is not compressed.
/// @param file  the name, for messages
/// @throws FileError  for what is no such archive
std::vector<NpzArray> npz_arrays(const std::string& file, std::string_view archive);

}  // namespace touchstone::io
