// What Python hands over: names, numbers and arrays, checked, with messages that name the argument and the row.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <touchstone/certify.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>

#include "python/bound.hpp"

namespace touchstone::python {

namespace py = pybind11;

/// @throws TypeError or ValueError (as do all functions here)  for anything but one of the names; "_" is as good
/// as "-"
Kind kind_of(py::handle name);
Metric metric_of(py::handle name);
Method method_of(py::handle name);
Wanted wanted_of(py::handle name);
MeshElement element_of(py::handle name);
IntersectionSort intersection_sort_of(py::handle name);
Verdict refuted_verdict_of(py::handle name);  ///< of a wrong claim

/// Item i of a tuple that names two elements: the number of one.
MeshIndex number_in(const py::tuple& pair, std::size_t i);

/// A pair as Python gives it: (kind, first, second).
MeshPair pair_of(py::handle given);

/// The names of the enumerations, by the enumeration's name: {"Kind": ("edge-edge", ...), ...}.
py::dict all_names();

/// @throws TypeError  for what is no whole number
void check_whole(py::handle number, const std::string& what);

/// A whole number in [least, most], which `right` says in words.
int whole_in(py::handle number, const char* what, int least, int most, const char* right);

/// A whole number of threads. @throws  also outside [0, 1024]
int threads_of(py::handle threads);

/// A real number. Its value is checked by the library.
double number_of(py::handle number, const char* what);

/// "(4, 3)"
std::string shape_text(const py::array& array);

/// An array of float64 or float32 in the machine's byte order that has the exact values of `values`: those themselves
/// where they are such an array. @throws  for anything that is no array of real numbers, or where no double holds one
py::array exact_array(py::handle values, const char* what);

/// Positions of the corners of `count` queries, in the memory of the array they came in, whatever its layout.
class CornerArray {
 public:
  /// @param values  of shape (n, corners, 3) or (n, corners, 2), or without n for a single query
  CornerArray(py::handle values, Kind kind, const char* what);

  bool is_single() const noexcept { return single_; }
  bool is_plane() const noexcept { return coordinates_ == 2; }
  std::size_t count() const noexcept { return count_; }

  /// Coordinate k of corner c of query q; 0 for z in the plane.
  double at(std::size_t q, std::size_t c, std::size_t k) const noexcept {
    if (k >= coordinates_) return 0;
    const char* const address = data_ + static_cast<std::ptrdiff_t>(q) * query_stride_ +
                                static_cast<std::ptrdiff_t>(c) * corner_stride_ +
                                static_cast<std::ptrdiff_t>(k) * coordinate_stride_;
    return is_float_ ? load<float>(address) : load<double>(address);
  }

  /// Corners of query q in the order of the kind.
  void read(std::size_t q, std::array<Vec3, 4>& corners) const noexcept;

  /// Whether each coordinate of each corner is a column of doubles already.
  bool has_columns() const noexcept;

  /// Coordinate k of corner c of query `first` and those after it, where has_columns(). @param zeros  the column of z
  /// in the plane
  const double* column(std::size_t first, std::size_t c, std::size_t k, const double* zeros) const noexcept;

  /// Copies queries [first, first + size) into columns: coordinate k of corner c begins at to + (3 c + k) size.
  void copy_columns(std::size_t first, std::size_t size, double* to) const noexcept;

 private:
  template <class Number>
  static double load(const char* address) noexcept {
    Number number;
    std::memcpy(&number, address, sizeof number);  // it may have any alignment
    return static_cast<double>(number);
  }
  template <class Number>
  void copy(std::size_t first, std::size_t size, double* to) const noexcept;

  py::array owner_;
  const char* data_ = nullptr;
  std::size_t count_ = 1, corners_ = 0, coordinates_ = 3;
  std::ptrdiff_t query_stride_ = 0, corner_stride_ = 0, coordinate_stride_ = 0;
  bool single_ = false, is_float_ = false;
};

/// One separation for all queries, or one for each.
struct SeparationArgument {
  Separation separation;
  std::vector<double> separations;  ///< empty: `separation` is that of all queries

  /// That of query q.
  Separation of(std::size_t q) const noexcept {
    return separations.empty() ? separation : Separation{separations[q], separation.metric};
  }
};

/// @param count  the number of queries; a list of distances must have as many
SeparationArgument separation_of(py::handle distance, py::handle metric, std::size_t count, bool single);

/// Rows of N indices as the library holds them. None is no row.
/// @param values  whole numbers of shape (rows, N)
template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> index_rows(py::handle values, const char* what);

/// The same of shape (rows,).
std::vector<std::uint32_t> indices(py::handle values, const char* what);

/// The numbers of a slice, a mask or several whole numbers, which count from the end where they are negative.
/// @param count, what  how many items there are, and what one of them is called
/// @throws IndexError  also for a number that is not there, or a mask of another length
std::vector<std::size_t> chosen_of(const py::object& several, std::size_t count, const char* what);

/// Numbers of shape (rows,). None is no row.
std::vector<double> numbers(py::handle values, const char* what);

}  // namespace touchstone::python
