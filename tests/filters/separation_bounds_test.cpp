// The bounds of the filters for separations under search, one by one. Most answers are far from them, so a wrong one
// would seldom show in an answer.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>
#include <limits>

#include "filters/apart/same_side.hpp"
#include "filters/apart/separating_direction.hpp"
#include "filters/frame_case.hpp"
#include "filters/separation/closest_near.hpp"
#include "filters/separation/entry_walk.hpp"
#include "filters/separation/precise_closest.hpp"
#include "filters/separation/straight_differences.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using filters::kUnit;
using ExactVector = std::array<Exact, 3>;

Exact dot(const ExactVector& a, const ExactVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
ExactVector exactly(const filters::Vector& v) { return {Exact(v[0]), Exact(v[1]), Exact(v[2])}; }
Exact absolute(const Exact& x) { return x.sign() < 0 ? -x : x; }
Exact least(const Exact& a, const Exact& b) { return b < a ? b : a; }

double value_of(const Exact& x) { return numbers::approximate_quotient(x, Exact(1)); }

/// The square root of a number that is not negative, within a relative error of about 2^-100.
Exact root_of(const Exact& square) {
  if (square.sign() == 0) return Exact(0);
  const double estimate = std::sqrt(value_of(square));
  const double correction = value_of(square - Exact(estimate) * Exact(estimate)) / (2 * estimate);
  return Exact(estimate) + Exact(correction);
}

/// The Euclidean norm, or the sum of the absolute coordinates.
Exact norm_of(const ExactVector& v, Metric metric) {
  return metric == Metric::euclidean ? root_of(dot(v, v)) : absolute(v[0]) + absolute(v[1]) + absolute(v[2]);
}

/// The largest distance of which `holds` says true; about 0 when there is none.
template <class Holds>
double largest_distance(const Holds& holds) {
  std::uint64_t low = 0, high = 0x7FE0000000000000u;  // the bits of doubles that are not negative are in their order
  const auto at = [](std::uint64_t bits) {
    double x = 0;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  };
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (holds(at(middle)) ? low : high) = middle;
  }
  return at(low);
}

bool frame_in_range(const FrameCase& s) {
  const double uw = s.size.u * s.size.w;
  return uw >= filters::kLeastNormProduct && uw <= filters::kGreatestNormProduct &&
         uw * s.size.r >= filters::kLeastVolume && uw * s.size.r <= filters::kGreatestVolume;
}

/// Elements that keep their shape: V and n stay as they are, and every test on them is as sharp as it can be.
FrameCase still(std::vector<double> x) {
  std::copy_n(x.begin(), 12, x.begin() + 12);
  return FrameCase(x);
}

/// r, u and w of the entry filter at a time.
struct ExactPlace {
  ExactVector r, u, w;

  ExactPlace(const Query& query, double t) {
    const filters::Differences d = filters::differences_of(query.kind);
    const auto vector = [&](const filters::Difference& difference) {
      ExactVector v;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto coordinate_at = [&](std::size_t corner) {
          const Exact from(coordinate(query.start[corner], k)), to(coordinate(query.end[corner], k));
          return from + Exact(t) * (to - from);
        };
        v[k] = coordinate_at(difference.one) - coordinate_at(difference.other);
      }
      return v;
    };
    r = vector(d.r);
    u = vector(d.u);
    w = vector(d.w);
  }

  /// The least value of a function that is linear in r - s u - q w, over the pairs of corners of two edges.
  template <class Linear>
  static Exact least_at_corners(const Linear& of) {
    const Exact none = of(0, 0);
    return least(least(none, of(1, 0)), least(of(0, 1), of(1, 1)));
  }
  Exact along(const ExactVector& n, int s, int q) const {
    return dot(n, r) - Exact(s) * dot(n, u) - Exact(q) * dot(n, w);
  }
};

/// A number and its derivative.
struct Moving {
  Exact value, slope;
};
Moving operator+(const Moving& a, const Moving& b) { return {a.value + b.value, a.slope + b.slope}; }
Moving operator-(const Moving& a, const Moving& b) { return {a.value - b.value, a.slope - b.slope}; }
Moving operator*(const Moving& a, const Moving& b) {
  return {a.value * b.value, a.value * b.slope + a.slope * b.value};
}
using MovingVector = std::array<Moving, 3>;
Moving dot(const MovingVector& a, const MovingVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The closest points of two edges of which `free` parameters are free, by Cramer's rule.
struct ExactClosest {
  Moving gap, measure;  ///< the squared distance is gap / measure
  Exact s, q;           ///< times the measure

  ExactClosest(const FrameCase& of, filters::Free free, const filters::Parameters& p, const Exact& t) {
    const ExactPlace start(of.query, 0), end(of.query, 1);
    const auto moving = [&t](const ExactVector& from, const ExactVector& to) {
      MovingVector v;
      for (std::size_t k = 0; k < 3; ++k) v[k] = {from[k] + t * (to[k] - from[k]), to[k] - from[k]};
      return v;
    };
    const auto minus = [](MovingVector a, const MovingVector& b) {
      for (std::size_t k = 0; k < 3; ++k) a[k] = a[k] - b[k];
      return a;
    };
    const MovingVector u = moving(start.u, end.u), w = moving(start.w, end.w);
    MovingVector c = moving(start.r, end.r);
    const bool s_free = free == filters::Free::s || free == filters::Free::both;
    const bool q_free = free == filters::Free::q || free == filters::Free::both;
    if (!s_free && p.s == 1) c = minus(c, u);
    if (!q_free && p.q == 1) c = minus(c, w);
    const Moving uu = dot(u, u), ww = dot(w, w), uw = dot(u, w), cu = dot(c, u), cw = dot(c, w), cc = dot(c, c);
    const Moving one = {Exact(1), Exact(0)};
    measure = s_free && q_free ? uu * ww - uw * uw : s_free ? uu : q_free ? ww : one;
    const Moving s_times = s_free && q_free ? cu * ww - cw * uw : cu,
                 q_times = s_free && q_free ? cw * uu - cu * uw : cw;
    s = s_free ? s_times.value : Exact(p.s) * measure.value;
    q = q_free ? q_times.value : Exact(p.q) * measure.value;
    gap = cc * measure;
    if (s_free) gap = gap - cu * s_times;
    if (q_free) gap = gap - cw * q_times;
  }
};

}  // namespace

TEST_CASE("the greatest norm of n is within its bound", "[separation]") {
  const auto ratio = [](const FrameCase& s, Metric metric) {
    const auto n = filters::normal_coefficients(s.frame);
    const double greatest =
        metric == Metric::euclidean ? filters::greatest_norm<true>(n) : filters::greatest_norm<false>(n);
    const double bound = (filters::kNormFactor - 1) * greatest + filters::kNormBound * s.size.u * s.size.w;
    double worst = 0;
    for (int j = 0; j < 3; ++j) {
      ExactVector exact;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto cross = [k](const ExactVector& a, const ExactVector& b) {
          const std::size_t i = (k + 1) % 3, l = (k + 2) % 3;
          return a[i] * b[l] - a[l] * b[i];
        };
        exact[k] = j == 0   ? cross(s.start[0], s.start[1])
                   : j == 2 ? cross(s.end[0], s.end[1])
                            : Exact(0.5) * (cross(s.start[0], s.end[1]) + cross(s.end[0], s.start[1]));
      }
      const Exact beyond = norm_of(exact, metric) - Exact(greatest);
      if (beyond.sign() > 0) worst = std::max(worst, over(beyond, bound));
    }
    return worst;
  };
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    report("norm", searched(91, 0, 20000, frame_in_range,
                            [&](const FrameCase& s, const std::vector<double>&) { return ratio(s, metric); }));
  }
}

TEST_CASE("clearance of the largest distance that it proves is true", "[separation]") {
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const auto search = searched(92, 0, 6000, frame_in_range, [&](const FrameCase&, const std::vector<double>& x) {
      const FrameCase s = still(x);
      const double distance = largest_distance([&](double d) {
        return filters::clear_all_along(s.query, {d, metric});
      });
      if (distance == 0) return std::nan("");
      ExactVector n;
      for (std::size_t k = 0; k < 3; ++k) n[k] = s.cross(0, 1, k, Exact(0));
      const Exact kept = Exact(distance) * norm_of(n, metric);
      const double uwr = s.size.u * s.size.w * s.size.r;
      const double margin = filters::kEndsBound * uwr + 16 * kUnit * value_of(kept) +
                            distance * filters::kNormBound * s.size.u * s.size.w;
      // 0 where no rounding was lost, 1 where V is as small as d |n|.
      return 1 - value_of(absolute(s.exact[0]) - kept) / margin;
    });
    // The margin has two parts, which the searches for V's coefficients and for the norm bring near theirs one by one.
    report("clearance", search, 0x1p-6);
  }
}

TEST_CASE("a direction separates by the largest distance that it proves", "[separation]") {
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const auto search = searched(93, 3, 6000, frame_in_range, [&](const FrameCase&, const std::vector<double>& x) {
      const FrameCase s = still(x);
      const filters::Vector n = {{x[24], x[25], x[26]}};
      const filters::RelativeCorners corners = filters::relative_corners(s.query);
      const double distance = largest_distance([&](double d) {
        return filters::separates_by(corners, n, {d, metric});
      });
      if (distance == 0) return std::nan("");
      const ExactPlace place(s.query, 0);
      const ExactVector direction = exactly(n);
      const auto along = [&](int sign) {
        return ExactPlace::least_at_corners([&](int i, int j) { return Exact(sign) * place.along(direction, i, j); });
      };
      const Exact up = along(1), down = along(-1);
      const Exact gap = up < down ? down : up;
      const Exact kept = Exact(distance) * norm_of(direction, metric);
      const filters::Gap found = filters::gap_along(corners, n);
      const double margin = found.error + 8 * kUnit * (found.error + value_of(kept));
      return 1 - value_of(gap - kept) / margin;
    });
    report("separating direction", search);
  }
}

TEST_CASE("the least product with a direction, at a time, is within its bound", "[separation]") {
  report("walk", searched(94, 4, 20000, frame_in_range, [](const FrameCase& s, const std::vector<double>& x) {
           const filters::Vector n = {{x[24], x[25], x[26]}};
           const double t = share(x[27]);
           const filters::Step step(s.query);
           const filters::Direction direction(step, n, {1, Metric::euclidean});
           const ExactPlace place(s.query, t);
           const Exact truth =
               ExactPlace::least_at_corners([&](int i, int j) { return place.along(exactly(n), i, j); });
           return over(Exact(direction.least_at(t)) - truth, filters::kWalkError * filters::largest_of(n) * step.size);
         }));
}

TEST_CASE("a direction keeps the largest distance that it is clear of", "[separation]") {
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const auto search =
        searched(95, 4, 4000, frame_in_range, [metric](const FrameCase& s, const std::vector<double>& x) {
          const filters::Vector n = {{x[24], x[25], x[26]}};
          const double t = share(x[27]);
          const filters::Step step(s.query);
          const double distance = largest_distance([&](double d) {
            return filters::Direction(step, n, {d, metric}).clear_at(t);
          });
          if (distance == 0) return std::nan("");
          const ExactPlace place(s.query, t);
          const Exact truth = ExactPlace::least_at_corners([&](int i, int j) { return place.along(exactly(n), i, j); });
          const Exact kept = Exact(distance) * norm_of(exactly(n), metric);
          const double margin = filters::kWalkError * filters::largest_of(n) * step.size + 8 * kUnit * value_of(kept);
          return 1 - value_of(truth - kept) / margin;
        });
    report("walk with a distance", search);
  }
}

TEST_CASE("the middle coefficient of a direction that turns is within its bound", "[separation][slow]") {
  const auto closest_place = [](const filters::Step& step, double t) {
    filters::StepAt place = filters::bare_iterate(step, t);
    const auto [p, q] = filters::closest(step.domain, place.r, place.u, place.w);
    place.n = filters::combined(place.r, place.u, place.w, p, q);
    return place;
  };
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const auto search = searched(96, 2, 30000, frame_in_range, [&](const FrameCase& s, const std::vector<double>& x) {
      const double times[2] = {share(x[24]), share(x[25])};
      const filters::Step step(s.query);
      const filters::StepAt a = closest_place(step, times[0]), b = closest_place(step, times[1]);
      const ExactPlace at_a(s.query, times[0]), at_b(s.query, times[1]);
      const ExactVector na = exactly(a.n), nb = exactly(b.n);
      const Exact truth =
          ExactPlace::least_at_corners([&](int i, int j) { return at_b.along(na, i, j) + at_a.along(nb, i, j); });
      const double distance = largest_distance([&](double d) { return filters::turns_clear(step, a, b, {d, metric}); });
      if (distance == 0) return std::nan("");
      const Exact kept = Exact(distance) * (norm_of(na, metric) + norm_of(nb, metric));
      const double margin = filters::kTurnError * (filters::largest_of(a.n) + filters::largest_of(b.n)) * step.size +
                            8 * kUnit * value_of(kept);
      return 1 - value_of(truth - kept) / margin;
    });
    report("turn", search, 0.09);
  }
}

TEST_CASE("the closest points in double-doubles are within their error", "[separation]") {
  for (const bool of_excess : {true, false}) {
    const auto ratio = [of_excess](const FrameCase& s, const std::vector<double>& x) {
      const filters::Step step(s.query);
      const double t = share(x[24]);
      const filters::StepAt place = filters::bare_iterate(step, t);
      filters::Parameters p = filters::closest(step.domain, place.r, place.u, place.w);
      const filters::Vector about = filters::combined(place.r, place.u, place.w, p.s, p.q);
      // The excess is near 0 where its error counts, and hints are off by more than doubles are.
      const double distance = std::sqrt(geometry::dot(about, about));
      const auto hint_near = [](double y, double change) {
        return y > 0 && y < 1 ? std::clamp(y + std::ldexp(share(change) - 0.5, -20), 0.0, 1.0) : y;
      };
      p = {hint_near(p.s, x[25]), hint_near(p.q, x[26])};
      if (!filters::of_ordinary_size(step, distance)) return std::nan("");
      const filters::PreciseStep precise(s.query);
      const auto found = filters::precise_closest(step, precise, distance, t, p);
      if (!found.ok) return std::nan("");
      const Exact s_exact = Exact(found.p.s) + Exact(found.ds), q_exact = Exact(found.p.q) + Exact(found.dq);
      const ExactPlace exact(s.query, t);
      Exact error;
      if (of_excess) {
        ExactVector c;
        for (std::size_t k = 0; k < 3; ++k) c[k] = exact.r[k] - s_exact * exact.u[k] - q_exact * exact.w[k];
        error = Exact(found.excess) - (dot(c, c) - Exact(distance) * Exact(distance));
      } else {
        // The direction is c as it is computed.
        const auto u = filters::at(precise.u, t), w = filters::at(precise.w, t);
        auto c = filters::minus(filters::minus(filters::at(precise.r, t), p.s, u), p.q, w);
        c = filters::minus(filters::minus(c, found.ds, u), found.dq, w);
        ExactVector n;
        for (std::size_t k = 0; k < 3; ++k) n[k] = Exact(c[k].high) + Exact(c[k].low);
        error = Exact(found.lowest) - ExactPlace::least_at_corners([&](int i, int j) {
                  return (s_exact - Exact(i)) * dot(n, exact.u) + (q_exact - Exact(j)) * dot(n, exact.w);
                });
        if (error.sign() < 0) return 0.0;
      }
      if (found.error == 0) return error.sign() == 0 ? 0.0 : std::numeric_limits<double>::infinity();
      return over(error, found.error);
    };
    auto search = searched(97, 3, 60000, frame_in_range, ratio);
    // Squares of such numbers have low parts that are no doubles, and the filter must keep its hands off.
    Rng rng(98);
    search_bound(search, rng, 27, -492, 0, 4, 200,
                 [&](const std::vector<double>& x) { return ratio(FrameCase(x), x); });
    report(of_excess ? "excess of the closest points" : "least product with their difference", search,
           of_excess ? 0x1p-8 : 0x1p-11);
  }
}

TEST_CASE("differences of moving points near a time are within their bounds", "[separation]") {
  const double radius = 0x1p-36;
  const auto ratio = [radius](const FrameCase& s, const std::vector<double>& x) {
    const filters::Step step(s.query);
    const double t = share(x[24]), other = t + radius * (2 * share(x[25]) - 1);
    const filters::StraightDifferences<filters::Jet> around = filters::differences_near(step, t, radius);
    const ExactPlace start(s.query, 0), end(s.query, 1);
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Exact slope = end.u[k] - start.u[k];
      const Exact value = start.u[k] + (Exact(t) + Exact(other - t)) * slope;
      worst =
          std::max({worst, over(value - Exact(around.u[k].value.value), numbers::kBoundSlack * around.u[k].value.error),
                    over(slope - Exact(around.u[k].slope.value), numbers::kBoundSlack * around.u[k].slope.error)});
    }
    return worst;
  };
  report("near differences", searched(99, 2, 20000, frame_in_range, ratio));
}

TEST_CASE("differences of moving points at an inexact time are within their bounds", "[separation]") {
  const auto ratio = [](const FrameCase& s, const std::vector<double>& x) {
    const filters::PreciseStep step(s.query);
    const double high = share(x[24]), low = std::ldexp(share(x[25]) - 0.5, -53) * high;
    const double off = std::ldexp(share(x[26]), -110);
    const auto at = filters::differences_at(step, {numbers::two_sum(high, low), off});
    const Exact time = Exact(high) + Exact(low) + Exact(off) * Exact(2 * share(x[27]) - 1);
    const ExactPlace start(s.query, 0), end(s.query, 1);
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Exact value = start.u[k] + time * (end.u[k] - start.u[k]);
      const Exact found = Exact(at.u[k].value.high) + Exact(at.u[k].value.low);
      worst = std::max(worst, over(value - found, numbers::kBoundSlack * at.u[k].error));
    }
    return worst;
  };
  report("precise differences", searched(100, 4, 20000, frame_in_range, ratio), 0x1p-3);
}

TEST_CASE("the closest points soon after a time are within their bounds", "[separation]") {
  for (const bool of_fall : {true, false}) {
    const auto ratio = [of_fall](const FrameCase& s, const std::vector<double>& x) {
      const filters::Step step(s.query);
      const double t = share(x[24]);
      const filters::StepAt place = filters::bare_iterate(step, t);
      const filters::Parameters p = filters::closest(step.domain, place.r, place.u, place.w);
      const filters::Vector about = filters::combined(place.r, place.u, place.w, p.s, p.q);
      const double distance = std::sqrt(geometry::dot(about, about));
      if (!filters::of_ordinary_size(step, distance)) return std::nan("");
      const filters::PreciseStep precise(s.query);
      const filters::PreciseClosest found = filters::precise_closest(step, precise, distance, t, p);
      if (!found.ok) return std::nan("");
      const double h = std::ldexp(share(x[25]), of_fall ? -30 : -50), later = h * share(x[26]);
      const filters::ClosestNear near(step, found, h);
      if (!near.certain()) return std::nan("");
      const ExactClosest closest(s, filters::free_parameters(step.domain, p), p, Exact(t) + Exact(later));
      if (of_fall) {
        // D^2 = gap / measure falls at the rate (gap measure' - gap' measure) / measure^2.
        const Exact square = closest.measure.value * closest.measure.value;
        const Exact fall = closest.gap.value * closest.measure.slope - closest.gap.slope * closest.measure.value;
        return over(fall - Exact(near.fall().value) * square,
                    numbers::kBoundSlack * near.fall().error * value_of(square));
      }
      Answer answer;
      if (!near.name(Kind::edge_edge, {later, 0}, answer)) return std::nan("");
      const Exact& size = closest.measure.value;
      const double s_off = over(closest.s - Exact(answer.weights_a[1]) * size, 0x1p-51 * value_of(size));
      const double q_off = over(closest.q - Exact(answer.weights_b[1]) * size, 0x1p-51 * value_of(size));
      return std::max(s_off, q_off);
    };
    report(of_fall ? "fall of the squared distance" : "weights of the closest points",
           searched(101, 3, 20000, frame_in_range, ratio), 0x1p-4);
  }
}

TEST_CASE("corners are certainly the closest points only where no other point is as near", "[separation]") {
  std::size_t certain = 0, uncertain = 0;
  const auto search = searched(102, 1, 6000, frame_in_range, [&](const FrameCase& s, const std::vector<double>& x) {
    const filters::Step step(s.query);
    const double t = share(x[24]);
    const filters::PreciseStep precise(s.query);
    const ExactPlace exact(s.query, t);
    for (const filters::Parameters p : {filters::Parameters{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
      const filters::PreciseClosest found = filters::precise_closest(step, precise, step.size, t, p);
      if (!found.ok || !filters::ClosestNear(step, found, 0).certain()) {
        ++uncertain;
        continue;
      }
      ++certain;
      ExactVector c;
      for (std::size_t k = 0; k < 3; ++k) c[k] = exact.r[k] - Exact(p.s) * exact.u[k] - Exact(p.q) * exact.w[k];
      // |c - x u| and |c - y w| grow on the way into the elements.
      if (dot(c, exact.u).sign() * (2 * p.s - 1) <= 0 || dot(c, exact.w).sign() * (2 * p.q - 1) <= 0) return 2.0;
    }
    return 0.0;
  });
  CHECK(search.worst == 0);
  CHECK(100 * certain > certain + uncertain);
  CHECK(uncertain > certain);
}

TEST_CASE("directions keep their hands off squares that underflow", "[separation]") {
  // Edges that cross at a distance of 2^100, and a direction between them whose squared length is no double.
  const double apart = 0x1p100, tiny = 0x1p-545;
  Query query;
  query.start = {Vec3{-1, 0, 0}, {1, 0, 0}, {0, -1, apart}, {0, 1, apart}};
  query.end = query.start;
  const Separation farther = {2 * apart, Metric::euclidean}, nearer = {0.5 * apart, Metric::euclidean};
  for (const double length : {1.0, tiny}) {
    const filters::Vector n = {{0, 0, length}};
    const filters::Step step(query);
    CHECK_FALSE(filters::Direction(step, n, farther).clear_at(0));
    CHECK_FALSE(filters::separates_by(filters::relative_corners(query), n, farther));
    CHECK(filters::Direction(step, {{0, 0, apart * length}}, nearer).clear_at(0) == (length == 1));
    CHECK(filters::separates_by(filters::relative_corners(query), n, nearer) == (length == 1));
  }
}

TEST_CASE("clearance keeps its hands off products that underflow", "[separation]") {
  // Edges of length 2^-280 cross at a distance of 1. The square of n's coordinate, 2^-560, is no double.
  const double tiny = 0x1p-280;
  Query query;
  query.start = {Vec3{0, 0, 0}, {tiny, 0, 0}, {0, 0, 1}, {0, tiny, 1}};
  query.end = query.start;
  CHECK_FALSE(filters::clear_all_along(query, {2, Metric::euclidean}));

  // n = (1, 1, 1) 2^-398 and r = (3, 3, 3) 2^-678: each product is 3/4 of the least double and becomes that, and 2.43
  // of it, which is d |n|, become 2.
  const double u = 0x1p-200, w = 0x1p-199, r = 3 * 0x1p-678;
  query.start = {Vec3{0, 0, 0}, {u, -u, 0}, {r, r, r}, {w, w, -2 * w}};
  query.end = query.start;
  CHECK_FALSE(filters::clear_all_along(query, {1.08 * std::sqrt(3.0) * r, Metric::euclidean}));
}
