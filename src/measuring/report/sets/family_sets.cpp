// SPDX-License-Identifier: MIT
#include "report/sets/family_sets.hpp"

#include <array>
#include <cmath>
#include <iterator>

#include "families/families.hpp"
#include "generators/candidates.hpp"
#include "generators/vectors.hpp"

namespace touchstone::report {
namespace {

using generators::operator+;
using generators::operator-;
using generators::operator*;
using seeded::Rng;

constexpr std::array<Kind, 2> kAskedKinds{Kind::edge_edge, Kind::vertex_face};

QuerySet empty_set(const std::string& family, Kind kind, const std::string& about) {
  QuerySet set;
  set.name = family + "/" + std::string(name_of(kind));
  set.about = about;
  set.kind = kind;
  return set;
}

Vec3 random_corner(Rng& random) {
  // One statement each, so that the order of the draws is fixed.
  Vec3 corner;
  corner.x = random.uniform(-1, 1);
  corner.y = random.uniform(-1, 1);
  corner.z = random.uniform(-1, 1);
  return corner;
}

Query random_query(Kind kind, Rng& random) {
  Query query;
  query.kind = kind;
  for (std::size_t k = 0; k < corner_count(kind); ++k) {
    query.start[k] = random_corner(random);
    query.end[k] = random_corner(random);
  }
  return query;
}

/// Just below or above `border`.
double beside(double border, Rng& random) {
  const double distance = std::ldexp(random.uniform(0.5, 1), -static_cast<int>(random.below(44)) - 6);
  return random.below(2) == 0 ? border - distance : border + distance;
}

/// The time and one weight of a meeting. At least one of the two is near a border of its range [0, 1].
struct MeetingNearBorder {
  double time;
  double weight;
};

MeetingNearBorder meeting_near_border(Rng& random) {
  const std::uint64_t which = random.below(3);  // the weight alone, the time alone, or both
  MeetingNearBorder meeting{random.uniform(0.1, 0.9), random.uniform(0.2, 0.8)};
  if (which != 0) meeting.time = beside(static_cast<double>(random.below(2)), random);
  if (which != 1) meeting.weight = beside(static_cast<double>(random.below(2)), random);
  return meeting;
}

/// The position at `time` of the point with these weights of three corners (or fewer). It is computed in doubles, which
/// is near enough.
Vec3 point_at(const Query& query, std::size_t first, const std::array<double, 3>& weights, double time) {
  Vec3 point;
  for (std::size_t k = 0; k < weights.size() && first + k < query.start.size(); ++k) {
    const Vec3 corner = query.start[first + k] + time * (query.end[first + k] - query.start[first + k]);
    point = point + weights[k] * corner;
  }
  return point;
}

Query near_query(Kind kind, Rng& random) {
  Query query = random_query(kind, random);
  const MeetingNearBorder meeting = meeting_near_border(random);
  const double other = random.uniform(0.2, 0.8);
  Vec3 shift;
  std::size_t moved = 1;  // corners of the first element: an edge's two or the one vertex
  if (kind == Kind::edge_edge) {
    moved = 2;
    shift = point_at(query, 2, {1 - other, other, 0}, meeting.time) -
            point_at(query, 0, {1 - meeting.weight, meeting.weight, 0}, meeting.time);
  } else {
    const double rest = 1 - meeting.weight;
    shift = point_at(query, 1, {meeting.weight, rest * other, rest * (1 - other)}, meeting.time) -
            point_at(query, 0, {1, 0, 0}, meeting.time);
  }
  for (std::size_t k = 0; k < moved; ++k) {
    query.start[k] = query.start[k] + shift;
    query.end[k] = query.end[k] + shift;
  }
  return query;
}

/// What all scenes of a family have in common.
struct SceneOptions {
  std::uint64_t seed;
  SceneSize size;
  double separation;
  generators::Placement placement;
};

/// Appends candidates of each scene to the set of edge-edge queries, the first of the two, and to that of vertex-face.
template <std::size_t N>
void append_candidates(const std::array<generators::SceneName, N>& scenes, const SceneOptions& common,
                       std::vector<QuerySet>& sets) {
  for (const generators::SceneName scene : scenes) {
    generators::CandidateOptions options;
    options.scene = scene;
    options.seed = common.seed;
    options.count = common.size.count;
    options.edges = common.size.edges;
    options.steps = common.size.steps;
    options.separation = common.separation;
    options.placement = common.placement;
    generators::for_each_batch(options, [&](const generators::Batch& batch) {
      auto& all = sets[batch.kind == Kind::edge_edge ? 0 : 1].queries;
      all.insert(all.end(), batch.queries.begin(), batch.queries.end());
    });
  }
}

}  // namespace

std::vector<QuerySet> simulation_sets(std::uint64_t seed, const SceneSize& size, double separation) {
  const std::string about =
      "Candidate pairs (boxes around the whole step overlap) of the scenes cloth, sheets and "
      "cables of touchstone generate";
  std::vector<QuerySet> sets{empty_set("simulation", Kind::edge_edge, about),
                             empty_set("simulation", Kind::vertex_face, about)};
  append_candidates(generators::kScenes, {seed, size, separation, generators::Placement::as_built}, sets);
  return sets;
}

std::vector<QuerySet> aligned_sets(std::uint64_t seed, const SceneSize& size, double separation) {
  std::vector<QuerySet> sets;
  for (const auto placement : {generators::Placement::as_built, generators::Placement::turned}) {
    const bool is_turned = placement == generators::Placement::turned;
    std::string about =
        "Candidate pairs of the scenes boxes, bricks, plane, grid and lying of touchstone generate, which lie along "
        "the axes";
    if (is_turned) about += ", turned by a generic rotation";
    const std::string family = is_turned ? "aligned-turned" : "aligned";
    std::vector<QuerySet> both{empty_set(family, Kind::edge_edge, about), empty_set(family, Kind::vertex_face, about)};
    append_candidates(generators::kAlignedScenes, {seed, size, separation, placement}, both);
    std::move(both.begin(), both.end(), std::back_inserter(sets));
  }
  return sets;
}

std::vector<QuerySet> random_sets(std::uint64_t seed, std::size_t count) {
  std::vector<QuerySet> sets;
  for (const Kind kind : kAskedKinds) {
    Rng random(seeded::seed_of_stream(seed, 1 + static_cast<std::uint64_t>(kind)));
    sets.push_back(empty_set("random", kind, "Corners anywhere in a cube of side 2, at both ends of the step"));
    for (std::size_t i = 0; i < count; ++i) sets.back().queries.push_back(random_query(kind, random));
  }
  return sets;
}

std::vector<QuerySet> near_sets(std::uint64_t seed, std::size_t count) {
  std::vector<QuerySet> sets;
  for (const Kind kind : kAskedKinds) {
    Rng random(seeded::seed_of_stream(seed, 11 + static_cast<std::uint64_t>(kind)));
    sets.push_back(empty_set("near", kind,
                             "Near hits and near misses: the meeting lies within 2^-50 to 2^-6 of the border of an "
                             "element or of the step, inside or outside"));
    for (std::size_t i = 0; i < count; ++i) sets.back().queries.push_back(near_query(kind, random));
  }
  return sets;
}

std::vector<Query> scaled(const std::vector<Query>& queries, int exponent) {
  std::vector<Query> result = queries;
  for (Query& query : result) {
    for (auto* corners : {&query.start, &query.end}) {
      for (Vec3& corner : *corners) {
        corner = {std::ldexp(corner.x, exponent), std::ldexp(corner.y, exponent), std::ldexp(corner.z, exponent)};
      }
    }
  }
  return result;
}

std::vector<QuerySet> curved_sets(std::uint64_t seed, std::size_t count) {
  std::vector<QuerySet> sets;
  for (const Kind kind : kKinds) {
    sets.push_back(empty_set("curved", kind,
                             "All families of curved queries of touchstone fuzz: machines, planned contacts, curves, "
                             "large and tiny turns, extreme lengths"));
    for (const families::FamilyInfo& family : families::curved_families()) {
      for (std::uint64_t index = 0; index < count; ++index) {
        sets.back().curved.push_back(families::make_curved({family.family, kind, seed, index}).query);
      }
    }
  }
  return sets;
}

}  // namespace touchstone::report
