// The first time at which two elements are within a separation. Time is divided where their distance can pass a level;
// between neighbouring times of the division, one rational time speaks for all.
// SPDX-License-Identifier: MIT
#include <tuple>
#include <vector>

#include "oracle/closest.hpp"
#include "oracle/distance_at.hpp"
#include "oracle/moment.hpp"
#include "oracle/motion.hpp"
#include "oracle/oracle.hpp"
#include "oracle/sublevel.hpp"

namespace touchstone::oracle {
namespace {

/// The elements and how their distance is measured. All distances and levels below are squared for the Euclidean
/// metric.
struct Measured {
  DifferencePolygon polygon;
  Polynomial scale;  ///< of the polygon's positions at each time
  Metric metric;

  /// At a time at which the scale is not zero.
  Rational distance_at(const Rational& time) const {
    const Rational size = scale.evaluate(time);
    return metric == Metric::euclidean ? Rational(squared_distance_at(polygon, time) / (size * size))
                                       : Rational(max_distance_at(polygon, time) / size);
  }

  /// The scale's roots are among the dividing times, so that no rational time between these is one of them.
  Sublevel sublevel(const Rational& level) const {
    Sublevel result =
        metric == Metric::euclidean ? euclidean_sublevel(polygon, level, scale) : max_sublevel(polygon, level, scale);
    result.dividing.push_back(scale);
    return result;
  }
};

/// 0, t_max and every time at which the distance can pass a level, with one time before and one after these.
class Division {
 public:
  Division(const Measured& elements, const Rational& level, double t_max)
      : elements_(elements), level_(level), sublevel_(elements.sublevel(level)) {
    const Rational last(t_max);
    const Polynomial from_start(Integer(0), Integer(1));
    const Polynomial from_end(Integer(-last.numerator()), last.denominator());
    std::vector<Polynomial> polynomials = sublevel_.dividing;
    polynomials.push_back(from_start);
    polynomials.push_back(from_end);
    times_ = times_dividing(Rational(-1, 2), Rational(3, 2), polynomials);
    while (times_[start_].sign(from_start) < 0) ++start_;
    end_ = start_;
    while (times_[end_].sign(from_end) < 0) ++end_;
  }

  /// The index of 0 and of t_max.
  std::size_t start() const { return start_; }
  std::size_t end() const { return end_; }

  const Moment& time(std::size_t i) const { return times_[i]; }

  /// Whether the distance is at most the level.
  bool is_within(std::size_t i) const { return oracle::is_within(sublevel_, times_[i]); }

  /// The distance compared with the level just before and just after a time of the step.
  CGAL::Comparison_result before(std::size_t i) const { return compare_between(i - 1); }
  CGAL::Comparison_result after(std::size_t i) const { return compare_between(i); }

  /// The closest points at a time at which the distance is the level.
  ClosestPair closest(std::size_t i) const {
    return closest_pair(elements_.polygon, sublevel_, times_[i], elements_.metric == Metric::euclidean);
  }

 private:
  CGAL::Comparison_result compare_between(std::size_t i) const {
    return CGAL::compare(elements_.distance_at(rational_between(times_[i], times_[i + 1])), level_);
  }

  const Measured& elements_;
  Rational level_;
  Sublevel sublevel_;
  std::vector<Moment> times_;
  std::size_t start_ = 0;
  std::size_t end_ = 0;
};

Trend trend_of(CGAL::Comparison_result change) {
  return change == CGAL::SMALLER ? Trend::approaching : change == CGAL::LARGER ? Trend::leaving : Trend::constant;
}

/// The nature of a contact at which the distance is the level.
Nature nature_at(const Division& division, std::size_t i) {
  switch (division.after(i)) {
    case CGAL::SMALLER: return Nature::entering;
    case CGAL::EQUAL: return Nature::sustained;
    default: return division.before(i) == CGAL::LARGER ? Nature::grazing : Nature::isolated;
  }
}

/// The contact at a time at which the distance is the division's level.
Answer contact(const Division& division, std::size_t i, Nature nature) {
  Answer answer = no_contact();
  answer.contact = true;
  answer.nature = nature;
  answer.trend = trend_of(division.after(i));
  answer.starts_within = i == division.start();
  std::tie(answer.toi, answer.toi_upper) = division.time(i).enclosing_doubles();
  const ClosestPair closest = division.closest(i);
  answer.feature_a = closest.a.feature;
  answer.feature_b = closest.b.feature;
  answer.weights_a = closest.a.weights;
  answer.weights_b = closest.b.weights;
  return answer;
}

Answer decide_measured(Kind kind, const MeasuredMotion& motion, double t_max, Metric metric) {
  const Measured elements = {difference_polygon(kind, motion.corners), motion.scale, metric};
  const Rational distance(motion.distance);
  const Rational level = metric == Metric::euclidean ? Rational(distance * distance) : distance;
  const Rational at_start = elements.distance_at(Rational(0));
  if (at_start < level) {
    const Division division(elements, at_start, t_max);
    return contact(division, division.start(), Nature::sustained);
  }
  // The distance is above the level just before the first time that is within, or that time is 0. So it is the level
  // then, and as the distance passes the level at times of the division only, that time is one of them.
  const Division division(elements, level, t_max);
  for (std::size_t i = division.start(); i <= division.end(); ++i) {
    if (division.is_within(i)) return contact(division, i, nature_at(division, i));
  }
  return no_contact();
}

}  // namespace

Answer decide_by_oracle(const Query& query, double t_max, const Separation& separation) {
  return decide_measured(query.kind, read_measured_motion(query, separation.distance), t_max, separation.metric);
}

Answer decide_by_oracle(const RationalQuery& query, double t_max, const Separation& separation) {
  return decide_measured(query.kind, read_measured_motion(query, separation.distance), t_max, separation.metric);
}

Answer decide_by_oracle(const CurvedQuery& query, double t_max, const Separation& separation) {
  return decide_measured(query.kind, read_measured_motion(query, separation.distance), t_max, separation.metric);
}

}  // namespace touchstone::oracle
