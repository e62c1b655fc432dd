// Touchstone: the steps of one mesh, question after question.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// Questions about many steps of one mesh, such as the tries of a line search or the steps of a simulation. The results
/// are those of the functions of the same names, bit for bit. Memory and the pairs that may meet are kept from one
/// question to the next, so that questions which are alike are answered much sooner.
///
/// A step is kept as the *reference* for those after it. A question is like the reference if all vertices start within
/// a margin of where they started there, and end within the margin of where they were after a fraction s of it, one s
/// for all vertices, and if its kept_fraction is no greater. The margin is 3/64 of the median length of an edge, along
/// each axis: the median of up to 1,001 edges, evenly by their numbers. A mesh without edges has next to none. Nothing
/// is kept for a kept_fraction beyond 0.9. Another question is answered as by the functions, and becomes the reference.
///
/// The pairs that may meet in such questions are found once, by a search that takes longer than that for one step: in
/// the first question about a reference, or in the second one where those of the reference before were of no use.
/// Nothing is kept where elements are so crowded that for each vertex and edge the boxes of more than 16 pairs meet,
/// wider by the margin, or with a kept_fraction f by (1 + 4 f / (1 - f)) times as much and f / (1 - f) of the ways of
/// their vertices.
///
/// It holds 96 bytes for each vertex, and 8 for each of the pairs that are kept, up to twice the most of them so far:
/// no boxes, nor their tree. One object is used by one thread at a time; MeshOptions::threads says how many work on a
/// question.
class MeshSteps {
 public:
  /// @param mesh  the mesh; a copy of it is kept, which is cheap
  explicit MeshSteps(const Mesh& mesh);
  MeshSteps(MeshSteps&& other) noexcept;             ///< `other` may only be assigned to, or destroyed, afterwards
  MeshSteps& operator=(MeshSteps&& other) noexcept;  ///< as the constructor
  ~MeshSteps();                                      ///< gives the memory back

  /// The mesh.
  const Mesh& mesh() const noexcept;

  /// As the function first_contact. @throws InvalidQuery  as that function
  FirstContact first_contact(const Positions& x0, const Positions& x1, const FirstContactOptions& options = {});

  /// As the function all_contacts. @throws InvalidQuery  as that function
  std::vector<MeshContact> all_contacts(const Positions& x0, const Positions& x1, const StepOptions& options = {});

  /// As the function free_step. @throws InvalidQuery  as that function
  FreeStep free_step(const Positions& x0, const Positions& x1, const FreeStepOptions& options = {});

  /// How many times the boxes of all elements were compared. Other questions were answered from kept pairs.
  std::size_t searches() const noexcept;

  /// Gives the memory back. The next question is as the first one.
  void release() noexcept;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
