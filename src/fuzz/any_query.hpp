// The queries that the engine asks: straight ones and curved ones.
// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

namespace touchstone::fuzz {

using AnyQuery = std::variant<Query, CurvedQuery>;

inline Kind kind_of(const AnyQuery& query) {
  return std::visit([](const auto& q) { return q.kind; }, query);
}
inline bool is_curved(const AnyQuery& query) { return std::holds_alternative<CurvedQuery>(query); }

}  // namespace touchstone::fuzz
