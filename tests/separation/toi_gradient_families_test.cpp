// Gradients of first contacts' times in every family of queries against rational ones, and how many doubles decide.
// SPDX-License-Identifier: MIT
#include <touchstone/toi_gradient.hpp>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include <touchstone/solve.hpp>

#include "exact/exact.hpp"
#include "filters/coplanar_gradient.hpp"
#include "filters/filters.hpp"
#include "filters/separation/entry_gradient.hpp"
#include "separation/distances.hpp"
#include "separation/rational_gradients.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

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
bool agrees(const ToiGradient& found, const std::optional<RationalGradient>& truth) {
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
    for (std::size_t i = 0; i < effort(50); ++i) {
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
          REQUIRE(agrees(found, rational_gradient(query, Rational(answer.toi))));
        } else {
          const auto right = [&](int bisections) {
            const std::optional<Rational> time = plane_time(query, answer.toi, answer.toi_upper, bisections);
            if (!time) ++two_times;
            return !time || agrees(found, rational_gradient(query, *time));
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
  CHECK(ordinary > 70);
  CHECK(100 * ordinary_in_doubles > 95 * ordinary);
  CHECK(degenerate > 300);
  CHECK(20 * two_times < degenerate);
  CHECK(degenerate_in_doubles > 150);
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
    for (std::size_t i = 0; i < effort(is_ordinary ? 100 : 4); ++i) {
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
          REQUIRE((agrees(found, truth) || agrees(found, rational_gradient(query, answer, separation.distance, 2500))));
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
  CHECK(others_in_doubles > 60);
  CHECK(others_in_doubles < others);
}
