// Touchstone: all the times at which two moving elements touch, with exact ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// An exact real algebraic time in [0, 1]. It is immutable, and several threads may use one object. A copy is cheap.
class ExactTime {
 public:
  /// The representation, known to the library only.
  struct Impl;

  /// For the library: a time from its representation, which is not null.
  explicit ExactTime(std::shared_ptr<const Impl> impl);

  /// The largest double <= this time.
  double lower() const noexcept;

  /// The smallest double >= this time. It equals lower() when this time is a double.
  double upper() const noexcept;

  /// Negative when this time is before the other, zero when they are equal, positive when it is after the other. The
  /// comparison is exact.
  int compare(const ExactTime& other) const;

  /// The same against a double. @throws InvalidQuery  for a time that is not finite
  int compare(double time) const;
  int compare(const Fraction& time) const;  ///< @throws InvalidQuery when `time` is no fraction

  /// 1 - this time, exactly: the time in the motion run backwards.
  ExactTime reversed() const;

  /// The time as text for a person, as `touchstone explain` prints it. A time that the library holds as a rational is
  /// a fraction in lowest terms: "1/3". Any other is the only root of a polynomial in the interval from lower() to
  /// upper(): "root of (-2) t^2 + (1) in [0x1.6a09e667f3bccp-1, 0x1.6a09e667f3bcdp-1]". A coefficient is an integer or
  /// an integer times a power of two: "(1101 * 2^-1)". Such a root may be rational too.
  std::string to_string() const;

 private:
  std::shared_ptr<const Impl> impl_;
};

/// Whether two exact times are equal.
inline bool operator==(const ExactTime& a, const ExactTime& b) { return a.compare(b) == 0; }
/// Whether two exact times differ.
inline bool operator!=(const ExactTime& a, const ExactTime& b) { return a.compare(b) != 0; }
/// Whether `a` is before `b`.
inline bool operator<(const ExactTime& a, const ExactTime& b) { return a.compare(b) < 0; }

/// A closed interval of touching times.
struct ContactInterval {
  ExactTime first;  ///< The earliest instant of the contact.
  ExactTime last;   ///< The latest instant of the contact; equal to `first` when the contact is a single instant.
};

/// The set of all t in [0, t_max] at which the elements are within a separation of each other. With distance 0 these
/// are the times at which they touch. The set is a list of disjoint closed intervals in ascending order, and is empty
/// without contact. The earliest instant is the exact time that `solve` encloses. Exact arithmetic computes the set.
/// @param query       the two elements and their motion
/// @param separation  the distance and its metric
/// @param t_max       the end of the time range, 0 <= t_max <= 1
/// @return the intervals
/// @throws InvalidQuery  for a NaN or infinite coordinate, a t_max outside [0, 1], a distance that is negative or not
///                       finite, or an unknown metric
std::vector<ContactInterval> contact_times(const Query& query, const Separation& separation = {}, double t_max = 1.0);

/// The same for rational coordinates.
/// @throws InvalidQuery  also for a coordinate that is not a fraction
std::vector<ContactInterval> contact_times(const RationalQuery& query, const Separation& separation = {},
                                           double t_max = 1.0);

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
