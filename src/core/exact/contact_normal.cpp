// The unit normal at the first contact, and how the contact's time changes with the corners, from polynomials in t.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "exact/corners.hpp"
#include "exact/distance_level.hpp"
#include "exact/exact.hpp"
#include "exact/exact_times.hpp"
#include "geometry/frame.hpp"
#include "geometry/nearest_points.hpp"
#include "numbers/integers/limb_scratch.hpp"

namespace touchstone::exact {
namespace {

using Direction = geometry::Vector<Form>;
using Corners = std::array<Direction, 4>;

Corners corners_of(const CurvedQuery& query) { return moving_corners<AnyDegree>(query).corners; }
template <class Q>
Corners corners_of(const Q& query) {
  const ScaledCorners scaled = scaled_corners(query);
  Corners corners;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) corners[i] = form_of(scaled.corners[i]);
  return corners;
}

/// The normal of two edges, or of a face, and its product with what leads from the first element to the second.
struct Plane {
  Direction n;
  Form coplanarity;
};

Plane plane_of(Kind kind, const Corners& x) {
  const auto frame = geometry::frame_of(kind, [&x](std::size_t i, std::size_t j) { return x[i] - x[j]; });
  const Direction n = geometry::normal(frame);
  const Form v = geometry::dot(n, frame.r);  // r leads from the face to the vertex
  return {n, kind == Kind::edge_edge ? v : -v};
}

/// What leads from the closest point of the first element to that of the second, times a positive number or zero. `at`
/// is the time of a contact with these features.
Direction between_closest_points(const Corners& x, const Answer& answer, Kind kind, const Moment& at) {
  const auto [a, b] = geometry::corners_of(kind, answer.feature_a, answer.feature_b);
  const Direction r = x[b.corners[0]] - x[a.corners[0]];
  const bool parallel = answer.feature_a == Feature::overlap;
  if (a.count == 1 && b.count == 1) return r;
  if (a.count == 1 && b.count == 2) return geometry::across(x[b.corners[1]] - x[b.corners[0]], r);
  if (parallel || (a.count == 2 && b.count == 1)) return geometry::across(x[a.corners[1]] - x[a.corners[0]], r);
  const Plane plane = plane_of(kind, x);
  const int side = at.sign(plane.coplanarity);
  return side > 0 ? plane.n : side < 0 ? -plane.n : Direction();
}

/// The unit vector along v at the root; nothing where v = 0. The largest coordinate m and the quotients v_k / v_m, each
/// off by at most 2^-50.5, make a vector that is at least 1 long and off by at most 2^-50. Division by its length adds
/// less than 2^-51: 4 roundings in each coordinate.
std::optional<std::array<double, 3>> unit_vector(const Direction& v, const RealRoot& root) {
  const Moment at = Moment::at(root);
  Direction size = v;
  std::array<int, 3> sign{};
  std::size_t largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sign[k] = v[k].is_zero() ? 0 : at.sign(v[k]);
    if (sign[k] < 0) size[k] = -v[k];
    if (sign[k] != 0 && (sign[largest] == 0 || at.sign(size[k] - size[largest]) > 0)) largest = k;
  }
  if (sign[largest] == 0) return std::nullopt;
  std::array<double, 3> unit{};
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (sign[k] != 0) unit[k] = k == largest ? sign[k] : sign[k] * root.quotient(size[k], size[largest]);
    square += unit[k] * unit[k];
  }
  const double length = std::sqrt(square);
  for (double& coordinate : unit) coordinate /= length;
  return unit;
}

template <class Q>
std::optional<std::array<double, 3>> normal_of(const Q& query, double t_max, const Separation& separation) {
  const Corners x = corners_of(query);
  if (separation.distance > 0) {
    const auto [answer, time] = decide_with_time(query, t_max, separation);
    if (!time) return std::nullopt;
    return unit_vector(between_closest_points(x, answer, query.kind, Moment::at(*time)), *time);
  }
  if (query.kind != Kind::edge_edge && query.kind != Kind::vertex_face) return std::nullopt;
  const std::vector<RootInterval> times = touching_times(query, t_max);
  if (times.empty()) return std::nullopt;
  const RealRoot& time = times.front().first;
  const Plane plane = plane_of(query.kind, x);
  const bool turned = !plane.coplanarity.is_zero() && Moment::just_before(time).sign(plane.coplanarity) < 0;
  return unit_vector(turned ? -plane.n : plane.n, time);
}

/// By each corner the gradient of what is 0 or the separation's at the contact: V, or half the squared distance, times
/// one positive number.
std::array<Direction, 4> gradient_by_corners(const Corners& x, const Answer& answer, Kind kind, bool apart) {
  const auto difference = [&x](std::size_t i, std::size_t j) { return x[i] - x[j]; };
  if (!apart) {
    const auto frame = geometry::frame_of(kind, difference);
    const auto& [u, w, r] = frame;
    return geometry::gradient_by_corners<Direction>(
        kind, {geometry::cross(w, r), geometry::cross(r, u), geometry::normal(frame)});
  }
  const auto [direction, weights] =
      geometry::closest_points(kind, answer.feature_a, answer.feature_b, Form(Exact(1)), difference);
  std::array<Direction, 4> gradient;
  for (std::size_t i = 0; i < corner_count(kind); ++i) gradient[i] = weights[i] * direction;
  return gradient;
}

bool is_inside(const Answer& answer, Kind kind) {
  return kind == Kind::edge_edge ? answer.feature_a == Feature::a && answer.feature_b == Feature::b
                                 : kind == Kind::vertex_face && answer.feature_b == Feature::f;
}

template <class Q>
std::optional<geometry::EndGradients> gradient_of(const Q& query, double t_max, const Separation& separation) {
  std::optional<RealRoot> time;
  Answer answer;
  if (separation.distance > 0) {
    TimedAnswer timed = decide_with_time(query, t_max, separation);
    answer = timed.answer;
    time = std::move(timed.time);
  } else {
    answer = decide_exactly(query, t_max);
    if (!answer.contact || !is_inside(answer, query.kind)) return std::nullopt;
    time = std::move(touching_times(query, t_max).front().first);
  }
  if (!time || time->compare(Exact(0)) == 0) return std::nullopt;

  const ScaledCorners scaled = scaled_corners(query);
  const Corners x = corners_of(query);
  const auto by_corners = gradient_by_corners(x, answer, query.kind, separation.distance > 0);
  const std::size_t count = corner_count(query.kind);
  Form speed;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      speed = speed + by_corners[i][k] * Form(x[i][k].size() > 1 ? x[i][k][1] : Exact(0));
    }
  }
  const Moment at = Moment::at(*time);
  const auto is_zero = [&](const Form& p) { return p.is_zero() || at.sign(p) == 0; };
  if (is_zero(speed)) return std::nullopt;  // where edges overlap, the direction is 0
  if (separation.distance > 0) {
    const auto difference = [&x](std::size_t i, std::size_t j) { return x[i] - x[j]; };
    const auto sizes = geometry::squared_sizes(query.kind, Form(Exact(1)), difference);
    if (is_zero(sizes[0]) || is_zero(sizes[1])) return std::nullopt;
  }
  geometry::EndGradients gradient{};
  // The coordinates are multiplied by the factor here, and so are derivatives by them divided by it.
  const Form fraction_at_end(Exact(0), scaled.factor), fraction_at_start(scaled.factor, -scaled.factor);
  const auto ratio = [&](const Form& p) { return is_zero(p) ? 0 : time->ratio(p, speed); };
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 3> start, end;
    for (std::size_t k = 0; k < 3; ++k) {
      const Form numerator = -by_corners[i][k];
      start[k] = ratio(numerator * fraction_at_start);
      end[k] = ratio(numerator * fraction_at_end);
    }
    gradient[0][i] = {start[0], start[1], start[2]};
    gradient[1][i] = {end[0], end[1], end[2]};
  }
  return gradient;
}

}  // namespace

std::optional<geometry::EndGradients> toi_gradient(const Query& query, double t_max, const Separation& separation) {
  return gradient_of(query, t_max, separation);
}
std::optional<geometry::EndGradients> toi_gradient(const RationalQuery& query, double t_max,
                                                   const Separation& separation) {
  return gradient_of(query, t_max, separation);
}

std::optional<std::array<double, 3>> contact_normal(const Query& query, double t_max, const Separation& separation) {
  return normal_of(query, t_max, separation);
}
std::optional<std::array<double, 3>> contact_normal(const RationalQuery& query, double t_max,
                                                    const Separation& separation) {
  return normal_of(query, t_max, separation);
}

// At each time the corners are multiplied by one positive number, which turns no normal.
std::optional<std::array<double, 3>> contact_normal(const CurvedQuery& query, double t_max,
                                                    const Separation& separation) {
  return normal_of(query, t_max, separation);
}

}  // namespace touchstone::exact
