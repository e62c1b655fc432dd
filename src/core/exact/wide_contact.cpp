// Contact in doubles of any exponent: signs of polynomials on parts of [0, 1].
//
// Seen along axis k, where corner i is at (y_i, z_i), let D_i be the determinant of the other three corners' rows
// (y, z, 1), times (-1)^i: then sum D_i = 0, sum D_i y_i = 0 and sum D_i z_i = 0. With the corners' x, sum D_i x_i is
// V, the determinant of the rows (x, y, z, 1): that of u, w and r for both kinds, once the row of corner 0 is taken off
// the others. Elements touch where V is zero and sum s_i w_i (x_i, y_i, z_i, 1) = 0 for weights w_i >= 0, not all of
// them 0, with s_i = 1 for the first element's corners and -1 for the second's.
//
// - If two of s_i D_i have opposite signs, the elements do not touch: D is not zero then, so the corners do not lie on
//   a line as seen along k, and all s_i w_i are a multiple of D_i. As w_i >= 0, no two of s_i D_i differ in sign.
// - If all s_i D_i have one sign and V is zero, they touch, with weights |D_i|.
//
// A point p and an edge x y are seen as three corners: they touch only where the determinant of their rows is zero
// along each axis, and where (p - x) . (p - y) <= 0.
//
// No term of D and of V is the product of two coordinates of one corner, which would cancel. This is what sets these
// formulas apart from those of geometry/frame.hpp: a corner that is much farther away than the others does no harm.
// SPDX-License-Identifier: MIT
#include "exact/wide_contact.hpp"

#include <optional>

#include "numbers/wide_double.hpp"

namespace touchstone::exact {
namespace {

using numbers::WideDouble;
using Verdict = WideLook::Verdict;

// Polynomials by their Bernstein coefficients on a part of [0, 1].
using Linear = std::array<WideDouble, 2>;
using Quadratic = std::array<WideDouble, 3>;
using Cubic = std::array<WideDouble, 4>;

Quadratic operator+(const Quadratic& a, const Quadratic& b) noexcept { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Quadratic operator-(const Quadratic& a, const Quadratic& b) noexcept { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// a b - c d.
Quadratic difference_of_products(const Linear& a, const Linear& b, const Linear& c, const Linear& d) noexcept {
  return {a[0] * b[0] - c[0] * d[0], half((a[0] * b[1] - c[0] * d[1]) + (a[1] * b[0] - c[1] * d[0])),
          a[1] * b[1] - c[1] * d[1]};
}

Quadratic product(const Linear& a, const Linear& b) noexcept {
  return {a[0] * b[0], half(a[0] * b[1] + a[1] * b[0]), a[1] * b[1]};
}

/// The sign that all values on the part certainly have; else 0.
template <std::size_t Size>
int certain_sign(const std::array<WideDouble, Size>& p) noexcept {
  const int first = p[0].sign();
  for (std::size_t i = 1; i < Size; ++i) {
    if (p[i].sign() != first) return 0;
  }
  return first;
}

/// A point of a part, by its distances from both ends, for a length of 1.
struct Point {
  WideDouble from_start, from_end;
};

/// De Casteljau's algorithm, at a point or in the middle. Each of its steps makes WideDouble's values at most 3 times
/// greater: the weights' are at most 1 and 2. These are 18 steps at most, from values that are at most 2^10.
template <std::size_t Size>
void split(std::array<WideDouble, Size> p, const std::optional<Point>& at, std::array<WideDouble, Size>& before,
           std::array<WideDouble, Size>& after) noexcept {
  for (std::size_t last = Size; last-- > 0;) {
    before[Size - 1 - last] = p[0];
    after[last] = p[last];
    for (std::size_t i = 0; i < last; ++i) {
      p[i] = at ? at->from_end * p[i] + at->from_start * p[i + 1] : half(p[i] + p[i + 1]);
    }
  }
}

class Corners {
 public:
  explicit Corners(const Query& query) noexcept {
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      const Vec3 &s = query.start[i], &e = query.end[i];
      at_[i] = {Linear{WideDouble(s.x), WideDouble(e.x)}, Linear{WideDouble(s.y), WideDouble(e.y)},
                Linear{WideDouble(s.z), WideDouble(e.z)}};
    }
  }

  /// (-1)^i D_i along an axis.
  std::array<Quadratic, 4> minors(std::size_t axis) const noexcept {
    const Quadratic p01 = pair(axis, 0, 1), p02 = pair(axis, 0, 2), p03 = pair(axis, 0, 3);
    const Quadratic p12 = pair(axis, 1, 2), p13 = pair(axis, 1, 3), p23 = pair(axis, 2, 3);
    return {p23 - p13 + p12, p23 - p03 + p02, p13 - p03 + p01, p12 - p02 + p01};
  }

  /// The determinant of the rows of the first three.
  Quadratic determinant(std::size_t axis) const noexcept {
    return pair(axis, 1, 2) - pair(axis, 0, 2) + pair(axis, 0, 1);
  }

  /// The first one minus the second, times the first one minus the third.
  Quadratic dot_from_first() const noexcept {
    std::array<Quadratic, 3> terms;
    for (std::size_t k = 0; k < 3; ++k) terms[k] = product(difference(k, 1), difference(k, 2));
    return terms[0] + terms[1] + terms[2];
  }

  /// 3 sum D_i x_i, from the minors along the first axis.
  Cubic coplanarity(const std::array<Quadratic, 4>& minors) const noexcept {
    const std::array<Cubic, 4> terms = {times(0, minors[0]), times(1, minors[1]), times(2, minors[2]),
                                        times(3, minors[3])};
    Cubic v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = (terms[0][i] - terms[1][i]) + (terms[2][i] - terms[3][i]);
    return v;
  }

 private:
  /// y_i z_j - y_j z_i.
  Quadratic pair(std::size_t axis, std::size_t i, std::size_t j) const noexcept {
    const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
    return difference_of_products(at_[i][y], at_[j][z], at_[j][y], at_[i][z]);
  }
  Linear difference(std::size_t k, std::size_t i) const noexcept {
    return {at_[0][k][0] - at_[i][k][0], at_[0][k][1] - at_[i][k][1]};
  }

  /// 3 x_i q.
  Cubic times(std::size_t i, const Quadratic& q) const noexcept {
    const WideDouble three(3);
    const auto& [x0, x1] = at_[i][0];
    return {three * (x0 * q[0]), twice(x0 * q[1]) + x1 * q[0], x0 * q[2] + twice(x1 * q[1]), three * (x1 * q[2])};
  }

  std::array<std::array<Linear, 3>, 4> at_;
};

/// A part of [0, 1].
struct Part {
  Cubic coplanarity;
  std::array<std::array<Quadratic, 4>, 3> minors;
  /// Along which all s_i D_i have one sign: minors are not needed. -1 for none.
  int axis = -1;
};

/// What the signs along an axis tell. Touching means here that they do where V is zero.
Verdict verdict_along(Kind kind, const std::array<Quadratic, 4>& minors) noexcept {
  // (-1)^i s_i
  static constexpr std::array<int, 4> edges = {1, -1, -1, 1}, face = {1, 1, -1, 1};
  const std::array<int, 4>& factors = kind == Kind::edge_edge ? edges : face;
  int positive = 0, negative = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const int sign = factors[i] * certain_sign(minors[i]);
    positive += sign > 0;
    negative += sign < 0;
  }
  if (positive > 0 && negative > 0) return Verdict::apart;
  return positive + negative == 4 ? Verdict::touching : Verdict::open;
}

/// Whether V has opposite signs at the ends, and one variation of signs whatever the uncertain ones are: + + ? - or
/// + ? - -, or the same negated.
bool has_one_root(const Cubic& v) noexcept {
  const int first = v[0].sign(), last = v[3].sign();
  return first * last < 0 && (v[1].sign() == first || v[2].sign() == last);
}

/// Where p first changes its sign after the start of the part, or before its end: at about 2^-exponent of it. Only a
/// hint. It is where, of two terms with different signs, the later one overtakes the earlier one as the greatest.
template <std::size_t Size>
long crossing_exponent(const std::array<WideDouble, Size>& p, bool from_end) noexcept {
  const auto term = [&](std::size_t i) -> const WideDouble& { return p[from_end ? Size - 1 - i : i]; };
  std::size_t i = 0;
  while (i + 1 < Size) {
    std::size_t next = 0;
    long least = 0;
    for (std::size_t j = i + 1; j < Size; ++j) {
      const long overtakes = (term(i).bits() - term(j).bits()) / static_cast<long>(j - i);
      if (next != 0 && overtakes > least) continue;
      next = j;
      least = overtakes;
    }
    if (term(i).sign() * term(next).sign() < 0) return -least;
    i = next;
  }
  return 0;
}

/// To the parts before and after a point next to where p changes its sign close to an end, or else the middle.
template <std::size_t Size>
WideLook::Step step_towards_root(const std::array<WideDouble, Size>& p) noexcept {
  constexpr long kClose = 3, kMargin = 2, kFarthest = 1L << 20;
  for (const bool from_end : {false, true}) {
    const long exponent = crossing_exponent(p, from_end);
    if (exponent >= kClose && exponent <= kFarthest) return {1, exponent - kMargin, from_end, false};
  }
  return {};
}

/// Nothing for the middle.
std::optional<Point> point_of(const WideLook::Step& step) noexcept {
  if (step.exponent == 1) return std::nullopt;
  const WideDouble distance = WideDouble(step.distance) * WideDouble::power(-step.exponent);
  const WideDouble rest = WideDouble(1) - distance;
  return step.from_end ? Point{rest, distance} : Point{distance, rest};
}

/// Splits p near a root, and says where.
template <std::size_t Size>
std::optional<Point> split_near_root(const std::array<WideDouble, Size>& p, WideLook::Step& step,
                                     std::array<WideDouble, Size>& before,
                                     std::array<WideDouble, Size>& after) noexcept {
  step = step_towards_root(p);
  std::optional<Point> at = point_of(step);
  split(p, at, before, after);
  if (after[0].sign() == 0) {                           // most likely a root
    constexpr double kUnlikely = 0x1.5bf0a8b145769p-1;  // e / 4
    step.distance = kUnlikely;
    if (step.exponent == 1) step.exponent = 0;
    at = point_of(step);
    split(p, at, before, after);
  }
  return at;
}

/// How many parts are split at most.
constexpr int kMostParts = 16;

class Search {
 public:
  explicit Search(const Query& query) noexcept : corners_(query), kind_(query.kind) {
    Part all;
    all.minors[0] = corners_.minors(0);
    all.coplanarity = corners_.coplanarity(all.minors[0]);
    look_.verdict = look(all, 0, [&](std::size_t k) -> const std::array<Quadratic, 4>& {
      if (k > 0) all.minors[k] = corners_.minors(k);
      return all.minors[k];
    });
  }

  const WideLook& found() const noexcept { return look_; }

 private:
  /// At a part after so many steps. minors(k) gives those along an axis.
  template <class Minors>
  Verdict look(Part& part, std::size_t steps, const Minors& minors) noexcept {
    if (certain_sign(part.coplanarity) != 0) return Verdict::apart;
    for (std::size_t k = 0; k < 3 && part.axis < 0; ++k) {
      const Verdict along = verdict_along(kind_, minors(k));
      if (along == Verdict::apart) return along;
      if (along == Verdict::touching) part.axis = static_cast<int>(k);
    }
    if (part.axis >= 0 && has_one_root(part.coplanarity)) {
      look_.steps_taken = steps;
      look_.axis = part.axis;
      look_.sign_at_start = part.coplanarity[0].sign();
      return Verdict::touching;
    }
    return look_closely(part, steps);
  }

  Verdict look_closely(const Part& part, std::size_t steps) noexcept {
    if (steps == WideLook::kMostSteps || --parts_left_ < 0) return Verdict::open;
    std::array<Part, 2> parts;
    WideLook::Step& step = look_.steps[steps];
    const auto at = split_near_root(part.coplanarity, step, parts[0].coplanarity, parts[1].coplanarity);
    for (Part& each : parts) each.axis = part.axis;
    for (std::size_t k = 0; k < 3 && part.axis < 0; ++k) {
      for (std::size_t i = 0; i < 4; ++i) split(part.minors[k][i], at, parts[0].minors[k][i], parts[1].minors[k][i]);
    }
    for (Part& each : parts) {
      step.after = &each == &parts[1];
      const Verdict verdict =
          look(each, steps + 1, [&](std::size_t k) -> const std::array<Quadratic, 4>& { return each.minors[k]; });
      if (verdict != Verdict::apart) return verdict;
    }
    return Verdict::apart;
  }

  Corners corners_;
  Kind kind_;
  WideLook look_;
  int parts_left_ = kMostParts;
};

/// Of a point and an edge.
class PointEdgeSearch {
 public:
  explicit PointEdgeSearch(const Query& query) noexcept : corners_(query) {}

  bool apart() noexcept {
    Conditions all;
    for (std::size_t k = 0; k < 3; ++k) {
      all[k] = corners_.determinant(k);
      if (certain_sign(all[k]) != 0) return true;
    }
    all[3] = corners_.dot_from_first();
    return apart(all, 0);
  }

 private:
  /// The determinants along the axes, and the dot product.
  using Conditions = std::array<Quadratic, 4>;

  bool apart(const Conditions& part, std::size_t steps) noexcept {
    if (certain_sign(part[3]) > 0) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (certain_sign(part[k]) != 0) return true;
    }
    if (steps == WideLook::kMostSteps || --parts_left_ < 0) return false;
    // Along the first axis along which something is known.
    std::size_t first = 0;
    while (first < 3 && part[first][0].sign() == 0 && part[first][2].sign() == 0) ++first;
    Conditions before, after;
    WideLook::Step step;
    const auto at = split_near_root(part[first], step, before[first], after[first]);
    for (std::size_t i = 0; i < 4; ++i) {
      if (i != first) split(part[i], at, before[i], after[i]);
    }
    return apart(before, steps + 1) && apart(after, steps + 1);
  }

  Corners corners_;
  int parts_left_ = kMostParts;
};

}  // namespace

WideLook look_widely(const Query& query) noexcept {
  if (query.kind == Kind::edge_edge || query.kind == Kind::vertex_face) return Search(query).found();
  WideLook look;
  if (query.kind == Kind::point_edge && PointEdgeSearch(query).apart()) look.verdict = Verdict::apart;
  return look;
}

}  // namespace touchstone::exact
