// The bounds inside the bracket level under search, one by one: what the level makes of them is so far from the truth
// that a wrong one would seldom show in an answer.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "filters/bernstein_cubic.hpp"
#include "filters/bound_search.hpp"
#include "filters/contact_values_steps.hpp"
#include "filters/coplanarity_form.hpp"
#include "numbers/exact_number.hpp"
#include "support/catch.hpp"

// The functions under test are private to these files, which are compiled here a second time.
#include "filters/bracket.cpp"       // NOLINT(bugprone-suspicious-include)
#include "filters/refined_root.cpp"  // NOLINT(bugprone-suspicious-include)

using namespace touchstone;
using namespace touchstone::tests;
using filters::BernsteinCubic;
using numbers::Exact;

namespace {

/// An edge-edge query from 24 doubles, its frame, and the exact Bernstein coefficients of V, each times 3 when inner.
struct FrameCase {
  Query query;
  filters::Frame frame;
  filters::Magnitudes size;
  std::array<std::array<Exact, 3>, 3> start, end;  // u, w, r
  std::array<Exact, 4> exact;                      // b0, 3 b1, 3 b2, b3

  explicit FrameCase(const std::vector<double>& x) {
    for (std::size_t i = 0; i < 4; ++i) {
      query.start[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
      query.end[i] = {x[12 + 3 * i], x[12 + 3 * i + 1], x[12 + 3 * i + 2]};
    }
    static constexpr std::size_t kMinuend[] = {1, 3, 2};
    static constexpr std::size_t kSubtrahend[] = {0, 2, 0};
    filters::Vector* rounded[2][3] = {{&frame.u0, &frame.w0, &frame.r0}, {&frame.u1, &frame.w1, &frame.r1}};
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double a = x[12 * side + 3 * kMinuend[v] + k], b = x[12 * side + 3 * kSubtrahend[v] + k];
          (*rounded[side][v])[k] = a - b;
          (side == 0 ? start : end)[v][k] = Exact(a) - Exact(b);
        }
      }
    }
    size = {filters::largest(frame.u0, frame.u1), filters::largest(frame.w0, frame.w1),
            filters::largest(frame.r0, frame.r1)};
    exact[0] = determinant(start[0], start[1], start[2]);
    exact[1] = determinant(start[0], end[1], start[2]) + determinant(end[0], start[1], start[2]) +
               determinant(start[0], start[1], end[2]);
    exact[2] = determinant(end[0], end[1], start[2]) + determinant(start[0], end[1], end[2]) +
               determinant(end[0], start[1], end[2]);
    exact[3] = determinant(end[0], end[1], end[2]);
  }

  using Vector = std::array<Exact, 3>;
  static Exact determinant(const Vector& a, const Vector& b, const Vector& c) {
    return a[0] * b[1] * c[2] + a[1] * b[2] * c[0] + a[2] * b[0] * c[1] - a[2] * b[1] * c[0] - a[0] * b[2] * c[1] -
           a[1] * b[0] * c[2];
  }

  bool usable() const { return filters::within_range(size); }
  BernsteinCubic cubic() const { return {filters::coplanarity_coefficients(frame), size.u * size.w * size.r}; }

  /// The blossom of V: its Bernstein coefficients over [p, q] are those of (p p p), (p p q), (p q q), (q q q).
  Exact blossom(const Exact& a, const Exact& b, const Exact& c) const {
    const Exact one(1);
    const Exact na = one - a, nb = one - b, nc = one - c;
    // Times 3, so that no division is needed.
    return Exact(3) * exact[0] * na * nb * nc + exact[1] * (a * nb * nc + na * b * nc + na * nb * c) +
           exact[2] * (a * b * nc + a * nb * c + na * b * c) + Exact(3) * exact[3] * a * b * c;
  }

  /// A coordinate of vector v (u, w or r) at a time.
  Exact at(std::size_t v, std::size_t k, const Exact& t) const { return start[v][k] + t * (end[v][k] - start[v][k]); }
  /// Coordinate k of the cross product of vectors a and b at a time.
  Exact cross(std::size_t a, std::size_t b, std::size_t k, const Exact& t) const {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return at(a, i, t) * at(b, j, t) - at(a, j, t) * at(b, i, t);
  }
};

double over(const Exact& error, double bound) { return std::fabs(numbers::approximate_quotient(error, Exact(bound))); }

/// A number in [0, 1] from any double; the ends are frequent.
double share(double x) {
  int exponent = 0;
  const double s = 2 * std::fabs(std::frexp(x, &exponent)) - 1;  // in [0, 1)
  return s < 0.125 ? 0 : s > 0.875 ? 1 : (s - 0.125) / 0.75;
}

void report(const char* what, const BoundSearch& search, double least) {
  std::printf("%s: worst observed error / bound = %.4f in %ld evaluations\n", what, search.worst, search.evaluations);
  for (const double x : search.input) UNSCOPED_INFO("input " << std::hexfloat << x);
  CHECK(search.worst <= 1);
  // An idle bound would cost speed, and a search that finds nothing proves nothing; the short ones of slow builds find less.
#ifdef NDEBUG
  CHECK(search.worst > least);
#else
  std::printf("  (a short search: not held to find %.4f)\n", least);
#endif
}

#ifdef NDEBUG
constexpr int kSteps = 4000;
#else
constexpr int kSteps = 100;
#endif

/// Searches over the 24 coordinates and `more` numbers besides.
template <class Ratio>
BoundSearch searched(std::uint64_t seed, std::size_t more, const Ratio& ratio) {
  Rng rng(seed);
  BoundSearch search;
  // At 2^-346 products of three are subnormal, and the level must keep its hands off.
  for (const int exponent : {0, 40, -40, 200, -200, -346}) {
    search_bound(search, rng, 24 + more, exponent, 0, 3, kSteps, [&](const std::vector<double>& x) {
      const FrameCase sample(x);
      return sample.usable() ? ratio(sample, x) : std::nan("");
    });
  }
  return search;
}

/// The least `m` for which sign_at_root is uncertain of a component, over `m`.
double needed_share(const filters::ValueAndSlope& component, const filters::Offset& offset, double m) {
  const auto certain = [&](double factor) { return filters::sign_at_root(component, offset, factor * m) != 0; };
  if (!certain(0)) return 0;
  if (certain(1)) return 2;  // certain of a sign that is nothing but error
  double low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (certain(middle) ? low : high) = middle;
  }
  return high;
}

/// How much of its bound sign_at_root needs for f1 = r x w along an axis, `distance` from where it is evaluated, when
/// the distance is off by `slip`.
double offset_ratio(const FrameCase& sample, double t, double distance, double slip) {
  if (!(t + distance + slip >= 0 && t + distance + slip <= 1)) {
    distance = -distance;
    slip = -slip;
  }
  const std::size_t k = 2;
  const Vec3* const start = sample.query.start.data();
  const Vec3* const end = sample.query.end.data();
  const auto w = filters::moving_difference(start, end, 3, 2, t), r = filters::moving_difference(start, end, 2, 0, t);
  const filters::Component first = filters::component(r, w, filters::cross(r.value, w.value), k);
  const Exact truth = sample.cross(2, 1, k, Exact(t) + Exact(distance) + Exact(slip));
  // The same component less its true value, as two doubles: its errors stay.
  const double high = numbers::approximate_quotient(truth, Exact(1));
  const double low = numbers::approximate_quotient(truth - Exact(high), Exact(1));
  const filters::Offset offset{distance, std::fabs(slip), 2 * std::fabs(distance + slip)};
  const double rest = (first.value.high - high) + (first.value.low - low);
  return needed_share({rest, first.slope}, offset, sample.size.r * sample.size.w);
}

}  // namespace

TEST_CASE("the cubic's value, slope and curvature at any time are within their bounds") {
  report("value",
         searched(81, 1,
                  [](const FrameCase& s, const std::vector<double>& x) {
                    const BernsteinCubic cubic = s.cubic();
                    const double t = share(x[24]);
                    const Exact at(t);
                    return over(Exact(3) * Exact(cubic.value(t)) - s.blossom(at, at, at), 3 * cubic.value_error());
                  }),
         0.0625);
  report("slope",
         searched(82, 1,
                  [](const FrameCase& s, const std::vector<double>& x) {
                    const BernsteinCubic cubic = s.cubic();
                    const double t = share(x[24]);
                    const Exact at(t), zero(0), one(1);
                    // V' = 3 (blossom(t, t, 1) - blossom(t, t, 0)), and the blossom is thrice V's.
                    return over(Exact(cubic.slope(t)) - (s.blossom(at, at, one) - s.blossom(at, at, zero)),
                                cubic.slope_error());
                  }),
         0.0625);
  report("curvature",
         searched(83, 0,
                  [](const FrameCase&, const std::vector<double>& x) {
                    // Where u and w all but stand still, V'' is all but zero, and the bound's share for errors is all
                    // there is.
                    std::vector<double> still = x;
                    for (std::size_t k = 0; k < 3; ++k) {
                      still[15 + k] = x[12 + k] + (x[3 + k] - x[k]);
                      still[21 + k] = x[18 + k] + (x[9 + k] - x[6 + k]);
                    }
                    const FrameCase s(still);
                    const BernsteinCubic cubic = s.cubic();
                    const double computed =
                        BernsteinCubic(filters::coplanarity_coefficients(s.frame), 0).curvature_bound();
                    const Exact zero(0), one(1);
                    double worst = 0;
                    for (const Exact& t : {zero, one}) {  // V'' is linear
                      const Exact second = Exact(2) * (s.blossom(t, one, one) - Exact(2) * s.blossom(t, zero, one) +
                                                       s.blossom(t, zero, zero));
                      const Exact size = second.sign() < 0 ? -second : second;
                      worst = std::max(worst, numbers::approximate_quotient(size - Exact(computed),
                                                                            Exact(cubic.curvature_bound() - computed)));
                    }
                    return worst;
                  }),
         0.0);
}

TEST_CASE("the cubic's coefficients over a part of the step are within their bound") {
  report("part",
         searched(84, 2,
                  [](const FrameCase& s, const std::vector<double>& x) {
                    const BernsteinCubic cubic = s.cubic();
                    const double p = share(x[24]), q = share(x[25]);
                    const auto part = cubic.part(p, q);
                    double worst = 0;
                    for (std::size_t i = 0; i < 4; ++i) {
                      const Exact truth = s.blossom(Exact(i > 0 ? q : p), Exact(i > 1 ? q : p), Exact(i > 2 ? q : p));
                      worst = std::max(worst, over(Exact(3) * Exact(part[i]) - truth, 3 * cubic.part_error()));
                    }
                    return worst;
                  }),
         0.0625);
}

TEST_CASE("the side conditions near a root are within their bounds") {
  static constexpr std::array<double, 5> kDistances{0, 0x1p-52, 0x1p-40, 0x1p-20, 0x1p-10};
  for (const double h : kDistances) {
    const auto search = searched(85, 1, [h](const FrameCase& s, const std::vector<double>& x) {
      const double t = share(x[24]);
      const filters::SideValues at = filters::side_values(s.query.kind, s.frame, s.size, t, h);
      double worst = 0;
      for (const double side : {-h, h}) {
        const Exact time = Exact(std::clamp(t + side, 0.0, 1.0));
        const Exact sign(at.sign);
        worst = std::max({worst, over(sign * s.cross(0, 1, at.axis, time) - Exact(at.normal.value), at.normal.error),
                          over(sign * s.cross(2, 1, at.axis, time) - Exact(at.first.value), at.first.error),
                          over(sign * s.cross(2, 0, at.axis, time) - Exact(at.second.value), at.second.error)});
      }
      return worst;
    });
    report(("sides within " + std::to_string(h)).c_str(), search, 0.0625);
  }
}

TEST_CASE("the signs of components at a root are certain only when they are") {
  struct Place {
    double distance, slip;
  };
  for (const Place& place : {Place{0, 0}, Place{0x1p-52, 0}, Place{0x1p-40, 0}, Place{0x1p-20, 0}, Place{0, 0x1p-80},
                             Place{0x1p-40, 0x1p-76}}) {
    const auto search = searched(86, 1, [&](const FrameCase& s, const std::vector<double>& x) {
      return offset_ratio(s, share(x[24]), place.distance, place.slip);
    });
    char name[80];
    std::snprintf(name, sizeof name, "component at a root %a away, give or take %a", place.distance, place.slip);
    report(name, search, 0.0);
  }
}

TEST_CASE("the step to a root is off by no more than it says") {
  report("step to a root",
         searched(87, 1,
                  [](const FrameCase& s, const std::vector<double>& x) {
                    const BernsteinCubic cubic = s.cubic();
                    if (cubic.variations(0, 1) != BernsteinCubic::Variations::one) return std::nan("");
                    const BernsteinCubic::Root root = cubic.root_between(0, 1);
                    if (!root.certain) return std::nan("");
                    // From as far away as the slope is steady enough: there the curvature shows.
                    const double away = (share(x[24]) - 0.5) * 0.2 * std::fabs(root.slope) / cubic.curvature_bound();
                    const double t = std::clamp(root.t + away, 0.0, 1.0);
                    const filters::SimpleRoot simple{t, root.radius, cubic.slope(t), cubic.slope_error(),
                                                     cubic.curvature_bound()};
                    const double value =
                        filters::contact_values(s.query.start.data(), s.query.end.data(), true, t, 0).coplanarity;
                    const auto offset = filters::offset_of(simple, cubic.size(), value);
                    if (!offset) return std::nan("");
                    // One more step of Newton's, exactly: as good as the root itself.
                    const Exact at = Exact(t) + Exact(offset->value), zero(0), one(1);
                    const Exact slope = s.blossom(at, at, one) - s.blossom(at, at, zero);
                    const double missing = numbers::approximate_quotient(s.blossom(at, at, at), Exact(3) * slope);
                    return std::fabs(missing) / offset->error;
                  }),
         0.0625);
}
