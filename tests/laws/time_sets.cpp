// Sets of touching times as sorted lists of intervals.
// SPDX-License-Identifier: MIT
#include "laws/time_sets.hpp"

#include <algorithm>

namespace touchstone::tests {
namespace {

std::string both(const TimeSet& expected, const TimeSet& found) {
  return "the times differ\n    expected " + text(expected) + "\n    found    " + text(found);
}

}  // namespace

std::string text(const TimeSet& set) {
  if (set.empty()) return "nothing";
  std::string all;
  for (const ContactInterval& interval : set) {
    all.append("[").append(interval.first.to_string()).append(", ").append(interval.last.to_string()).append("] ");
  }
  return all;
}

std::string set_difference(const TimeSet& expected, const TimeSet& found) {
  const bool same = std::equal(
      expected.begin(), expected.end(), found.begin(), found.end(),
      [](const ContactInterval& a, const ContactInterval& b) { return a.first == b.first && a.last == b.last; });
  return same ? "" : both(expected, found);
}

TimeSet united(const TimeSet& one, const TimeSet& other) {
  TimeSet sorted = one;
  sorted.insert(sorted.end(), other.begin(), other.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const ContactInterval& a, const ContactInterval& b) { return a.first < b.first; });
  TimeSet result;
  for (const ContactInterval& interval : sorted) {
    if (result.empty() || result.back().last < interval.first) {
      result.push_back(interval);
    } else if (result.back().last < interval.last) {
      result.back().last = interval.last;
    }
  }
  return result;
}

TimeSet reversed(const TimeSet& set) {
  TimeSet result;
  for (auto interval = set.rbegin(); interval != set.rend(); ++interval) {
    result.push_back({interval->last.reversed(), interval->first.reversed()});
  }
  return result;
}

std::string cut_difference(const TimeSet& whole, double t_max, const TimeSet& found) {
  std::size_t kept = 0;
  for (const ContactInterval& interval : whole) {
    if (interval.first.compare(t_max) > 0) break;
    if (kept == found.size() || found[kept].first != interval.first) return both(whole, found);
    const bool cut = interval.last.compare(t_max) > 0;
    if (cut ? found[kept].last.compare(t_max) != 0 : found[kept].last != interval.last) return both(whole, found);
    ++kept;
  }
  return kept == found.size() ? "" : both(whole, found);
}

}  // namespace touchstone::tests
