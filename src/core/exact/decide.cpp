// The first contact, all contacts, and the record of how they are found.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "exact/bounded_list.hpp"
#include "exact/common_scale.hpp"
#include "exact/corners.hpp"
#include "exact/elements.hpp"
#include "exact/exact.hpp"
#include "exact/exact_times.hpp"
#include "exact/gap.hpp"
#include "exact/wide_contact.hpp"
#include "numbers/limb_scratch.hpp"
#include "numbers/near_root.hpp"

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

/// Nothing where a doubt is left.
template <int Limbs>
std::optional<Answer> near_first_contact(const Query& query, const std::array<BitSpan, 3>& spans, double t_max,
                                         Wanted wanted, numbers::Doubt& doubt) {
  const NearRange<Time<Near<Limbs>>> range(t_max, doubt);
  std::optional<Answer> answer = with_elements_of<Near<Limbs>>(
      query.kind, moving_corners<Near<Limbs>>(query, spans),
      [&](const auto& elements) -> std::optional<Answer> { return first_contact(elements, range, wanted, nullptr); });
  if (doubt.raised()) answer.reset();
  return answer;
}

int most_bits(const std::array<BitSpan, 3>& spans) noexcept {
  return std::max({spans[0].bits(), spans[1].bits(), spans[2].bits()});
}

/// Whether V and the components of cross products have so few bits that times of NearRoot<Limbs> hold them, for
/// coordinates of more. See kMostBits: each of their terms has a factor along each axis, or along each of two.
bool is_uneven(const std::array<BitSpan, 3>& spans, int limbs) noexcept {
  constexpr int kSpare = 6;  // of what fits, as numbers::shortened has it
  const int x = spans[0].bits(), y = spans[1].bits(), z = spans[2].bits();
  return x + y + z + 10 <= 192 * limbs - kSpare && x + y + z - std::min({x, y, z}) + 5 <= 128 * limbs - kSpare;
}

/// Over [0, 1].
std::optional<Answer> decide_across_gap(const Query& query, Wanted wanted) {
  const std::optional<Gap> gap = Gap::of(query);
  if (!gap) return std::nullopt;
  const Query& narrowed = gap->narrowed();
  const std::array<BitSpan, 3> spans = axis_spans(narrowed);
  auto doubt = numbers::Doubt::without_quotients();
  const Wanted needed = wanted == Wanted::time ? Wanted::features : wanted;  // they tell which root the time is
  std::optional<Answer> answer = most_bits(spans) <= kMostBits<1>
                                     ? near_first_contact<1>(narrowed, spans, 1, needed, doubt)
                                     : near_first_contact<2>(narrowed, spans, 1, needed, doubt);
  if (answer && !gap->restore(*answer, wanted)) answer.reset();
  return answer;
}

/// The ends of the part that it has found. Sparse::scaled divides by the power of two, as a step does.
std::array<numbers::Sparse, 2> ends_of_part(const WideLook& look) {
  std::array<numbers::Sparse, 2> ends = {numbers::Sparse(), numbers::Sparse(1)};
  for (std::size_t i = 0; i < look.steps_taken; ++i) {
    const WideLook::Step& step = look.steps[i];
    const numbers::Sparse distance = (ends[1] - ends[0]) * numbers::Sparse::scaled(step.distance, step.exponent);
    ends[step.after ? 0 : 1] = step.from_end ? ends[1] - distance : ends[0] + distance;
  }
  return ends;
}

/// In sparse numbers, where `look` tells that they touch and where.
std::optional<Answer> decide_at_contact(const Query& query, double t_max, Wanted wanted, const WideLook& look) {
  if (wanted == Wanted::contact && t_max == 1) return contact_only();
  using N = Near<kSparse>;
  numbers::Doubt doubt;
  const numbers::SparseScratch scratch(doubt);
  const auto corners = moving_corners<N>(query, axis_spans(query));
  std::optional<Answer> answer =
      with_elements_of<N>(query.kind, corners, [&](const auto& elements) -> std::optional<Answer> {
        if constexpr (std::remove_cvref_t<decltype(elements)>::kHasCubic) {
          const auto [low, high] = ends_of_part(look);
          const auto root = numbers::SparseRoot::between(low, high, elements.coplanarity(), look.sign_at_start, doubt);
          if (!root) return std::nullopt;
          if (root->compare(t_max) > 0) return Answer();
          const SideSigns sides = {look.axis, {1, 1, 1, 1}};
          return contact_at(elements, *root, sides, wanted, [] { return Nature::crossing; });
        }
        return std::nullopt;
      });
  if (doubt.raised()) answer.reset();
  return answer;
}

template <class N, class Q>
std::vector<RootInterval> touching_times_of_any(const Q& query, double t_max) {
  return with_elements<N>(query, [&](const auto& elements) { return all_contacts(elements, ExactRange(t_max)); });
}

Answer decide_by_size(const Query& query, double t_max, Wanted wanted) {
  const numbers::LimbScratch scratch;  // no number outlives the decision
  const int bits = coordinate_span(query).bits();
  if (bits <= kMostBits<1>) return first_contact_in<Short>(query, t_max, wanted);
  if (bits <= kMostBits<2>) return first_contact_in<Medium>(query, t_max, wanted);
  if (bits <= kMostBits<3>) return first_contact_in<Long>(query, t_max, wanted);
  return first_contact_in<Exact>(query, t_max, wanted);
}

}  // namespace

Answer decide_exactly(const Query& query, double t_max) { return decide_by_size(query, t_max, Wanted::all); }
Answer decide_exactly(const RationalQuery& query, double t_max) { return first_contact_in<Exact>(query, t_max); }
Answer decide_exactly(const CurvedQuery& query, double t_max) {
  const numbers::LimbScratch scratch;
  return first_contact_in<AnyDegree>(query, t_max);
}

std::optional<Answer> decide_nearby(const Query& query, double t_max, Wanted wanted) {
  const std::array<BitSpan, 3> spans = axis_spans(query);
  const int bits = most_bits(spans);
  numbers::Doubt doubt;
  if (bits <= kMostBits<0>) return near_first_contact<0>(query, spans, t_max, wanted, doubt);
  if (bits <= kMostBits<1>) return near_first_contact<1>(query, spans, t_max, wanted, doubt);
  if (bits <= kMostBits<2>) {
    // A gap beside so few bits is worth it: the narrowed query mostly has few enough for times of one limb.
    constexpr int kFewBits = 6;
    if (t_max == 1 && spans[0].bits() + spans[1].bits() + spans[2].bits() - bits <= kFewBits) {
      if (const std::optional<Answer> answer = decide_across_gap(query, wanted)) return answer;
    }
    if (is_uneven(spans, 1)) {
      numbers::Doubt uneven;
      const auto answer = near_first_contact<kUnevenMedium>(query, spans, t_max, wanted, uneven);
      if (answer) return answer;
    }
    return near_first_contact<2>(query, spans, t_max, wanted, doubt);
  }
  if (t_max == 1) {
    if (const std::optional<Answer> answer = decide_across_gap(query, wanted)) return answer;
  }
  if (bits <= kMostBits<3> && is_uneven(spans, 2)) {
    const auto answer = near_first_contact<kUnevenLong>(query, spans, t_max, wanted, doubt);
    if (answer) return answer;
  }
  const WideLook look = look_widely(query);
  if (look.verdict == WideLook::Verdict::apart) return Answer();
  if (look.verdict == WideLook::Verdict::touching) {
    if (const auto answer = decide_at_contact(query, t_max, wanted, look)) return answer;
  }
  return decide_sparsely(query, t_max, wanted);
}

std::optional<Answer> decide_sparsely(const Query& query, double t_max, Wanted wanted) {
  numbers::Doubt doubt;
  const numbers::SparseScratch scratch(doubt);
  return near_first_contact<kSparse>(query, axis_spans(query), t_max, wanted, doubt);
}

Answer decide_sooner(const Query& query, double t_max, Wanted wanted) {
  if (const std::optional<Answer> answer = decide_nearby(query, t_max, wanted)) return *answer;
  return decide_by_size(query, t_max, wanted);
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
