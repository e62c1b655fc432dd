// SPDX-License-Identifier: MIT
#include "mesh/narrow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <touchstone/distance.hpp>
#include <touchstone/solve.hpp>

#include "filters/separation/distance_bound.hpp"
#include "geometry/kind_traits.hpp"
#include "mesh/pair_distance.hpp"

namespace touchstone::mesh {
namespace {

constexpr double kFarthest = std::numeric_limits<double>::infinity();

}  // namespace

ColumnBlock::ColumnBlock() {
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      columns_.start[c][k] = coordinates_ + (6 * c + k) * kStride;
      columns_.end[c][k] = coordinates_ + (6 * c + 3 + k) * kStride;
    }
  }
}

ColumnBlock& ColumnBlock::of_thread(Kind kind) {
  // Null before the first call, and after the thread's objects have gone: destructors of static objects may ask too.
  thread_local ColumnBlock* block = nullptr;
  struct Release {
    ~Release() { delete std::exchange(block, nullptr); }
  };
  if (block == nullptr) {
    block = new ColumnBlock;
    thread_local const Release release;
  }
  block->columns_.kind = kind;
  block->clear();
  return *block;
}

void ColumnBlock::solve(double t_max, Wanted wanted, Metric metric, const double* distances) {
  BatchOptions options;
  options.t_max = t_max;
  options.wanted = wanted;
  options.separation.metric = metric;
  if (distances != nullptr) {
    options.separations = distances;
    options.separation_count = columns_.count;
  }
  solve_batch(columns_, answers_, options);
}

// Each operation is rounded up, and d + fraction (D0 - d) rises with each of its parts.
double KeptDistances::kept(double separation, double at_start) const noexcept {
  const auto upwards = [](double x) { return std::nextafter(x, kFarthest); };
  const double clearance = upwards(std::max(0.0, at_start - separation));
  const double all = upwards(separation + upwards(fraction_ * clearance));
  return std::min(all, std::numeric_limits<double>::max());
}

KeptDistances::Kept KeptDistances::quick(const MeshPair& pair, const std::array<Index, 4>& corners) const {
  const double separation = separation_of(mesh_, pair, corners);
  if (fraction_ == 0) return {separation, false, 0};
  if (fraction_ <= kMostBounded && metric() == Metric::euclidean) {
    const auto bound = filters::distance_bound(query_of(motion_, pair.kind, corners), 0);
    // So the distance to keep grows by less than 2^-10 of its excess over the separation.
    if (bound && filters::kLoosestBound * *bound <= 0x1p-11 * (*bound - separation)) {
      return {kept(separation, *bound), false, *bound * (1 - 2 * filters::kLoosestBound)};
    }
  }
  // The distance of the elements is at most that of their nearest corners.
  double nearest = kFarthest;
  for (std::size_t i = 0; i < geometry::corners_of_first(pair.kind); ++i) {
    for (std::size_t j = geometry::corners_of_first(pair.kind); j < corner_count(pair.kind); ++j) {
      const Vec3 &a = motion_[corners[i]].start, &b = motion_[corners[j]].start;
      nearest = std::min(nearest, std::hypot(a.x - b.x, a.y - b.y, a.z - b.z));
    }
  }
  return {kept(separation, with_room(nearest)), true, 0};
}

// Seen from a corner of the second element, which does not change the distance, corner c moves by w_c in the step. Each
// point of an element is a convex combination of its corners: so the distance falls by at most the greatest |w_c| of
// either element until t = 1, and by a part t of that until the time t.
// A coordinate of w_c is off by less than 2^-51 of the greatest coordinate of a way. Squares that underflow make less
// than 2^-500 of it: nothing beside distances for which there is a bound at the start.
bool KeptDistances::keeps(const Kept& kept, Kind kind, const std::array<Index, 4>& corners,
                          double t_max) const noexcept {
  if (!(kept.least_at_0 > kept.distance)) return false;
  constexpr double kRoundings = 1 + 0x1p-40;  // of the roots, the sums and the product
  const Vec3 seen_from = way_of(motion_[corners[corner_count(kind) - 1]]);
  std::array<double, 2> greatest{};  // squares
  double largest = 0;
  for (std::size_t c = 0; c < corner_count(kind); ++c) {
    const Vec3 way = way_of(motion_[corners[c]]);
    const double x = way.x - seen_from.x, y = way.y - seen_from.y, z = way.z - seen_from.z;
    double& square = greatest[c < geometry::corners_of_first(kind) ? 0 : 1];
    square = std::max(square, x * x + y * y + z * z);
    largest = std::max({largest, std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)});
  }
  const double way = std::sqrt(greatest[0]) + std::sqrt(greatest[1]) + 0x1p-48 * largest + 0x1p-500;
  return kept.least_at_0 > (kept.distance + t_max * way) * kRoundings;
}

double KeptDistances::exact(const MeshPair& pair, const std::array<Index, 4>& corners) const {
  const double separation = separation_of(mesh_, pair, corners);
  if (fraction_ == 0) return separation;
  const double at_start = distance(query_of(motion_, pair.kind, corners), 0, metric()).value;  // the nearest double
  return kept(separation, at_start == 0 ? 0 : std::nextafter(at_start, kFarthest));
}

void for_each_contact(const Mesh::Impl& mesh, const Motion& motion, const KeptDistances& distances, Kind kind,
                      const broad_phase::Pair* pairs, std::size_t count, double t_max, Wanted wanted,
                      const ContactConsumer& contact) {
  ColumnBlock& columns = ColumnBlock::of_thread(kind);
  std::array<double, ColumnBlock::kQueries> kept;
  std::array<bool, ColumnBlock::kQueries> is_bound{};
  std::array<std::array<Index, 4>, ColumnBlock::kQueries> all_corners;
  std::array<std::size_t, ColumnBlock::kQueries> numbers;
  const bool without_distances = distances.are_zero();
  const std::size_t corners_each = corner_count(kind);
  for (std::size_t begin = 0; begin < count; begin += ColumnBlock::kQueries) {
    const std::size_t size = std::min(ColumnBlock::kQueries, count - begin);
    columns.clear();
    for (std::size_t i = 0; i < size; ++i) {
      const MeshPair pair{kind, pairs[begin + i][0], pairs[begin + i][1]};
      const std::size_t at = columns.size();
      const auto& corners = all_corners[at] = corners_of(mesh, pair);
      if (!without_distances) {
        const KeptDistances::Kept quick = distances.quick(pair, corners);
        if (distances.keeps(quick, kind, corners, t_max)) continue;
        kept[at] = quick.distance;
        is_bound[at] = quick.is_bound;
      }
      numbers[at] = begin + i;
      for (std::size_t c = 0; c < corners_each; ++c) columns.set(c, motion[corners[c]].start, motion[corners[c]].end);
      columns.finish_query();
    }
    columns.solve(t_max, wanted, distances.metric(), without_distances ? nullptr : kept.data());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Answer& answer = columns.answers()[i];
      if (!answer.contact) continue;
      const MeshPair pair{kind, pairs[numbers[i]][0], pairs[numbers[i]][1]};
      if (!is_bound[i]) {
        contact(pair, without_distances ? 0 : kept[i], answer);
        continue;
      }
      const double distance = distances.exact(pair, all_corners[i]);
      const Query query = query_of(motion, kind, all_corners[i]);
      const Answer own =
          touchstone::solve(query, {.t_max = t_max, .separation = {distance, distances.metric()}, .wanted = wanted});
      if (own.contact) contact(pair, distance, own);
    }
  }
}

}  // namespace touchstone::mesh
