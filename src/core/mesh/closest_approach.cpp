// The boxes of elements are made to hold the elements' ways at all times, and to swell evenly while a number s goes
// from 0 to 1. Two boxes that meet first at s are as far from each other, along some axis, as they have swollen by
// then, and the elements no nearer. So pairs whose boxes meet only after that part of the swelling that makes up the
// least distance found so far are no nearer: the search for moving boxes, with a time that falls, looks for the nearest
// pair.
// SPDX-License-Identifier: MIT
#include <touchstone/closest_approach.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <touchstone/distance.hpp>
#include <touchstone/solve.hpp>

#include "filters/separation/distance_bound.hpp"
#include "mesh/candidates.hpp"
#include "mesh/contacts.hpp"
#include "mesh/folds.hpp"
#include "mesh/intersections.hpp"
#include "mesh/pair_distance.hpp"
#include "mesh/rounded_distance.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"

namespace touchstone::mesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMost = std::numeric_limits<double>::max();
constexpr double kLeastSwelling = std::numeric_limits<double>::min();

/// Two elements on their way, and how near they come to each other.
class PairInStep {
 public:
  PairInStep(const Query& query, Metric metric, double t_max) noexcept
      : query_(query), metric_(metric), t_max_(t_max), rests_(true) {
    for (std::size_t c = 0; c < corner_count(query.kind); ++c) rests_ &= same_position(query.start[c], query.end[c]);
  }

  bool comes_within(double distance) const {
    if (rests_) return compare_distance(query_, 0, {distance, metric_}) <= 0;
    return solve(query_, {.t_max = t_max_, .separation = {distance, metric_}, .wanted = Wanted::contact}).contact;
  }

  /// The least double that they come within, if it is less than `most`; nothing else.
  std::optional<double> distance_below(double most) const {
    if (rests_) {
      const double distance = distance_rounded_up(query_, metric_);
      return distance < most ? std::optional(distance) : std::nullopt;
    }
    double low = 0, high = std::nextafter(most, 0);  // not within the one, and within the other
    if (!comes_within(high)) return std::nullopt;
    if (comes_within(0)) return 0;
    while (std::nextafter(low, kInfinity) < high) {
      const double middle = between(low, high);
      (comes_within(middle) ? high : low) = middle;
    }
    return high;
  }

 private:
  /// The double in the middle of all doubles between two that are not negative.
  static double between(double a, double b) noexcept {
    const auto low = std::bit_cast<std::uint64_t>(a), high = std::bit_cast<std::uint64_t>(b);
    return std::bit_cast<double>(low + (high - low) / 2);
  }

  const Query& query_;
  Metric metric_;
  double t_max_;
  bool rests_;
};

/// Half of the greatest extent of the mesh's elements in the step, or a little more.
double half_extent(const Mesh::Impl& mesh, const Motion& motion) noexcept {
  double greatest = 0;
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    double low = kInfinity, high = -kInfinity;
    for (const Index v : mesh.vertices) {
      const MovingVertex& vertex = motion[v];
      low = std::min({low, vertex.start.*axis, vertex.end.*axis});
      high = std::max({high, vertex.start.*axis, vertex.end.*axis});
    }
    greatest = std::max(greatest, 0.5 * high - 0.5 * low);
  }
  return std::clamp(with_room(greatest), kLeastSwelling, kMost);
}

/// The least distance of those that were told so far. Any thread may tell.
class LeastDistance {
 public:
  /// @param swelling  of the boxes
  /// @param so_far    the least distance that another search found
  LeastDistance(double swelling, double so_far) : swelling_(swelling) { tell(so_far); }

  /// Boxes that meet only after this part of their swelling are no nearer.
  const std::atomic<double>& until() const noexcept { return until_; }
  double so_far() const noexcept { return so_far_.load(std::memory_order_relaxed); }

  /// Whether the swelling is so much greater than the least distance that `until` cannot tell pairs apart. The search
  /// then ends early.
  bool swells_too_far() const noexcept {
    return so_far() > 0 && so_far() < kLeastRatio * swelling_ && swelling_ > kLeastSwelling;
  }

  void tell(double distance) {
    const std::lock_guard<std::mutex> guard(lock_);
    if (distance >= so_far_) return;
    so_far_.store(distance, std::memory_order_relaxed);
    // Both boxes swell: s of 2 swelling is the distance. The rest is for roundings.
    const double until = std::min(1.0, 0.5 * distance / swelling_ * (1 + 0x1p-40) + 0x1p-60);
    until_.store(distance == 0 || swells_too_far() ? kNever : until, std::memory_order_relaxed);
  }

 private:
  static constexpr double kNever = -1;
  static constexpr double kLeastRatio = 0x1p-40;  // to the swelling: far above the reserve for roundings

  double swelling_;
  std::mutex lock_;
  std::atomic<double> until_{1};
  std::atomic<double> so_far_{kInfinity};
};

/// A pair, and what its distance is at least.
struct Candidate {
  double least;
  std::array<Index, 4> corners;
  bool only_folds;  ///< it is asked whether it touches, and not how near it comes
};

/// Tells of those of the pairs that come nearer than all before: first of those that may come nearest.
void tell_nearer(const Mesh::Impl& mesh, const Motion& motion, const StepOptions& options, Kind kind,
                 const broad_phase::Pair* pairs, std::size_t count, LeastDistance& least_distance) {
  const Metric metric = mesh.separation.metric;
  const double factor = metric == Metric::max ? 0.57735 : 1;  // below 1 over the root of 3
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < count; ++i) {
    const MeshPair pair{kind, pairs[i][0], pairs[i][1]};
    const auto corners = corners_of(mesh, pair);
    const double least = factor * filters::least_distance(query_of(motion, kind, corners));
    const bool only_folds = separation_of(mesh, pair, corners) == 0;
    if (least < least_distance.so_far()) candidates.push_back({least, corners, only_folds});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.least < b.least; });
  for (const auto& [least, corners, only_folds] : candidates) {
    if (least >= least_distance.so_far()) return;
    check_stop(options.stop);
    const Query query = query_of(motion, kind, corners);
    const PairInStep pair(query, metric, options.t_max);
    if (only_folds && !pair.comes_within(0)) continue;
    if (const auto distance = pair.distance_below(least_distance.so_far())) least_distance.tell(*distance);
  }
}

/// The least distance of elements that are apart at the start; infinity without any.
double least_distance_of(const Mesh::Impl& mesh, const Motion& motion, const StepOptions& options) {
  Reach reach;
  reach.swelling = half_extent(mesh, motion);
  double least = kInfinity;
  for (;;) {
    LeastDistance least_distance(reach.swelling, least);
    for_each_candidate_block(mesh, motion, reach, {options.threads, &least_distance.until()},
                             [&](Kind kind, const broad_phase::Pair* pairs, std::size_t count) {
                               check_stop(options.stop);
                               tell_nearer(mesh, motion, options, kind, pairs, count, least_distance);
                             });
    least = least_distance.so_far();
    if (!least_distance.swells_too_far()) return least;
    reach.swelling = std::max(least, kLeastSwelling);
  }
}

TOUCHSTONE_BEHIND_GUARD ClosestApproach approach_of(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1,
                                                    const StepOptions& options) {
  const Motion motion = motion_of(mesh, x0, x1, options.threads);
  Mesh::Impl apart = mesh;  // every pair has one separation
  apart.separation.distance = 1;
  apart.radii.clear();
  apart.pair_separations.clear();
  std::vector<Intersection> intersections = find_intersections(apart, motion, options.threads, options.stop);
  ClosestApproach result;
  result.distance = intersections.empty() ? least_distance_of(apart, motion, options) : 0;
  if (result.distance < kInfinity) {
    apart.separation.distance = result.distance;
    ContactSearch search;
    search.t_max = options.t_max;
    search.threads = options.threads;
    search.stop = options.stop;
    result.first_contact = find_first(apart, motion, search);
  }
  result.first_contact.start_checked = true;
  result.first_contact.start_intersections = std::move(intersections);
  return result;
}

}  // namespace
}  // namespace touchstone::mesh

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

ClosestApproach closest_approach(const Mesh& mesh, const Positions& x0, const Positions& x1,
                                 const StepOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_t_max(options.t_max);
  return mesh::approach_of(mesh.impl(), x0, x1, options);
}

ClosestApproach distance(const Mesh& mesh, const Positions& x, const MeshOptions& options) {
  StepOptions at_rest;
  static_cast<MeshOptions&>(at_rest) = options;
  return closest_approach(mesh, x, x, at_rest);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
