// SPDX-License-Identifier: MIT
#include "mesh/candidate_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "filters/separation/distance_bound.hpp"
#include "mesh/narrow.hpp"
#include "mesh/pair_distance.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::mesh {
namespace {

using broad_phase::Pair;

constexpr double Vec3::*kAxes[3] = {&Vec3::x, &Vec3::y, &Vec3::z};

/// The margin as a fraction of an edge's length: steps of a simulation are a small part of it, and the candidates are
/// hardly more.
constexpr double kMarginOfEdge = 0x1p-4;

/// The margin as a fraction of the largest coordinate, at least. A coordinate y(s) of the reference is computed with
/// products and sums of relative error 2^-53 each, so it is off by less than 2^-50 of that coordinate, but for
/// underflow.
constexpr double kLeastMargin = 0x1p-40;

/// Motions are compared with this fraction of the margin: the rest covers the errors of y(s) and of the comparison.
constexpr double kUsedMargin = 0.75;

/// Pairs of boxes that meet, for each vertex and edge, at most: where there are more, keeping pairs costs more than it
/// saves.
constexpr std::size_t kMostForEach = 16;

double largest_coordinate(const Motion& motion) noexcept {
  double largest = 0;
  for (const MovingVertex& vertex : motion) {
    for (const auto axis : kAxes) {
      largest = std::max({largest, std::fabs(vertex.start.*axis), std::fabs(vertex.end.*axis)});
    }
  }
  return largest;
}

/// The pairs that may come as near as they are to keep, in a motion within the margin of the reference.
///
/// Proof: let L be a lower bound of a pair's distance in the reference at all times, and a the distance that a vertex
/// is off at most: sqrt(3) m. An element of the motion is at each time within a of one of the reference. So the pair's
/// distance is at least L - 2 a. What it is to keep is d + f (D0 - d). D0, at the start, is at most 2 a more than in
/// the reference: so what is to be kept is at most 2 f a more than there. The pair keeps it if L >= k + 2 (1 + f) a,
/// for the k of the reference. In the max metric a distance is at least the Euclidean one over sqrt(3), and off by 2 m:
/// so L >= sqrt(3) (k + 2 (1 + f) m).
class NearPairs {
 public:
  NearPairs(const Mesh::Impl& mesh, const Motion& reference, double kept_fraction, double margin)
      : mesh_(mesh),
        reference_(reference),
        distances_(mesh, reference, kept_fraction),
        in_max_(mesh.separation.metric == Metric::max),
        room_(2 * (1 + kept_fraction) * (in_max_ ? margin : kRoot3 * margin)) {}

  bool may_meet(const MeshPair& pair) const {
    const auto corners = corners_of(mesh_, pair);
    const double least = filters::least_distance(query_of(reference_, pair.kind, corners));
    if (!(least > room_)) return true;
    const double kept = distances_.are_zero() ? 0 : distances_.quick(pair, corners).distance;
    return !(least > kMoreRoom * (in_max_ ? kRoot3 : 1) * (kept + room_));
  }

 private:
  static constexpr double kRoot3 = 1.7320508075688775;  // a little more
  /// Covers what a bound of D0 in doubles adds to what is to be kept, less than 2^-10 of it, and rounding errors.
  static constexpr double kMoreRoom = 1 + 0x1p-9;

  const Mesh::Impl& mesh_;
  const Motion& reference_;
  KeptDistances distances_;
  bool in_max_;
  double room_;
};

/// Written so that NaN is not near.
bool is_near(double x, double y, double margin) noexcept { return std::fabs(x - y) <= margin; }

}  // namespace

void CandidateSearch::release() noexcept {
  state_ = State::no_reference;
  of_use_ = true;
  Motion().swap(reference_);
  for (auto& pairs : pairs_) broad_phase::LargeVector<Pair>().swap(pairs);
}

bool CandidateSearch::covers(const Motion& motion, double kept_fraction) const noexcept {
  if (state_ == State::no_reference || kept_fraction > kept_fraction_) return false;
  // For a lesser fraction there may be few enough.
  if (state_ == State::too_many && kept_fraction < kept_fraction_) return false;
  const MovingVertex& lead = reference_[farthest_];
  const double way = lead.end.*along_ - lead.start.*along_;
  const double fraction =
      way == 0 ? 1 : std::clamp((motion[farthest_].end.*along_ - lead.start.*along_) / way, 0.0, 1.0);
  const double margin = kUsedMargin * margin_;
  for (std::size_t v = 0; v < motion.size(); ++v) {
    const MovingVertex &y = reference_[v], &x = motion[v];
    for (const auto axis : kAxes) {
      if (!is_near(x.start.*axis, y.start.*axis, margin)) return false;
      if (!is_near(x.end.*axis, y.start.*axis + fraction * (y.end.*axis - y.start.*axis), margin)) return false;
    }
  }
  return true;
}

void CandidateSearch::refer_to(const Motion& motion, double kept_fraction) {
  state_ = State::no_reference;
  if (kept_fraction > kMostBounded) return;
  reference_ = motion;
  kept_fraction_ = kept_fraction;
  margin_ = std::max(kMarginOfEdge * usual_edge_length(mesh_, motion), kLeastMargin * largest_coordinate(motion));
  double farthest = -1;
  for (std::size_t v = 0; v < motion.size(); ++v) {
    for (const auto axis : kAxes) {
      const double way = std::fabs(motion[v].end.*axis - motion[v].start.*axis);
      if (!(way > farthest)) continue;
      farthest = way;
      farthest_ = v;
      along_ = axis;
    }
  }
  // Beside a margin that is a normal number, no underflow counts.
  if (std::isfinite(margin_) && margin_ >= std::numeric_limits<double>::min()) state_ = State::without_lists;
}

/// Fills the lists, unless there are too many candidates.
void CandidateSearch::collect(int threads, const std::atomic<bool>* stop) {
  Reach reach = reach_of(mesh_, reference_, kept_fraction_);
  // Beside a part s of the reference's usual way, a vertex of the motion moves by at most 2 sqrt(3) m more than the
  // reference's vertex beside the whole. By f / (1 - f) of that a fraction f has a reach.
  const double wider = margin_ * (1 + 4 * kept_fraction_ / (1 - kept_fraction_));
  reach.same = with_room(reach.same + wider);
  for (double& one : reach.of_vertices) one = with_room(one + wider);

  for (auto& pairs : pairs_) pairs.clear();
  const std::size_t most = kMostForEach * (mesh_.vertex_count + mesh_.edges.size());
  const NearPairs near(mesh_, reference_, kept_fraction_, margin_);
  std::atomic<std::size_t> count{0};
  std::mutex lock;
  std::atomic<double> until{1};
  ++searches_;
  const auto take = [&](Kind kind, const Pair* pairs, std::size_t size) {
    check_stop(stop);
    if ((count += size) > most) {
      until = -1;  // no more boxes meet
      return;
    }
    std::array<Pair, broad_phase::kPairBlock> kept;
    const auto end = std::copy_if(pairs, pairs + size, kept.begin(), [&](const Pair& pair) {
      return near.may_meet({kind, pair[0], pair[1]});
    });
    const std::lock_guard<std::mutex> guard(lock);
    auto& list = pairs_[static_cast<std::size_t>(kind)];
    list.insert(list.end(), kept.begin(), end);
  };
  for_each_candidate_block(mesh_, reference_, reach, {threads, &until}, take);
  if (count > most) {
    for (auto& pairs : pairs_) broad_phase::LargeVector<Pair>().swap(pairs);
    state_ = State::too_many;
    return;
  }
  state_ = State::with_lists;
}

void CandidateSearch::for_each_block(const Motion& motion, double kept_fraction, const broad_phase::PairSearch& search,
                                     const std::atomic<bool>* stop, const CandidateConsumer& take) {
  // Lists are made for a second question about a reference, and at once if those of the reference before were of use.
  const bool alike = covers(motion, kept_fraction);
  if (!alike) refer_to(motion, kept_fraction);
  const bool keeps = alike || std::exchange(of_use_, false);
  if (keeps && state_ == State::without_lists) collect(search.threads, stop);
  if (keeps && state_ == State::with_lists) {
    if (alike) of_use_ = true;
    for (const Kind kind : kKinds) {
      const auto& pairs = pairs_[static_cast<std::size_t>(kind)];
      threads::for_each_range(pairs.size(), broad_phase::kPairBlock, search.threads,
                              [&](std::size_t first, std::size_t last) {
                                for (std::size_t at = first; at < last; at += broad_phase::kPairBlock) {
                                  take(kind, &pairs[at], std::min(broad_phase::kPairBlock, last - at));
                                }
                              });
    }
    return;
  }
  ++searches_;
  const Reach reach = reach_of(mesh_, motion, kept_fraction, broad_phase::until(search));
  for_each_candidate_block(mesh_, motion, reach, search, take);
}

}  // namespace touchstone::mesh
