// The names of elements and corners: other names for the same query, and what they change in the answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::tests {

/// relabelling[i] is the corner of the original query that corner i of the new one is.
using Relabelling = std::array<std::size_t, 4>;

/// All relabellings of a kind but the identity.
const std::vector<Relabelling>& relabellings(Kind kind);

/// How many elements are touched in a feature of the same name, and of another one.
struct NameTally {
  std::size_t same_names = 0;
  std::size_t other_names = 0;
};

/// Whether the element of `count` corners from `first` on may have no length or no area when it is touched. Only then
/// may one place have several names.
using MayBeDegenerate = std::function<bool(std::size_t first, std::size_t count)>;

/// Empty when `found`, the answer to the relabelled query, says the same as `expected` in the new names.
std::string name_difference(Kind kind, const Relabelling& relabelling, const Answer& expected, const Answer& found,
                            const MayBeDegenerate& may_be_degenerate, NameTally& tally);

}  // namespace touchstone::tests
