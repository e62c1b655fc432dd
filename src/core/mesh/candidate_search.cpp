// SPDX-License-Identifier: MIT
#include "mesh/candidate_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "mesh/pair_distance.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::mesh {
namespace {

using broad_phase::Pair;

constexpr double Vec3::*kAxes[3] = {&Vec3::x, &Vec3::y, &Vec3::z};

/// The margin as a fraction of the mean length of an edge: steps of a simulation are a small part of it, and the
/// candidates are hardly more.
constexpr double kMarginOfEdge = 0x1p-4;

/// The margin as a fraction of the largest coordinate, at least. A coordinate y(s) of the reference is computed with
/// products and sums of relative error 2^-53 each, so it is off by less than 2^-50 of that coordinate, but for
/// underflow.
constexpr double kLeastMargin = 0x1p-40;

/// Motions are compared with this fraction of the margin: the rest covers the errors of y(s) and of the comparison.
constexpr double kUsedMargin = 0.75;

/// Lists of a path that is a smaller fraction of the reference are not made: its own are shorter too.
constexpr double kLeastFraction = 0.5;

/// Candidates for each vertex and edge, at most: where there are more, keeping them costs more than it saves.
constexpr std::size_t kMostForEach = 64;

double largest_coordinate(const Motion& motion) noexcept {
  double largest = 0;
  for (const MovingVertex& vertex : motion) {
    for (const auto axis : kAxes) {
      largest = std::max({largest, std::fabs(vertex.start.*axis), std::fabs(vertex.end.*axis)});
    }
  }
  return largest;
}

/// Of the positions at the start; 0 without edges.
double mean_edge_length(const Mesh::Impl& mesh, const Motion& motion) noexcept {
  double sum = 0;
  for (const auto& edge : mesh.edges) {
    const Vec3 &a = motion[edge[0]].start, &b = motion[edge[1]].start;
    sum += std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) / static_cast<double>(mesh.edges.size());
  }
  return sum;
}

/// Written so that NaN is not near.
bool is_near(double x, double y, double margin) noexcept { return std::fabs(x - y) <= margin; }

}  // namespace

void CandidateSearch::release() noexcept {
  state_ = State::no_reference;
  Motion().swap(reference_);
  for (auto& pairs : pairs_) broad_phase::LargeVector<Pair>().swap(pairs);
}

bool CandidateSearch::covers(const Motion& motion, double kept_fraction) noexcept {
  if (state_ == State::no_reference || kept_fraction != kept_fraction_) return false;
  const MovingVertex& lead = reference_[farthest_];
  const double way = lead.end.*along_ - lead.start.*along_;
  fraction_ = way == 0 ? 1 : std::clamp((motion[farthest_].end.*along_ - lead.start.*along_) / way, 0.0, 1.0);
  const double margin = kUsedMargin * margin_;
  for (std::size_t v = 0; v < motion.size(); ++v) {
    const MovingVertex &y = reference_[v], &x = motion[v];
    for (const auto axis : kAxes) {
      if (!is_near(x.start.*axis, y.start.*axis, margin)) return false;
      if (!is_near(x.end.*axis, y.start.*axis + fraction_ * (y.end.*axis - y.start.*axis), margin)) return false;
    }
  }
  return true;
}

void CandidateSearch::refer_to(const Motion& motion, double kept_fraction) {
  state_ = State::no_reference;
  if (kept_fraction > kMostBounded) return;
  reference_ = motion;
  kept_fraction_ = kept_fraction;
  const double length = mean_edge_length(mesh_, motion);
  margin_ = std::max(kMarginOfEdge * length, kLeastMargin * largest_coordinate(motion));
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
  // A vertex of the motion moves by at most |y1 - y0| + 2 sqrt(3) m. By f / (1 - f) of that a fraction f has a reach.
  const double wider = margin_ * (1 + 4 * kept_fraction_ / (1 - kept_fraction_));
  reach.same = with_room(reach.same + wider);
  for (double& one : reach.of_vertices) one = with_room(one + wider);

  for (auto& pairs : pairs_) pairs.clear();
  const std::size_t most = kMostForEach * (mesh_.vertex_count + mesh_.edges.size());
  std::size_t count = 0;
  std::mutex lock;
  std::atomic<double> until{1};
  ++searches_;
  for_each_candidate_block(mesh_, reference_, reach, {threads, &until},
                           [&](Kind kind, const Pair* pairs, std::size_t size) {
                             check_stop(stop);
                             const std::lock_guard<std::mutex> guard(lock);
                             auto& list = pairs_[static_cast<std::size_t>(kind)];
                             if ((count += size) > most) {
                               until = -1;  // no more boxes meet
                             } else {
                               list.insert(list.end(), pairs, pairs + size);
                             }
                           });
  if (count > most) {
    for (auto& pairs : pairs_) broad_phase::LargeVector<Pair>().swap(pairs);
    state_ = State::too_many;
    return;
  }
  state_ = State::with_lists;
}

void CandidateSearch::for_each_block(const Motion& motion, double kept_fraction, const broad_phase::PairSearch& search,
                                     const std::atomic<bool>* stop, const CandidateConsumer& take) {
  const bool alike = covers(motion, kept_fraction);
  if (alike && state_ == State::without_lists && fraction_ >= kLeastFraction) collect(search.threads, stop);
  if (alike && state_ == State::with_lists) {
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
  if (!alike || state_ == State::without_lists) refer_to(motion, kept_fraction);
  ++searches_;
  for_each_candidate_block(mesh_, motion, reach_of(mesh_, motion, kept_fraction), search, take);
}

}  // namespace touchstone::mesh
