// The Euclidean distance of two elements is the least over pairs of their features: corner and corner, corner and edge,
// corner and face, edge and edge. Of each pair, a patch describes the points that are nearest to each other on the
// feature's lines and planes, by weights that may lie outside the features. Where they lie inside, the patch's distance
// counts.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/distance_level.hpp"
#include "geometry/frame.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::exact {
namespace {

using Point = geometry::Vector<Form>;

/// A pair of features. The scale is positive but where the features degenerate: a lesser pair then has the same closest
/// points. An edge's direction is known up to a positive polynomial: the multiplier of its element, which the weights
/// on this element are multiplied by in addition. The distances do not depend on it.
struct Patch {
  Feature feature_a = Feature::none;
  Feature feature_b = Feature::none;
  Form scale;   ///< 1, |e|^2 or |n|^2
  Form gap;     ///< the squared distance of the corners as they are scaled, times the scale
  Form excess;  ///< squared distance minus level, times the scale and the level's denominator
  /// The weights of the nearest points on each element, times unit_a and unit_b.
  std::array<Form, 3> a, b;
  Form unit_a, unit_b;  ///< the scale, times the element's multiplier
  /// The weights that are neither 0 nor 1 at all times.
  std::array<std::pair<int, int>, 4> free = {};  ///< element (0, 1) and corner
  std::size_t free_count = 0;

  const Form& weight(std::size_t i) const {
    const auto [element, corner] = free[i];
    return (element == 0 ? a : b)[static_cast<std::size_t>(corner)];
  }
  void add_free(int element, std::initializer_list<int> corners) {
    for (const int corner : corners) free[free_count++] = {element, corner};
  }
};

/// A corner of an element.
struct Corner {
  Feature feature;
  int index;  ///< of its weight
  Point position;
};

/// An edge between two corners of an element.
struct Edge {
  Feature feature;
  int first, second;  ///< of its weights
  Point start;
  Point direction;  ///< to its end, up to the multiplier
};

Patch corner_and_corner(const Corner& a, const Corner& b) {
  Patch patch;
  patch.feature_a = a.feature;
  patch.feature_b = b.feature;
  patch.scale = Form(Exact(1));
  const Point r = b.position - a.position;
  patch.gap = geometry::dot(r, r);
  patch.a[static_cast<std::size_t>(a.index)] = patch.b[static_cast<std::size_t>(b.index)] = patch.scale;
  patch.unit_a = patch.unit_b = patch.scale;
  return patch;
}

/// With e = end - start and r = corner - start the foot on the edge's line has the weight (r . e) / |e|^2 at its end,
/// and the squared distance is |e x r|^2 / |e|^2. `corner_first`: the corner belongs to the first element.
Patch corner_and_edge(const Corner& corner, const Edge& edge, const Form& multiplier, bool corner_first) {
  Patch patch;
  (corner_first ? patch.feature_a : patch.feature_b) = corner.feature;
  (corner_first ? patch.feature_b : patch.feature_a) = edge.feature;
  auto& on_corner = corner_first ? patch.a : patch.b;
  auto& on_edge = corner_first ? patch.b : patch.a;
  const Point& e = edge.direction;
  const Point r = corner.position - edge.start;
  const Point c = geometry::cross(e, r);
  patch.scale = geometry::dot(e, e);
  patch.gap = geometry::dot(c, c);
  on_corner[static_cast<std::size_t>(corner.index)] = patch.scale;
  Form& unit = corner_first ? patch.unit_b : patch.unit_a;
  (corner_first ? patch.unit_a : patch.unit_b) = patch.scale;
  unit = scaled_by(multiplier, patch.scale);
  on_edge[static_cast<std::size_t>(edge.second)] = geometry::dot(r, e);
  on_edge[static_cast<std::size_t>(edge.first)] = unit - geometry::dot(r, e);
  patch.add_free(corner_first ? 1 : 0, {edge.first, edge.second});
  return patch;
}

/// Two edges, or a vertex and a face: see geometry/frame.hpp. Where n is not zero, r = f1 u - f2 w + (r . n) / |n|^2 n
/// for edges, and r = w1 u + w2 w + (r . n) / |n|^2 n for a face, with f1 = (r x w) . n / |n|^2 and so on.
Patch interiors(Kind kind, const AnyCorners& x) {
  const bool edges = kind == Kind::edge_edge;
  Patch patch;
  patch.feature_a = edges ? Feature::a : Feature::v;
  patch.feature_b = edges ? Feature::b : Feature::f;
  const auto frame = geometry::frame_of(kind, [&x](std::size_t i, std::size_t j) { return difference(x, i, j); });
  const Point n = geometry::normal(frame);
  const Form coplanarity = geometry::dot(n, frame.r);
  patch.scale = geometry::dot(n, n);
  patch.gap = coplanarity * coplanarity;
  const auto along_normal = [&n](const auto& numerator) {
    return n[0] * numerator(0) + n[1] * numerator(1) + n[2] * numerator(2);
  };
  const Form first = along_normal([&](std::size_t k) { return geometry::first_numerator(frame, k); });
  const Form second = along_normal([&](std::size_t k) { return geometry::second_numerator(kind, frame, k); });
  patch.unit_a = scaled_by(x.multipliers[0], patch.scale);
  patch.unit_b = scaled_by(x.multipliers[1], patch.scale);
  if (edges) {
    patch.a = {patch.unit_a - first, first, Form()};
    patch.b = {patch.unit_b - second, second, Form()};
    patch.add_free(0, {0, 1});
    patch.add_free(1, {0, 1});
  } else {
    patch.a = {patch.unit_a, Form(), Form()};
    patch.b = {patch.unit_b - first - second, first, second};
    patch.add_free(1, {0, 1, 2});
  }
  return patch;
}

/// The corners and edges of an element, whose corners are those from x[from] on.
struct Borders {
  std::vector<Corner> corners;
  std::vector<Edge> edges;

  Borders(const geometry::Element& element, const AnyCorners& x, std::size_t from) {
    for (std::size_t i = 0; i < element.corners(); ++i) {
      corners.push_back({element.corner(i), static_cast<int>(i), x[from + i]});
    }
    for (std::size_t i = 0; i < element.edges(); ++i) {
      const std::size_t end = element.end_of_edge(i);
      edges.push_back({element.edge(i), static_cast<int>(i), static_cast<int>(end), x[from + i],
                       difference(x, from + end, from + i)});
    }
  }
};

/// Lesser pairs before greater ones, in the order of their features.
std::vector<Patch> patches_of(Kind kind, const AnyCorners& x) {
  std::vector<Patch> patches;
  const auto& [first, second] = geometry::traits_of(kind);
  const Borders a(first, x, 0), b(second, x, first.corners());
  for (const Corner& corner : a.corners) {
    for (const Corner& other : b.corners) patches.push_back(corner_and_corner(corner, other));
  }
  for (const Corner& corner : a.corners) {
    for (const Edge& other : b.edges) patches.push_back(corner_and_edge(corner, other, x.multipliers[1], true));
  }
  for (const Corner& corner : b.corners) {
    for (const Edge& other : a.edges) patches.push_back(corner_and_edge(corner, other, x.multipliers[0], false));
  }
  if (kind == Kind::edge_edge || kind == Kind::vertex_face) patches.push_back(interiors(kind, x));
  return patches;
}

class EuclideanLevel final : public DistanceLevel {
 public:
  /// @param square  of the positive number that the corners are multiplied by at each time
  EuclideanLevel(Kind kind, std::vector<Patch> patches, Form square, const Ratio& level)
      : kind_(kind), patches_(std::move(patches)), square_(std::move(square)) {
    for (Patch& patch : patches_) {
      patch.excess = patch.gap * level.denominator - scaled_by(square_, patch.scale) * level.numerator;
    }
  }

  int compare(const Moment& moment) const override {
    int least = 1;
    for (const Patch& patch : patches_) {
      const int sign = moment.sign(patch.excess);
      if (sign >= least || !feet_inside(patch, moment)) continue;
      if (sign < 0) return sign;
      least = sign;
    }
    return least;
  }

  std::vector<Event> events() const override {
    std::vector<Event> events;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const Patch& patch = patches_[i];
      if (!patch.excess.is_zero() && !never_inside(patch)) events.push_back({patch.excess, i});
    }
    return events;
  }

  bool holds(const Event& event, const Moment& moment) const override {
    return feet_inside(patches_[event.index], moment);
  }

  std::string event_name(const Event& event) const override {
    const Patch& patch = patches_[event.index];
    return std::string(name_of(patch.feature_a)).append(" against ").append(name_of(patch.feature_b));
  }

  std::vector<CandidateStory::Condition> conditions_of(const Event& event, const Moment& moment) const override {
    const Patch& patch = patches_[event.index];
    std::vector<CandidateStory::Condition> conditions;
    if (patch.free_count > 0) {
      const bool interior = patch.free_count > 2;
      conditions.push_back({interior ? "|n|^2" : "squared length of the edge", moment.sign(patch.scale)});
    }
    for (std::size_t i = 0; i < patch.free_count; ++i) {
      const auto [element, corner] = patch.free[i];
      const std::size_t index =
          static_cast<std::size_t>(corner) + (element == 0 ? 0 : geometry::corners_of_first(kind_));
      conditions.push_back({"weight of " + std::string(corner_name(kind_, index)), moment.sign(patch.weight(i))});
    }
    return conditions;
  }

  void locate(const RealRoot& root, Answer& answer) const override {
    const Moment moment = Moment::at(root);
    if (kind_ == Kind::edge_edge && locate_overlap(root, answer)) return;
    for (const Patch& patch : patches_) {
      if (moment.sign(patch.excess) != 0 || !feet_strictly_inside(patch, moment)) continue;
      answer.feature_a = patch.feature_a;
      answer.feature_b = patch.feature_b;
      answer.weights_a = weights(patch.a, patch.unit_a, root);
      answer.weights_b = weights(patch.b, patch.unit_b, root);
      return;
    }
  }

  Ratio distance_at(const RealRoot& time) const override {
    const Moment moment = Moment::at(time);
    const Ratio at = {time.numerator(), time.denominator()};
    std::optional<Ratio> least;
    for (const Patch& patch : patches_) {
      if (!feet_inside(patch, moment)) continue;
      const Form scale = scaled_by(square_, patch.scale);
      Ratio distance = {homogeneous_value(patch.gap, at), homogeneous_value(scale, at)};
      // To the same formal degree.
      for (int i = scale.size(); i < patch.gap.size(); ++i)
        distance.denominator = distance.denominator * at.denominator;
      for (int i = patch.gap.size(); i < scale.size(); ++i) distance.numerator = distance.numerator * at.denominator;
      if (!least || exact::compare(distance, *least) < 0) least = std::move(distance);
    }
    return *least;  // the closest points lie on some pair of features
  }

  std::unique_ptr<DistanceLevel> with_level(const Ratio& level) const override {
    return std::make_unique<EuclideanLevel>(kind_, patches_, square_, level);
  }

 private:
  static bool feet_inside(const Patch& patch, const Moment& moment) {
    if (moment.sign(patch.scale) <= 0) return false;
    for (std::size_t i = 0; i < patch.free_count; ++i) {
      if (moment.sign(patch.weight(i)) < 0) return false;
    }
    return true;
  }

  static bool feet_strictly_inside(const Patch& patch, const Moment& moment) {
    if (moment.sign(patch.scale) <= 0) return false;
    for (std::size_t i = 0; i < patch.free_count; ++i) {
      if (moment.sign(patch.weight(i)) <= 0) return false;
    }
    return true;
  }

  /// Whether some weight is certainly negative in all of [0, 1].
  static bool never_inside(const Patch& patch) {
    for (std::size_t i = 0; i < patch.free_count; ++i) {
      const numbers::BernsteinForm form(patch.weight(i), Exact(0), Exact(1));
      if (std::all_of(form.begin(), form.end(), [](const Exact& c) { return numbers::sign_of(c) < 0; })) return true;
    }
    return false;
  }

  static std::array<double, 3> weights(const std::array<Form, 3>& numerators, const Form& unit, const RealRoot& root) {
    std::array<int, 3> positive{};
    std::size_t count = 0;
    for (int i = 0; i < 3; ++i) {
      const Form& numerator = numerators[static_cast<std::size_t>(i)];
      if (!numerator.is_zero() && root.quick_sign_at(numerator) > 0) positive[count++] = i;
    }
    std::array<double, 3> result{};
    const auto quotient = [&](int i) { return root.quotient(numerators[static_cast<std::size_t>(i)], unit); };
    if (count == 1) result[static_cast<std::size_t>(positive[0])] = 1;
    if (count == 2) {
      result[static_cast<std::size_t>(positive[1])] = quotient(positive[1]);
      result[static_cast<std::size_t>(positive[0])] = 1 - result[static_cast<std::size_t>(positive[1])];
    }
    if (count == 3) {
      for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>(i)] = quotient(i);
    }
    return result;
  }

  /// Two edges that have more than one pair of closest points: they are parallel, and their projections on their
  /// direction share a part of positive length. Each end of that part is a corner. False for other edges.
  bool locate_overlap(const RealRoot& root, Answer& answer) const {
    const Moment moment = Moment::at(root);
    if (moment.sign(patches_[kInteriors].scale) != 0) return false;
    const auto closest = [&](std::size_t patch) {
      return moment.sign(patches_[patch].excess) == 0 && feet_inside(patches_[patch], moment);
    };
    // Without a length of their own, edges have no patch with a corner of the other.
    const bool a0 = closest(kA0AndB), a1 = closest(kA0AndB + 1);
    const bool b0 = closest(kB0AndA), b1 = closest(kB0AndA + 1);
    if (static_cast<int>(a0) + static_cast<int>(a1) + static_cast<int>(b0) + static_cast<int>(b1) < 2) return false;
    if (moment.sign(patches_[kA0AndB].scale) == 0 || moment.sign(patches_[kB0AndA].scale) == 0) return false;
    if (!(a0 && a1) && !(b0 && b1)) {
      // A corner of each: both are the shared part's ends, or they are each other's closest point.
      const Patch& b_on_a = patches_[b0 ? kB0AndA : kB0AndA + 1];
      if (moment.sign(b_on_a.a[a0 ? 1 : 0]) == 0) return false;
    }
    answer.feature_a = answer.feature_b = Feature::overlap;
    // The smallest weight of a0: the end of the shared part that is farthest along a.
    const Patch* end = &patches_[kA0AndB + 1];
    if (!a1) {
      end = &patches_[b0 ? kB0AndA : kB0AndA + 1];
      const Patch& other = patches_[kB0AndA + 1];
      if (b0 && b1 && moment.sign(other.a[1] - end->a[1]) > 0) end = &other;
    }
    answer.weights_a = weights(end->a, end->unit_a, root);
    answer.weights_b = weights(end->b, end->unit_b, root);
    return true;
  }

  // Places among the patches of two edges.
  static constexpr std::size_t kA0AndB = 4, kB0AndA = 6, kInteriors = 8;

  Kind kind_;
  std::vector<Patch> patches_;
  Form square_;
};

}  // namespace

Exact homogeneous_value(const Form& p, const Ratio& time) {
  Exact value(0);
  Exact power(1);
  for (int i = p.size() - 1; i >= 0; --i) {
    value = value * time.numerator + p[i] * power;
    if (i > 0) power = power * time.denominator;
  }
  return value;
}

std::unique_ptr<DistanceLevel> euclidean_level(Kind kind, const AnyCorners& corners, const Ratio& level) {
  return std::make_unique<EuclideanLevel>(kind, patches_of(kind, corners), corners.scale * corners.scale, level);
}

}  // namespace touchstone::exact
