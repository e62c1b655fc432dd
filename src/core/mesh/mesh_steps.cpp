// SPDX-License-Identifier: MIT
#include <touchstone/mesh_steps.hpp>

#include "mesh/contacts.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

struct MeshSteps::Memory {
  explicit Memory(const Mesh& whole) : mesh(whole) { step.kept.emplace(mesh.impl()); }
  Mesh mesh;
  mesh::StepMemory step;
};

MeshSteps::MeshSteps(const Mesh& mesh) : memory_(std::make_unique<Memory>(mesh)) {}
MeshSteps::MeshSteps(MeshSteps&& other) noexcept = default;
MeshSteps& MeshSteps::operator=(MeshSteps&& other) noexcept = default;
MeshSteps::~MeshSteps() = default;

const Mesh& MeshSteps::mesh() const noexcept { return memory_->mesh; }

FirstContact MeshSteps::first_contact(const Positions& x0, const Positions& x1, const FirstContactOptions& options) {
  return mesh::first_contact(memory_->mesh.impl(), x0, x1, options, memory_->step);
}

std::vector<MeshContact> MeshSteps::all_contacts(const Positions& x0, const Positions& x1, const StepOptions& options) {
  return mesh::all_contacts(memory_->mesh.impl(), x0, x1, options, memory_->step);
}

FreeStep MeshSteps::free_step(const Positions& x0, const Positions& x1, const FreeStepOptions& options) {
  return mesh::free_step(memory_->mesh.impl(), x0, x1, options, memory_->step);
}

std::size_t MeshSteps::searches() const noexcept { return memory_->step.kept->searches(); }

void MeshSteps::release() noexcept {
  mesh::Motion().swap(memory_->step.motion);
  memory_->step.kept->release();
}

FirstContact first_contact(const Mesh& mesh, const Positions& x0, const Positions& x1,
                           const FirstContactOptions& options) {
  mesh::StepMemory memory;
  return mesh::first_contact(mesh.impl(), x0, x1, options, memory);
}

std::vector<MeshContact> all_contacts(const Mesh& mesh, const Positions& x0, const Positions& x1,
                                      const StepOptions& options) {
  mesh::StepMemory memory;
  return mesh::all_contacts(mesh.impl(), x0, x1, options, memory);
}

FreeStep free_step(const Mesh& mesh, const Positions& x0, const Positions& x1, const FreeStepOptions& options) {
  mesh::StepMemory memory;
  return mesh::free_step(mesh.impl(), x0, x1, options, memory);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
