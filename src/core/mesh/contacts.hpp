// The contacts of a mesh in a step, for any distances that its pairs are to keep.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include <touchstone/mesh.hpp>

#include "mesh/candidate_search.hpp"
#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

struct ContactSearch {
  double t_max = 1;
  int threads = 1;
  double kept_fraction = 0;                 ///< as in FreeStepOptions
  const std::atomic<bool>* stop = nullptr;  ///< as in MeshOptions
  bool check_start = false;                 ///< as in FirstContactOptions; find_all does not use it
  CandidateSearch* candidates = nullptr;    ///< keeps candidates from question to question; null: they are found anew
  double known_by = 1;                      ///< of find_first: a time in [0, 1] by which there is a contact, or 1
};

/// What a question about a step needs room for.
struct StepMemory {
  Motion motion;
  std::optional<CandidateSearch> kept;  ///< nothing where candidates are not kept
  CandidateSearch* candidates() noexcept { return kept ? &*kept : nullptr; }
};

FirstContact find_first(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search);

/// The first time at which a pair comes into contact, or up to a double later; search.t_max where none does. What is to
/// be kept of distances counts for nothing, nor do contacts at the start.
double first_time(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search);

/// In the order of all_contacts.
std::vector<MeshContact> find_all(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search);

/// The public functions of these names, with memory of their own or kept from call to call.
FirstContact first_contact(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1,
                           const FirstContactOptions& options, StepMemory& memory);
std::vector<MeshContact> all_contacts(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1,
                                      const StepOptions& options, StepMemory& memory);
FreeStep free_step(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1, const FreeStepOptions& options,
                   StepMemory& memory);

}  // namespace touchstone::mesh
