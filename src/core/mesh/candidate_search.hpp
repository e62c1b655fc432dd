// The candidates of a mesh for one question after another, kept while the questions are alike.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include <touchstone/mesh.hpp>

#include "broad_phase/large_vector.hpp"
#include "mesh/candidates.hpp"

namespace touchstone::mesh {

/// Keeps the candidates of a *reference*: an earlier motion, whose boxes are wider by a margin on all sides. Those that
/// may come as near as they are to keep are handed out for each motion that the reference covers. That is a motion of
/// which all vertices start within the margin of where they started in the reference, and end within the margin of
/// where they were after a fraction s of it, one s for all vertices. The part f of a pair's distance D0 at the start
/// that is to be kept is at most the reference's. Boxes reach less far with a lesser f, and the distance to keep,
/// d + f (D0 - d), is no greater, unless D0 < d: such a pair is in contact at the start, and in the lists of every f.
///
/// Proof: let a vertex of the reference be at y(t) = y0 + t (y1 - y0), and of the motion at x(t) = (1 - t) x0 + t x1.
/// If each coordinate of x0 is within m of y0, and of x1 within m of y(s), then that of x(t) is within
/// (1 - t) m + t m = m of (1 - t) y0 + t y(s) = y(s t). So an element of the motion is at time t in the box of the
/// reference at time s t, wider by m. Where the motion's boxes meet at t, those of the reference meet at s t.
class CandidateSearch {
 public:
  explicit CandidateSearch(const Mesh::Impl& mesh) : mesh_(mesh) {}

  /// Hands out, once, each pair that may collide and may come as near as it is to keep, and perhaps others that may
  /// collide. Pairs that come so near after search.until need not be found, and are found among those that are kept.
  void for_each_block(const Motion& motion, double kept_fraction, const broad_phase::PairSearch& search,
                      const std::atomic<bool>* stop, const CandidateConsumer& take);

  /// Whether the lists hold the pairs for this motion.
  bool has_lists_for(const Motion& motion, double kept_fraction) const noexcept {
    return state_ == State::with_lists && covers(motion, kept_fraction);
  }

  /// How often all boxes were compared, with searches elsewhere that were counted.
  std::size_t searches() const noexcept { return searches_; }
  void count_search() noexcept { ++searches_; }

  /// Forgets the reference and gives its memory back.
  void release() noexcept;

 private:
  bool covers(const Motion& motion, double kept_fraction) const noexcept;
  void refer_to(const Motion& motion, double kept_fraction);
  void collect(int threads, const std::atomic<bool>* stop);

  /// Whether there is a reference, and whether the lists hold its candidates, or would be too long.
  enum class State { no_reference, without_lists, too_many, with_lists };

  const Mesh::Impl& mesh_;
  State state_ = State::no_reference;
  Motion reference_;
  double kept_fraction_ = 0;
  double margin_ = 0;
  std::size_t farthest_ = 0;        // the vertex of which a coordinate moves farthest in the reference,
  double Vec3::*along_ = &Vec3::x;  // and that coordinate
  bool of_use_ = true;              // whether a question after the first was answered by the lists; true without one
  std::array<broad_phase::LargeVector<broad_phase::Pair>, kKinds.size()> pairs_;
  std::size_t searches_ = 0;
};

}  // namespace touchstone::mesh
