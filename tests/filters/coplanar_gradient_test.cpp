// The gradient of a contact's time in double-doubles against exact arithmetic: its bounds hold under search, and every
// processor's code takes the same steps. tests/separation/toi_gradient_test.cpp compares the results.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include <touchstone/solve.hpp>

#include "filters/bound_search.hpp"
#include "filters/coplanar_gradient_steps.hpp"
#include "numbers/integers/exact_number.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using numbers::Exact;

namespace {

using Point = std::array<Exact, 3>;

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Exact dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The corners' positions and velocities in exact numbers.
struct ExactCorners {
  std::array<Point, 4> start, velocity;

  explicit ExactCorners(const Query& query) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 &a = query.start[i], &b = query.end[i];
      start[i] = {Exact(a.x), Exact(a.y), Exact(a.z)};
      velocity[i] = difference({Exact(b.x), Exact(b.y), Exact(b.z)}, start[i]);
    }
  }

  /// The gradient of det(x1 - x0, x2 - x0, x3 - x0), negated, by the corners: it is multilinear. This is V of either
  /// kind.
  std::array<Point, 4> gradient_at(const Exact& t) const {
    std::array<Point, 4> x;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) x[i][k] = start[i][k] + t * velocity[i][k];
    }
    std::array<Point, 4> by;
    by[1] = cross(difference(x[3], x[0]), difference(x[2], x[0]));
    by[2] = cross(difference(x[1], x[0]), difference(x[3], x[0]));
    by[3] = cross(difference(x[2], x[0]), difference(x[1], x[0]));
    for (std::size_t k = 0; k < 3; ++k) by[0][k] = -(by[1][k] + by[2][k] + by[3][k]);
    return by;
  }
  Exact slope_at(const std::array<Point, 4>& gradient) const {
    Exact sum(0);
    for (std::size_t i = 0; i < 4; ++i) sum = sum + dot(gradient[i], velocity[i]);
    return sum;
  }
  Exact volume_at(const Exact& t) const {
    const auto by = gradient_at(t);
    Exact sum(0);  // V is linear in x1, with its zero at x0
    for (std::size_t k = 0; k < 3; ++k) {
      sum = sum + by[1][k] * (start[1][k] + t * velocity[1][k] - start[0][k] - t * velocity[0][k]);
    }
    return sum;
  }
};

/// A root of V in the step within 2^-250, and the double before it; nothing where V has one sign at both ends.
struct Root {
  Exact time;
  double toi;
};
std::optional<Root> root_of(const ExactCorners& corners) {
  const Exact zero(0), one(1), two(2), half = numbers::power_of_two(-1);
  // The coefficients of V, times 2, from its values at 0, 1, -1 and 2.
  const Exact v0 = corners.volume_at(zero), v1 = corners.volume_at(one), vm = corners.volume_at(-one),
              v2 = corners.volume_at(two);
  if (sign_of(v0) * sign_of(v1) >= 0) return std::nullopt;
  const Exact c2 = v1 + vm - two * v0;            // 2 c2
  const Exact c3 = v2 - two * c2 - v1 + vm - v0;  // 6 c3: v2 = c0 + 2 c1 + 4 c2 + 8 c3
  const Exact c1 = Exact(3) * (v1 - vm) - c3;     // 6 c1
  const auto value = [&](const Exact& t) { return Exact(6) * v0 + t * (c1 + t * (Exact(3) * c2 + t * c3)); };
  Exact low = zero, high = one;
  for (int i = 0; i < 250; ++i) {
    const Exact middle = (low + high) * half;
    (sign_of(value(middle)) == sign_of(v0) ? low : high) = middle;
  }
  double toi = numbers::to_double(low);
  while (sign_of(Exact(toi) - low) > 0) toi = std::nextafter(toi, 0.0);
  while (sign_of(Exact(std::nextafter(toi, 2.0)) - low) <= 0) toi = std::nextafter(toi, 2.0);
  return Root{low, toi};
}

enum class Term { time, speed, corners };

/// |error| / bound of one sort of terms.
double worst_ratio(const Query& query, Term term) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const ExactCorners corners(query);
  const std::optional<Root> root = root_of(corners);
  if (!root) return kNone;
  const auto terms = filters::gradient_terms(query, root->toi, std::nextafter(root->toi, 2.0));
  // The bounds are for roots whose slope is known.
  if (!terms.in_range || !(terms.speed_error <= 0x1p-30 * std::fabs(terms.speed.high))) return kNone;
  const auto ratio = [](double high, double low, const Exact& truth, double bound) {
    const Exact error = Exact(high) + Exact(low) - truth;
    if (is_zero(error)) return 0.0;
    return bound > 0 ? std::fabs(numbers::approximate_quotient(error, Exact(bound)))
                     : std::numeric_limits<double>::infinity();
  };
  const auto of_number = [&](const numbers::DoubleDouble& x, const Exact& truth, double bound) {
    return ratio(x.high, x.low, truth, bound);
  };
  const auto gradient = corners.gradient_at(root->time);
  if (term == Term::speed) return of_number(terms.speed, corners.slope_at(gradient), terms.speed_error);
  if (term == Term::time) {
    return std::max(of_number(terms.time, root->time, terms.time_error),
                    of_number(terms.rest, Exact(1) - root->time, terms.time_error));
  }
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [high, low] = terms.by_corners[i];
    for (std::size_t k = 0; k < 3; ++k) {
      worst = std::max(worst, ratio(high.v[k], low.v[k], gradient[i][k], terms.error.v[k]));
    }
  }
  return worst;
}

/// The motion is so many binary orders slower than the elements are large.
Query query_of(const std::vector<double>& x, bool edges, int slower) {
  std::array<Vec3, 4> start, end;
  for (std::size_t i = 0; i < 4; ++i) {
    start[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
    const double* const to = &x[12 + 3 * i];
    end[i] = slower == 0 ? Vec3{to[0], to[1], to[2]}
                         : Vec3{start[i].x + std::ldexp(to[0], -slower), start[i].y + std::ldexp(to[1], -slower),
                                start[i].z + std::ldexp(to[2], -slower)};
  }
  if (slower != 0 && edges) {  // near to each other
    for (auto* side : {&start, &end}) {
      const double f = std::ldexp(1.0, -slower);
      (*side)[3] = {(*side)[3].x * f + (*side)[0].x, (*side)[3].y * f + (*side)[0].y, (*side)[3].z * f + (*side)[0].z};
    }
  }
  return edges ? Query(EdgeEdge{start, end}) : Query(VertexFace{start, end});
}

}  // namespace

TEST_CASE("what makes up a gradient is within its bounds, at all magnitudes and for slow motion", "[slow]") {
  static const char* const names[] = {"the time in double-doubles", "its speed", "the gradient of V"};
  for (const Term term : {Term::time, Term::speed, Term::corners}) {
    BoundSearch search;
    Rng rng(471 + static_cast<unsigned>(term));
    for (const bool edges : {true, false}) {
      constexpr int kSteps = kLongSearches ? 4000 : 40;
      for (const int slower : {0, 12}) {
        const auto measured = [&](const std::vector<double>& x) {
          return worst_ratio(query_of(x, edges, slower), term);
        };
        search_bound(search, rng, 24, 0, 0, 2, kSteps, measured);
        for (const int exponent : {40, -40, 190, -150}) {
          search_bound(search, rng, 24, exponent, 0, 1, kSteps / 20, measured);
          search_bound(search, rng, 24, exponent, 30, 1, kSteps / 20, measured);
        }
      }
    }
    // Those of the speed are for nine products whose errors all have one sign.
    report(names[static_cast<std::size_t>(term)], search, term == Term::speed ? 0.004 : 0.02);
  }
}

TEST_CASE("fused and plain steps give the same gradients") {
  const filters::CoplanarGradient plain_steps = filters::coplanar_gradient_function(false);
  const filters::CoplanarGradient fused_steps = filters::coplanar_gradient_function(true);
  if (fused_steps == nullptr) {
    skip("this processor, or compiler, has no fused multiply-add to compare with");
    return;
  }
  Rng rng(476);
  std::size_t compared = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<double> x(24);
    for (double& v : x) v = rng.symmetric();
    const Query query = query_of(x, rng.one_in(2), rng.one_in(2) ? rng.between(1, 30) : 0);
    const Answer answer = solve(query);
    if (!answer.contact || answer.toi_upper == 0) continue;
    geometry::EndGradients plain{}, fused{};
    const bool known = plain_steps(query, answer.toi, answer.toi_upper, plain);
    REQUIRE(fused_steps(query, answer.toi, answer.toi_upper, fused) == known);
    if (!known) continue;
    ++compared;
    REQUIRE(std::memcmp(&plain, &fused, sizeof plain) == 0);
  }
  CHECK(compared > 1000);
}
