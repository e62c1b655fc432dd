// How the time of the first contact changes with the corners: rational gradients, differences, and laws.
// SPDX-License-Identifier: MIT
#include <touchstone/toi_gradient.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "exact/exact.hpp"
#include "filters/coplanar_gradient.hpp"
#include "filters/filters.hpp"
#include "filters/separation/entry_gradient.hpp"
#include "separation/distances.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Rational = mpq_class;
using Point = std::array<Rational, 3>;

double& coordinate_of(Vec3& v, std::size_t k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The gradient by the volume of the tetrahedron of the four corners, for a contact without separation at the time t;
/// none where the volume does not change then.
struct RationalGradient {
  std::array<Point, 4> start, end;
};

/// The corners at the time t, and their velocities.
std::array<std::array<Point, 4>, 2> corners_at(const Query& query, const Rational& t) {
  std::array<std::array<Point, 4>, 2> found;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational a(coordinate(query.start[i], k)), b(coordinate(query.end[i], k));
      found[0][i][k] = a + t * (b - a);
      found[1][i][k] = b - a;
    }
  }
  return found;
}

std::optional<RationalGradient> rational_gradient(const Query& query, const Rational& t) {
  const auto [x, v] = corners_at(query, t);
  // det(x1 - x0, x2 - x0, x3 - x0) is multilinear: by corner 1 its derivative is (x2 - x0) x (x3 - x0), and so on.
  std::array<Point, 4> by;
  by[1] = cross(difference(x[2], x[0]), difference(x[3], x[0]));
  by[2] = cross(difference(x[3], x[0]), difference(x[1], x[0]));
  by[3] = cross(difference(x[1], x[0]), difference(x[2], x[0]));
  Rational speed = 0;
  for (std::size_t k = 0; k < 3; ++k) by[0][k] = -by[1][k] - by[2][k] - by[3][k];
  for (std::size_t i = 0; i < 4; ++i) speed += dot(by[i], v[i]);
  if (speed == 0) return std::nullopt;
  RationalGradient gradient;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      gradient.start[i][k] = -(1 - t) * by[i][k] / speed;
      gradient.end[i][k] = -t * by[i][k] / speed;
    }
  }
  return gradient;
}

/// The time between two doubles at which the four corners are in one plane, from so many bisections; nothing where they
/// are on the same side of a plane at both.
std::optional<Rational> plane_time(const Query& query, double lower, double upper, int bisections = 250) {
  const auto volume = [&](const Rational& t) {
    const auto x = corners_at(query, t)[0];
    return Rational(dot(difference(x[1], x[0]), cross(difference(x[2], x[0]), difference(x[3], x[0]))));
  };
  Rational low(lower), high(upper);
  const int sign = sgn(volume(low));
  if (sign * sgn(volume(high)) > 0) return std::nullopt;
  for (int i = 0; i < bisections; ++i) {
    const Rational middle = (low + high) / 2;
    (sgn(volume(middle)) == sign ? low : high) = middle;
  }
  return low;
}

/// Whether it is the true one, or a double beside it; beyond the greatest double that is infinity.
bool is_beside(double found, const Rational& truth) {
  if (truth == 0) return found == 0;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double below = std::nextafter(found, -kInfinity), above = std::nextafter(found, kInfinity);
  return (std::isinf(below) || Rational(below) < truth) && (std::isinf(above) || truth < Rational(above)) &&
         (!std::isinf(found) || sgn(truth) == (found > 0 ? 1 : -1));
}

/// Elements of small integers that meet at an eighth of the step.
Query meeting_at_an_eighth(Rng& rng, int eighth) {
  Query query;
  query.kind = rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
  const auto small = [&] { return Vec3{rng.between(-8, 8) * 1.0, rng.between(-8, 8) * 1.0, rng.between(-8, 8) * 1.0}; };
  const auto sum = [](const Vec3& a, double f, const Vec3& b) {
    return Vec3{a.x + f * b.x, a.y + f * b.y, a.z + f * b.z};
  };
  std::array<Vec3, 4> at = {small(), small(), small(), small()};
  if (query.kind == Kind::edge_edge) {  // both go through the point 0.25 a0 + 0.75 a1
    const Vec3 foot = sum(at[0], 0.75, sum(at[1], -1, at[0]));
    at[3] = sum(foot, 3, sum(foot, -1, at[2]));
  } else {
    at[0] = sum(sum(at[1], 0.25, sum(at[2], -1, at[1])), 0.5, sum(at[3], -1, at[1]));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 way = small();
    query.start[i] = sum(at[i], -eighth / 8.0, way);
    query.end[i] = sum(at[i], 1 - eighth / 8.0, way);
  }
  return query;
}

double greatest(const ToiGradient& gradient) {
  double most = 0;
  for (const auto* side : {&gradient.start, &gradient.end}) {
    for (const Vec3& g : *side) most = std::max({most, std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)});
  }
  return most;
}

bool is_zero(const ToiGradient& gradient) { return greatest(gradient) == 0; }

}  // namespace

TEST_CASE("the gradient of a point that falls on a face is known") {
  // It is at 3 above the face at t = 0, and at -1 at t = 1: T = 3/4.
  const Query query =
      VertexFace{{{{1, 1, 3}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};
  const ToiGradient gradient = toi_gradient(query);
  REQUIRE(gradient.exists);
  CHECK(gradient.start[0].z == 0.0625);  // 1 / 4^2, the derivative of z0 / (z0 - z1)
  CHECK(gradient.end[0].z == 0.1875);    // 3 / 4^2
  CHECK(gradient.start[1].z == -0.03125);
  CHECK(gradient.start[2].z == -0.015625);
  CHECK(gradient.end[3].z == -0.046875);
  for (const auto* side : {&gradient.start, &gradient.end}) {
    for (const Vec3& g : *side) CHECK((g.x == 0 && g.y == 0));
  }
  const ToiGradient apart = toi_gradient(query, {0.5, Metric::euclidean});
  REQUIRE(apart.exists);
  CHECK(apart.start[0].z == 0.09375);  // T = 5/8: (1 - T) / 4
  CHECK(apart.end[0].z == 0.15625);
}

TEST_CASE("gradients of times that are doubles are the rational ones, or a double beside them") {
  std::size_t judged = 0;
  for (std::size_t i = 0; i < effort(3000); ++i) {
    Rng rng(seeded::seed_of_stream(395, i));
    const int eighth = rng.between(1, 8);
    const Query query = meeting_at_an_eighth(rng, eighth);
    const Answer answer = solve(query);
    CAPTURE(i, cpp_initializer(query));
    REQUIRE(answer.contact);
    const ToiGradient gradient = toi_gradient(query);
    if (!gradient.exists) {
      CHECK(is_zero(gradient));
      continue;
    }
    if (answer.toi != answer.toi_upper) continue;
    ++judged;
    const std::optional<RationalGradient> truth = rational_gradient(query, Rational(answer.toi));
    REQUIRE(truth);
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(is_beside(coordinate(gradient.start[c], k), truth->start[c][k]));
        REQUIRE(is_beside(coordinate(gradient.end[c], k), truth->end[c][k]));
      }
    }
  }
  CAPTURE(judged);
  CHECK(4 * judged > effort(3000));
}

TEST_CASE("gradients of other times are within a double, too") {
  std::size_t judged = 0;
  for (std::size_t i = 0; i < effort(3000); ++i) {
    Rng rng(seeded::seed_of_stream(397, i));
    Query query;
    query.kind = rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
    const double speed = rng.one_in(3) ? std::ldexp(1.0, -rng.between(0, 40)) : 1;
    for (std::size_t c = 0; c < 4; ++c) {
      query.start[c] = {rng.symmetric(), rng.symmetric(), rng.symmetric()};
      query.end[c] = {query.start[c].x + speed * rng.symmetric(), query.start[c].y + speed * rng.symmetric(),
                      query.start[c].z + speed * rng.symmetric()};
    }
    const ToiGradient gradient = toi_gradient(query);
    const Answer answer = solve(query);
    if (!gradient.exists || answer.toi == answer.toi_upper) continue;
    ++judged;
    CAPTURE(i, cpp_initializer(query));
    const std::optional<Rational> time = plane_time(query, answer.toi, answer.toi_upper);
    REQUIRE(time);
    const std::optional<RationalGradient> truth = rational_gradient(query, *time);
    REQUIRE(truth);
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(is_beside(coordinate(gradient.start[c], k), truth->start[c][k]));
        REQUIRE(is_beside(coordinate(gradient.end[c], k), truth->end[c][k]));
      }
    }
  }
  CAPTURE(judged);
  CHECK((20 * judged > effort(3000) || !whole_effort("how many gradients of other times are judged")));
}

namespace {

/// Whether both have a gradient or none, with zeros in the same coordinates.
bool alike(const ToiGradient& found, const std::optional<geometry::EndGradients>& exact) {
  if (found.exists != exact.has_value()) return false;
  for (std::size_t c = 0; found.exists && c < 4; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((coordinate(found.start[c], k) == 0) != (coordinate((*exact)[0][c], k) == 0)) return false;
      if ((coordinate(found.end[c], k) == 0) != (coordinate((*exact)[1][c], k) == 0)) return false;
    }
  }
  return true;
}

/// Whether all that are not zero are the true ones, or a double beside. Zeros are compared with `alike`.
bool is_beside(const ToiGradient& found, const std::optional<RationalGradient>& truth) {
  bool right = truth.has_value();
  for (std::size_t c = 0; right && c < 4; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double start = coordinate(found.start[c], k), end = coordinate(found.end[c], k);
      right = right && (start == 0 || is_beside(start, truth->start[c][k]));
      right = right && (end == 0 || is_beside(end, truth->end[c][k]));
    }
  }
  return right;
}

}  // namespace

TEST_CASE("gradients of every family are the rational ones, and doubles decide most ordinary ones") {
  std::size_t ordinary = 0, ordinary_in_doubles = 0, degenerate = 0, degenerate_in_doubles = 0, two_times = 0;
  for (const FamilyInfo& family : all_families()) {
    // Of ordinary size, with contacts that are neither at a border nor grazing by construction.
    const bool is_ordinary = family.family == Family::random_doubles || family.family == Family::simulation ||
                             family.family == Family::lattice4 || family.family == Family::prescribed ||
                             family.family == Family::far_offset || family.family == Family::layers;
    for (std::size_t i = 0; i < effort(120); ++i) {
      for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
        const CaseId id{family.family, kind, 398, i};
        const Query query = make(id);
        CAPTURE(family.name, i, cpp_initializer(query));
        const ToiGradient found = toi_gradient(query);
        REQUIRE(alike(found, exact::toi_gradient(query, 1, {})));
        if (!found.exists) {
          CHECK(is_zero(found));
          continue;
        }
        const Answer answer = solve(query);
        if (answer.toi == answer.toi_upper) {
          REQUIRE(is_beside(found, rational_gradient(query, Rational(answer.toi))));
        } else {
          const auto right = [&](int bisections) {
            const std::optional<Rational> time = plane_time(query, answer.toi, answer.toi_upper, bisections);
            if (!time) ++two_times;
            return !time || is_beside(found, rational_gradient(query, *time));
          };
          REQUIRE((right(250) || right(2500)));  // the second where a subnormal number makes the difference
        }
        geometry::EndGradients gradient;
        const bool in_doubles = filters::coplanar_gradient(query, answer.toi, answer.toi_upper, gradient);
        ++(is_ordinary ? ordinary : degenerate);
        if (in_doubles) ++(is_ordinary ? ordinary_in_doubles : degenerate_in_doubles);
      }
    }
  }
  CAPTURE(ordinary, ordinary_in_doubles, degenerate, degenerate_in_doubles, two_times);
  if (!whole_effort("how many gradients doubles decide")) return;
  CHECK(ordinary > 150);
  CHECK(100 * ordinary_in_doubles > 97 * ordinary);
  CHECK(degenerate > 500);
  CHECK(20 * two_times < degenerate);
  CHECK(degenerate_in_doubles > 200);
  CHECK(degenerate_in_doubles < degenerate);
}

namespace {

/// The closest points of the lines or planes through the features of an answer, at one time: the difference of both,
/// and the weights of the corners in them, negated on the first element.
struct Nearest {
  Point c;
  std::array<Rational, 4> weights;
};

/// Of the corners of an element those that bound a feature: "f01" has two digits for them, and "f" has all.
std::vector<std::size_t> corners_of(std::string_view feature, std::size_t first, std::size_t end) {
  std::vector<std::size_t> corners;
  for (std::size_t i = first; i < end; ++i) {
    const bool has_digits = feature.find_first_of("012") != std::string_view::npos;
    if (!has_digits || feature.find(static_cast<char>('0' + i - first)) != std::string_view::npos) corners.push_back(i);
  }
  return corners;
}

Nearest nearest_points(const std::array<Point, 4>& x, const Answer& answer, Kind kind) {
  const std::size_t of_first = kind == Kind::edge_edge ? 2 : 1;
  const std::vector<std::size_t> a = corners_of(name_of(answer.feature_a), 0, of_first),
                                 b = corners_of(name_of(answer.feature_b), of_first, corner_count(kind));
  // c = r + the sum of parameters times directions, orthogonal to these.
  const Point r = difference(x[b[0]], x[a[0]]);
  std::vector<Point> directions;
  for (std::size_t j = 1; j < b.size(); ++j) directions.push_back(difference(x[b[j]], x[b[0]]));
  for (std::size_t j = 1; j < a.size(); ++j) directions.push_back(difference(x[a[0]], x[a[j]]));
  std::vector<Rational> parameters;
  const auto along = [&](std::size_t i, std::size_t j) { return dot(directions[i], directions[j]); };
  const auto wanted = [&](std::size_t i) { return Rational(-dot(directions[i], r)); };
  if (directions.size() == 1) parameters = {wanted(0) / along(0, 0)};
  if (directions.size() == 2) {
    const Rational determinant = along(0, 0) * along(1, 1) - along(0, 1) * along(0, 1);
    parameters = {(wanted(0) * along(1, 1) - wanted(1) * along(0, 1)) / determinant,
                  (wanted(1) * along(0, 0) - wanted(0) * along(0, 1)) / determinant};
  }
  Nearest nearest{r, {}};
  nearest.weights[a[0]] = -1;
  nearest.weights[b[0]] = 1;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    for (std::size_t k = 0; k < 3; ++k) nearest.c[k] += parameters[j] * directions[j][k];
    const bool second = j + 1 < b.size();
    nearest.weights[second ? b[j + 1] : a[j + 2 - b.size()]] += second ? parameters[j] : Rational(-parameters[j]);
    nearest.weights[second ? b[0] : a[0]] -= second ? parameters[j] : Rational(-parameters[j]);
  }
  return nearest;
}

/// The gradient at the time between two doubles at which these points come within the distance, from so many
/// bisections, or at the one double; nothing where they are within it, or not, at both.
std::optional<RationalGradient> rational_gradient(const Query& query, const Answer& answer, double distance,
                                                  int bisections) {
  const auto excess = [&](const Rational& t) {
    const Nearest at = nearest_points(corners_at(query, t)[0], answer, query.kind);
    return Rational(dot(at.c, at.c) - Rational(distance) * distance);
  };
  Rational low(answer.toi), high(answer.toi_upper);
  if (low != high && (excess(low) <= 0 || excess(high) >= 0)) return std::nullopt;
  for (int i = 0; i < bisections && low != high; ++i) {
    const Rational middle = (low + high) / 2;
    (excess(middle) > 0 ? low : high) = middle;
  }
  const auto [x, v] = corners_at(query, low);
  const Nearest at = nearest_points(x, answer, query.kind);
  Rational speed = 0;
  for (std::size_t i = 0; i < 4; ++i) speed += at.weights[i] * dot(at.c, v[i]);
  if (speed == 0) return std::nullopt;
  RationalGradient gradient;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      gradient.start[i][k] = -(1 - low) * at.weights[i] * at.c[k] / speed;
      gradient.end[i][k] = -low * at.weights[i] * at.c[k] / speed;
    }
  }
  return gradient;
}

}  // namespace

TEST_CASE("gradients of separations are the rational ones in every family, and doubles decide most ordinary ones") {
  std::size_t judged = 0, ordinary = 0, ordinary_in_doubles = 0, others = 0, others_in_doubles = 0;
  for (const FamilyInfo& family : all_families()) {
    const bool is_ordinary = family.family == Family::random_doubles || family.family == Family::simulation;
    for (std::size_t i = 0; i < effort(is_ordinary ? 120 : 7); ++i) {
      for (const Kind kind : kKinds) {
        Rng rng(seeded::seed_of_stream(399, 4 * i + static_cast<std::size_t>(kind)));
        const Query query = make(CaseId{family.family, kind, 399, i});
        const Separation separation = {interesting_distance(query, Metric::euclidean, rng), Metric::euclidean};
        if (!(separation.distance > 0)) continue;
        CAPTURE(family.name, i, separation.distance, cpp_initializer(query));
        const Answer answer = solve(query, {.separation = separation});
        const ToiGradient found = toi_gradient(query, separation);
        if (!answer.contact || answer.toi_upper == 0) {
          REQUIRE((!found.exists && is_zero(found)));
          continue;
        }
        REQUIRE(alike(found, exact::toi_gradient(query, 1, separation)));
        if (!found.exists) continue;
        const auto truth = rational_gradient(query, answer, separation.distance, 250);
        if (truth) {
          REQUIRE((is_beside(found, truth) ||
                   is_beside(found, rational_gradient(query, answer, separation.distance, 2500))));
          ++judged;
        }
        Answer entry;
        numbers::BoundedPair time;
        geometry::EndGradients gradient;
        const bool in_doubles =
            filters::decide_by_filters(query, separation, 1, entry, &time) == filters::Outcome::contact &&
            filters::entry_gradient(query, entry, time, gradient);
        ++(is_ordinary ? ordinary : others);
        if (in_doubles) ++(is_ordinary ? ordinary_in_doubles : others_in_doubles);
      }
    }
  }
  CAPTURE(judged, ordinary, ordinary_in_doubles, others, others_in_doubles);
  if (!whole_effort("how many gradients of separations doubles decide")) return;
  CHECK(10 * judged > 9 * (ordinary + others));
  CHECK(ordinary > 100);
  CHECK(10 * ordinary_in_doubles > 7 * ordinary);
  CHECK(others_in_doubles > 100);
  CHECK(others_in_doubles < others);
}

TEST_CASE("gradients are the differences of times, with a separation too, and moving all corners changes nothing") {
  std::size_t compared = 0;
  for (std::size_t i = 0; i < effort(1500); ++i) {
    Rng rng(seeded::seed_of_stream(396, i));
    Query query;
    query.kind = rng.pick(kKinds);
    for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
      query.start[c] = {rng.symmetric(), rng.symmetric(), rng.symmetric()};
      query.end[c] = {rng.symmetric(), rng.symmetric(), rng.symmetric()};
    }
    Separation separation;
    if (rng.one_in(2)) separation.distance = interesting_distance(query, Metric::euclidean, rng);
    CAPTURE(i, separation.distance, cpp_initializer(query));
    const ToiGradient gradient = toi_gradient(query, separation);
    const Answer answer = solve(query, {.separation = separation});
    if (!gradient.exists) {
      CHECK(is_zero(gradient));
      continue;
    }
    REQUIRE(answer.contact);
    const double size = greatest(gradient);
    Vec3 sum = {0, 0, 0}, sum_at_end = {0, 0, 0};
    for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
      const Vec3 &a = gradient.start[c], &b = gradient.end[c];
      sum = {sum.x + a.x, sum.y + a.y, sum.z + a.z};
      sum_at_end = {sum_at_end.x + b.x, sum_at_end.y + b.y, sum_at_end.z + b.z};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(std::fabs(coordinate(sum, k)) <= 0x1p-50 * size);
      REQUIRE(std::fabs(coordinate(sum_at_end, k)) <= 0x1p-50 * size);
    }
    // One coordinate a little less and more. The third derivative counts where two elements hardly meet.
    const std::size_t corner = rng.below(corner_count(query.kind)), axis = rng.below(3);
    const bool of_end = rng.one_in(2);
    const double step = 0x1p-22;
    std::array<double, 2> times{};
    bool both = true;
    for (const int sign : {-1, 1}) {
      Query moved = query;
      coordinate_of((of_end ? moved.end : moved.start)[corner], axis) += sign * step;
      const Answer later = solve(moved, {.separation = separation});
      both = both && later.contact;
      times[sign < 0 ? 0 : 1] = later.toi;
    }
    // Beyond the ends of the step a time does not go on, and another contact may begin before the start.
    const auto [least, most] = std::minmax(times[0], times[1]);
    if (!both || size > 20 || least < 1e-3 || most > 1 - 1e-3) continue;
    ++compared;
    const double found = coordinate((of_end ? gradient.end : gradient.start)[corner], axis);
    const double by_times = (times[1] - times[0]) / (2 * step);
    CAPTURE(corner, axis, of_end, size, found, by_times);
    CHECK(std::fabs(by_times - found) <= 1e-8 * std::pow(1 + size, 5));
  }
  CAPTURE(compared);
  CHECK((compared > effort(1500) / 8 || !whole_effort("how many differences are compared")));
}

TEST_CASE("there is no gradient without a contact, at the start, at a border, or where elements only touch") {
  const auto none = [](const Query& query, const Separation& separation = {}) {
    const ToiGradient gradient = toi_gradient(query, separation);
    CHECK_FALSE(gradient.exists);
    CHECK(is_zero(gradient));
  };
  const auto falling = [](double x, double y, double from, double to) {
    return Query(
        VertexFace{{{{x, y, from}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{x, y, to}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  };
  none(falling(1, 1, 3, 1));                                                   // no contact
  none(falling(1, 1, 0, -1));                                                  // at the start
  none(falling(2, 0, 3, -1));                                                  // on an edge
  none(falling(0, 0, 3, -1));                                                  // on a corner
  CHECK(toi_gradient(falling(2, 0, 3, -1), {0.5, Metric::euclidean}).exists);  // its distance has a gradient there
  none(Query(PointPoint{{{{0, 0, 0}, {1, 0, 0}}}, {{{2, 0, 0}, {1, 0, 0}}}}));
  CHECK(toi_gradient(Query(PointPoint{{{{0, 0, 0}, {1, 0, 0}}}, {{{2, 0, 0}, {1, 0, 0}}}}), {0.5, Metric::euclidean})
            .start[0]
            .x == -0.375);  // T = 1/4
  // A point that passes another one at exactly the separation.
  none(Query(PointPoint{{{{-1, 1, 0}, {0, 0, 0}}}, {{{1, 1, 0}, {0, 0, 0}}}}), {1, Metric::euclidean});
  // Parallel edges.
  const Query parallel =
      EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 2}, {2, 0, 2}}}, {{{0, 0, 0}, {1, 0, 0}, {0.5, 0, -2}, {2, 0, -2}}}};
  none(parallel);
  none(parallel, {0.5, Metric::euclidean});
  CHECK_THROWS_AS(toi_gradient(parallel, {0.5, Metric::max}), InvalidQuery);
  CHECK_THROWS_AS(toi_gradient(parallel, {}, 2), InvalidQuery);
}

TEST_CASE("gradients of any size are found") {
  for (const double size : {0x1p-500, 0x1p-60, 0x1p60, 0x1p500}) {
    const Query query = VertexFace{{{{size, size, 3 * size}, {0, 0, 0}, {4 * size, 0, 0}, {0, 4 * size, 0}}},
                                   {{{size, size, -size}, {0, 0, 0}, {4 * size, 0, 0}, {0, 4 * size, 0}}}};
    const ToiGradient gradient = toi_gradient(query);
    REQUIRE(gradient.exists);
    CHECK(gradient.start[0].z == 0.0625 / size);
  }
}
