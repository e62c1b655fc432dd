// Conservative inclusion over t and the weights, after Wang et al. 2021 (the idea; see baseline.hpp).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "baselines/baseline.hpp"

// The difference of a point of one element and one of the other is affine in t and in each weight, so its image over a
// box of them lies in the convex hull of its values at the box's corners: per axis, between the least and the greatest.
// If the image of a box, widened by the rounding error, does not contain the origin, the elements do not touch in the
// box, and it is dropped. Boxes are taken in the order of their earliest t. So the first box that is small enough to be
// a hit starts no later than any contact that is left.
namespace touchstone::baselines {
namespace {

struct Range {
  double low;
  double high;

  double middle() const { return 0.5 * low + 0.5 * high; }
};

/// Axis 0 is t; the others are weights, of which edge-edge has one per edge, vertex-face two on the face.
constexpr std::size_t kAxes = 3;
struct Box {
  std::array<Range, kAxes> range;
  int depth;
};

/// Earliest first; of boxes that start together the one that was split most, so that a hit at their time is found soon.
bool comes_later(const Box& a, const Box& b) {
  const double ta = a.range[0].low;
  const double tb = b.range[0].low;
  return ta != tb ? ta > tb : a.depth < b.depth;
}

/// One coordinate of the corners at both ends of the step.
struct Coordinate {
  std::array<double, 4> start{};
  std::array<double, 4> end{};
  double error = 0;  ///< bound on the rounding error of `difference`
};

/// Rounding of one coordinate of the difference. With u = 2^-53 and M the largest absolute coordinate: each of (1 - t)
/// x0 and t x1 has at most three roundings, so a position is off by 3 u M. Edges: each term passes three more roundings
/// and the difference one, 7 u M a side, 14 u M in all. Face: 1 - f1 - f2 is off by 2 u and at most 1 in size, so the
/// three terms are off by 2 u M + 3 (3 + 1 + 2) u M = 20 u M, the vertex by 3 u M, and their difference, at most 4 M,
/// by 4 u M: 27 u M. Second-order terms are far below the 5 u M that remain to 32 u M = 2^-48 M. Where products
/// underflow they lose 2^-1075 each, as do coordinates that are scaled down: fewer than 64 such losses.
constexpr double kRounding = 0x1p-48;
constexpr double kUnderflow = 0x1p-1068;

class Difference {
 public:
  explicit Difference(const Query& query, double scale) : kind_(query.kind) {
    for (std::size_t k = 0; k < 3; ++k) {
      double greatest = 0;
      for (std::size_t i = 0; i < corner_count(kind_); ++i) {
        axis_[k].start[i] = scale * coordinate(query.start[i], k);
        axis_[k].end[i] = scale * coordinate(query.end[i], k);
        greatest = std::max({greatest, std::fabs(axis_[k].start[i]), std::fabs(axis_[k].end[i])});
      }
      axis_[k].error = kRounding * greatest + kUnderflow;
    }
  }

  static double coordinate(const Vec3& v, std::size_t k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

  std::size_t axes() const { return kind_ == Kind::point_point ? 1 : kind_ == Kind::point_edge ? 2 : 3; }

  /// The image of the box: whether it may contain the origin, its largest width, and how far it spreads along each
  /// axis.
  struct Image {
    bool may_touch = true;
    double width = 0;
    std::array<double, kAxes> spread{};
  };

  Image image(const Box& box) const {
    Image image;
    const std::size_t corners = std::size_t{1} << axes();
    for (const Coordinate& c : axis_) {
      const std::array<std::array<double, 4>, 2> x{positions(c, box.range[0].low), positions(c, box.range[0].high)};
      std::array<double, 8> values{};
      for (std::size_t i = 0; i < corners; ++i) values[i] = value(x[i & 1], box, i);
      const auto [low, high] =
          std::minmax_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(corners));
      if (!(*low <= c.error && *high >= -c.error)) {  // also when they are not numbers
        image.may_touch = false;
        return image;
      }
      image.width = std::max(image.width, *high - *low);
      for (std::size_t axis = 0; axis < axes(); ++axis) {
        const std::size_t bit = std::size_t{1} << axis;
        for (std::size_t i = 0; i < corners; ++i) {
          if ((i & bit) == 0) image.spread[axis] = std::max(image.spread[axis], std::fabs(values[i | bit] - values[i]));
        }
      }
    }
    return image;
  }

 private:
  /// The corners' positions at one time.
  static std::array<double, 4> positions(const Coordinate& c, double t) {
    std::array<double, 4> x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = (1 - t) * c.start[i] + t * c.end[i];
    return x;
  }

  /// Of the corners x, with the weights at the corner of the box whose bits say which ends.
  double value(const std::array<double, 4>& x, const Box& box, std::size_t bits) const {
    const auto end = [&](std::size_t axis) {
      const Range& range = box.range[axis];
      return (bits >> axis & 1) != 0 ? range.high : range.low;
    };
    switch (kind_) {
      case Kind::edge_edge: return ((1 - end(1)) * x[0] + end(1) * x[1]) - ((1 - end(2)) * x[2] + end(2) * x[3]);
      case Kind::vertex_face: return x[0] - (((1 - end(1) - end(2)) * x[1] + end(1) * x[2]) + end(2) * x[3]);
      case Kind::point_edge: return x[0] - ((1 - end(1)) * x[1] + end(1) * x[2]);
      case Kind::point_point: break;
    }
    return x[0] - x[1];
  }

  Kind kind_;
  std::array<Coordinate, 3> axis_{};
};

/// The axis along which the image spreads most, of those that can still be split; kAxes when none can.
std::size_t axis_to_split(const Box& box, const Difference::Image& image, std::size_t axes) {
  std::size_t best = kAxes;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const Range& range = box.range[axis];
    const double middle = range.middle();
    if (middle <= range.low || middle >= range.high) continue;
    if (best == kAxes || image.spread[axis] > image.spread[best]) best = axis;
  }
  return best;
}

/// A power of two that keeps sums of coordinates from overflowing.
double scale_of(const Query& query) {
  double greatest = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      greatest = std::max({greatest, std::fabs(Difference::coordinate(query.start[i], k)),
                           std::fabs(Difference::coordinate(query.end[i], k))});
    }
  }
  return greatest > 0x1p1000 ? 0x1p-64 : 1.0;
}

}  // namespace

Result solve_interval(const Query& query, double t_max, double tolerance) {
  const double scale = scale_of(query);
  const double small = scale * tolerance;
  const Difference difference(query, scale);
  const std::size_t axes = difference.axes();
  const bool face = query.kind == Kind::vertex_face;

  std::vector<Box> boxes{{{Range{0, t_max}, Range{0, 1}, Range{0, 1}}, 0}};
  for (int step = 0; !boxes.empty(); ++step) {
    std::pop_heap(boxes.begin(), boxes.end(), comes_later);
    const Box box = boxes.back();
    boxes.pop_back();
    const Difference::Image image = difference.image(box);
    if (!image.may_touch) continue;
    const std::size_t axis = axis_to_split(box, image, axes);
    if (image.width <= small || axis == kAxes || step >= kIntervalSteps) return {true, box.range[0].low};
    const double middle = box.range[axis].middle();
    for (const Range& half : {Range{box.range[axis].low, middle}, Range{middle, box.range[axis].high}}) {
      Box child = box;
      child.range[axis] = half;
      ++child.depth;
      // Rounding is monotone, so a sum that rounds to more than 1 is more than 1: outside the face.
      if (face && child.range[1].low + child.range[2].low > 1) continue;
      boxes.push_back(child);
      std::push_heap(boxes.begin(), boxes.end(), comes_later);
    }
  }
  return {};
}

}  // namespace touchstone::baselines
