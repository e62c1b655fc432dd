// The first contact, all contacts, and the record of how they are found.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <utility>

#include "exact/bounded_list.hpp"
#include "exact/common_scale.hpp"
#include "exact/corners.hpp"
#include "exact/elements.hpp"
#include "exact/exact.hpp"
#include "exact/exact_times.hpp"
#include "numbers/limb_scratch.hpp"

namespace touchstone::exact {
namespace {

/// Ascending, distinct times in [0, limit], 0 and limit included, that contain all ends of touching intervals. For
/// elements that are coplanar at all times or have no coplanarity cubic.
template <class N>
class CandidateTimes {
 public:
  template <class Elements>
  CandidateTimes(const Elements& elements, const Exact& limit) {
    Events<N> events;
    elements.append_events(events);
    times_.add(RealRoot::rational(Exact(0), Exact(1), 1));
    for (const auto& event : events) {
      const numbers::RootList roots = numbers::isolate_roots(event, limit);
      for (int i = 0; i < roots.size(); ++i) times_.add(roots[i]);
    }
    times_.add(RealRoot::rational(limit, Exact(1), 1));
    for (const RealRoot& time : times_) order_.add(&time);
    std::sort(order_.begin(), order_.end(), [](const RealRoot* a, const RealRoot* b) { return a->compare(*b) < 0; });
    const auto same = [](const RealRoot* a, const RealRoot* b) { return a->compare(*b) == 0; };
    distinct_ = std::unique(order_.begin(), order_.end(), same) - order_.begin();
  }

  auto begin() const { return order_.begin(); }
  auto end() const { return order_.begin() + distinct_; }

 private:
  EventTimes<N, RealRoot> times_;
  EventTimes<N, const RealRoot*> order_;
  std::ptrdiff_t distinct_ = 0;
};
template <class Elements>
CandidateTimes(const Elements&, const Exact&) -> CandidateTimes<typename Elements::Number>;

template <class Elements>
auto nonzero_cubic(const Elements& elements) -> const typename Elements::Cubic* {
  if constexpr (Elements::kHasCubic) {
    if (!is_zero(elements.coplanarity())) return &elements.coplanarity();
  }
  return nullptr;
}

template <class Elements>
bool touching_at(const Elements& elements, const RealRoot& root, CandidateStory* chapter, SideSigns& found) {
  found = SideSigns();
  const bool touching = elements.touching(Moment::at(root, chapter != nullptr ? &chapter->conditions : nullptr), found);
  if (chapter != nullptr) chapter->touching = touching;
  return touching;
}

template <class Elements>
bool touching_after(const Elements& elements, const RealRoot& root) {
  SideSigns ignored;
  return elements.touching(Moment::just_after(root), ignored);
}

template <class Elements>
Answer contact_at(const Elements& elements, const RealRoot& root, const SideSigns& found, Nature nature) {
  Answer answer;
  answer.contact = true;
  answer.nature = nature;
  answer.toi = root.lower();
  answer.toi_upper = root.upper();
  elements.locate(root, found, answer);
  return answer;
}

template <class Elements>
Answer first_contact(const Elements& elements, const Exact& limit, Story* story) {
  SideSigns found;
  if (const auto* cubic = nonzero_cubic(elements)) {
    const numbers::RootList roots = numbers::isolate_roots(*cubic, limit);
    for (int i = 0; i < roots.size(); ++i) {
      const RealRoot& root = roots[i];
      if (touching_at(elements, root, new_chapter(story, root, root.multiplicity()), found)) {
        return contact_at(elements, root, found, root.multiplicity() % 2 == 1 ? Nature::crossing : Nature::grazing);
      }
    }
    return Answer();
  }
  const auto nature_at = [&](const RealRoot& root) {
    const bool lasts = root.compare(limit) < 0 && touching_after(elements, root);
    return lasts ? Nature::sustained : Nature::isolated;
  };
  const RealRoot start = RealRoot::rational(Exact(0), Exact(1), 1);
  if (story == nullptr && touching_at(elements, start, nullptr, found))
    return contact_at(elements, start, found, nature_at(start));
  for (const RealRoot* time : CandidateTimes(elements, limit)) {
    const RealRoot& root = *time;
    if (touching_at(elements, root, new_chapter(story, root, 0), found))
      return contact_at(elements, root, found, nature_at(root));
  }
  return Answer();
}

template <class Elements>
std::vector<RootInterval> all_contacts(const Elements& elements, const Exact& limit) {
  std::vector<RootInterval> intervals;
  SideSigns found;
  if (const auto* cubic = nonzero_cubic(elements)) {
    const numbers::RootList roots = numbers::isolate_roots(*cubic, limit);
    for (int i = 0; i < roots.size(); ++i) {
      if (touching_at(elements, roots[i], nullptr, found)) intervals.push_back({roots[i], roots[i]});
    }
    return intervals;
  }
  // Between neighbouring candidates the elements touch always or never.
  bool lasting = false;
  for (const RealRoot* time : CandidateTimes(elements, limit)) {
    const RealRoot& root = *time;
    if (lasting) {
      intervals.back().last = root;  // the set is closed
    } else if (touching_at(elements, root, nullptr, found)) {
      intervals.push_back({root, root});
    } else {
      continue;
    }
    lasting = root.compare(limit) < 0 && touching_after(elements, root);
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
    story.answer = first_contact(elements, Exact(t_max), &story);
    return story;
  });
}

template <class N, class Q>
Answer first_contact_in(const Q& query, double t_max) {
  return with_elements<N>(query, [&](const auto& elements) { return first_contact(elements, Exact(t_max), nullptr); });
}

template <class N, class Q>
std::vector<RootInterval> touching_times_of_any(const Q& query, double t_max) {
  return with_elements<N>(query, [&](const auto& elements) { return all_contacts(elements, Exact(t_max)); });
}

}  // namespace

Answer decide_exactly(const Query& query, double t_max) {
  const numbers::LimbScratch scratch;  // no number outlives the decision
  const int bits = coordinate_span(query).bits();
  if (bits <= kMostBits<1>) return first_contact_in<Short>(query, t_max);
  if (bits <= kMostBits<2>) return first_contact_in<Medium>(query, t_max);
  if (bits <= kMostBits<3>) return first_contact_in<Long>(query, t_max);
  return first_contact_in<Exact>(query, t_max);
}
Answer decide_exactly(const RationalQuery& query, double t_max) { return first_contact_in<Exact>(query, t_max); }
Answer decide_exactly(const CurvedQuery& query, double t_max) {
  const numbers::LimbScratch scratch;
  return first_contact_in<AnyDegree>(query, t_max);
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
