// Repeated, interleaved measurements of things to do: Google Benchmark behind one function.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace touchstone::cli {

/// @throws Error when the program was built without Google Benchmark, saying what to install
void require_benchmark_library();

/// Seconds of processor time that one call of each action takes: result[i][k] is repetition k of actions[i], the mean
/// of as many calls as make up `min_time` seconds. The repetitions of all actions are run in random order where the
/// library can (since its version 1.6), so that a machine's slow minutes do not fall on one action.
/// @throws Error as require_benchmark_library
std::vector<std::vector<double>> measure(const std::vector<std::function<void()>>& actions, int repetitions,
                                         double min_time);

}  // namespace touchstone::cli
