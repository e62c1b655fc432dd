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
/// are those of the functions of the same names, bit for bit, and come sooner: memory and the pairs that may meet are
/// kept from one question to the next.
///
/// The pairs of a step are found when a second question is much like it: all vertices start within a margin of where
/// they started in that step, and end within the margin of where they were after a fraction s of at least 1/2 of it,
/// one s for all vertices. From then on they are kept, for every s, until a question is not like that step, or has
/// another kept_fraction. The margin is 3/64 of the mean length of an edge, along each axis; a mesh without edges has next to
/// none, and keeps pairs for the same way only. Nothing is kept for a kept_fraction beyond 0.9.
///
/// It holds 96 bytes for each vertex and up to 16 for each pair that is kept, of which there are at most 64 for each
/// vertex and edge. One object is used by one thread at a time; MeshOptions::threads says how many work on a question.
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
