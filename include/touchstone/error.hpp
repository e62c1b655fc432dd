// Touchstone: what goes wrong, as exceptions.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace touchstone {

/// Base of every exception that the library throws on purpose. The message names what, where and what would be right.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A query, a t_max or an option that has no meaning: a NaN or infinite coordinate, t_max outside [0, 1],
/// a fraction that is not a pair of decimal integers or has a zero denominator.
class InvalidQuery : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read or written, or whose content is malformed. The message is "FILE:ROW: reason".
class FileError : public Error {
 public:
  using Error::Error;
};

}  // namespace touchstone
