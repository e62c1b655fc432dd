// A scene in motion: each step is integrated, its contacts are answered, and it is taken only with its proof.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/phase_times.hpp"
#include "sim/refusal.hpp"
#include "sim/response.hpp"
#include "dynamics/stepper.hpp"

namespace touchstone::sim {

/// Two elements that were apart and touched within a step that was taken all the same.
struct Crossing {
  std::uint64_t step = 0;
  double time = 0;                  ///< s, when they touch first
  Vector3 place = Vector3::Zero();  ///< m, where
  Pair pair;
  Answer answer;
};

/// The exact answers to every candidate pair of a step as it is stored.
struct Proof {
  std::uint64_t pairs = 0;
  LevelCounts levels;
  std::uint64_t crossings = 0;
};

/// What happened in one step, or in one part of a step that had to be shortened.
struct StepRecord {
  std::uint64_t step = 0;  ///< from 1
  double time = 0;         ///< s, at its end
  double length = 0;       ///< s
  int newton_iterations = 0, newton_convex = 0;
  int first_order = 0;    ///< 1 when implicit Euler stood in for the scene's own method
  int gained_energy = 0;  ///< 1 when the part gained energy, and was too short to be cut again
  ResponseCounts response;
  Proof proof;
};

struct SimulationOptions {
  NarrowPhase narrow_phase = NarrowPhase::exact;
  int threads = 1;
  std::function<void()> before_part = {};  ///< may throw to end the run: the step under way has not been made then
};

class Simulation {
 public:
  /// @throws Error for a scene that makes no sense, or in which elements touch at the start
  Simulation(Scene scene, const SimulationOptions& options);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Moves on by settings.time_step, in shorter parts where a whole step is refused.
  /// @returns a record of each part @throws Error when even the shortest part is refused, naming what is in the way and
  /// what would be right, or what before_part or the sink of queries throws: nothing has moved then
  std::vector<StepRecord> step();

  const Scene& scene() const noexcept { return scene_; }
  const System& system() const noexcept { return system_; }
  const Elements& elements() const noexcept { return elements_; }
  const State& state() const noexcept { return state_; }
  std::uint64_t steps() const noexcept { return steps_; }
  const std::vector<Crossing>& crossings() const noexcept { return crossings_; }
  /// Over the whole run.
  const RefusedCounts& refused() const noexcept { return refused_; }
  double thickness() const noexcept { return response_.thickness(); }
  /// Of all steps so far, those that were refused included.
  const PhaseTimes& times() const noexcept { return times_; }
  Energies energies() const { return sim::energies(system_, state_); }

  /// Goes on from a state of the same scene. @throws Error as check_state does, or when elements touch: it stays where
  /// it is then
  void resume(State state, std::uint64_t steps);

  /// Sees every query of the proofs, with its answer.
  void watch(QuerySink sink) { prover_.watch(std::move(sink)); }

 private:
  double time_at(double steps) const noexcept { return steps * scene_.settings.time_step; }
  void check_start(const State& state, std::string_view what);
  /// @param before  set to the state before the step, once a part may move it
  std::vector<StepRecord> parts_of_step(std::optional<State>& before);
  /// The part, or why it is not taken.
  std::optional<Refusal> try_part(double h, double end_time, StepRecord& record);

  Scene scene_;
  System system_;
  Elements elements_;
  Stepper stepper_;
  Response response_;
  PairSolver prover_;
  NarrowPhase narrow_phase_;
  std::function<void()> before_part_;
  State state_;
  std::uint64_t steps_ = 0;
  std::vector<Crossing> crossings_;
  RefusedCounts refused_;
  PhaseTimes times_;
};

}  // namespace touchstone::sim
