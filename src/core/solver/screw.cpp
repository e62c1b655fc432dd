// Verdicts about motions of constant rate. On arcs whose corners are off by at most A and B, elements that stay farther
// than d + A + B from each other are farther than d on the true motion too, and elements within d - A - B are within d.
// For d = 0, a contact is proved by a crossing: the true V has different signs at two times, and everywhere between
// them the lines, or the line and the plane, meet inside the elements if they meet at all.
// SPDX-License-Identifier: MIT
#include <touchstone/screw.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <touchstone/error.hpp>

#include "geometry/frame.hpp"
#include "numbers/doubles/double_double.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"
#include "solver/screw_arcs.hpp"
#include "solver/validate.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

using solver::Interval;
using solver::ScrewArcs;
using Position = geometry::Vector<Interval>;

geometry::Frame<Position> frame_between(const CurvedQuery& query, const ScrewArcs& arcs, double from, double to) {
  std::array<Position, 4> x;
  for (std::size_t c = 0; c < 4; ++c) x[c] = arcs.position(c, from, to);
  return geometry::frame_of(query.kind, [&x](std::size_t i, std::size_t j) { return x[i] - x[j]; });
}

/// The sign of V on the true motion at a time; 0 when uncertain.
int sign_of_coplanarity(const CurvedQuery& query, const ScrewArcs& arcs, double time) {
  return geometry::coplanarity(frame_between(query, arcs, time, time)).sign();
}

/// Whether, at every time between two, V = 0 means contact.
bool meets_inside(const CurvedQuery& query, const ScrewArcs& arcs, double from, double to) {
  const bool edges = query.kind == Kind::edge_edge;
  const auto frame = frame_between(query, arcs, from, to);
  const auto n = geometry::normal(frame);
  for (std::size_t k = 0; k < 3; ++k) {
    const int sign = n[k].sign();
    if (sign == 0) continue;
    const auto oriented = [sign](const Interval& x) { return sign > 0 ? x : -x; };
    const Interval whole = oriented(n[k]);
    const Interval first = oriented(geometry::first_numerator(frame, k));
    const Interval second = oriented(geometry::second_numerator(query.kind, frame, k));
    if (!(first.low >= 0 && second.low >= 0)) continue;
    if (edges ? (whole - first).low >= 0 && (whole - second).low >= 0 : (whole - first - second).low >= 0) return true;
  }
  return false;
}

/// The end of a short range of times around `time`, in which the elements certainly pass through each other.
std::optional<double> proved_crossing(const CurvedQuery& query, const ScrewArcs& arcs, double time, double t_max) {
  if (query.kind != Kind::edge_edge && query.kind != Kind::vertex_face) return std::nullopt;
  for (double half = 0x1p-44; half < 0.1; half *= 4) {
    const double from = std::max(0.0, time - half), to = std::min(t_max, time + half);
    const int before = sign_of_coplanarity(query, arcs, from);
    if (before == 0 || sign_of_coplanarity(query, arcs, to) != -before) continue;
    return meets_inside(query, arcs, from, to) ? std::optional<double>(to) : std::nullopt;
  }
  return std::nullopt;
}

/// The query at rest in the pose at t = 0 or t = 1, where the motion of constant rate is the query's own.
bool touches_at_end(CurvedQuery query, const Separation& separation, bool last) {
  for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
    CurvedCorner& corner = query.corners[c];
    if (corner.motion == CurvedCorner::kOnCurve) {
      if (last) corner.points[0] = corner.points[static_cast<std::size_t>(corner.control_points) - 1];
      corner.control_points = 1;
      continue;
    }
    RigidMotion& motion = query.motions[static_cast<std::size_t>(corner.motion)];
    if (last) {
      motion.q0 = motion.q1;
      motion.p0 = motion.p1;
    }
    motion = {motion.q0, motion.q0, motion.p0, motion.p0};
  }
  return solver::answer(query, separation, Method::fast, 0, Wanted::contact).contact;
}

/// Where a corner always is along axis z; nothing if it may leave that height. A body that turns about z keeps it.
std::optional<numbers::DoubleDouble> height_of(const CurvedQuery& query, const CurvedCorner& corner) {
  const double z = corner.points[0].z;
  if (corner.motion == CurvedCorner::kOnCurve) {
    for (int i = 1; i < corner.control_points; ++i) {
      if (corner.points[static_cast<std::size_t>(i)].z != z) return std::nullopt;
    }
    return numbers::DoubleDouble{z, 0};
  }
  const RigidMotion& motion = query.motions[static_cast<std::size_t>(corner.motion)];
  if (motion.q0[1] != 0 || motion.q0[2] != 0 || motion.q1[1] != 0 || motion.q1[2] != 0) return std::nullopt;
  if (motion.p0.z != motion.p1.z) return std::nullopt;
  for (int i = 0; i + 2 < motion.control_points; ++i) {
    if (motion.inner[static_cast<std::size_t>(i)].z != motion.p0.z) return std::nullopt;
  }
  return numbers::two_sum(z, motion.p0.z);
}

/// A point and an edge that stay in one plane z = c, as two edges: the point's has it in its interior, and is along z.
/// So both touch at the same times, and these edges pass through each other where the point passes through the edge.
std::optional<CurvedQuery> drawn_out(const CurvedQuery& query) {
  if (query.kind != Kind::point_edge) return std::nullopt;
  const auto height = height_of(query, query.corners[0]);
  if (!height) return std::nullopt;
  double size = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const CurvedCorner& corner = query.corners[c];
    const auto other = height_of(query, corner);
    if (!other || other->high != height->high || other->low != height->low) return std::nullopt;
    const bool on_curve = corner.motion == CurvedCorner::kOnCurve;
    for (int i = 0; i < (on_curve ? corner.control_points : 1); ++i) {
      const Vec3& x = corner.points[static_cast<std::size_t>(i)];
      size = std::max({size, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
    }
  }
  const double half = size * 0x1p-10;  // little beside the corner's distance from the axis of the turn
  CurvedQuery edges = query;
  edges.kind = Kind::edge_edge;
  edges.corners = {query.corners[0], query.corners[0], query.corners[1], query.corners[2]};
  for (std::size_t i = 0; i < query.corners[0].points.size(); ++i) {
    const double z = query.corners[0].points[i].z;
    edges.corners[0].points[i].z = z - half;
    edges.corners[1].points[i].z = z + half;
  }
  const double z = query.corners[0].points[0].z;
  return z - half < z && z < z + half && std::isfinite(z + half) && std::isfinite(z - half) ? std::optional(edges)
                                                                                            : std::nullopt;
}

/// The verdict by so many arcs, when the elements have no contact at t = 0.
ScrewAnswer decide(const CurvedQuery& query, const ScrewOptions& options, int count) {
  const ScrewArcs arcs(query, count);
  const double distance = options.separation.distance;
  ScrewAnswer answer;
  answer.arcs = count;
  answer.free_until = answer.contact_by = options.t_max;
  const double first = arcs.deviation(0), second = arcs.deviation(1);
  answer.deviation = std::max(first, second);
  const double both = solver::rounded_up(first + second);
  const double outer = solver::rounded_up(distance + both), inner = solver::rounded_down(distance - both);
  if (!std::isfinite(outer)) {
    answer.free_until = 0;
    return answer;
  }
  bool free = true;
  const auto contact_by = [&](double time) {
    answer.verdict = ScrewVerdict::contact;
    answer.contact_by = std::min(time, options.t_max);
    answer.free_until = std::min(answer.free_until, answer.contact_by);
    return answer;
  };
  for (int i = 0; i < count && static_cast<double>(i) / count <= options.t_max; ++i) {
    const CurvedQuery arc = arcs.arc(i);
    const double limit = std::min(1.0, options.t_max * count - i);  // exact, or 1
    const auto time_of = [&](double local) { return (local + i) / count; };
    const Answer near = solver::answer(arc, {outer, options.separation.metric}, Method::fast, limit);
    if (!near.contact) continue;
    if (free) answer.free_until = std::max(0.0, solver::rounded_down(time_of(near.toi)));
    free = false;
    if (distance > 0) {
      if (inner <= 0) continue;
      const Answer within = solver::answer(arc, {inner, options.separation.metric}, Method::fast, limit);
      if (within.contact) return contact_by(solver::rounded_up(time_of(within.toi_upper)));
      continue;
    }
    const Answer touch = solver::answer(arc, Method::fast, limit);
    if (!touch.contact) continue;
    if (const auto end = proved_crossing(query, arcs, time_of(touch.toi), options.t_max)) return contact_by(*end);
  }
  if (free) {
    answer.verdict = ScrewVerdict::free;
  } else if (options.t_max == 1 && touches_at_end(query, options.separation, true)) {
    return contact_by(1);
  }
  return answer;
}

}  // namespace

template <>
Names names_of<ScrewVerdict>() noexcept {
  static constexpr std::string_view kNames[] = {"free", "contact", "within the bound"};
  return kNames;
}

ScrewAnswer solve_screw(const CurvedQuery& query, const ScrewOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(options.separation);
  solver::validate(query, options.t_max, solver::OriginPath::curved);
  solver::validate_arcs(options.arcs, options.most_arcs);
  if (touches_at_end(query, options.separation, false)) {
    ScrewAnswer answer;
    answer.verdict = ScrewVerdict::contact;
    return answer;
  }
  const auto edges = options.separation.distance == 0 ? drawn_out(query) : std::nullopt;
  for (int count = options.arcs;; count *= 2) {
    const ScrewAnswer answer = decide(edges ? *edges : query, options, count);
    if (answer.verdict != ScrewVerdict::within_bound || count >= options.most_arcs) return answer;
  }
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
