// The ladder of straight queries: the tests that a query about touching meets, in their order, by Method::fast. Each
// of them decides, or passes the query on.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::solver {

struct LadderRung {
  std::string_view name;
  std::string_view applies;  ///< to which queries
  std::string_view proves;
  Level level;  ///< of its answers; a rescaled query's are of the rung that decides it then
};

inline constexpr std::array<LadderRung, 13> kLadder = {{
    {"same side", "two edges, a vertex and a face", "no contact", Level::filter},
    {"shared corner", "a corner in common at all times", "contact at 0", Level::filter},
    {"boxes", "all", "no contact", Level::filter},
    {"bracket level", "two edges, a vertex and a face, a point and an edge in a plane of two axes", "either",
     Level::bracket},
    {"direction", "all but those that the bracket level finds close", "no contact", Level::filter},
    {"rescaled", "extreme coordinates, or an axis much longer than another", "either", Level::bracket},
    {"near, one word", "at most 16 bits along each axis", "either", Level::exact},
    {"near, one limb", "17 to 59 bits", "either", Level::exact},
    {"near, two limbs", "60 to 123 bits", "either", Level::exact},
    {"exact, one limb", "at most 59 bits in all", "either", Level::exact},
    {"exact, two limbs", "at most 123 bits in all", "either", Level::exact},
    {"exact, three limbs", "at most 187 bits in all", "either", Level::exact},
    {"exact, any size", "all", "either", Level::exact},
}};

/// The answer by Method::fast, and the number of the rung that gave it.
struct RungAnswer {
  Answer answer;
  std::size_t rung = 0;
};
RungAnswer answer_and_rung(const Query& query, double t_max);

}  // namespace touchstone::solver
