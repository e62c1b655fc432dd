// Exact answers for blocks of candidate pairs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include <touchstone/answer.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/solve.hpp>

#include "broad_phase/box_tree.hpp"
#include "mesh/mesh_elements.hpp"
#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

/// The distance that each pair is to keep: its separation d, or d + fraction (D0 - d) rounded up, for its distance D0
/// at the start. Where it is quick, the bound of D0 by distance_bound stands for D0.
class KeptDistances {
 public:
  KeptDistances(const Mesh::Impl& mesh, const Motion& motion, double fraction)
      : mesh_(mesh), motion_(motion), fraction_(fraction) {}

  /// Whether every pair is only asked to touch nothing.
  bool are_zero() const noexcept {
    return fraction_ == 0 && mesh_.radii.empty() && mesh_.pair_separations.empty() && mesh_.separation.distance == 0;
  }
  Metric metric() const noexcept { return mesh_.separation.metric; }

  struct Kept {
    double distance;
    bool is_bound;      ///< it is at least the pair's, which `exact` finds
    double least_at_0;  ///< at most D0; 0 where that is not known
  };

  /// The pair's, or a bound, if that is much faster to find.
  Kept quick(const MeshPair& pair, const std::array<Index, 4>& corners) const;

  double exact(const MeshPair& pair, const std::array<Index, 4>& corners) const;

  /// True proves that the pair is farther apart than that at all times until t_max.
  bool keeps(const Kept& kept, Kind kind, const std::array<Index, 4>& corners, double t_max) const noexcept;

 private:
  double kept(double separation, double at_start) const noexcept;

  const Mesh::Impl& mesh_;
  const Motion& motion_;
  double fraction_;
};

/// Called for pairs in contact: contact(pair, distance that it is to keep, answer).
using ContactConsumer = std::function<void(const MeshPair& pair, double distance, const Answer& answer)>;

/// Asks about `count` pairs of a kind, and calls contact for those that come nearer than they are to keep, or as near,
/// in [0, t_max]. The answers are those of solve with the same separation, Wanted and t_max.
void for_each_contact(const Mesh::Impl& mesh, const Motion& motion, const KeptDistances& distances, Kind kind,
                      const broad_phase::Pair* pairs, std::size_t count, double t_max, Wanted wanted,
                      const ContactConsumer& contact);

/// Columns of queries of one kind, filled one query after another.
class ColumnBlock {
 public:
  static constexpr std::size_t kQueries = 256;  // 48 KiB of coordinates: they stay in the cache

  /// The calling thread's own block, without queries, for those of this kind. It is too large for a thread's stack.
  static ColumnBlock& of_thread(Kind kind);

  ColumnBlock(const ColumnBlock&) = delete;
  ColumnBlock& operator=(const ColumnBlock&) = delete;

  bool is_full() const noexcept { return columns_.count == kQueries; }
  std::size_t size() const noexcept { return columns_.count; }
  void clear() noexcept { columns_.count = 0; }

  /// The corner c of the query that is being filled.
  void set(std::size_t c, const Vec3& start, const Vec3& end) noexcept {
    double* const at = coordinates_ + 6 * c * kStride + columns_.count;
    at[0 * kStride] = start.x;
    at[1 * kStride] = start.y;
    at[2 * kStride] = start.z;
    at[3 * kStride] = end.x;
    at[4 * kStride] = end.y;
    at[5 * kStride] = end.z;
  }
  void finish_query() noexcept { ++columns_.count; }

  /// answers()[i] for the i-th query since clear(). @param distances  one for each query, or null
  void solve(double t_max, Wanted wanted, Metric metric, const double* distances);
  const Answer* answers() const noexcept { return answers_; }

 private:
  /// From a column to the next. Columns a power of two apart would share a few sets of the cache.
  static constexpr std::size_t kStride = kQueries + 8;

  ColumnBlock();

  QueryColumns columns_;
  double coordinates_[24 * kStride];
  Answer answers_[kQueries];
};

}  // namespace touchstone::mesh
