// The first contact, all contacts, and the record of how they are found.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "exact/bounded_list.hpp"
#include "exact/common_scale.hpp"
#include "exact/corners.hpp"
#include "exact/elements.hpp"
#include "exact/exact.hpp"
#include "exact/exact_times.hpp"
#include "numbers/integers/limb_scratch.hpp"
#include "numbers/roots/near_root.hpp"

namespace touchstone::exact {
namespace {

/// The range [0, t_max] of times, exact ones.
class ExactRange {
 public:
  explicit ExactRange(double t_max) : end_(t_max) {}

  RealRoot start() const { return RealRoot::rational(Exact(0), Exact(1), 1); }
  RealRoot end() const { return RealRoot::rational(end_, Exact(1), 1); }
  bool ends_at(const RealRoot& root) const { return root.compare(end_) >= 0; }
  template <class P>
  bool none_until(const RealRoot&, const P&) const {
    return false;
  }
  template <class P>
  numbers::RootList roots(const P& p) const {
    return numbers::isolate_roots(p, end_);
  }

 private:
  Exact end_;
};

/// The same with times in double-doubles.
template <class Root>
class NearRange {
 public:
  NearRange(double t_max, numbers::Doubt& doubt) : end_(t_max), doubt_(doubt) {}

  Root start() const { return Root::at_double(0, 1, doubt_); }
  Root end() const { return Root::at_double(end_, 1, doubt_); }
  bool ends_at(const Root& root) const { return root.compare(end_) >= 0; }
  /// Whether it is plain that p has no root up to this one.
  template <class P>
  bool none_until(const Root& root, const P& p) const {
    return numbers::certainly_without_root(p, root.upper());
  }
  template <class P>
  typename Root::List roots(const P& p) const {
    return typename Root::List(p, end_, doubt_);
  }

 private:
  double end_;
  numbers::Doubt& doubt_;
};

/// Ascending, distinct times in the range, its ends included, that contain all ends of touching intervals. For
/// elements that are coplanar at all times or have no coplanarity cubic.
template <class N>
class CandidateTimes {
 public:
  template <class Elements, class Range>
  CandidateTimes(const Elements& elements, const Range& range) {
    Events<N> events;
    elements.append_events(events);
    times_.add(range.start());
    for (const auto& event : events) {
      const auto roots = range.roots(event);
      for (int i = 0; i < roots.size(); ++i) times_.add(roots[i]);
    }
    times_.add(range.end());
    for (const Time<N>& time : times_) order_.add(&time);
    std::sort(order_.begin(), order_.end(), [](const Time<N>* a, const Time<N>* b) { return a->compare(*b) < 0; });
    const auto same = [](const Time<N>* a, const Time<N>* b) { return a->compare(*b) == 0; };
    distinct_ = std::unique(order_.begin(), order_.end(), same) - order_.begin();
  }

  auto begin() const { return order_.begin(); }
  auto end() const { return order_.begin() + distinct_; }

 private:
  EventTimes<N, Time<N>> times_;
  EventTimes<N, const Time<N>*> order_;
  std::ptrdiff_t distinct_ = 0;
};
template <class Elements, class Range>
CandidateTimes(const Elements&, const Range&) -> CandidateTimes<typename Elements::Number>;

template <class Elements>
auto nonzero_cubic(const Elements& elements) -> const typename Elements::Cubic* {
  if constexpr (Elements::kHasCubic) {
    if (!is_zero(elements.coplanarity())) return &elements.coplanarity();
  }
  return nullptr;
}

template <class Elements, class Root>
bool touching_at(const Elements& elements, const Root& root, CandidateStory* chapter, SideSigns& found) {
  found = SideSigns();
  const bool touching =
      elements.touching(MomentOf<Root>::at(root, chapter != nullptr ? &chapter->conditions : nullptr), found);
  if (chapter != nullptr) chapter->touching = touching;
  return touching;
}

template <class Elements, class Root>
bool touching_after(const Elements& elements, const Root& root) {
  SideSigns ignored;
  return elements.touching(MomentOf<Root>::just_after(root), ignored);
}

/// The first time after 0 in the range at which the touching of a border begins, if there is one. At each such time the
/// border has an event. So the first event of a border at which the border touches is the only one that counts.
template <class Elements, class Range>
auto first_touch_of_borders(const Elements& elements, const Range& range)
    -> std::optional<Time<typename Elements::Number>> {
  using N = typename Elements::Number;
  std::optional<Time<N>> first;
  elements.for_each_border([&](const auto& border) {
    if (border.always_beside()) return;
    Events<N> events;
    border.append_events(events);
    for (const auto& event : events) {
      if (first && range.none_until(*first, event)) continue;
      const auto roots = range.roots(event);
      for (int i = 0; i < roots.size(); ++i) {
        if (first && first->compare(roots[i]) <= 0) break;
        if (!border.touching(MomentOf<Time<N>>::at(roots[i]))) continue;
        first = roots[i];
        break;
      }
    }
  });
  return first;
}

Answer contact_only() {
  Answer answer;
  answer.contact = true;
  return answer;
}

/// nature() is asked only where it is wanted.
template <class Elements, class Root, class NatureOf>
Answer contact_at(const Elements& elements, const Root& root, const SideSigns& found, Wanted wanted,
                  const NatureOf& nature) {
  Answer answer = contact_only();
  if (wanted == Wanted::contact) return answer;
  answer.toi = root.lower();
  answer.toi_upper = root.upper();
  if (wanted == Wanted::time) return answer;
  answer.nature = nature();
  elements.locate(root, found, answer);
  return answer;
}

/// The first of all candidate times at which the elements touch, each told in the story. Its list of times is large on
/// the stack: calls without a story do not have it in their frame.
template <class Elements, class Range, class ContactFrom>
[[gnu::noinline]] Answer first_contact_told(const Elements& elements, const Range& range, Story* story,
                                            SideSigns& found, const ContactFrom& contact_from) {
  for (const auto* time : CandidateTimes(elements, range)) {
    if (touching_at(elements, *time, new_chapter(story, *time, 0), found)) return contact_from(*time);
  }
  return Answer();
}

template <class Elements, class Range>
Answer first_contact(const Elements& elements, const Range& range, Wanted wanted, Story* story) {
  SideSigns found;
  if (const auto* cubic = nonzero_cubic(elements)) {
    const auto roots = range.roots(*cubic);
    for (int i = 0; i < roots.size(); ++i) {
      const auto& root = roots[i];
      if (touching_at(elements, root, new_chapter(story, root, root.multiplicity()), found)) {
        const auto nature = [&] { return root.multiplicity() % 2 == 1 ? Nature::crossing : Nature::grazing; };
        return contact_at(elements, root, found, wanted, nature);
      }
    }
    return Answer();
  }
  const auto contact_from = [&](const auto& root) {
    return contact_at(elements, root, found, wanted, [&] {
      const bool lasts = !range.ends_at(root) && touching_after(elements, root);
      return lasts ? Nature::sustained : Nature::isolated;
    });
  };
  if (story == nullptr) {
    const auto start = range.start();
    if (touching_at(elements, start, nullptr, found)) return contact_from(start);
    const auto first = first_touch_of_borders(elements, range);
    return first && touching_at(elements, *first, nullptr, found) ? contact_from(*first) : Answer();
  }
  return first_contact_told(elements, range, story, found, contact_from);
}

template <class Elements>
std::vector<RootInterval> all_contacts(const Elements& elements, const ExactRange& range) {
  std::vector<RootInterval> intervals;
  SideSigns found;
  if (const auto* cubic = nonzero_cubic(elements)) {
    const numbers::RootList roots = range.roots(*cubic);
    for (int i = 0; i < roots.size(); ++i) {
      if (touching_at(elements, roots[i], nullptr, found)) intervals.push_back({roots[i], roots[i]});
    }
    return intervals;
  }
  // Between neighbouring candidates the elements touch always or never.
  bool lasting = false;
  for (const RealRoot* time : CandidateTimes(elements, range)) {
    const RealRoot& root = *time;
    if (lasting) {
      intervals.back().last = root;  // the set is closed
    } else if (touching_at(elements, root, nullptr, found)) {
      intervals.push_back({root, root});
    } else {
      continue;
    }
    lasting = !range.ends_at(root) && touching_after(elements, root);
  }
  return intervals;
}

template <class Elements>
void describe(const Elements& elements, Story& story) {
  if constexpr (Elements::kHasCubic) {
    story.has_cubic = true;
    const numbers::Coefficients v = elements.coplanarity();
    for (int i = 0; i < v.size; ++i) story.coefficients.push_back(numbers::to_string(v.c[i]));
    story.why =
        is_zero(elements.coplanarity())
            ? "V is identically zero: the corners are coplanar at all times, and touching may begin only where a "
              "corner of one element meets the border of the other"
            : "contact is possible only at the roots of V";
  } else {
    story.why =
        "this kind has no coplanarity cubic: touching may begin only where the point meets the line or the ends "
        "of the other element";
  }
}

template <class N, class Q>
Story tell(const Q& query, double t_max) {
  return with_elements<N>(query, [&](const auto& elements) {
    Story story;
    describe(elements, story);
    story.answer = first_contact(elements, ExactRange(t_max), Wanted::all, &story);
    return story;
  });
}

/// A frame of its own for each number type: together they would be tens of kilobytes.
template <class N, class Q>
[[gnu::noinline]] Answer first_contact_in(const Q& query, double t_max, Wanted wanted = Wanted::all) {
  const ExactRange range(t_max);
  return with_elements<N>(query, [&](const auto& elements) { return first_contact(elements, range, wanted, nullptr); });
}

using Spans = std::array<BitSpan, 3>;

/// A rung in integers of this size with times in double-doubles. Nothing where something stayed open: the flag tells.
template <class Integer>
std::optional<Answer> decide_near(const Query& query, const Spans& spans, double t_max, Wanted wanted) {
  numbers::Doubt doubt;
  const NearRange<Time<Near<Integer>>> range(t_max, doubt);
  std::optional<Answer> answer = with_elements_of<Near<Integer>>(
      query.kind, moving_corners<Near<Integer>>(query, spans),
      [&](const auto& elements) -> std::optional<Answer> { return first_contact(elements, range, wanted, nullptr); });
  if (doubt.raised()) answer.reset();
  return answer;
}

/// A rung in numbers of type N with exact times.
template <class N>
std::optional<Answer> decide_in(const Query& query, const Spans&, double t_max, Wanted wanted) {
  const numbers::LimbScratch scratch;  // no number outlives the decision
  return first_contact_in<N>(query, t_max, wanted);
}

/// The ladder of the exact level: what a rung needs, and how it decides or leaves the query to the next one.
struct RungOfLadder {
  Rung rung;
  bool each_axis;  ///< the coordinates' bits are counted in a unit for each axis, not in one for all
  int fewest_bits, most_bits;
  std::optional<Answer> (*decide)(const Query&, const Spans&, double t_max, Wanted);
};
constexpr int kAnyBits = std::numeric_limits<int>::max();
constexpr RungOfLadder kLadder[] = {
    {Rung::near_word, true, 0, kMostBits<SmallInt>, decide_near<SmallInt>},
    {Rung::near_one, true, kMostBits<SmallInt> + 1, kMostBits<Short>, decide_near<Short>},
    {Rung::near_two, true, kMostBits<Short> + 1, kMostBits<Medium>, decide_near<Medium>},
    {Rung::exact_one, false, 0, kMostBits<Short>, decide_in<Short>},
    {Rung::exact_two, false, 0, kMostBits<Medium>, decide_in<Medium>},
    {Rung::exact_three, false, 0, kMostBits<Long>, decide_in<Long>},
    {Rung::exact_any, false, 0, kAnyBits, decide_in<Exact>},
};

static_assert(std::size(kLadder) == kRungs && kLadder[kRungs - 1].most_bits == kAnyBits &&
                  kLadder[kRungs - 1].rung == Rung::exact_any,
              "the last rung decides each query");
static_assert(kMostBits<SmallInt> == 16 && kMostBits<Short> == 59 && kMostBits<Medium> == 123 && kMostBits<Long> == 187,
              "as exact.hpp, the solver's ladder and the design page say");

Answer decide_from(Rung first, const Query& query, double t_max, Wanted wanted, Rung* decided) {
  const Spans spans = axis_spans(query);
  const int along_axes = std::max({spans[0].bits(), spans[1].bits(), spans[2].bits()});
  const int together = common_span(spans).bits();
  for (const RungOfLadder& rung : kLadder) {
    const int bits = rung.each_axis ? along_axes : together;
    if (rung.rung < first || bits < rung.fewest_bits || bits > rung.most_bits) continue;
    const std::optional<Answer> answer = rung.decide(query, spans, t_max, wanted);
    if (!answer) continue;
    if (decided != nullptr) *decided = rung.rung;
    return *answer;
  }
  std::abort();  // the last rung decides each query
}

template <class N, class Q>
std::vector<RootInterval> touching_times_of_any(const Q& query, double t_max) {
  return with_elements<N>(query, [&](const auto& elements) { return all_contacts(elements, ExactRange(t_max)); });
}

}  // namespace

Answer decide_exactly(const Query& query, double t_max) {
  return decide_from(Rung::exact_one, query, t_max, Wanted::all, nullptr);
}
Answer decide_exactly(const RationalQuery& query, double t_max) { return first_contact_in<Exact>(query, t_max); }
Answer decide_exactly(const CurvedQuery& query, double t_max) {
  const numbers::LimbScratch scratch;
  return first_contact_in<AnyDegree>(query, t_max);
}

Answer decide(const Query& query, double t_max, Wanted wanted, Rung* decided) {
  return decide_from(Rung::near_word, query, t_max, wanted, decided);
}

Story explain(const Query& query, double t_max) { return tell<Exact>(query, t_max); }
Story explain(const RationalQuery& query, double t_max) { return tell<Exact>(query, t_max); }
Story explain(const CurvedQuery& query, double t_max) { return tell<AnyDegree>(query, t_max); }

std::vector<RootInterval> touching_times(const Query& query, double t_max) {
  return touching_times_of_any<Exact>(query, t_max);
}
std::vector<RootInterval> touching_times(const RationalQuery& query, double t_max) {
  return touching_times_of_any<Exact>(query, t_max);
}
std::vector<RootInterval> touching_times(const CurvedQuery& query, double t_max) {
  return touching_times_of_any<AnyDegree>(query, t_max);
}

}  // namespace touchstone::exact
