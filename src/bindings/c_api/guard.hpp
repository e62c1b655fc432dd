// What each function of the C interface does first and last: checks of its arguments, and errors as status codes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

#include <touchstone/c.h>
#include <touchstone/error.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>

namespace touchstone::c_api {

/// An argument of a C function that cannot be: a null pointer, an unknown enumerator.
class InvalidArgument : public Error {
 public:
  using Error::Error;
};

/// Keeps the message for touchstone_last_error, and returns the status.
int failed(touchstone_status_code status, const char* message) noexcept;

/// Runs the body of a C function. No exception leaves it.
template <typename Body>
int guarded(const Body& body) noexcept {
  try {
    body();
    return TOUCHSTONE_OK;
  } catch (const InvalidArgument& error) {
    return failed(TOUCHSTONE_INVALID_ARGUMENT, error.what());
  } catch (const InvalidQuery& error) {
    return failed(TOUCHSTONE_INVALID_QUERY, error.what());
  } catch (const InvalidMesh& error) {
    return failed(TOUCHSTONE_INVALID_MESH, error.what());
  } catch (const std::bad_alloc&) {
    return failed(TOUCHSTONE_OUT_OF_MEMORY, "memory ran out");
  } catch (const std::length_error&) {
    return failed(TOUCHSTONE_OUT_OF_MEMORY, "memory ran out");
  } catch (const std::exception& error) {
    return failed(TOUCHSTONE_INTERNAL_ERROR, error.what());
  } catch (...) {
    return failed(TOUCHSTONE_INTERNAL_ERROR, "an unknown error");
  }
}

/// Refuses a null pointer.
template <typename T>
T& required(T* pointer, const char* name) {
  if (pointer == nullptr) throw InvalidArgument(std::string(name) + " is a null pointer");
  return *pointer;
}

/// Refuses an array that is null and not empty, or longer than memory.
template <typename T>
const T* array(const T* first, std::size_t count, std::size_t values_each, const char* name) {
  if (first == nullptr && count > 0) {
    throw InvalidArgument(std::string(name) + " is a null pointer, and its count is " + std::to_string(count));
  }
  if (count > std::numeric_limits<std::ptrdiff_t>::max() / (sizeof(T) * values_each)) {
    throw InvalidArgument(std::string(name) + " has the count " + std::to_string(count) +
                          ", which is more than memory");
  }
  return first;
}

/// A structure of the caller's, of which an older program may have had fewer members: those that it lacks keep the
/// values of `defaults`. The first version of the structure had `least_size` bytes.
template <typename T>
T grown(const T& given, T defaults, std::size_t least_size, const char* name) {
  if (given.size < least_size) {
    throw InvalidArgument(std::string(name) + " has the size " + std::to_string(given.size) +
                          "; initialise it by its macro, which makes it " + std::to_string(sizeof(T)));
  }
  if (given.size > sizeof(T)) {
    throw InvalidArgument(std::string(name) + " has the size " + std::to_string(given.size) +
                          ", and this library knows " + std::to_string(sizeof(T)) +
                          ": the program was compiled for a later version");
  }
  const auto* from = reinterpret_cast<const unsigned char*>(&given);
  auto* to = reinterpret_cast<unsigned char*>(&defaults);
  for (std::size_t i = 0; i < given.size; ++i) to[i] = from[i];
  return defaults;
}

/// Options that a function has, as bits. Each has `threads`.
enum HasOptions : unsigned {
  kHasTMax = 1,
  kHasSeparation = 2,  ///< and metric
  kHasSeparations = 4,
  kHasKeptFraction = 8,
  kHasWanted = 16,
  kHasFloat32 = 32,
  kHasCheckStart = 64,
  kHasMethod = 128,
  kHasArcs = 256  ///< and most_arcs
};

/// The options, or those by default for a null pointer.
/// @param has  of HasOptions
/// @throws InvalidArgument  for another option that is not as it is by default
touchstone_options options_of(const touchstone_options* options, unsigned has);

/// @throws InvalidArgument  for a number that is none of touchstone_kind
Kind kind_of(int kind);

/// @throws InvalidArgument  for a number that is none of touchstone_metric
Metric metric_of(int metric);

/// @throws InvalidArgument  for a number that is none of touchstone_what_is_wanted
Wanted wanted_of(int wanted);

/// @throws InvalidArgument  for a number that is none of touchstone_method
Method method_of(int method);

}  // namespace touchstone::c_api
