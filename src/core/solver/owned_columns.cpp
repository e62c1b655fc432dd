// SPDX-License-Identifier: MIT
#include "solver/owned_columns.hpp"

namespace touchstone::solver {

OwnedColumns::OwnedColumns(const std::vector<Query>& queries) {
  if (queries.empty()) return;
  view_.kind = queries.front().kind;
  view_.count = queries.size();
  const std::size_t corners = corner_count(view_.kind);
  coordinates_.resize(2 * 3 * corners * queries.size());
  double* column = coordinates_.data();
  for (auto* side : {&view_.start, &view_.end}) {
    for (std::size_t i = 0; i < corners; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        (*side)[i][k] = column;
        for (const Query& query : queries) {
          const Vec3& corner = (side == &view_.start ? query.start : query.end)[i];
          *column++ = k == 0 ? corner.x : k == 1 ? corner.y : corner.z;
        }
      }
    }
  }
}

}  // namespace touchstone::solver
