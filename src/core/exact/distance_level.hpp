// The distance of two moving elements against one level d > 0, in exact arithmetic.
//
// The elements are within d of each other where one of finitely many conditions holds, each made of signs of
// polynomials in t. So the times at which the distance falls to d are among the roots of finitely many polynomials: the
// events. docs/design.md proves both for both metrics.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "exact/corners.hpp"
#include "exact/elements.hpp"
#include "exact/form.hpp"

namespace touchstone::exact {

/// numerator / denominator, denominator > 0.
struct Ratio {
  Exact numerator;
  Exact denominator;
};

/// The sign of (a - b).
inline int compare(const Ratio& a, const Ratio& b) {
  return numbers::sign_of(a.numerator * b.denominator - b.numerator * a.denominator);
}

class DistanceLevel {
 public:
  /// A polynomial among whose roots are times at which the distance may reach the level. `index` is the level's own.
  struct Event {
    Form polynomial;
    std::size_t index;
  };

  virtual ~DistanceLevel() = default;

  /// The sign of (distance - level).
  virtual int compare(const Moment& moment) const = 0;

  /// Events that together have every first time of a contact among their roots; each is not identically zero. Events
  /// that have no root in [0, 1] at which they hold may be missing.
  virtual std::vector<Event> events() const = 0;

  /// Whether the distance is at most the level at a root of the event, as far as the event's own condition shows it.
  virtual bool holds(const Event& event, const Moment& moment) const = 0;

  /// For a person: the event's name, and the conditions under which `holds` holds, with their signs.
  virtual std::string event_name(const Event& event) const = 0;
  virtual std::vector<CandidateStory::Condition> conditions_of(const Event& event, const Moment& moment) const = 0;

  /// The closest points' features and weights. The distance at the root must be the level.
  virtual void locate(const RealRoot& root, Answer& answer) const = 0;

  /// The distance at a rational time, in the form in which this metric holds levels: squared in the Euclidean one.
  virtual Ratio distance_at(const RealRoot& time) const = 0;

  /// The same elements against another level, given in that form.
  virtual std::unique_ptr<DistanceLevel> with_level(const Ratio& level) const = 0;
};

/// The Euclidean distance; the level is d^2. d is multiplied by the corners' factor, but not by their scale.
std::unique_ptr<DistanceLevel> euclidean_level(Kind kind, const AnyCorners& corners, const Ratio& level);

/// The largest distance along an axis; the level is d, multiplied in the same way.
std::unique_ptr<DistanceLevel> max_level(Kind kind, const AnyCorners& corners, const Ratio& level);

/// A moving point, in polynomials of any formal degree.
inline geometry::Vector<Form> form_of(const Forms<Exact>::Point& point) {
  return {{Form(point[0][0], point[0][1]), Form(point[1][0], point[1][1]), Form(point[2][0], point[2][1])}};
}

/// p at a rational time n / d, times d^degree for its formal degree.
Exact homogeneous_value(const Form& p, const Ratio& time);

}  // namespace touchstone::exact
