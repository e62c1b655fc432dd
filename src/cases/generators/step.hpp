// One step of a moving scene: the positions of the corners at both ends, and the pairs of elements that come close in
// between.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <touchstone/query.hpp>

#include "broad_phase/grid.hpp"
#include "generators/moving_mesh.hpp"

namespace touchstone::generators {

class Step {
 public:
  /// The scene before its first step. @param speed, separation, placement  as in CandidateOptions
  Step(SceneName scene, std::uint64_t seed, std::size_t edges, double speed, double separation = 0,
       Placement placement = Placement::as_built);

  /// The next step; it starts where this one ends.
  void advance();

  /// Moves one corner through a face of another part at the end of this step, as MovingMesh::plant_crossing does: this
  /// step and the next one are not free of contact. @returns the corner's number; nothing for a scene that has contacts
  std::optional<Index> plant_crossing();

  const Mesh& mesh() const noexcept { return moving_->mesh(); }
  const std::vector<Vec3>& start() const noexcept { return start_; }
  const std::vector<Vec3>& end() const noexcept { return end_; }

  /// Calls found(i, j) once for each pair whose boxes around the whole step, grown by half the separation, overlap:
  /// edges i < j, or corner i and face j. An element moves inside its box, so every contact is among them.
  void for_each_candidate(Kind kind, bool shared_corners, const broad_phase::PairConsumer& found) const;

  Query query(Kind kind, Index i, Index j) const;

 private:
  template <std::size_t N>
  std::vector<broad_phase::Box> boxes(const std::vector<std::array<Index, N>>& elements) const;
  std::vector<broad_phase::Box> corner_boxes() const;

  std::unique_ptr<MovingMesh> moving_;
  double time() const noexcept { return first_time_ + duration_ * static_cast<double>(number_); }  ///< at the end

  double first_time_;
  double duration_;
  double margin_;  ///< of each box; at least half the separation
  std::size_t number_ = 0;
  std::vector<Vec3> start_, end_;
};

}  // namespace touchstone::generators
