// Touchstone: errors, as exceptions.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include <touchstone/version.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The base class of the library's own exceptions. The message names the wrong value and its place, and says which
/// values are valid.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A query or an option that has no meaning: a NaN or infinite coordinate, a t_max outside [0, 1], a fraction that is
/// not a pair of decimal integers, a zero denominator.
class InvalidQuery : public Error {
 public:
  using Error::Error;
};

/// A mesh that has no meaning: an index out of range, a repeated corner, an element given twice.
class InvalidMesh : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read or written, or a file with malformed content. The message is "FILE:ROW: reason".
class FileError : public Error {
 public:
  using Error::Error;
};

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
