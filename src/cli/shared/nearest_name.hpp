// What a person meant who mistyped a name.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::cli {

/// "; did you mean certify?" for the one of the names that is nearest to the word: with at most a third of its
/// characters changed, added, left out or swapped with the next one. Empty where there is none.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace touchstone::cli
