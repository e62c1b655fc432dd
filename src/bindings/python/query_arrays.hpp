// Queries in the arrays they came in.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <touchstone/contact_times.hpp>

#include "python/arguments.hpp"

namespace touchstone::python {

struct QueryArrays {
  Kind kind;
  CornerArray start, end;

  /// @throws  for arrays that are no queries of this kind, or not equally many
  QueryArrays(py::handle kind_name, py::handle start_values, py::handle end_values);

  bool is_single() const noexcept { return start.is_single(); }
  std::size_t count() const noexcept { return start.count(); }
  Query at(std::size_t q) const noexcept;
};

}  // namespace touchstone::python
