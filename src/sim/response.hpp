// From the positions that the integrator wants to positions in which nothing has touched.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "contact/contact_finder.hpp"
#include "sim/phase_times.hpp"
#include "dynamics/stepper.hpp"

namespace touchstone::sim {

/// Impulses first, in the order of exact time. They act on single particles, which is right for what is loose and pumps
/// energy into what is stiff: where the energy says so, the step is solved again with the contacts in its potential,
/// and impulses only tidy up. What contacts are left then is answered by rigid impact zones.
class Response {
 public:
  Response(const Elements& elements, const System& system, const Settings& settings, NarrowPhase narrow_phase,
           int threads);

  enum class Outcome : std::uint8_t {
    done,
    not_converged,
    not_resolved,  ///< contacts are left: the step must be shorter
    gained_energy  ///< contacts would do work: the step should be shorter
  };

  /// Changes `next`, what the integrator made of `state` in h seconds, until the narrow phase finds no contact.
  Outcome respond(Stepper& stepper, const State& state, double h, State& next, ResponseCounts& counts,
                  PhaseTimes& times);

  /// What stood in the way of the last response: for not_converged a mover, for not_resolved a contact that is left.
  struct Trouble {
    Mover mover;
    std::optional<Contact> left;
  };
  const Trouble& trouble() const noexcept { return trouble_; }

  double thickness() const noexcept { return thickness_; }

 private:
  struct Work;
  bool impulses(Work& work, std::vector<Contact> known, int passes);
  bool freeze_zones(Work& work, std::vector<Contact> contacts);
  bool solve_with_contacts(Work& work, Stepper& stepper, std::vector<Contact> contacts);
  /// Whether all its coordinates are prescribed.
  bool is_held(Index particle) const;
  /// Of the displacements in this step, kg m, but for a constant; what is held left aside.
  Vector3 free_momentum(const std::vector<Index>& zone, const Work& work) const;
  void measure_hold(const VectorX& q);
  ContactTerm term_of(const Contact& contact, const Work& work) const;
  /// The share of a missing distance that is made good in h seconds: the same speed for any h.
  double recovery(double h) const;
  /// How far elements in a contact of the potential, `room` m nearer than the thickness, are to move apart, m.
  double pushed_out(double room, double h) const;
  /// Whether the springs of its particles answer within the step.
  bool is_stiff(const Contact& contact, double h) const;
  void take_velocities(const Work& work, State& next) const;
  bool gained_energy(const Work& work, const State& next) const;

  const Elements* elements_;
  const System* system_;
  ContactSettings contact_;
  Vector3 gravity_;
  double time_step_;
  double thickness_;
  VectorX inverse_mass_;
  VectorX stiffness_;                  // of each particle's springs, N/m
  std::vector<Eigen::Matrix3f> hold_;  // what holds each particle where it is, by direction, N/m; roughly
  bool repels_;                        // elements that are nearer than the thickness
  ContactFinder finder_;
  Trouble trouble_;
};

}  // namespace touchstone::sim
