// Tables of numbers that Python hands over: one row for each of n things, or one row for all.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "python/arguments.hpp"

namespace touchstone::python {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The numbers of n rows of one shape, or of one row that counts for all.
class NumberTable {
 public:
  /// @param shape  that of a row
  NumberTable(py::handle values, const char* what, const std::vector<py::ssize_t>& shape) {
    const py::array given = exact_array(values, what);
    const auto width = static_cast<py::ssize_t>(shape.size());
    bool fits = given.ndim() == width || given.ndim() == width + 1;
    for (py::ssize_t i = 0; fits && i < width; ++i) {
      fits = given.shape(given.ndim() - width + i) == shape[static_cast<std::size_t>(i)];
      row_ *= static_cast<std::size_t>(shape[static_cast<std::size_t>(i)]);
    }
    if (!fits) {
      std::string row;
      for (const py::ssize_t size : shape) row.append(row.empty() ? "" : ", ").append(std::to_string(size));
      throw py::value_error(std::string(what) + " has the shape " + shape_text(given) + "; it must be (n, " + row +
                            ") or (" + row + (shape.size() == 1 ? ",)" : ")"));
    }
    if (given.ndim() > width) count_ = static_cast<std::size_t>(given.shape(0));
    numbers_ = Doubles(given);
  }

  /// The number of rows; none: one row for all.
  std::optional<std::size_t> count() const noexcept { return count_; }

  const double* row(std::size_t i) const { return numbers_.data() + (count_ ? i * row_ : 0); }

 private:
  Doubles numbers_;
  std::size_t row_ = 1;
  std::optional<std::size_t> count_;
};

}  // namespace touchstone::python
