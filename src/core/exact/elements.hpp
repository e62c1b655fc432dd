// The four kinds of query in exact arithmetic: moving corners, when two elements touch, and where. Everything is a sign
// of a polynomial in t, of degree at most 3 for straight motion, at an exact time or just after it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <touchstone/answer.hpp>

#include "exact/bounded_list.hpp"
#include "exact/exact.hpp"
#include "exact/form.hpp"
#include "exact/lazy.hpp"
#include "geometry/frame.hpp"
#include "geometry/vector.hpp"
#include "numbers/integers/fixed_int.hpp"
#include "numbers/integers/small_int.hpp"
#include "numbers/roots/near_root.hpp"
#include "numbers/roots/real_root.hpp"

namespace touchstone::exact {

using numbers::Exact;
using numbers::RealRoot;

/// The polynomials of corners whose coordinates are numbers of type N: a ring, in which products may be of wider types.
template <class N>
struct Forms {
  using Number = N;
  using Square = decltype(N() * N());
  using Linear = numbers::Polynomial<N, 1>;
  using Quadratic = numbers::Polynomial<Square, 2>;
  using Cubic = numbers::Polynomial<decltype(Square() * N()), 3>;
  using Point = geometry::Vector<Linear>;  ///< a moving corner: start + t (end - start)
  using Corners = std::array<Point, 4>;
};

/// In place of a number type: corners whose coordinates are polynomials of any degree.
struct AnyDegree {};

/// Moving corners, at each time multiplied by one positive number, a polynomial in t.
struct AnyCorners {
  using Point = geometry::Vector<Form>;

  const Point& operator[](std::size_t i) const { return corners[i]; }
  /// 0 for a corner of the first element, 1 for one of the second.
  std::size_t element_of(std::size_t corner) const { return corner < second ? 0 : 1; }

  std::array<Point, 4> corners;

  /// The same corners up to a moving vector that is common to an element, for differences of lower degrees within it:
  /// corners[i] - corners[j] = multipliers[e] (own[i] - own[j]) for corners of element e.
  std::array<Point, 4> own;
  std::array<Form, 2> multipliers = {Form(Exact(1)), Form(Exact(1))};  ///< positive
  std::size_t second = 4;                                              ///< the second element's first corner

  /// The positions of the query, and so its distances, are multiplied by the factor and, at each time, by the scale.
  Exact factor = Exact(1);
  Form scale = Form(Exact(1));
};
template <>
struct Forms<AnyDegree> {
  using Linear = Form;
  using Quadratic = Form;
  using Cubic = Form;
  using Point = AnyCorners::Point;
  using Corners = AnyCorners;
};

/// In place of a number type: coordinates of type Integer, SmallInt or FixedInt, whose times are known as
/// numbers::NearRoot.
template <class Integer>
struct Near;
template <>
struct Near<numbers::SmallInt> {
  using Time = numbers::NearRoot<1>;
};
template <int Limbs>
struct Near<numbers::FixedInt<Limbs>> {
  using Time = numbers::NearRoot<Limbs>;
};
template <class Integer>
struct Forms<Near<Integer>> : Forms<Integer> {};

/// The type of times over numbers of type N.
template <class N>
struct TimeOf {
  using Type = RealRoot;
};
template <class Integer>
struct TimeOf<Near<Integer>> {
  using Type = typename Near<Integer>::Time;
};
template <class N>
using Time = typename TimeOf<N>::Type;

/// p times a positive polynomial, which is often 1.
inline Form scaled_by(const Form& scale, const Form& p) {
  return scale.size() == 1 && scale[0] == Exact(1) ? p : scale * p;
}

/// Corner i minus corner j. Two corners of one element have this difference divided by a positive polynomial;
/// `completed` multiplies by it again.
template <class Point>
Point difference(const std::array<Point, 4>& corners, std::size_t i, std::size_t j) {
  return corners[i] - corners[j];
}
inline AnyCorners::Point difference(const AnyCorners& corners, std::size_t i, std::size_t j) {
  const bool within = corners.element_of(i) == corners.element_of(j);
  return within ? corners.own[i] - corners.own[j] : corners[i] - corners[j];
}

/// p times the polynomial by which `difference` divides for two corners of this element (0 or 1).
template <class Point, class P>
const P& completed(const std::array<Point, 4>&, std::size_t, const P& p) {
  return p;
}
inline Form completed(const AnyCorners& corners, std::size_t element, const Form& p) {
  return scaled_by(corners.multipliers[element], p);
}

/// The number types of coordinates at this level: integers of one word for all that is computed; of one, two
/// or three limbs, which grow with each product; and Exact, numbers of any size.
using numbers::SmallInt;
using Short = numbers::FixedInt<1>;
using Medium = numbers::FixedInt<2>;
using Long = numbers::FixedInt<3>;

// NOLINTBEGIN(bugprone-macro-parentheses): the name of a template stands without parentheses.
/// Instantiates a class template for each of them.
#define TOUCHSTONE_FOR_EACH_NUMBER_TYPE(Template) \
  template class Template<Short>;                 \
  template class Template<Medium>;                \
  template class Template<Long>;                  \
  template class Template<Near<SmallInt>>;        \
  template class Template<Near<Short>>;           \
  template class Template<Near<Medium>>;          \
  template class Template<Exact>;                 \
  template class Template<AnyDegree>
// NOLINTEND(bugprone-macro-parentheses)

/// The most bits B of integer coordinates, |x| < 2^B, with which no number overflows. The numbers have so many bits:
/// - differences B + 1, their changes over the step B + 2;
/// - a quadratic's coefficients 2 B + 5, from 4 products of B + 2 and B + 1 or 2 of B + 2 and B + 2; sums of three of
///   them and dot products 2 B + 7; their Bernstein coefficients 2 B + 9;
/// - V's coefficients 3 B + 10, sums of 3 such products with B + 1 and 3 with B + 2; its Bernstein coefficients, below
///   6 times more, 3 B + 13.
/// SmallInt has one word for all of them.
constexpr int most_bits_for(int words_of_v) { return (64 * words_of_v - 1 - 13) / 3; }
template <class Integer>
constexpr int kMostBits = most_bits_for(1);
template <int Limbs>
constexpr int kMostBits<numbers::FixedInt<Limbs>> = most_bits_for(3 * Limbs);
static_assert(kMostBits<Short> + 2 < 64 && 2 * kMostBits<Short> + 9 < 128 && kMostBits<Medium> + 2 < 128 &&
              2 * kMostBits<Medium> + 9 < 256);
static_assert(kMostBits<Long> + 2 < 192 && 2 * kMostBits<Long> + 9 < 384);
static_assert(kMostBits<SmallInt> == 16 && 2 * kMostBits<SmallInt> + 9 <= numbers::NearRoot<1>::kMostSmallBits &&
              3 * kMostBits<SmallInt> + 10 < 60);

/// Touching begins or ends only at roots of these polynomials. Each of the four pairs of a corner and the other edge
/// has at most two of them.
constexpr std::size_t kMostEvents = 8;
template <class N>
using Events = BoundedList<typename Forms<N>::Quadratic, kMostEvents>;

/// A list with an element for each root of the events and for two times more. Each event of straight motion has at most
/// two roots.
template <class N, class T>
class EventTimes : public BoundedList<T, 2 + 2 * kMostEvents> {};
template <class T>
class EventTimes<AnyDegree, T> : public std::vector<T> {
 public:
  void add(T time) { this->push_back(std::move(time)); }
};

/// Adds a sign to a record, under its name and its axis (0, 1, 2; -1 for none).
void keep_sign(std::vector<CandidateStory::Condition>& record, int sign, const char* name, int axis);

/// Signs at a root, or just before or after it. It keeps a record of them when `explain` wants one.
template <class Root>
class MomentOf {
 public:
  static MomentOf at(const Root& root, std::vector<CandidateStory::Condition>* record = nullptr) {
    return MomentOf(root, 0, record);
  }
  static MomentOf just_after(const Root& root) { return MomentOf(root, 1, nullptr); }
  static MomentOf just_before(const Root& root) { return MomentOf(root, -1, nullptr); }

  const Root& root() const { return root_; }
  bool is_at_root() const { return side_ == 0; }

  /// The sign of q at this moment. The name and the axis are for the record.
  template <class R, int D>
  int sign(const numbers::Polynomial<R, D>& q, const char* name, int axis = -1) const {
    const int sign = side_ == 0 ? root_.sign_at(q) : side_ > 0 ? root_.sign_after(q) : root_.sign_before(q);
    if (record_ != nullptr) keep_sign(*record_, sign, name, axis);
    return sign;
  }

  int sign(const Form& q, const char* name, int axis = -1) const {
    const int sign = this->sign(numbers::Coefficients(q));
    if (record_ != nullptr) keep_sign(*record_, sign, name, axis);
    return sign;
  }

  /// The same for a polynomial of any formal degree, without a record.
  int sign(numbers::Coefficients q) const {
    const int sign = root_.quick_sign_at(q);
    return sign != 0 || side_ == 0 ? sign : side_ > 0 ? root_.sign_after(q) : root_.sign_before(q);
  }

 private:
  MomentOf(const Root& root, int side, std::vector<CandidateStory::Condition>* record)
      : root_(root), side_(side), record_(record) {}

  const Root& root_;
  int side_;  // 1: just after the root, -1: just before it
  std::vector<CandidateStory::Condition>* record_;
};
using Moment = MomentOf<RealRoot>;

/// A new chapter of the story about a candidate time; null without a story. The multiplicity is that of
/// CandidateStory::multiplicity. Stories are told of exact times only.
template <class Root>
CandidateStory* new_chapter(Story*, const Root&, int) {
  return nullptr;
}
inline CandidateStory* new_chapter(Story* story, const RealRoot& time, int multiplicity) {
  if (story == nullptr) return nullptr;
  CandidateStory& chapter = story->candidates.emplace_back();
  chapter.lower = time.lower();
  chapter.upper = time.upper();
  chapter.time = time.to_string();
  chapter.multiplicity = multiplicity;
  return &chapter;
}

/// Signs that `touching` computes and `locate` needs again: the axis along which n is not zero (-1: none), and the
/// signs of the side conditions along it, in their order, each 0 or 1 where the elements touch.
struct SideSigns {
  int axis = -1;
  std::array<int, 4> sign{};
};

/// The names of a point's and an edge's polynomials in the record.
struct PointOnEdgeNames {
  const char* cross;
  const char* dot;
};

/// A point and an edge x y: they touch iff (p - x) x (y - x) = 0 and (p - x) . (p - y) <= 0.
template <class N>
class PointOnEdge {
 public:
  using Point = typename Forms<N>::Point;
  using Names = PointOnEdgeNames;
  PointOnEdge(const Point& p, const Point& x, const Point& y, Names names);

  /// Whether it is plain that they never touch: along some axis the point is always before both ends, or after both, or
  /// it sees them at less than a right angle all along.
  bool always_beside() const;

  bool touching(const MomentOf<Time<N>>& moment) const;

  /// The position on the edge of a touching point: 0 at x, 1 at y, 2 between. x wins where both coincide.
  int position(const Time<N>& root) const;

  /// The weights (x, y) of a touching point, supported on its position.
  std::array<double, 3> weights(const Time<N>& root) const;

  /// Appends polynomials whose roots contain all times at which touching may begin or end.
  void append_events(Events<N>& events) const;

 private:
  using Cross = geometry::Vector<typename Forms<N>::Quadratic>;
  using Product = typename Forms<N>::Quadratic;
  const Cross& cross() const;
  const Product& product() const;  ///< (p - x) . (p - y)

  Point from_x_, from_y_, edge_;
  mutable Lazy<Cross> cross_;
  mutable Lazy<Product> product_;
  Names names_;
};

/// Edge a0 a1 against edge b0 b1.
template <class N>
class EdgeEdgeElements {
 public:
  using Number = N;
  using Point = typename Forms<N>::Point;
  using Quadratic = typename Forms<N>::Quadratic;
  using Cubic = typename Forms<N>::Cubic;

  static constexpr bool kHasCubic = true;
  explicit EdgeEdgeElements(const typename Forms<N>::Corners& corners);

  const Cubic& coplanarity() const { return coplanarity_; }
  /// Whether the elements touch. The four corners must be coplanar at the moment.
  bool touching(const MomentOf<Time<N>>& moment, SideSigns& found) const;
  /// Where they touch at the root. `found` is from `touching` at the same root.
  void locate(const Time<N>& root, const SideSigns& found, Answer& answer) const;
  void append_events(Events<N>& events) const;  ///< complete when the corners are always coplanar

  /// Calls f with each border: a PointOnEdge. When the corners are always coplanar, touching begins only where touching
  /// of a border begins.
  template <class F>
  void for_each_border(F&& f) const {
    for (const Pair which : {a0_on_b, a1_on_b, b0_on_a, b1_on_a}) f(pair(which));
  }

 private:
  enum Pair { a0_on_b, a1_on_b, b0_on_a, b1_on_a };
  const PointOnEdge<N>& pair(Pair which) const;
  void locate_parallel(const Time<N>& root, Answer& answer) const;
  void locate_overlap(const Time<N>& root, Answer& answer) const;

  typename Forms<N>::Corners corners_;
  geometry::Frame<Point> frame_;
  geometry::Vector<Quadratic> n_;
  Cubic coplanarity_;
  mutable std::array<Lazy<PointOnEdge<N>>, 4> pairs_;
};

/// Vertex v against triangle f0 f1 f2.
template <class N>
class VertexFaceElements {
 public:
  using Number = N;
  using Point = typename Forms<N>::Point;
  using Quadratic = typename Forms<N>::Quadratic;
  using Cubic = typename Forms<N>::Cubic;

  static constexpr bool kHasCubic = true;
  explicit VertexFaceElements(const typename Forms<N>::Corners& corners);

  const Cubic& coplanarity() const { return coplanarity_; }
  bool touching(const MomentOf<Time<N>>& moment, SideSigns& found) const;
  void locate(const Time<N>& root, const SideSigns& found, Answer& answer) const;
  void append_events(Events<N>& events) const;
  template <class F>
  void for_each_border(F&& f) const {
    for (std::size_t i = 0; i < 3; ++i) f(side(i));
  }

 private:
  const PointOnEdge<N>& side(std::size_t which) const;  // f01, f12, f20
  void locate_flat(const Time<N>& root, Answer& answer) const;

  typename Forms<N>::Corners corners_;
  geometry::Frame<Point> frame_;
  geometry::Vector<Quadratic> n_;
  Cubic coplanarity_;
  mutable std::array<Lazy<PointOnEdge<N>>, 3> sides_;
};

/// Point p against edge e0 e1.
template <class N>
class PointEdgeElements {
 public:
  using Number = N;
  using Point = typename Forms<N>::Point;
  using Quadratic = typename Forms<N>::Quadratic;
  using Cubic = typename Forms<N>::Cubic;

  static constexpr bool kHasCubic = false;
  explicit PointEdgeElements(const typename Forms<N>::Corners& corners);

  bool touching(const MomentOf<Time<N>>& moment, SideSigns&) const { return point_.touching(moment); }
  void locate(const Time<N>& root, const SideSigns& found, Answer& answer) const;
  void append_events(Events<N>& events) const;
  template <class F>
  void for_each_border(F&& f) const {
    f(point_);
  }

 private:
  PointOnEdge<N> point_;
};

/// Point p against point q.
template <class N>
class PointPointElements {
 public:
  using Number = N;
  using Point = typename Forms<N>::Point;
  using Quadratic = typename Forms<N>::Quadratic;
  using Cubic = typename Forms<N>::Cubic;

  static constexpr bool kHasCubic = false;
  explicit PointPointElements(const typename Forms<N>::Corners& corners);

  bool touching(const MomentOf<Time<N>>& moment) const;
  bool touching(const MomentOf<Time<N>>& moment, SideSigns&) const { return touching(moment); }
  void locate(const Time<N>& root, const SideSigns& found, Answer& answer) const;
  bool always_beside() const { return false; }
  void append_events(Events<N>& events) const;
  template <class F>
  void for_each_border(F&& f) const {
    f(*this);
  }

 private:
  Point difference_;
};

}  // namespace touchstone::exact
