// Touchstone: all the times at which two moving elements touch, with exact ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <touchstone/query.hpp>

namespace touchstone {

/// An exact real algebraic time in [0, 1]. Immutable; copies are cheap and may be shared between threads.
class ExactTime {
 public:
  struct Impl;
  explicit ExactTime(std::shared_ptr<const Impl> impl);

  double lower() const noexcept;  ///< the largest double <= this time
  double upper() const noexcept;  ///< the smallest double >= this time; equal to lower() when this time is a double

  /// Negative, zero or positive as this time is before, equal to or after the other; exact.
  int compare(const ExactTime& other) const;
  int compare(double time) const;
  int compare(const Fraction& time) const;  ///< @throws InvalidQuery when `time` is no fraction

  /// 1 - this time, exactly.
  ExactTime reversed() const;

  /// For a person: "1/3", or "root of 3 t^3 - t - 1 in [0x1.b3p-1, 0x1.b4p-1]".
  std::string to_string() const;

 private:
  std::shared_ptr<const Impl> impl_;
};

inline bool operator==(const ExactTime& a, const ExactTime& b) { return a.compare(b) == 0; }
inline bool operator!=(const ExactTime& a, const ExactTime& b) { return a.compare(b) != 0; }
inline bool operator<(const ExactTime& a, const ExactTime& b) { return a.compare(b) < 0; }

/// A closed interval of touching times; a single instant has first == last.
struct ContactInterval {
  ExactTime first;
  ExactTime last;
};

/// The set of all t in [0, t_max] at which the elements touch, as disjoint closed intervals in ascending order.
/// Its first end is the exact time that `solve` encloses. @throws InvalidQuery as `solve` does.
std::vector<ContactInterval> contact_times(const Query& query, double t_max = 1.0);
std::vector<ContactInterval> contact_times(const RationalQuery& query, double t_max = 1.0);

}  // namespace touchstone
