// A scene in motion: each step is integrated, its contacts are answered, and it is taken only with its proof.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "contact/phase_times.hpp"
#include "dynamics/energy_budget.hpp"
#include "dynamics/stepper.hpp"
#include "linear/cancellation.hpp"
#include "sim/contact_mark.hpp"
#include "sim/refusal.hpp"
#include "sim/response.hpp"
#include "sim/simulated_bodies.hpp"
#include "sim/start_check.hpp"

namespace touchstone::sim {

/// Two elements that were apart and touched within a step that was taken all the same. Only the narrow phase of the
/// paper allows it, for which radii are left aside.
struct Crossing {
  std::uint64_t step = 0;
  double time = 0;                  ///< s, when they touch first
  Vector3 point = Vector3::Zero();  ///< m, where
  Pair pair;
  Query query;    ///< of the substep
  Answer answer;  ///< to it
};

/// The exact answers to every candidate pair of a step as it is stored: without a crossing, each pair stays farther
/// apart than its separation at all times of the step.
struct StepProof {
  std::uint64_t pairs = 0;
  LevelCounts levels;
  std::uint64_t crossings = 0;
  SeparationCounts separations;
};

/// The course of one substep: of a whole step, or of a part of one that had to be shortened.
struct SubstepRecord {
  std::uint64_t step = 0;  ///< from 1
  double time = 0;         ///< s, at its end
  double length = 0;       ///< s
  int newton_iterations = 0, newton_projected = 0;
  int first_order = 0;    ///< 1 when implicit Euler stood in for the scene's own method
  int gained_energy = 0;  ///< 1 when the substep gained energy, and was too short to be halved again
  /// The error of the integration over what the tolerance allows; 0 without a tolerance. Above 1 the substep was too
  /// short to be halved again.
  double excess = 0;
  ResponseCounts response;
  StepProof proof;
  EnergyFlows flows;     ///< with measure_flows
  double numerical = 0;  ///< J, with measure_flows: what the substep gained beyond the flows
  BodyCounts bodies;
  std::vector<ContactMark> contacts;  ///< with keep_contacts: those that the response saw
  VectorX end;            ///< the coordinates at its end, the doubles that were proved; empty without keep_ends
  BodyStates end_bodies;  ///< likewise the bodies; empty without keep_ends
};

struct SimulationOptions {
  NarrowPhase narrow_phase = NarrowPhase::exact;
  int threads = 1;
  /// Called while the simulation is made, and between substeps, iterations of Newton's method and passes over contacts.
  /// It may throw to end the run: the step under way has not been made then.
  std::function<void()> check_cancelled = {};
  bool keep_ends = false;      ///< whether each record has the coordinates at the end of its substep
  bool measure_flows = false;  ///< whether each record has the flows of energy of its substep
  bool keep_contacts = false;  ///< whether each record has its contacts
};

class Simulation {
 public:
  /// @throws Error for a scene that makes no sense, or in which elements touch or intersect at the start or are nearer
  /// than their separation
  Simulation(Scene scene, const SimulationOptions& options);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Moves on by settings.time_step, in shorter substeps where a whole step is refused. Nothing has moved when it
  /// throws.
  /// @returns a record of each substep
  /// @throws Error when even the shortest substep is refused, naming the elements in the way and a remedy;
  /// and any exception of check_cancelled and of the sink of queries
  std::vector<SubstepRecord> step();

  const Scene& scene() const noexcept { return scene_; }
  const System& system() const noexcept { return system_; }
  const Colliders& colliders() const noexcept { return colliders_; }
  const State& state() const noexcept { return state_; }
  std::uint64_t steps() const noexcept { return steps_; }
  const std::vector<Crossing>& crossings() const noexcept { return crossings_; }
  /// Whether radii of the scene are left aside, as the narrow phase knows no separation.
  bool ignores_radii() const noexcept { return ignores_radii_; }
  /// The waypoints of paths, in the steps made so far, that lie between the ends of a substep: the straight motion
  /// between these ends passes them by.
  std::size_t passed_waypoints() const noexcept { return passed_waypoints_; }
  /// Of the scene's start, or of the checkpoint's state.
  const StartFindings& start() const noexcept { return start_; }
  /// Over the whole run.
  const RefusedCounts& refused() const noexcept { return refused_; }
  std::uint64_t refused(Cause cause) const noexcept { return refused_[static_cast<std::size_t>(cause)]; }
  double thickness() const noexcept { return response_.thickness(); }
  /// Of all steps so far, those that were refused included.
  const PhaseTimes& times() const noexcept { return times_; }
  /// Now, by the numbers of `colliders`. m
  Vector3 position_of(Index vertex) const;
  /// Of particles and bodies.
  Energies energies() const;
  /// Whether pairs of elements keep distances, by the radii of particles' elements or of bodies.
  bool has_separations() const noexcept { return colliders_.has_separations(); }
  /// Null when the scene has no bodies.
  const SimulatedBodies* bodies() const noexcept { return bodies_.get(); }

  /// Goes on from a state of the same scene.
  /// @throws Error as check_state does, or when elements touch or intersect or are nearer than their separation. The
  /// simulation stays at its own state then
  void resume(State state, std::uint64_t steps, BodiesState bodies = {});

  /// Sees every query of the proofs, with its answer.
  void watch(QuerySink sink) { prover_.watch(std::move(sink)); }

 private:
  double time_at(double steps) const noexcept { return steps * scene_.settings.time_step; }
  std::size_t waypoints_between(double start, double end) const noexcept;
  StartFindings check_start(const State& state, const BodyStates& bodies, std::string_view what);
  /// @param before  set to the state before the step, once a substep may move it
  std::vector<SubstepRecord> make_substeps(std::optional<State>& before);
  /// Moves the state on by h seconds, unless the substep is refused.
  std::variant<SubstepRecord, Refusal> try_substep(double h, double end_time);
  /// Moves the state on without contacts; excess: as in a record.
  Advance integrate(double h, double& excess);
  /// Whether the tolerance asks for no shorter substep.
  bool is_least(double h) const noexcept;
  StepProof prove(const State& end, double h, std::vector<Crossing>& crossings);

  linear::Cancellation cancel_;
  Scene scene_;
  System system_;
  Colliders colliders_;
  Stepper stepper_;
  Response response_;
  PairSolver prover_;
  NarrowPhase narrow_phase_;
  int threads_;
  bool keep_ends_, measures_flows_, keeps_contacts_;
  bool ignores_radii_;
  std::vector<double> waypoints_;  // the times of all, in ascending order
  std::size_t passed_waypoints_ = 0;
  std::unique_ptr<SimulatedBodies> bodies_;
  State state_;
  StartFindings start_;
  std::uint64_t steps_ = 0;
  std::vector<Crossing> crossings_;
  RefusedCounts refused_{};
  PhaseTimes times_;
};

}  // namespace touchstone::sim
