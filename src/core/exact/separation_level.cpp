// The first time, and all times, at which two elements are within a separation of each other; and their distance at one
// time.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "exact/distance_level.hpp"
#include "exact/exact.hpp"
#include "exact/exact_times.hpp"
#include "exact/off_the_stack.hpp"
#include "geometry/kind_traits.hpp"
#include "numbers/integers/limb_scratch.hpp"

namespace touchstone::exact {
namespace {

/// A distance in the form in which a metric holds levels.
Ratio level_of(const Exact& distance, Metric metric) {
  return {metric == Metric::euclidean ? distance * distance : distance, Exact(1)};
}

AnyCorners any_corners(const CurvedQuery& query) { return moving_corners<AnyDegree>(query); }
template <class Q>
AnyCorners any_corners(const Q& query) {
  const ScaledCorners scaled = scaled_corners(query);
  AnyCorners corners;
  corners.second = geometry::corners_of_first(query.kind);
  corners.factor = scaled.factor;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    corners.corners[i] = corners.own[i] = form_of(scaled.corners[i]);
  }
  return corners;
}

/// The positive number that the corners, and so the distances, are multiplied by.
Exact factor_of(const CurvedQuery& query) {
  return off_the_stack([&] { return any_corners(query); })->factor;
}
template <class Q>
Exact factor_of(const Q& query) {
  return scaled_corners(query).factor;
}

template <class Q>
std::unique_ptr<DistanceLevel> level_for(const Q& query, const Separation& separation) {
  const std::unique_ptr<const AnyCorners> corners = off_the_stack([&] { return any_corners(query); });
  const Ratio level = level_of(Exact(separation.distance) * corners->factor, separation.metric);
  const auto make = separation.metric == Metric::euclidean ? euclidean_level : max_level;
  return make(query.kind, *corners, level);
}

RealRoot time_at(double t) { return RealRoot::rational(Exact(t), Exact(1), 1); }

/// An event's root.
struct Candidate {
  RealRoot time;
  const DistanceLevel::Event* event;
};

std::vector<Candidate> candidates_of(const std::vector<DistanceLevel::Event>& events, const Exact& limit) {
  std::vector<Candidate> candidates;
  for (const DistanceLevel::Event& event : events) {
    const numbers::RootList roots = numbers::isolate_roots(numbers::Coefficients(event.polynomial), limit);
    for (int i = 0; i < roots.size(); ++i) candidates.push_back({roots[i], &event});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.time.compare(b.time) < 0; });
  return candidates;
}

/// The nature and the trend of a contact at a time at which the distance is the level.
void describe_course(const DistanceLevel& level, const RealRoot& time, Answer& answer) {
  const int after = level.compare(Moment::just_after(time));
  answer.trend = after < 0 ? Trend::approaching : after == 0 ? Trend::constant : Trend::leaving;
  if (after < 0) {
    answer.nature = Nature::entering;
  } else if (after == 0) {
    answer.nature = Nature::sustained;
  } else {
    answer.nature = level.compare(Moment::just_before(time)) > 0 ? Nature::grazing : Nature::isolated;
  }
}

Answer contact_at(const DistanceLevel& level, const RealRoot& time) {
  Answer answer;
  answer.contact = true;
  answer.toi = time.lower();
  answer.toi_upper = time.upper();
  describe_course(level, time, answer);
  level.locate(time, answer);
  return answer;
}

/// Tells which polynomials have roots, those of `candidates`, and which have none.
void tell_events(const DistanceLevel& level, const std::vector<DistanceLevel::Event>& events,
                 const std::vector<Candidate>& candidates, Story& story) {
  for (const DistanceLevel::Event& event : events) {
    const bool has_root = std::any_of(candidates.begin(), candidates.end(),
                                      [&](const Candidate& candidate) { return candidate.event == &event; });
    if (!has_root) {
      story.without_root.push_back(level.event_name(event));
      continue;
    }
    Story::DistancePolynomial& told = story.polynomials.emplace_back();
    told.name = level.event_name(event);
    for (int i = 0; i < event.polynomial.size(); ++i) {
      told.coefficients.push_back(numbers::to_string(event.polynomial[i]));
    }
  }
}

/// @param when  becomes the exact time of a contact, if it is not null
Answer first_contact(const DistanceLevel& level, double t_max, Story* story = nullptr,
                     std::optional<RealRoot>* when = nullptr) {
  const RealRoot start = time_at(0);
  const int at_start = level.compare(Moment::at(start));
  if (CandidateStory* const chapter = new_chapter(story, start, 0)) {
    chapter->conditions.push_back({"distance - d", at_start});
    chapter->touching = at_start <= 0;
  }
  if (at_start <= 0) {
    if (when != nullptr) *when = start;
    Answer answer =
        at_start == 0 ? contact_at(level, start) : contact_at(*level.with_level(level.distance_at(start)), start);
    answer.starts_within = true;
    if (at_start < 0) answer.nature = Nature::sustained;
    return answer;
  }
  const std::vector<DistanceLevel::Event> events = level.events();
  const std::vector<Candidate> candidates = candidates_of(events, Exact(t_max));
  if (story != nullptr) tell_events(level, events, candidates, *story);
  for (const Candidate& candidate : candidates) {
    const Moment moment = Moment::at(candidate.time);
    const bool holds = level.holds(*candidate.event, moment);
    if (CandidateStory* const chapter = new_chapter(story, candidate.time, candidate.time.multiplicity())) {
      chapter->polynomial = level.event_name(*candidate.event);
      chapter->conditions = level.conditions_of(*candidate.event, moment);
      chapter->touching = holds;
    }
    if (!holds) continue;
    if (when != nullptr) *when = candidate.time;
    return contact_at(level, candidate.time);
  }
  return Answer();
}

TimedAnswer timed_contact(const DistanceLevel& level, double t_max) {
  TimedAnswer timed;
  timed.answer = first_contact(level, t_max, nullptr, &timed.time);
  return timed;
}

template <class Q>
Story tell(const Q& query, double t_max, const Separation& separation) {
  Story story;
  const std::unique_ptr<DistanceLevel> level = level_for(query, separation);
  story.answer = first_contact(*level, t_max, &story);
  if (story.answer.starts_within) {
    story.why = "the elements are within d of each other at t = 0 already";
  } else if (separation.metric == Metric::euclidean) {
    story.why =
        "the distance may reach d only where a pair of features does: at a root of the pair's polynomial, squared "
        "distance minus d^2 times a square, at which the nearest points have no negative weight";
  } else {
    story.why =
        "the distance may reach d only where three borders meet: planes on which a coordinate of the difference is d "
        "or -d, and ends of the elements, where a corner has no weight";
  }
  return story;
}

std::vector<RootInterval> all_contacts(const DistanceLevel& level, double t_max) {
  const std::vector<DistanceLevel::Event> events = level.events();
  std::vector<RealRoot> times = {time_at(0)};
  for (Candidate& candidate : candidates_of(events, Exact(t_max))) times.push_back(std::move(candidate.time));
  times.push_back(time_at(t_max));
  std::vector<RootInterval> intervals;
  bool lasting = false;
  const RealRoot* previous = nullptr;
  for (const RealRoot& time : times) {
    if (previous != nullptr && previous->compare(time) == 0) continue;
    previous = &time;
    // Between neighbouring times the elements are within the level always or never. The set is closed.
    if (lasting) {
      intervals.back().last = time;
    } else if (level.compare(Moment::at(time)) <= 0) {
      intervals.push_back({time, time});
    } else {
      continue;
    }
    lasting = time.compare(Exact(t_max)) < 0 && level.compare(Moment::just_after(time)) <= 0;
  }
  return intervals;
}

/// The double nearest to a ratio's square root or, for the other metric, to the ratio itself.
double nearest_double(const Ratio& level, const Exact& factor, Metric metric) {
  if (numbers::is_zero(level.numerator)) return 0;
  // The sign of (distance - x).
  const auto compare_with = [&](const Exact& x) {
    const Ratio other = level_of(x * factor, metric);
    return numbers::sign_of(level.numerator * other.denominator - other.numerator * level.denominator);
  };
  // Doubles above zero are ordered as their bit patterns: the greatest that is not above the distance.
  std::uint64_t below = 0;
  std::uint64_t above = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  while (above - below > 1) {
    const std::uint64_t middle = below + (above - below) / 2;
    (compare_with(Exact(std::bit_cast<double>(middle))) >= 0 ? below : above) = middle;
  }
  const Exact low(std::bit_cast<double>(below));
  const bool overflows = above == std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  const Exact high = overflows ? numbers::power_of_two(1024) : Exact(std::bit_cast<double>(above));
  const int side = compare_with((low + high) * Exact(0.5));
  const bool up = side > 0 || (side == 0 && (below & 1) != 0);
  return std::bit_cast<double>(up ? above : below);
}

}  // namespace

Answer decide_exactly(const Query& query, double t_max, const Separation& separation) {
  const numbers::LimbScratch scratch;  // no number outlives the decision
  return first_contact(*level_for(query, separation), t_max);
}
Answer decide_exactly(const RationalQuery& query, double t_max, const Separation& separation) {
  return first_contact(*level_for(query, separation), t_max);
}
Answer decide_exactly(const CurvedQuery& query, double t_max, const Separation& separation) {
  const numbers::LimbScratch scratch;
  return first_contact(*level_for(query, separation), t_max);
}

Story explain(const Query& query, double t_max, const Separation& separation) { return tell(query, t_max, separation); }
Story explain(const RationalQuery& query, double t_max, const Separation& separation) {
  return tell(query, t_max, separation);
}
Story explain(const CurvedQuery& query, double t_max, const Separation& separation) {
  return tell(query, t_max, separation);
}

TimedAnswer decide_with_time(const Query& query, double t_max, const Separation& separation) {
  return timed_contact(*level_for(query, separation), t_max);
}
TimedAnswer decide_with_time(const RationalQuery& query, double t_max, const Separation& separation) {
  return timed_contact(*level_for(query, separation), t_max);
}
TimedAnswer decide_with_time(const CurvedQuery& query, double t_max, const Separation& separation) {
  return timed_contact(*level_for(query, separation), t_max);
}

std::vector<RootInterval> touching_times(const Query& query, double t_max, const Separation& separation) {
  return all_contacts(*level_for(query, separation), t_max);
}
std::vector<RootInterval> touching_times(const RationalQuery& query, double t_max, const Separation& separation) {
  return all_contacts(*level_for(query, separation), t_max);
}
std::vector<RootInterval> touching_times(const CurvedQuery& query, double t_max, const Separation& separation) {
  return all_contacts(*level_for(query, separation), t_max);
}

template <class AnyQuery>
int compare_distance(const AnyQuery& query, double t, const Separation& separation) {
  return level_for(query, separation)->compare(Moment::at(time_at(t)));
}
template int compare_distance(const Query&, double, const Separation&);
template int compare_distance(const RationalQuery&, double, const Separation&);
template int compare_distance(const CurvedQuery&, double, const Separation&);

template <class AnyQuery>
Distance distance_at(const AnyQuery& query, double t, Metric metric) {
  const RealRoot time = time_at(t);
  const std::unique_ptr<DistanceLevel> zero = level_for(query, {0, metric});
  const Ratio level = zero->distance_at(time);
  Answer where;
  zero->with_level(level)->locate(time, where);
  return {nearest_double(level, factor_of(query), metric), where.feature_a, where.feature_b, where.weights_a,
          where.weights_b};
}
template Distance distance_at(const Query&, double, Metric);
template Distance distance_at(const RationalQuery&, double, Metric);
template Distance distance_at(const CurvedQuery&, double, Metric);

}  // namespace touchstone::exact
