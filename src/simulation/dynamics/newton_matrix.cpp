// SPDX-License-Identifier: MIT
#include "dynamics/newton_matrix.hpp"

#include <utility>

namespace touchstone::sim {

NewtonMatrix::NewtonMatrix(const System& system, linear::PatternCache& cache, const linear::Cancellation& cancel)
    : free_(static_cast<std::size_t>(system.size()), -1), joint_offset_(system.stretch_elements.size()) {
  int count = 0;
  std::vector<int> coordinates;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (system.fixed[i]) continue;
    free_[i] = count++;
    coordinates.push_back(i < 3 * system.particle_count() ? static_cast<int>(i) : -1);
  }
  linear::Blocks cliques;
  for (const StretchElement& element : system.stretch_elements) {
    std::vector<int> all;
    for (const Index p : {element.a, element.b}) {
      for (Index c = 0; c < 3; ++c) all.push_back(free_[3 * p + c]);
    }
    cliques.push_back(std::move(all));
  }
  for (const Joint& joint : system.joints) {
    // The order of JointVector.
    std::vector<int> all;
    for (int k = 0; k < 3; ++k) {
      for (Index c = 0; c < 3; ++c) all.push_back(free_[3 * joint.p[static_cast<std::size_t>(k)] + c]);
      if (k < 2) all.push_back(free_[static_cast<std::size_t>(system.angle(k == 0 ? joint.e : joint.f))]);
    }
    cliques.push_back(std::move(all));
  }
  const auto add_cliques = [&](const auto& elements) {
    for (const auto& element : elements) {
      std::vector<int> all;
      for (const Index p : element.p) {
        for (Index c = 0; c < 3; ++c) all.push_back(free_[3 * p + c]);
      }
      cliques.push_back(std::move(all));
    }
  };
  membrane_offset_ = cliques.size();
  add_cliques(system.cloth.membranes);
  hinge_offset_ = cliques.size();
  add_cliques(system.cloth.hinges);
  solver_ = std::make_unique<linear::SparseSolver>(count, std::move(cliques), std::move(coordinates), cache, cancel);
}

void NewtonMatrix::set_contacts(std::span<const ContactTerm> contacts) {
  if (contacts.empty() && contact_count_ == 0) return;
  contact_count_ = contacts.size();
  std::vector<linear::SparseSolver::Corners> corners(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    corners[i].fill(-1);
    for (std::size_t c = 0; c < contacts[i].corners; ++c) {
      for (std::size_t k = 0; k < 3; ++k) corners[i][3 * c + k] = free_[3 * contacts[i].particles[c] + k];
    }
  }
  solver_->set_contacts(corners);
}

void NewtonMatrix::start(const VectorX& diagonal) {
  solver_->clear();
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] >= 0) solver_->add_diagonal(free_[i], diagonal[static_cast<Eigen::Index>(i)]);
  }
}

void NewtonMatrix::stretch(std::size_t element, const Eigen::Matrix3d& block) {
  Eigen::Matrix<double, 6, 6> all;
  all << block, -block, -block, block;
  solver_->add(element, all.data());
}

void NewtonMatrix::joint(std::size_t element, const JointMatrix& block) {
  solver_->add(joint_offset_ + element, block.data());
}

void NewtonMatrix::membrane(std::size_t element, const MembraneMatrix& block) {
  solver_->add(membrane_offset_ + element, block.data());
}

void NewtonMatrix::hinge(std::size_t element, const HingeMatrix& block) {
  solver_->add(hinge_offset_ + element, block.data());
}

VectorX NewtonMatrix::direction(const VectorX& gradient) {
  VectorX right(solver_->size());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] >= 0) right[free_[i]] = -gradient[static_cast<Eigen::Index>(i)];
  }
  const VectorX solution = solver_->solve(right);
  VectorX all = VectorX::Zero(gradient.size());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] >= 0) all[static_cast<Eigen::Index>(i)] = solution[free_[i]];
  }
  return all;
}

}  // namespace touchstone::sim
