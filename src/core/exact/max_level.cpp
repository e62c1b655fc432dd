// The largest-axis distance. The difference of two points, one on each element, is an affine function of two parameters
// s and t. The elements are within d of each other when some (s, t) satisfies a system of half-planes: six that keep
// the difference in [-d, d] along the axes, and the borders of the elements. The polygon that they leave is bounded. It
// is not empty exactly when one of its vertices exists, which is a point where two border lines meet.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exact/distance_level.hpp"
#include "exact/off_the_stack.hpp"
#include "geometry/frame.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::exact {
namespace {

using Point = geometry::Vector<Form>;

/// s's coefficient times s, plus t's times t, plus the constant is >= 0.
struct HalfPlane {
  Form s, t, constant;
};

constexpr std::size_t kAxes = 6;  // the half-planes of the axes come first
constexpr std::size_t kMost = 10;

/// A set of half-planes: bit i is half-plane i.
using Mask = unsigned;
constexpr Mask bit(std::size_t i) { return 1U << i; }

/// A vertex of the polygon: where the border lines of half-planes i < j meet.
struct Vertex {
  std::size_t i, j;
  Mask tight;  ///< the half-planes on whose border lines it lies
};

class MaxLevel final : public DistanceLevel {
 public:
  // With edges' directions divided by their element's multiplier m, s and t are multiplied by it: s + t <= m and so on.
  // d is multiplied by what the corners are multiplied by.
  MaxLevel(Kind kind, const AnyCorners& corners, const Ratio& level) : kind_(kind), corners_(corners), level_(level) {
    const Form zero, one(Exact(1)), minus_one(Exact(-1));
    const bool edges = kind == Kind::edge_edge;
    // The difference is r - s u - t w. For edges it is b0 + t (b1 - b0) - a0 - s u, for a face v - f0 - s u - t w, for
    // a point and an edge p - e0 - s u, and for two points r.
    Point u, w, r;
    if (kind == Kind::edge_edge || kind == Kind::vertex_face) {
      const auto frame =
          geometry::frame_of(kind, [&](std::size_t i, std::size_t j) { return difference(corners_, i, j); });
      u = frame.u;
      w = edges ? difference(corners_, 2, 3) : frame.w;
      r = frame.r;
    } else {
      if (kind == Kind::point_edge) u = difference(corners_, 2, 1);
      r = corners_[0] - corners_[1];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Form d = corners_.scale * level.numerator;
      const Form us = u[k] * level.denominator, ws = w[k] * level.denominator, rs = r[k] * level.denominator;
      add({us, ws, d - rs});    // r_k - s u_k - t w_k <= d
      add({-us, -ws, d + rs});  // and >= -d
    }
    add({one, zero, zero});  // 0 <= s
    add({zero, one, zero});  // 0 <= t
    if (kind == Kind::vertex_face) {
      add({minus_one, minus_one, corners_.multipliers[1]});  // s + t <= 1
    } else {
      const Form& of_s = corners_.multipliers[edges ? 0 : 1];
      add({minus_one, zero, kind == Kind::point_point ? zero : of_s});  // s <= 1
      add({zero, minus_one, edges ? corners_.multipliers[1] : zero});   // t <= 1
    }
  }

  int compare(const Moment& moment) const override {
    // At the mean of the polygon's vertices a half-plane holds strictly, unless it holds with equality at all of them.
    Mask tight = bit(kAxes) - 1;
    bool any = false;
    for_each_vertex(moment, [&](const Vertex& vertex) {
      any = true;
      tight &= vertex.tight;
      return tight != 0;
    });
    return !any ? 1 : tight == 0 ? -1 : 0;
  }

  std::vector<Event> events() const override {
    std::vector<Event> events;
    for (std::size_t i = 0; i < kAxes; ++i) {
      for (std::size_t j = i + 1; j < count_; ++j) {
        for (std::size_t k = j + 1; k < count_; ++k) {
          const Form& form = determinant(i, j, k);
          if (!form.is_zero()) events.push_back({form, i + kMost * (j + kMost * k)});
        }
      }
    }
    return events;
  }

  bool holds(const Event&, const Moment& moment) const override { return compare(moment) <= 0; }

  std::string event_name(const Event& event) const override {
    const std::size_t i = event.index % kMost, j = event.index / kMost % kMost, k = event.index / (kMost * kMost);
    return border_name(i) + ", " + border_name(j) + " and " + border_name(k);
  }

  std::vector<CandidateStory::Condition> conditions_of(const Event&, const Moment& moment) const override {
    return {{"distance - d", compare(moment)}};
  }

  void locate(const RealRoot& root, Answer& answer) const override {
    const Moment moment = Moment::at(root);
    std::vector<Vertex> vertices;
    for_each_vertex(moment, [&](const Vertex& vertex) {
      vertices.push_back(vertex);
      return true;
    });
    for (const Mask forced : borders_in_order(moment)) {
      const Vertex* least = nullptr;
      for (const Vertex& vertex : vertices) {
        if ((vertex.tight & forced) == forced && (least == nullptr || precedes(vertex, *least, moment)))
          least = &vertex;
      }
      if (least == nullptr) continue;
      describe(*least, root, answer);
      return;
    }
  }

  Ratio distance_at(const RealRoot& time) const override {
    // The least d of a linear programme in s, t and d: three of its borders meet there in one point.
    const Moment moment = Moment::at(time);
    const Ratio at = {time.numerator(), time.denominator()};
    const auto corners = off_the_stack([&] { return is_dyadic(time) ? corners_at(time) : corners_; });
    const auto ground = std::make_unique<const MaxLevel>(kind_, *corners, Ratio{Exact(0), Exact(1)});
    std::vector<Ratio> candidates;
    for (std::size_t i = 0; i < kAxes; ++i) {
      for (std::size_t j = i + 1; j < count_; ++j) {
        for (std::size_t k = j + 1; k < count_; ++k) {
          const auto row = [&](std::size_t m) { return ground->row_at(m, at); };
          const std::array<std::array<Exact, 4>, 3> rows = {row(i), row(j), row(k)};
          const Exact slope = determinant_of(rows, 3);
          if (numbers::is_zero(slope)) continue;
          const Exact value = determinant_of(rows, 2);
          Ratio d = numbers::sign_of(slope) > 0 ? Ratio{-value, slope} : Ratio{value, -slope};
          if (numbers::sign_of(d.numerator) >= 0) candidates.push_back(std::move(d));
        }
      }
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Ratio& a, const Ratio& b) { return exact::compare(a, b) < 0; });
    return *std::partition_point(candidates.begin(), candidates.end(), [&](const Ratio& d) {
      return std::make_unique<const MaxLevel>(kind_, *corners, d)->compare(moment) > 0;
    });
  }

  std::unique_ptr<DistanceLevel> with_level(const Ratio& level) const override {
    return std::make_unique<MaxLevel>(kind_, corners_, level);
  }

 private:
  /// The border of half-plane m: a coordinate of the difference, or a weight.
  std::string border_name(std::size_t m) const {
    static constexpr std::array<const char*, kAxes> kAxisNames = {"x = d",  "x = -d", "y = d",
                                                                  "y = -d", "z = d",  "z = -d"};
    if (m < kAxes) return kAxisNames[m];
    std::size_t corner = 0;
    switch (kind_) {
      case Kind::edge_edge: corner = std::array<std::size_t, 4>{1, 3, 0, 2}[m - kAxes]; break;
      case Kind::vertex_face: corner = std::array<std::size_t, 3>{2, 3, 1}[m - kAxes]; break;
      case Kind::point_edge: corner = m == kS ? 2 : 1; break;
      case Kind::point_point: break;
    }
    return "no weight of " + std::string(corner_name(kind_, corner));
  }

  void add(HalfPlane half_plane) { half_planes_[count_++] = std::move(half_plane); }

  /// The index of a pair i < j among all pairs: those with a smaller j come before it.
  static constexpr std::size_t index_of(std::size_t i, std::size_t j) { return i + j * (j - 1) / 2; }

  /// A polynomial that is made when it is first asked for, in memory of its own: all of them would fill 150 kilobytes,
  /// and most are never asked for.
  using Kept = std::unique_ptr<const Form>;
  template <class Make>
  static const Form& kept(Kept& form, const Make& make) {
    if (!form) form = std::make_unique<const Form>(make());
    return *form;
  }

  /// The determinant of the rows (s, t) of two half-planes, or (s, t, constant) of three, i < j < k. Both are kept: the
  /// same ones are asked for at many times.
  const Form& determinant(std::size_t i, std::size_t j) const {
    return kept(pairs_[index_of(i, j)], [&] {
      const HalfPlane &a = half_planes_[i], &b = half_planes_[j];
      return a.s * b.t - b.s * a.t;
    });
  }
  const Form& determinant(std::size_t i, std::size_t j, std::size_t k) const {
    return kept(triples_[index_of(i, j) + k * (k - 1) * (k - 2) / 6], [&] {
      const HalfPlane &a = half_planes_[i], &b = half_planes_[j], &c = half_planes_[k];
      return a.constant * determinant(j, k) - b.constant * determinant(i, k) + c.constant * determinant(i, j);
    });
  }

  static bool is_dyadic(const RealRoot& time) { return time.denominator() == Exact(1); }

  /// The corners at a dyadic time, at rest.
  AnyCorners corners_at(const RealRoot& time) const {
    const Ratio at = {time.numerator(), time.denominator()};
    AnyCorners result = corners_;
    const auto fix = [&](Form& p) { p = Form(homogeneous_value(p, at)); };
    for (std::size_t i = 0; i < result.corners.size(); ++i) {
      for (Form& p : result.corners[i].c) fix(p);
      for (Form& p : result.own[i].c) fix(p);
    }
    for (Form& p : result.multipliers) fix(p);
    fix(result.scale);
    return result;
  }

  /// The same elements and level at rest, as they are at a dyadic time; null for another time. Polynomials in full are
  /// only needed where their values there are zero.
  const MaxLevel* at_rest(const Moment& moment) const {
    const RealRoot& time = moment.root();
    if (!is_dyadic(time)) return nullptr;
    if (!at_rest_ || time.numerator() != rest_time_) {
      const auto corners = off_the_stack([&] { return corners_at(time); });
      at_rest_ = std::make_unique<MaxLevel>(kind_, *corners, level_);
      rest_time_ = time.numerator();
    }
    return at_rest_.get();
  }
  template <class... Index>
  int sign_of_determinant(const Moment& moment, Index... rows) const {
    if (corners_.scale.size() > 1 || half_planes_[0].constant.size() > 1) {
      if (const MaxLevel* const rest = at_rest(moment)) {
        const int sign = numbers::sign_of(rest->determinant(rows...)[0]);
        if (sign != 0 || moment.is_at_root()) return sign;
      }
    }
    return moment.sign(determinant(rows...));
  }

  /// Half-plane m's value at the meeting point of i and j, times determinant(i, j).
  const Form& value_at(std::size_t i, std::size_t j, std::size_t m, bool& negative) const {
    // Sorting the rows changes the determinant's sign with each exchange.
    negative = m > i && m < j;
    return m < i ? determinant(m, i, j) : m < j ? determinant(i, m, j) : determinant(i, j, m);
  }
  int sign_at(const Vertex& vertex, std::size_t m, const Moment& moment) const {
    const auto [i, j, tight] = vertex;
    if (m < i) return sign_of_determinant(moment, m, i, j);
    if (m > j) return sign_of_determinant(moment, i, j, m);
    return -sign_of_determinant(moment, i, m, j);
  }

  /// Calls f with each vertex until it returns false.
  template <class F>
  void for_each_vertex(const Moment& moment, const F& f) const {
    for (std::size_t j = count_ - 1; j > 0; --j) {  // vertices on the elements' borders first: they are cheaper
      for (std::size_t i = j; i-- > 0;) {
        const int orientation = sign_of_determinant(moment, i, j);
        if (orientation == 0) continue;
        Vertex vertex = {i, j, bit(i) | bit(j)};
        bool inside = true;
        for (std::size_t m = 0; m < count_ && inside; ++m) {
          if (m == i || m == j) continue;
          const int sign = orientation * sign_at(vertex, m, moment);
          inside = sign >= 0;
          if (sign == 0) vertex.tight |= bit(m);
        }
        if (inside && !f(vertex)) return;
      }
    }
  }

  // The elements' borders.
  static constexpr std::size_t kS = kAxes, kT = kAxes + 1, kSum = kAxes + 2, kOtherS = kAxes + 2, kOtherT = kAxes + 3;

  /// Parts of the elements on whose borders the closest points are looked for, in this order. A zero-length edge is its
  /// first corner, and a flat triangle the first of its corners and edges that holds closest points.
  std::vector<Mask> borders_in_order(const Moment& moment) const {
    const auto vanishes = [&](const Point& v) {
      return moment.sign(v[0]) == 0 && moment.sign(v[1]) == 0 && moment.sign(v[2]) == 0;
    };
    const auto point_at = [&](std::size_t i, std::size_t j, std::size_t border) {
      return vanishes(difference(corners_, i, j)) ? bit(border) : 0U;
    };
    switch (kind_) {
      case Kind::edge_edge: return {point_at(0, 1, kS) | point_at(2, 3, kT)};
      case Kind::point_edge: return {point_at(1, 2, kS)};
      case Kind::point_point: return {0U};
      case Kind::vertex_face: break;
    }
    if (!vanishes(geometry::cross(difference(corners_, 2, 1), difference(corners_, 3, 1)))) return {0U};
    return {bit(kS) | bit(kT), bit(kT) | bit(kSum), bit(kS) | bit(kSum), bit(kT), bit(kSum), bit(kS)};
  }

  /// The borders whose values are weights, in the order in which small weights are preferred.
  std::vector<std::size_t> preferred_borders() const {
    if (kind_ == Kind::vertex_face) return {kSum, kS};
    if (kind_ == Kind::edge_edge) return {kOtherS, kOtherT};
    return {kOtherS};
  }

  bool precedes(const Vertex& a, const Vertex& b, const Moment& moment) const {
    for (const std::size_t border : preferred_borders()) {
      const bool a_zero = (a.tight & bit(border)) != 0, b_zero = (b.tight & bit(border)) != 0;
      if (a_zero && b_zero) continue;
      if (a_zero || b_zero) return a_zero;
      const auto [an, ad] = weight_of(a, border);
      const auto [bn, bd] = weight_of(b, border);
      const int sign = moment.sign(an * bd - bn * ad) * moment.sign(ad) * moment.sign(bd);
      if (sign != 0) return sign < 0;
    }
    return false;
  }

  /// The border's value at the vertex, which is the weight times its element's multiplier: numerator and denominator.
  std::pair<Form, Form> weight_of(const Vertex& vertex, std::size_t border) const {
    bool negative = false;
    const Form& value = value_at(vertex.i, vertex.j, border, negative);
    return {negative ? -value : value, determinant(vertex.i, vertex.j)};
  }

  void describe(const Vertex& vertex, const RealRoot& root, Answer& answer) const {
    const auto positive = [&](std::size_t border) { return (vertex.tight & bit(border)) == 0; };
    const auto weight = [&](std::size_t border) {
      const auto [numerator, denominator] = weight_of(vertex, border);
      const bool of_first = kind_ == Kind::edge_edge && (border == kS || border == kOtherS);
      return root.quotient(numerator, completed(corners_, of_first ? 0 : 1, denominator));
    };
    const auto on_edge = [&](std::size_t first, std::size_t second, const std::array<Feature, 3>& features,
                             Feature& feature) -> std::array<double, 3> {
      if (!positive(second)) return feature = features[0], std::array<double, 3>{1, 0, 0};
      if (!positive(first)) return feature = features[1], std::array<double, 3>{0, 1, 0};
      feature = features[2];
      const double later = weight(second);
      return {1 - later, later, 0};
    };
    answer.weights_a = answer.weights_b = {1, 0, 0};
    switch (kind_) {
      case Kind::edge_edge:
        answer.weights_a = on_edge(kOtherS, kS, {Feature::a0, Feature::a1, Feature::a}, answer.feature_a);
        answer.weights_b = on_edge(kOtherT, kT, {Feature::b0, Feature::b1, Feature::b}, answer.feature_b);
        return;
      case Kind::vertex_face: {
        answer.feature_a = Feature::v;
        unsigned support = 0;
        static constexpr std::size_t borders[3] = {kSum, kS, kT};
        for (unsigned i = 0; i < 3; ++i) support |= positive(borders[i]) ? 1U << i : 0U;
        answer.feature_b = geometry::kFace.features[support];
        for (unsigned i = 0; i < 3; ++i) {
          answer.weights_b[i] = (support & (1U << i)) == 0 ? 0 : support == 1U << i ? 1 : weight(borders[i]);
        }
        return;
      }
      case Kind::point_edge:
        answer.feature_a = Feature::p;
        answer.weights_b = on_edge(kOtherS, kS, {Feature::e0, Feature::e1, Feature::e}, answer.feature_b);
        return;
      case Kind::point_point:
        answer.feature_a = Feature::p;
        answer.feature_b = Feature::q;
        return;
    }
  }

  /// A half-plane's row at a rational time, times a power of the time's denominator: s, t, constant, and the factor of
  /// d.
  std::array<Exact, 4> row_at(std::size_t m, const Ratio& time) const {
    const HalfPlane& h = half_planes_[m];
    const Form& of_d = corners_.scale;
    const int size = std::max({h.s.size(), h.t.size(), h.constant.size(), of_d.size()});
    const auto value = [&](const Form& p) {
      Exact result = homogeneous_value(p, time);
      for (int i = p.size(); i < size; ++i) result = result * time.denominator;
      return result;
    };
    return {value(h.s), value(h.t), value(h.constant), m < kAxes ? value(of_d) : Exact(0)};
  }

  /// The determinant of three rows' columns 0, 1 and `column`.
  static Exact determinant_of(const std::array<std::array<Exact, 4>, 3>& rows, std::size_t column) {
    const auto minor = [&](std::size_t i, std::size_t j) { return rows[i][0] * rows[j][1] - rows[j][0] * rows[i][1]; };
    return rows[0][column] * minor(1, 2) - rows[1][column] * minor(0, 2) + rows[2][column] * minor(0, 1);
  }

  Kind kind_;
  AnyCorners corners_;
  Ratio level_;
  mutable std::unique_ptr<MaxLevel> at_rest_;
  mutable Exact rest_time_;
  std::array<HalfPlane, kMost> half_planes_;
  std::size_t count_ = 0;
  mutable std::array<Kept, kMost*(kMost - 1) / 2> pairs_;
  mutable std::array<Kept, kMost*(kMost - 1) * (kMost - 2) / 6> triples_;
};

}  // namespace

std::unique_ptr<DistanceLevel> max_level(Kind kind, const AnyCorners& corners, const Ratio& level) {
  return std::make_unique<MaxLevel>(kind, corners, level);
}

}  // namespace touchstone::exact
