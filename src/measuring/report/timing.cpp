// SPDX-License-Identifier: MIT
#include "report/timing.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "seeded/shuffle.hpp"

namespace touchstone::report {
namespace {

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double seconds_of_call(const std::function<void()>& action, double least) {
  for (double calls = 1;;) {
    const double start = processor_seconds();
    for (double i = 0; i < calls; ++i) action();
    const double taken = processor_seconds() - start;
    if (!(taken < least)) return taken / calls;
    // Reading the clock takes its time, too: it is read again only after so many calls that this should be the last.
    const double enough = taken > 0 ? std::ceil(1.2 * calls * least / taken) : 10 * calls;
    calls = std::clamp(enough, calls + 1, 10 * calls);
  }
}

std::vector<std::vector<double>> seconds_of_calls(const std::vector<std::function<void()>>& actions, int repetitions,
                                                  double least) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < actions.size(); ++i) order.insert(order.end(), static_cast<std::size_t>(repetitions), i);
  seeded::shuffle(order, 1);
  std::vector<std::vector<double>> seconds(actions.size());
  for (const std::size_t i : order) seconds[i].push_back(seconds_of_call(actions[i], least));
  return seconds;
}

}  // namespace touchstone::report
