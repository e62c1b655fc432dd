// The distance's polynomials, of degree 6, 4 and 2, in plain doubles.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "baselines/distance.hpp"
#include "baselines/polynomial.hpp"
#include "baselines/separation_baseline.hpp"

namespace touchstone::baselines {

using geometry::cross;
using geometry::dot;

namespace {

// Slack of the inside tests, as a fraction of an element.
constexpr double kWeightSlack = 1e-9;

// A stationary value within this fraction of the sum of the coefficients' sizes is a double root.
constexpr double kDoubleRoot = 1e-15;

constexpr std::size_t kMost = 6;  // the largest degree

/// Roots in ascending order.
struct RootList {
  std::array<double, kMost + 2> t{};
  std::size_t count = 0;
  void add(double root) {
    if (count < t.size()) t[count++] = root;
  }
};

double value(const double* c, std::size_t degree, double t) {
  double sum = c[degree];
  for (std::size_t i = degree; i-- > 0;) sum = sum * t + c[i];
  return sum;
}

/// A change of sign between low and high, to the last bit.
double bisected(const double* c, std::size_t degree, double low, double high, bool positive_low) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) return high;
    ((value(c, degree, middle) > 0) == positive_low ? low : high) = middle;
  }
}

/// Between neighbouring roots of its derivative a polynomial has at most one root.
RootList roots_in(const double* c, std::size_t degree, double t_max) {
  RootList roots;
  if (degree == 0) return roots;
  std::array<double, kMost> derivative{};
  double size = 0;
  for (std::size_t i = 0; i <= degree; ++i) {
    size += std::fabs(c[i]);
    if (i > 0) derivative[i - 1] = static_cast<double>(i) * c[i];
  }
  RootList stationary = roots_in(derivative.data(), degree - 1, t_max);
  stationary.add(t_max);
  double low = 0;
  for (std::size_t i = 0; i < stationary.count; ++i) {
    const double high = stationary.t[i];
    const double at_low = value(c, degree, low), at_high = value(c, degree, high);
    if (std::fabs(at_high) <= kDoubleRoot * size) {
      roots.add(high);
    } else if ((at_low > 0) != (at_high > 0)) {
      roots.add(bisected(c, degree, low, high, at_low > 0));
    }
    low = high;
  }
  return roots;
}

using Linear = geometry::Vector<Polynomial<1>>;

bool inside(double numerator, double denominator) {
  const double f = numerator / denominator;
  return f >= -kWeightSlack && f <= 1 + kWeightSlack;
}

class FirstWithin {
 public:
  FirstWithin(double separation, double t_max) : squared_(separation * separation), t_max_(t_max), first_(t_max + 1) {}

  /// Calls holds(t) at the roots of p, and keeps the first one at which it holds.
  template <std::size_t D, class F>
  void add(const Polynomial<D>& p, const F& holds) {
    const RootList roots = roots_in(p.c.data(), D, t_max_);
    for (std::size_t i = 0; i < roots.count && roots.t[i] < first_; ++i) {
      if (holds(roots.t[i])) first_ = roots.t[i];
    }
  }

  void add_points(const Motion& r) {
    const Linear p = linear<double>(r);
    Polynomial<2> excess = dot(p, p);
    excess.c[0] -= squared_;
    add(excess, [](double) { return true; });
  }

  /// The point r and the edge from the origin to u.
  void add_point_edge(const Motion& r, const Motion& u) {
    const Linear p = linear<double>(r), e = linear<double>(u);
    const auto c = cross(e, p);
    add(dot(c, c) - scaled(dot(e, e)), [&](double t) {
      const Vector ut = u.at(t);
      return inside(dot(r.at(t), ut), dot(ut, ut));
    });
  }

  /// The interiors of two edges, or a point and the interior of a face.
  void add_interiors(const Frame& frame) {
    const auto n = cross(linear<double>(frame.u), linear<double>(frame.w));
    const auto height = dot(n, linear<double>(frame.r));
    add(height * height - scaled(dot(n, n)), [&](double t) {
      const Vector u = frame.u.at(t), w = frame.w.at(t), r = frame.r.at(t);
      const Vector normal = cross(u, w);
      const double nn = dot(normal, normal);
      const double f1 = dot(cross(r, w), normal);
      if (frame.kind == Kind::edge_edge) return inside(f1, nn) && inside(dot(cross(r, u), normal), nn);
      const double f2 = dot(cross(u, r), normal);
      return inside(f1, nn) && inside(f2, nn) && inside(f1 + f2, nn);
    });
  }

  Result result() const { return first_ <= t_max_ ? Result{true, first_} : Result{}; }

 private:
  /// d^2 times p, of a formal degree greater by 2.
  template <std::size_t D>
  Polynomial<D + 2> scaled(const Polynomial<D>& p) const {
    Polynomial<D + 2> product;
    for (std::size_t i = 0; i <= D; ++i) product.c[i] = squared_ * p.c[i];
    return product;
  }

  double squared_;
  double t_max_;
  double first_;
};

}  // namespace

Result solve_thick_polynomial(const Query& query, double separation, double t_max, double) {
  const Frame frame = frame_of(query);
  const double apart = std::scalbn(separation, -frame.exponent);
  if (distance_at(frame, 0) <= apart) return {true, 0};
  const auto& [kind, u, w, r, exponent, box] = frame;
  FirstWithin search(apart, t_max);
  search.add_points(r);
  switch (kind) {
    case Kind::edge_edge:
      search.add_points(r + w);
      search.add_points(r - u);
      search.add_points(r + w - u);
      search.add_point_edge(r, u);
      search.add_point_edge(r + w, u);
      search.add_point_edge(-r, w);
      search.add_point_edge(u - r, w);
      search.add_interiors(frame);
      break;
    case Kind::vertex_face:
      search.add_points(r - u);
      search.add_points(r - w);
      search.add_point_edge(r, u);
      search.add_point_edge(r, w);
      search.add_point_edge(r - u, w - u);
      search.add_interiors(frame);
      break;
    case Kind::point_edge:
      search.add_points(r - u);
      search.add_point_edge(r, u);
      break;
    case Kind::point_point: break;
  }
  return search.result();
}

}  // namespace touchstone::baselines
