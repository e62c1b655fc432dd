// Interval arithmetic over time, after Redon, Kheddar and Coquillart 2002 (the idea; see curved_baseline.hpp).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "baselines/curved_baseline.hpp"
#include "baselines/curved_position.hpp"
#include "geometry/vector.hpp"

namespace touchstone::baselines {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// All numbers between two, but for rounding.
struct Interval {
  double low = 0;
  double high = 0;

  Interval() = default;
  explicit Interval(double x) : low(x), high(x) {}
  Interval(double from, double to) : low(from), high(to) {}
};

Interval everything() { return {-kInfinity, kInfinity}; }

/// Nothing is known where infinities gave no number.
Interval checked(double low, double high) {
  return std::isnan(low) || std::isnan(high) ? everything() : Interval(low, high);
}

Interval operator+(const Interval& a, const Interval& b) { return checked(a.low + b.low, a.high + b.high); }
Interval operator-(const Interval& a, const Interval& b) { return checked(a.low - b.high, a.high - b.low); }
Interval operator*(const Interval& a, const Interval& b) {
  const double ll = a.low * b.low, lh = a.low * b.high, hl = a.high * b.low, hh = a.high * b.high;
  if (std::isnan(ll + lh + hl + hh)) return everything();
  return {std::min({ll, lh, hl, hh}), std::max({ll, lh, hl, hh})};
}
Interval operator/(const Interval& a, const Interval& b) {
  if (!(b.low > 0)) return everything();
  return a * Interval(1 / b.high, 1 / b.low);
}
using baselines::square;

Interval square(const Interval& x) {
  const double low = x.low * x.low, high = x.high * x.high;
  if (x.low <= 0 && x.high >= 0) return {0, std::max(low, high)};
  return {std::min(low, high), std::max(low, high)};
}

using geometry::cross;
using geometry::dot;

/// The polynomials that decide, over numbers of type N. The meeting point's weights are first / normal and second /
/// normal: fractions of both edges, or of the face's second and third corner.
template <class N>
struct Meeting {
  N coplanarity, normal, first, second;
  bool edges;

  Meeting(const CurvedCorners& corners, const N& t) : edges(corners.query().kind == Kind::edge_edge) {
    const auto at = [&](std::size_t i) { return corners.at(i, t); };
    const auto c0 = at(0), c1 = at(1), c2 = at(2), c3 = at(3);
    const auto u = edges ? c1 - c0 : c2 - c1;
    const auto w = edges ? c3 - c2 : c3 - c1;
    const auto r = edges ? c2 - c0 : c0 - c1;
    const auto n = cross(u, w);
    coplanarity = dot(n, r);
    normal = (square(n[0]) + square(n[1])) + square(n[2]);
    first = dot(cross(r, w), n);
    second = edges ? dot(cross(r, u), n) : dot(cross(u, r), n);
  }
};

/// Whether interval arithmetic excludes that the elements touch.
bool excluded(const Meeting<Interval>& m) {
  if (m.coplanarity.low > 0 || m.coplanarity.high < 0) return true;
  if (m.first.high < 0 || m.second.high < 0) return true;
  if (!m.edges) return (m.normal - m.first - m.second).high < 0;
  return (m.normal - m.first).high < 0 || (m.normal - m.second).high < 0;
}

/// Whether the lines, or line and plane, meet within the slack of both elements at one time.
bool meets(const Meeting<double>& m) {
  if (!(m.normal > 0)) return false;
  const double first = m.first / m.normal, second = m.second / m.normal;
  constexpr double kLow = -kRedonSlack, kHigh = 1 + kRedonSlack;
  if (!(first >= kLow && second >= kLow)) return false;
  return m.edges ? first <= kHigh && second <= kHigh : first + second <= kHigh;
}

}  // namespace

Result solve_redon(const CurvedQuery& query, double t_max, double tolerance) {
  if (query.kind != Kind::edge_edge && query.kind != Kind::vertex_face) {
    throw InvalidQuery("redon takes no " + std::string(name_of(query.kind)) + " queries");
  }
  const CurvedCorners corners(query);
  std::vector<Interval> left{{0, t_max}};  // the earliest last
  for (int done = 0; !left.empty(); ++done) {
    const Interval times = left.back();
    left.pop_back();
    if (done == kRedonIntervals) return {true, times.low};
    if (excluded(Meeting<Interval>(corners, times))) continue;
    const double middle = 0.5 * (times.low + times.high);
    if (times.high - times.low > tolerance && middle > times.low && middle < times.high) {
      left.push_back({middle, times.high});
      left.push_back({times.low, middle});
    } else if (meets(Meeting<double>(corners, middle))) {
      return {true, times.low};
    }
  }
  return {};
}

}  // namespace touchstone::baselines
