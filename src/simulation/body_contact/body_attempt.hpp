// One substep of bodies under way: the end as it stands, its contacts, and what has been measured.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "body_contact/body_response.hpp"

namespace touchstone::sim {

/// One substep under way.
class BodyResponse::Attempt {
 public:
  Attempt(const BodyResponse& response, const BodiesState& start, const BodyStep& step)
      : r_(&response),
        system_(&response.colliders_->bodies()),
        start_(&start),
        step_(&step),
        bodies_(start.bodies.size()) {}

  BodyResult run();

 private:
  bool begin();
  void find_contacts();
  void set_targets();
  void solve(double restitution);
  void move();
  std::optional<Refusal> settle(double restitution);
  Touches touches();
  void count_asked(const Touches& touches);
  void answer_touches(const Touches& touches);
  bool merge(Touches left);
  bool move_as_one(const std::vector<Index>& members, const BodyStates& before, const VectorX& x_before);
  void restore_angular_momentum();
  bool gained_energy() const;
  void measure_flows();
  bool is_held(const ContactSide& side) const;
  double kinetic(const BodyStates& states, const VectorX& velocity) const;
  SceneMotion motion() const { return {step_->x0, &result_.x1, &start_->bodies, &result_.end.bodies}; }
  void add(SolverContact contact) { contacts_.push_back(std::move(contact)); }

  // Bodies by their numbers, and then particles: what touches moves together.
  Index particle_node(Index particle) const { return static_cast<Index>(bodies_ + particle); }
  Index node(Index vertex) const {
    const Index group = r_->colliders_->group_of(vertex);
    return group == kParticles ? particle_node(vertex) : group - 1;
  }
  std::size_t nodes() const { return bodies_ + static_cast<std::size_t>(step_->x1.size()) / 3; }
  Eigen::Index at(Index node) const { return 3 * static_cast<Eigen::Index>(node - bodies_); }  // of a particle's node
  bool node_is_held(Index node) const;
  double mass_of(Index node) const;
  Vector3 start_of(Index node) const;

  const BodyResponse* r_;
  const BodySystem* system_;
  const BodiesState* start_;
  const BodyStep* step_;
  std::size_t bodies_;
  BodyResult result_;
  BodyStates free_;         // velocities and poses at the end without contacts
  BodyStates unpushed_;     // with contacts, without position corrections
  Movers free_movers_;      // the velocities that lead there
  Movers movers_, pushes_;  // with contacts
  std::vector<char> held_;  // by body: it has contacts, and its velocity at the end is that of its displacement
  std::vector<SolverContact> contacts_;
  std::vector<std::pair<Index, Index>> merged_;  // nodes that move as one
  double kept_ = 0;                              // m
  double restored_ = 0;                          // J: the kinetic energy that restoring angular momentum gave
  double restored_particles_ = 0;                // J: the part of particles
  EnergyFlows carried_;                          // of bodies that moved as one
};

}  // namespace touchstone::sim
