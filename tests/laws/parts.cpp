// Parts and wholes: an element cut in two has the contacts of the whole, a part has no
// others, and a degenerate element has the contacts of the simpler element that it is.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "laws/law.hpp"
#include "laws/time_sets.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 14;

bool has_parts(const FamilyInfo&, Kind kind) { return kind != Kind::point_point; }
bool dyadic_with_parts(const FamilyInfo& family, Kind kind) { return family.dyadic && kind != Kind::point_point; }

// A query of another kind from chosen corners.
Query of_corners(const Query& query, Kind kind, const std::vector<std::size_t>& corners) {
  Query result;
  result.kind = kind;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    result.start[i] = query.start[corners[i]];
    result.end[i] = query.end[corners[i]];
  }
  return result;
}

// Puts corner `moved` at `share` of the way from `from` to `to`, both ends; exact for dyadic coordinates.
Query with_corner_between(const Query& query, std::size_t moved, std::size_t from, std::size_t to, double share) {
  Query result = query;
  result.start[moved] = query.start[from] + share * (query.start[to] - query.start[from]);
  result.end[moved] = query.end[from] + share * (query.end[to] - query.end[from]);
  return result;
}

// The two queries that an element, cut at `share` along one edge, makes of one.
std::pair<Query, Query> cut_in_two(const Query& query, Rng& rng) {
  static constexpr std::array<double, 4> shares{0.5, 0.25, 0.375, 0.9375};
  const double share = rng.pick(shares);
  std::size_t i = element_sizes(query.kind).a, j = i + 1;  // the edge that is cut
  if (query.kind == Kind::edge_edge && rng.one_in(2)) {
    i = 0;
    j = 1;
  } else if (query.kind == Kind::vertex_face) {
    i = 1 + static_cast<std::size_t>(rng.between(0, 2));
    j = i % 3 + 1;
  }
  return {with_corner_between(query, j, i, j, share), with_corner_between(query, i, i, j, share)};
}

TEST_CASE("law: an element cut in two touches when one of its parts does") {
  check_law(kSeed, 200, dyadic_with_parts, 1,
            [](const Query& query, Method, Rng& rng) -> Finding {
              const auto [first, second] = cut_in_two(query, rng);
              return set_difference(united(contact_times(first), contact_times(second)), contact_times(query));
            },
            {Method::exact});
}

TEST_CASE("law: nothing slips through a joint") {
  check_law(kSeed, 200, dyadic_with_parts, 1, [](const Query& query, Method method, Rng& rng) -> Finding {
    const auto [one, two] = cut_in_two(query, rng);
    const Answer whole = solve(query, {.method = method});
    const Answer first = solve(one, {.method = method});
    const Answer second = solve(two, {.method = method});
    if (whole.contact != (first.contact || second.contact)) return "contact with the whole, but not with the parts";
    if (!whole.contact) return "";
    if (whole.toi == std::min(first.toi, second.toi) &&
        whole.toi_upper == std::min(first.toi_upper, second.toi_upper)) {
      return "";
    }
    return "whole  " + describe(whole) + "\n    first  " + describe(first) + "\n    second " + describe(second);
  });
}

// The queries between one corner of an element and the other element, or between a corner and an edge of the face.
std::vector<Query> parts_of(const Query& query) {
  switch (query.kind) {
    case Kind::edge_edge:
      return {of_corners(query, Kind::point_edge, {0, 2, 3}), of_corners(query, Kind::point_edge, {1, 2, 3}),
              of_corners(query, Kind::point_edge, {2, 0, 1}), of_corners(query, Kind::point_edge, {3, 0, 1})};
    case Kind::vertex_face:
      return {of_corners(query, Kind::point_edge, {0, 1, 2}), of_corners(query, Kind::point_edge, {0, 2, 3}),
              of_corners(query, Kind::point_edge, {0, 3, 1})};
    case Kind::point_edge:
      return {of_corners(query, Kind::point_point, {0, 1}), of_corners(query, Kind::point_point, {0, 2})};
    case Kind::point_point: break;
  }
  return {};
}

TEST_CASE("law: where a part touches, the whole does") {
  check_law(kSeed, 100, has_parts, 1,
            [](const Query& query, Method, Rng&) -> Finding {
              const TimeSet whole = contact_times(query);
              for (const Query& part : parts_of(query)) {
                const std::string wrong = set_difference(whole, united(whole, contact_times(part)));
                if (!wrong.empty()) return wrong + "\n    by " + cpp_initializer(part);
              }
              return "";
            },
            {Method::exact});
}

TEST_CASE("law: a part touches no earlier than the whole") {
  check_law(kSeed, 100, has_parts, 1, [](const Query& query, Method method, Rng&) -> Finding {
    const Answer whole = solve(query, {.method = method});
    for (const Query& part : parts_of(query)) {
      const Answer answer = solve(part, {.method = method});
      if (!answer.contact || (whole.contact && whole.toi <= answer.toi && whole.toi_upper <= answer.toi_upper))
        continue;
      return "whole " + describe(whole) + "\n    part  " + describe(answer) + "\n    " + cpp_initializer(part);
    }
    return "";
  });
}

// A query with a degenerate element, and the lesser query that it is.
struct Degenerate {
  Query degenerate;
  Query lesser;
};

std::vector<Degenerate> degenerate_forms(const Query& query) {
  switch (query.kind) {
    case Kind::point_edge:
      return {{of_corners(query, Kind::edge_edge, {0, 0, 1, 2}), query},
              {of_corners(query, Kind::edge_edge, {1, 2, 0, 0}), query},
              {of_corners(query, Kind::vertex_face, {0, 1, 2, 2}), query},
              {of_corners(query, Kind::vertex_face, {0, 1, 2, 1}), query},
              {of_corners(query, Kind::vertex_face, {0, 1, 1, 2}), query}};
    case Kind::point_point:
      return {{of_corners(query, Kind::point_edge, {0, 1, 1}), query},
              {of_corners(query, Kind::edge_edge, {0, 0, 1, 1}), query},
              {of_corners(query, Kind::vertex_face, {0, 1, 1, 1}), query}};
    default: return {};
  }
}

TEST_CASE("law: a degenerate element is the lesser one that it is") {
  const auto lesser = [](const FamilyInfo&, Kind kind) {
    return kind == Kind::point_edge || kind == Kind::point_point;
  };
  check_law(kSeed, 200, lesser, 1, [](const Query& query, Method method, Rng&) -> Finding {
    const TimeSet times = contact_times(query);
    for (const Degenerate& form : degenerate_forms(query)) {
      const Answer expected = solve(form.lesser, {.method = method});
      const Answer found = solve(form.degenerate, {.method = method});
      const bool same = expected.contact == found.contact &&
                        (!expected.contact || (expected.toi == found.toi && expected.toi_upper == found.toi_upper &&
                                               expected.nature == found.nature));
      if (!same) {
        return "expected " + describe(expected) + "\n    found    " + describe(found) + "\n    asked    " +
               cpp_initializer(form.degenerate);
      }
      const std::string wrong = set_difference(times, contact_times(form.degenerate));
      if (!wrong.empty()) return wrong + "\n    asked    " + cpp_initializer(form.degenerate);
    }
    return "";
  });
}

}  // namespace
}  // namespace touchstone::tests
