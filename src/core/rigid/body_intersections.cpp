// Bodies at rest. The points of an edge are the places of a vertex that moves from its first corner to its second one,
// so the solver decides whether it meets a face, exactly: in poses, corners are fractions.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <touchstone/bodies.hpp>
#include <touchstone/solve.hpp>

#include "geometry/kind_traits.hpp"
#include "mesh/candidates.hpp"
#include "mesh/inside_surfaces/ray_passes.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/integers/exact_number.hpp"
#include "rigid/body_search.hpp"
#include "rigid/near_elements.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::rigid {
namespace {

using mesh::ExactPoint;
using numbers::Exact;

/// A pose: x = (M X) / n + p, n = |q|^2, exactly.
struct ExactPose {
  explicit ExactPose(const Pose& pose) : p(mesh::exact(pose.position)) {
    const auto& q = pose.orientation;
    const Exact w(q[0]), x(q[1]), y(q[2]), z(q[3]), two(2);
    n = w * w + x * x + y * y + z * z;
    m = {{{{w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)}},
          {{two * (x * y + w * z), w * w + y * y - x * x - z * z, two * (y * z - w * x)}},
          {{two * (x * z - w * y), two * (y * z + w * x), w * w + z * z - x * x - y * y}}}};
  }

  /// n times the place of a point.
  ExactPoint position(const Vec3& point) const {
    const ExactPoint x = mesh::exact(point);
    return ExactPoint{{dot(m[0], x), dot(m[1], x), dot(m[2], x)}} + n * p;
  }

  /// The point of the body at the place `at` / scale, times n * scale.
  ExactPoint point_at(const ExactPoint& at, const Exact& scale) const {
    const ExactPoint v = at - scale * p;
    const auto along = [&](std::size_t k) { return m[0][k] * v[0] + m[1][k] * v[1] + m[2][k] * v[2]; };
    return {{along(0), along(1), along(2)}};
  }

  std::array<ExactPoint, 3> m;  ///< rows
  Exact n;
  ExactPoint p;
};

Fraction fraction_of(const Exact& numerator, const Exact& denominator) {
  const std::string text = numbers::quotient_to_string(numerator, denominator);
  const std::size_t bar = text.find('/');
  if (bar == std::string::npos) return {text, "1"};
  return {text.substr(0, bar), text.substr(bar + 1)};
}

std::array<Fraction, 3> position_in(const ExactPose& pose, const Vec3& point) {
  const ExactPoint at = pose.position(point);
  return {fraction_of(at[0], pose.n), fraction_of(at[1], pose.n), fraction_of(at[2], pose.n)};
}

/// How two elements meet, if they do.
std::optional<IntersectionSort> meeting_of(const Bodies& bodies, const std::vector<ExactPose>& poses,
                                           const NearElements& near) {
  const auto corners = [&](MeshElement sort, const BodyElement& of) {
    const Body::Impl& body = bodies.bodies[of.body].impl();
    const Index* const numbers = geometry::corners_of(sort, of.element, body.mesh.edges(), body.mesh.faces());
    std::vector<std::array<Fraction, 3>> positions;
    for (std::size_t c = 0; c <= static_cast<std::size_t>(sort); ++c) {
      positions.push_back(position_in(poses[of.body], body.points[numbers[c]]));
    }
    return positions;
  };
  const auto first = corners(near.first_sort, near.first), second = corners(near.second_sort, near.second);
  RationalQuery query;
  query.kind = near.second_sort == MeshElement::face   ? Kind::vertex_face
               : near.second_sort == MeshElement::edge ? Kind::point_edge
                                                       : Kind::point_point;
  query.start[0] = first.front();
  query.end[0] = first.back();
  for (std::size_t c = 0; c < second.size(); ++c) query.start[1 + c] = query.end[1 + c] = second[c];
  const Answer answer = solve(query);
  if (!answer.contact) return std::nullopt;
  if (near.first_sort != MeshElement::edge || !(answer.toi_upper > 0 && answer.toi < 1)) {
    return IntersectionSort::touches;
  }
  const bool inside_second = near.second_sort == MeshElement::face
                                 ? answer.feature_b == Feature::f && answer.nature == Nature::crossing
                                 : answer.feature_b == Feature::e && answer.nature == Nature::isolated;
  return inside_second ? IntersectionSort::pierces : IntersectionSort::touches;
}

/// The pieces of a body that meet another one.
std::vector<char> meeting_pieces(const Body::Impl& body, BodyIndex number, const std::vector<BodyIntersection>& all) {
  std::vector<char> meet(body.pieces().size(), 0);
  const auto mark = [&](MeshElement sort, const BodyElement& of) {
    if (of.body != number) return;
    for (const Index piece : body.pieces().of(sort, of.element)) meet[piece] = 1;
  };
  for (const BodyIntersection& one : all) {
    mark(one.first_element, one.first);
    mark(one.second_element, one.second);
  }
  return meet;
}

/// What is around a point that no surface of a body holds.
struct Around {
  std::optional<Index> face;  ///< the least one of the least closed surface, if it is inside these
  bool cancels = false;       ///< closed surfaces are around it, and their winding numbers add up to 0
  bool in_open = false;       ///< it is in the box around all open surfaces of the body
};

Around surfaces_around(const Body::Impl& body, const ExactPoint& point, const Exact& scale) {
  std::array<double, 3> at, room;
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = numbers::approximate_quotient(point[k], scale);  // within 2^-50 of it, relatively, or an underflow
    room[k] = std::fabs(at[k]) * 0x1p-49 + 0x1p-1070;
  }
  const auto may_hold = [&](const Box& box, std::size_t k) {
    return at[k] + room[k] >= box.low[k] && at[k] - room[k] <= box.high[k];
  };
  const auto is_in = [&](const Box& box) { return may_hold(box, 0) && may_hold(box, 1) && may_hold(box, 2); };
  Around around;
  if (!is_in(body.box)) return around;
  const mesh::Pieces& pieces = body.pieces();
  std::vector<int> passes(pieces.size(), 0), odd(pieces.size(), 0);
  const auto& faces = body.mesh.faces();
  for (Index f = 0; f < faces.size(); ++f) {
    const Index piece = pieces.of_face(f);
    if (!pieces[piece].is_closed()) continue;
    const std::array<Vec3, 3> corners{body.points[faces[f][0]], body.points[faces[f][1]], body.points[faces[f][2]]};
    Box box = broad_phase::empty_box();
    for (const Vec3& corner : corners) broad_phase::extend(box, corner);
    if (at[0] - room[0] > box.high[0] || !may_hold(box, 1) || !may_hold(box, 2)) continue;  // the ray misses it
    const int pass = mesh::passes(point, scale, corners);
    passes[piece] += pass;
    odd[piece] ^= pass & 1;
  }
  int winding = 0;
  Box open = broad_phase::empty_box();  // one box: open surfaces enclose something together, as unjoined faces do
  for (Index piece = 0; piece < pieces.size(); ++piece) {
    if (pieces[piece].sort == mesh::PieceSort::open) {
      broad_phase::extend(open, {pieces[piece].box.low[0], pieces[piece].box.low[1], pieces[piece].box.low[2]});
      broad_phase::extend(open, {pieces[piece].box.high[0], pieces[piece].box.high[1], pieces[piece].box.high[2]});
    }
    const bool is_even = pieces[piece].sort == mesh::PieceSort::even;
    if (is_even ? odd[piece] == 0 : passes[piece] == 0) continue;
    winding += is_even ? 1 : passes[piece];
    if (!around.face) around.face = pieces[piece].least;
  }
  around.in_open = is_in(open);
  around.cancels = around.face && winding == 0;
  if (winding == 0) around.face.reset();
  return around;
}

/// Adds what lies inside closed surfaces of the other body, and meets no element of it.
void add_inside(const Bodies& bodies, const std::vector<ExactPose>& poses, BodyIndex inner, BodyIndex outer,
                std::vector<BodyIntersection>& all, BodiesLeftOut& left_out) {
  const Body::Impl &body = bodies.bodies[inner].impl(), &other = bodies.bodies[outer].impl();
  if (other.mesh.faces().empty()) return;
  const mesh::Pieces& pieces = body.pieces();
  const std::vector<char> meet = meeting_pieces(body, inner, all);
  for (Index piece = 0; piece < pieces.size(); ++piece) {
    if (meet[piece] != 0) continue;
    const Index vertex = pieces[piece].vertex;
    const ExactPose &pose = poses[inner], &around = poses[outer];
    const ExactPoint point = around.point_at(pose.position(body.points[vertex]), pose.n);
    const Around found = surfaces_around(other, point, around.n * pose.n);
    if (found.face) {
      all.push_back(
          {MeshElement::vertex, {inner, vertex}, MeshElement::face, {outer, *found.face}, IntersectionSort::inside});
    } else {
      left_out.cancelled += found.cancels ? 1 : 0;
      left_out.in_open += found.in_open ? 1 : 0;
    }
  }
}

}  // namespace

std::vector<BodyIntersection> find_intersections(const Bodies& bodies, const CollidingBodies& colliding,
                                                 const std::vector<Pose>& poses, const MeshOptions& options,
                                                 BodiesLeftOut* left_out) {
  const std::vector<RigidMotion> motions = resting(poses);
  Bodies touching;  // separations and radii do not count
  touching.bodies = bodies.bodies;
  const std::vector<Arc> arcs = arcs_of(bodies, motions, 0, 0);
  const BodyPairs near = near_bodies(touching, colliding, arcs);
  std::vector<ExactPose> exact;
  for (const Pose& pose : poses) exact.emplace_back(pose);
  std::vector<BodyIntersection> all;
  std::mutex lock;
  threads::for_each_range(near.size(), 1, options.threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto [a, b] = near[i];
      std::vector<BodyIntersection> found;
      const NearConsumer take = [&](const NearElements& elements) {
        mesh::check_stop(options.stop);
        if (const auto sort = meeting_of(bodies, exact, elements)) {
          found.push_back({elements.first_sort, elements.first, elements.second_sort, elements.second, *sort});
        }
      };
      for_each_near_at_rest({a, bodies.bodies[a].impl(), arcs[a]}, {b, bodies.bodies[b].impl(), arcs[b]}, take);
      BodiesLeftOut some;
      add_inside(bodies, exact, a, b, found, some);
      add_inside(bodies, exact, b, a, found, some);
      const std::lock_guard<std::mutex> guard(lock);
      if (left_out != nullptr) {
        left_out->in_open += some.in_open;
        left_out->cancelled += some.cancelled;
      }
      all.insert(all.end(), found.begin(), found.end());
    }
  });
  if (left_out != nullptr) left_out->excluded = colliding.excluded();
  std::sort(all.begin(), all.end(), [](const BodyIntersection& a, const BodyIntersection& b) {
    return std::tie(a.first_element, a.second_element, a.first, a.second) <
           std::tie(b.first_element, b.second_element, b.first, b.second);
  });
  return all;
}

}  // namespace touchstone::rigid

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

std::vector<BodyIntersection> intersections(const Bodies& bodies, const std::vector<Pose>& poses,
                                            const MeshOptions& options, BodiesLeftOut* left_out) {
  const numbers::DefaultFloatEnvironment environment;
  const rigid::CollidingBodies colliding(bodies);
  rigid::validate(bodies, rigid::resting(poses), options.threads);
  if (left_out != nullptr) *left_out = {};
  return rigid::find_intersections(bodies, colliding, poses, options, left_out);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
