// contact_times against solve, and against the third opinion at sampled times.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <set>

#include <touchstone/contact_times.hpp>
#include <touchstone/solve.hpp>

#include "support/report.hpp"
#include "support/static_contact.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 2;

std::string interval_text(const std::vector<ContactInterval>& times) {
  std::string text = "T =";
  for (const ContactInterval& interval : times) {
    text += " [" + interval.first.to_string() + ", " + interval.last.to_string() + "]";
  }
  return text;
}

// Whether the bounds of an exact time are the neighbouring doubles around it.
std::string time_malformation(const ExactTime& time) {
  const double lower = time.lower();
  const double upper = time.upper();
  if (!(lower >= 0 && upper <= 1)) return "an end lies outside [0, 1]";
  if (time.compare(lower) < 0 || time.compare(upper) > 0) return "an end lies outside its bounds";
  if (lower == upper && time.compare(lower) != 0) return "an end is not the double that it says it is";
  if (lower != upper && (time.compare(lower) == 0 || time.compare(upper) == 0)) return "an end is a double untold";
  if (lower != upper && std::nextafter(lower, 2.0) != upper) return "an end's bounds are not neighbours";
  if (time.to_string().empty()) return "an end has no text";
  if (time.reversed().reversed() != time) return "reversing an end twice changes it";
  if (time.compare(time) != 0) return "an end differs from itself";
  return "";
}

std::string set_malformation(const std::vector<ContactInterval>& times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (const ExactTime* end : {&times[i].first, &times[i].last}) {
      if (std::string wrong = time_malformation(*end); !wrong.empty()) return wrong;
    }
    if (times[i].last < times[i].first) return "an interval ends before it starts";
    if (i > 0 && !(times[i - 1].last < times[i].first)) return "intervals are not disjoint and ascending";
  }
  return "";
}

// The answer of `solve` must follow from the set.
std::string contradiction(const Query& query, const Answer& answer, const std::vector<ContactInterval>& times) {
  if (answer.contact == times.empty()) return "contact and an empty set, or none and a set";
  if (times.empty()) return "";
  const ContactInterval& first = times.front();
  if (first.first.lower() != answer.toi || first.first.upper() != answer.toi_upper) return "toi is not the first end";
  const bool lasts = first.first < first.last;
  if (lasts != (answer.nature == Nature::sustained))
    return "sustained and an instant, or an interval and not sustained";
  if (!coplanarity_cubic(query).empty()) {
    if (times.size() > 3) return "more times than a cubic has roots";
    for (const ContactInterval& interval : times) {
      if (interval.first != interval.last) return "an interval of positive length although V does not vanish";
    }
    if (answer.nature == Nature::isolated) return "isolated although V does not vanish";
  } else if (answer.nature == Nature::crossing || answer.nature == Nature::grazing) {
    return "crossing or grazing although V vanishes";
  }
  return "";
}

bool contains(const std::vector<ContactInterval>& times, double t) {
  for (const ContactInterval& interval : times) {
    if (interval.first.compare(t) <= 0 && interval.last.compare(t) >= 0) return true;
  }
  return false;
}

// Sixteenths, and the doubles at and beside every end.
std::set<double> sampled_times(const std::vector<ContactInterval>& times) {
  std::set<double> samples;
  for (int k = 0; k <= 16; ++k) samples.insert(k / 16.0);
  for (const ContactInterval& interval : times) {
    for (const ExactTime* end : {&interval.first, &interval.last}) {
      for (const double bound : {end->lower(), end->upper()}) {
        samples.insert(bound);
        if (bound > 0) samples.insert(std::nextafter(bound, 0.0));
        if (bound < 1) samples.insert(std::nextafter(bound, 1.0));
      }
    }
  }
  return samples;
}

std::string membership_error(const Query& query, const std::vector<ContactInterval>& times) {
  for (const double t : sampled_times(times)) {
    const bool touching = touching_at(query, mpq_class(t));
    if (touching == contains(times, t)) continue;
    return std::string(touching ? "touching" : "not touching") + " at " + hexfloat(t) + ", but " + interval_text(times);
  }
  return "";
}

void check_contact_times(Group group, std::size_t count) {
  Report report;
  std::size_t intervals = 0, instants = 0, several = 0;
  for_each_case(
      kSeed, count, [&](const FamilyInfo& f, Kind) { return f.group == group; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const std::vector<ContactInterval> times = contact_times(query);
        std::string wrong = set_malformation(times);
        if (wrong.empty()) wrong = contradiction(query, solve(query, {.method = Method::exact}), times);
        if (!wrong.empty())
          wrong += "\n    " + interval_text(times) + "\n    " + describe(solve(query, {.method = Method::exact}));
        if (wrong.empty()) wrong = membership_error(query, times);
        report.add(id, query, wrong);
        several += times.size() > 1;
        for (const ContactInterval& interval : times) ++(interval.first < interval.last ? intervals : instants);
      });
  if (!chosen_case()) {
    std::printf("seed %llu: %zu sets of times; %zu intervals, %zu instants, %zu sets of several\n",
                static_cast<unsigned long long>(kSeed), report.checked(), intervals, instants, several);
    CHECK(instants > 0);
    if (group == Group::coplanar) CHECK(intervals > 0);
    if (group != Group::scale) CHECK(several > 0);
  }
  report.finish();
}

TEST_CASE("contact_times agrees with solve and with the third opinion: lattice") {
  check_contact_times(Group::lattice, 1000);
}
TEST_CASE("contact_times agrees with solve and with the third opinion: coplanar") {
  check_contact_times(Group::coplanar, 1000);
}
TEST_CASE("contact_times agrees with solve and with the third opinion: contact") {
  check_contact_times(Group::contact, 1000);
}
TEST_CASE("contact_times agrees with solve and with the third opinion: perturbed") {
  check_contact_times(Group::perturbed, 1000);
}
TEST_CASE("contact_times agrees with solve and with the third opinion: scale") {
  check_contact_times(Group::scale, 100);
}

}  // namespace
}  // namespace touchstone::tests
