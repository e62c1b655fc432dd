// How long things to do take, in processor time: what other programs on the machine do does not count.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace touchstone::report {

/// Seconds of processor time of this thread that one call takes: the mean of as many calls as take `least` seconds.
double seconds_of_call(const std::function<void()>& action, double least);

/// The same of several actions: result[i][k] is repetition k of actions[i]. All repetitions are run in a random order,
/// so that a machine's slow minutes do not fall on one action.
std::vector<std::vector<double>> seconds_of_calls(const std::vector<std::function<void()>>& actions, int repetitions,
                                                  double least);

}  // namespace touchstone::report
