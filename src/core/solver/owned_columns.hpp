// Queries of one kind, copied into columns of their own.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <touchstone/solve.hpp>

namespace touchstone::solver {

class OwnedColumns {
 public:
  /// All queries must be of one kind.
  explicit OwnedColumns(const std::vector<Query>& queries);

  const QueryColumns& view() const noexcept { return view_; }  ///< as long as this lives

  OwnedColumns(OwnedColumns&&) noexcept = default;
  OwnedColumns& operator=(OwnedColumns&&) noexcept = default;

 private:
  std::vector<double> coordinates_;
  QueryColumns view_;
};

}  // namespace touchstone::solver
