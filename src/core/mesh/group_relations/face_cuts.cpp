// SPDX-License-Identifier: MIT
#include "mesh/group_relations/face_cuts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace touchstone::mesh {
namespace {

using geometry::cross;
using geometry::dot;
using numbers::Exact;
using numbers::sign_of;

ExactPoint scaled(const ExactPoint& v, const Exact& by) { return {{v[0] * by, v[1] * by, v[2] * by}}; }
ExactPoint sum(const ExactPoint& a, const ExactPoint& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }

/// A fraction t = over / under, with under > 0.
struct Fraction {
  Exact over, under;

  bool is_between_0_and_1() const { return sign_of(over) > 0 && over < under; }
  bool operator<(const Fraction& other) const { return over * other.under < other.over * under; }
  bool operator==(const Fraction& other) const { return over * other.under == other.over * under; }
};

Fraction fraction(const Exact& over, const Exact& under) {
  return sign_of(under) < 0 ? Fraction{-over, -under} : Fraction{over, under};
}

/// The middles of the pieces between some fractions, 0 and 1.
std::vector<Fraction> middles_of(std::vector<Fraction> all) {
  all.push_back({Exact(0), Exact(1)});
  all.push_back({Exact(1), Exact(1)});
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<Fraction> middles;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const auto &a = all[i - 1], &b = all[i];
    middles.push_back({a.over * b.under + b.over * a.under, a.under * b.under * Exact(2)});
  }
  return middles;
}

FaceCut segment(const RationalPoint& a, const RationalPoint& b) {
  const ExactPoint q = scaled(a.x, b.w);
  broad_phase::Box box = box_around(a);
  const broad_phase::Box of_end = box_around(b);
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], of_end.low[k]);
    box.high[k] = std::max(box.high[k], of_end.high[k]);
  }
  return {q, scaled(b.x, a.w) - q, a.w * b.w, box};
}

RationalPoint point_at(const FaceCut& cut, const Fraction& t) {
  return {sum(scaled(cut.q, t.under), scaled(cut.step, t.over)), cut.w * t.under};
}

/// The points that a face has in the plane through `origin`: the ends of a segment, a point, or all three corners.
std::vector<RationalPoint> points_in_plane(const ExactCorners& face, const ExactPoint& normal,
                                           const ExactPoint& origin) {
  std::array<Exact, 3> height;
  for (std::size_t i = 0; i < 3; ++i) height[i] = dot(normal, face[i] - origin);
  std::vector<RationalPoint> points;
  for (std::size_t i = 0; i < 3; ++i) {
    if (height[i].is_zero()) points.push_back({face[i], Exact(1)});
    const std::size_t j = (i + 1) % 3;
    if (sign_of(height[i]) * sign_of(height[j]) >= 0) continue;
    // The mean of both ends, each with the distance of the other one as its weight.
    const Exact a = sign_of(height[j]) > 0 ? height[j] : -height[j],
                b = sign_of(height[i]) > 0 ? height[i] : -height[i];
    points.push_back({sum(scaled(face[i], a), scaled(face[j], b)), a + b});
  }
  return points;
}

/// Where the segment, which is none of length 0, meets another one in its plane: adds their fractions of it.
void add_meetings(const FaceCut& cut, const FaceCut& other, const ExactPoint& normal, std::vector<Fraction>& all) {
  // From the start of `other` to that of `cut`, and its steps, all times both w.
  const ExactPoint from = scaled(cut.q, other.w) - scaled(other.q, cut.w), step = scaled(cut.step, other.w),
                   other_step = scaled(other.step, cut.w);
  const ExactPoint to_other_side = cross(normal, other_step), to_own_side = cross(normal, step);
  const Exact start = dot(to_other_side, from), change = dot(to_other_side, step);
  const Exact begin = -dot(to_own_side, from), end = begin + dot(to_own_side, other_step);  // of `other`, from `cut`
  if (change.is_zero()) {
    if (!begin.is_zero()) return;
    const Exact length = dot(step, step), first = -dot(step, from), last = first + dot(step, other_step);
    for (const Exact& over : {first, last}) {
      const Fraction t{over, length};
      if (t.is_between_0_and_1()) all.push_back(t);
    }
    return;
  }
  if (sign_of(begin) * sign_of(end) > 0) return;
  const Fraction t = fraction(-start, change);
  if (t.is_between_0_and_1()) all.push_back(t);
}

}  // namespace

std::vector<FaceCut> cuts_of(const ExactCorners& face, const ExactPoint& normal, const std::vector<ExactCorners>& met) {
  std::vector<FaceCut> cuts;
  const auto add_borders = [&](const ExactCorners& of) {
    for (std::size_t i = 0; i < 3; ++i) cuts.push_back(segment({of[i], Exact(1)}, {of[(i + 1) % 3], Exact(1)}));
  };
  add_borders(face);
  for (const ExactCorners& other : met) {
    const std::vector<RationalPoint> points = points_in_plane(other, normal, face[0]);
    if (points.size() == 3) add_borders(other);
    if (points.size() == 2) cuts.push_back(segment(points[0], points[1]));
    if (points.size() == 1) cuts.push_back(segment(points[0], points[0]));
  }
  return cuts;
}

std::vector<RationalPoint> middles_of(const FaceCut& cut, const std::vector<FaceCut>& all, const ExactPoint& normal) {
  std::vector<Fraction> meetings;
  for (const FaceCut& other : all) {
    if (&other != &cut && overlap(cut.box, other.box)) add_meetings(cut, other, normal, meetings);
  }
  std::vector<RationalPoint> middles;
  for (const Fraction& t : middles_of(std::move(meetings))) middles.push_back(point_at(cut, t));
  return middles;
}

PointBeside point_in(const ExactCorners& face) {
  const ExactPoint up = normal_of(face), border = face[1] - face[0];
  return {{sum(face[0], face[1]), Exact(2)}, cross(up, border), up};
}

std::vector<RationalPoint> middles_between(const ExactPoint& a, const ExactPoint& b,
                                           const std::vector<ExactCorners>& met) {
  const FaceCut whole = segment({a, Exact(1)}, {b, Exact(1)});
  if (is_zero(whole.step)) return {{a, Exact(1)}};
  std::vector<Fraction> meetings;
  const auto add_plane = [&](const ExactPoint& normal, const ExactPoint& origin) {
    const Exact change = dot(normal, whole.step);
    if (change.is_zero()) return;
    const Fraction t = fraction(dot(normal, origin - a), change);
    if (t.is_between_0_and_1()) meetings.push_back(t);
  };
  for (const ExactCorners& face : met) {
    const ExactPoint normal = normal_of(face);
    add_plane(normal, face[0]);
    for (std::size_t i = 0; i < 3; ++i) add_plane(cross(normal, face[(i + 1) % 3] - face[i]), face[i]);
  }
  std::vector<RationalPoint> middles;
  for (const Fraction& t : middles_of(std::move(meetings))) middles.push_back(point_at(whole, t));
  return middles;
}

bool is_on(const RationalPoint& point, const ExactCorners& face) {
  const ExactPoint normal = normal_of(face);
  if (is_zero(normal)) return false;  // a closed surface has the point in another face, too
  const PointBeside beside{point, {}, {}};
  if (beside.side(normal, face[0], 1) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (beside.side(cross(normal, face[(i + 1) % 3] - face[i]), face[i], 1) < 0) return false;
  }
  return true;
}

}  // namespace touchstone::mesh
