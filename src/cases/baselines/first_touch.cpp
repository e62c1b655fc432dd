// SPDX-License-Identifier: MIT
#include "baselines/first_touch.hpp"

#include <algorithm>
#include <cmath>

#include "baselines/distance.hpp"

namespace touchstone::baselines {

using geometry::cross;
using geometry::dot;

namespace {

// Below this sine, squared, the projection along the common normal loses its digits; so does it where a length, squared
// and in the frame's unit, is less than this: an edge or a face that is flat for an instant.
constexpr double kFlat = 0x1p-80;

/// Where u and w span a plane, its normal; the projections divide by its squared length.
struct Normal {
  Vector n;
  double nn;
  bool flat;

  Normal(const Vector& u, const Vector& w) : n(cross(u, w)), nn(dot(n, n)) {
    const double uu = dot(u, u);
    const double ww = dot(w, w);
    flat = !(nn > kFlat * uu * ww && nn > kFlat * std::max(uu, ww));
  }
};

bool between(double f, double slack) { return f >= -slack && f <= 1 + slack; }

/// Whether the elements touch at t, a root of V for the kinds that have one.
bool touches(const Frame& frame, double t, double slack) {
  if (frame.kind == Kind::point_edge || frame.kind == Kind::point_point) return distance_at(frame, t) <= slack;
  const Vector u = frame.u.at(t);
  const Vector w = frame.w.at(t);
  const Vector r = frame.r.at(t);
  const Normal normal(u, w);
  if (normal.flat) return distance_at(frame, t) <= slack;
  const double f1 = dot(cross(r, w), normal.n) / normal.nn;
  if (frame.kind == Kind::edge_edge)
    return between(f1, slack) && between(dot(cross(r, u), normal.n) / normal.nn, slack);
  const double f2 = dot(cross(u, r), normal.n) / normal.nn;
  return f1 >= -slack && f2 >= -slack && f1 + f2 <= 1 + slack;
}

template <class N>
auto coplanarity(const Frame& frame) {
  return dot(cross(linear<N>(frame.u), linear<N>(frame.w)), linear<N>(frame.r));
}

/// The sizes of V's coefficients add up to at most this many times `frame.box`: six products of three components, each
/// of which is |start| + (|start| + |end|) in size.
constexpr double kSizes = 6 * 27;

class FirstTouchSearch {
 public:
  FirstTouchSearch(double t_max, RootFinder roots, double tolerance)
      : t_max_(t_max), roots_(roots), tolerance_(tolerance) {}

  void add_roots(const Cubic& p) { roots_(p, t_max_, tolerance_, times_); }
  void add_start() { times_.add(0.0); }

  /// When the point r is on the line of the edge from the origin to u; if it always is, when it passes one of its ends.
  void add_point_edge(const Motion& r, const Motion& u) {
    const auto collinear = cross(linear<double>(r), linear<double>(u));
    const auto sizes = cross(linear<Magnitude>(r), linear<Magnitude>(u));
    bool always = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Cubic component = cubic_of(collinear[k], sizes[k]);
      if (is_noise(component)) continue;
      always = false;
      add_roots(component);
    }
    if (always) {
      add_point_point(r);
      add_point_point(r - u);
    }
  }

  void add_point_point(const Motion& r) {
    const auto components = linear<double>(r);
    const auto sizes = linear<Magnitude>(r);
    for (std::size_t k = 0; k < 3; ++k) add_roots(cubic_of(components[k], sizes[k]));
  }

  Times& sorted() {
    std::sort(times_.begin(), times_.end());
    return times_;
  }

 private:
  double t_max_;
  RootFinder roots_;
  double tolerance_;
  Times times_;
};

/// While the elements stay coplanar they can only start to touch where a corner of one meets an edge of the other.
void add_coplanar_times(const Frame& frame, FirstTouchSearch& search) {
  const auto& [kind, u, w, r, exponent, box] = frame;
  search.add_start();
  search.add_point_edge(r, u);
  if (kind == Kind::edge_edge) {
    search.add_point_edge(r + w, u);
    search.add_point_edge(-r, w);
    search.add_point_edge(u - r, w);
  } else {
    search.add_point_edge(r, w);
    search.add_point_edge(r - u, w - u);
  }
}

}  // namespace

Result first_touch(const Query& query, double t_max, RootFinder roots, double tolerance, double slack) {
  const Frame frame = frame_of(query);
  FirstTouchSearch search(t_max, roots, tolerance);
  switch (frame.kind) {
    case Kind::edge_edge:
    case Kind::vertex_face: {
      const Polynomial<3> values = coplanarity<double>(frame);
      if (one_sided(values.c, kZero * kSizes * frame.box)) return {};
      const Cubic v = cubic_of(values, coplanarity<Magnitude>(frame));
      if (is_noise(v)) {
        add_coplanar_times(frame, search);
      } else {
        search.add_roots(v);
      }
      break;
    }
    case Kind::point_edge:
      search.add_start();
      search.add_point_edge(frame.r, frame.u);
      break;
    case Kind::point_point:
      search.add_start();
      search.add_point_point(frame.r);
      break;
  }
  for (const double t : search.sorted()) {
    if (touches(frame, t, slack)) return {true, t};
  }
  return {};
}

}  // namespace touchstone::baselines
