// The contacts of a mesh in a step, for any distances that its pairs are to keep.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <vector>

#include <touchstone/mesh.hpp>

#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

struct ContactSearch {
  double t_max = 1;
  int threads = 1;
  double kept_fraction = 0;                 ///< as in FreeStepOptions
  const std::atomic<bool>* stop = nullptr;  ///< as in MeshOptions
  bool check_start = false;                 ///< as in FirstContactOptions; find_all does not use it
};

/// @throws Stopped  when the flag is set
inline void check_stop(const std::atomic<bool>* stop) {
  if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw Stopped("the call was stopped");
}

FirstContact find_first(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search);

/// In the order of all_contacts.
std::vector<MeshContact> find_all(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search);

}  // namespace touchstone::mesh
