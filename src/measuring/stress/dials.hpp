// Dials. A dial makes queries stiff in one way. Its setting says how stiff, as a power of two.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

#include "report/sets/query_set.hpp"
#include "seeded/rng.hpp"

namespace touchstone::stress {

struct Dial {
  std::string_view name;      ///< as --dial takes it
  std::string_view varies;    ///< the meaning of 2^setting, for tables and axes
  std::string_view about;     ///< the way in which the queries are made; one sentence without its full stop
  std::vector<int> settings;  ///< ascending
  int gentle;                 ///< the setting that is not stiff
  Query (*make)(Kind kind, int setting, seeded::Rng& rng);
};

const std::vector<Dial>& dials();

/// The dial of this name, or null.
const Dial* find_dial(std::string_view name) noexcept;

/// The kinds of query that the dials make.
inline constexpr std::array<Kind, 2> kAskedKinds{Kind::edge_edge, Kind::vertex_face};

/// `count` queries at one setting. The same seed makes the same queries on every machine.
report::QuerySet make_set(const Dial& dial, Kind kind, int setting, std::uint64_t seed, std::size_t count);

}  // namespace touchstone::stress
