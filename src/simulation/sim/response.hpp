// From the positions that the integrator leads to, to positions in which nothing has touched.
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/contact_finder.hpp"
#include "contact/outcome.hpp"
#include "dynamics/stepper.hpp"
#include "sim/response_model.hpp"

namespace touchstone::sim {

/// A substep that the integrator has made, contacts left aside.
struct Substep {
  const State* start = nullptr;
  double h = 0;  ///< s
  State end;
  EnergyFlows flows{};  ///< when they are measured
};

struct ResponseResult : ContactOutcome {
  State end;  ///< of the substep, without a contact on the way: when not refused, or when energy was gained
  ResponseCounts counts;
  std::vector<Contact> contacts;  ///< with keep_contacts: each pair that was close at the start or found to touch, once
};

/// Impulses first, in the order of exact time. They act on single particles, which is right for loose particles and
/// pumps energy into stiff elements. Where the energy grows, the substep is solved again with the contacts in its
/// potential, and impulses only tidy up. Contacts that are left then are answered by rigid impact zones.
class Response {
 public:
  /// @param stepper  solves substeps again  @param cancel  is checked in each pass; both live as long as this
  Response(const Colliders& colliders, const System& system, const Settings& settings, NarrowPhase narrow_phase,
           int threads, Stepper& stepper, const linear::Cancellation& cancel = linear::Cancellation::never());

  /// Measures the flows of energy from now on. The stepper does so, too.
  void measure_flows() noexcept { measures_flows_ = true; }

  /// Keeps the contacts of each response from now on.
  void keep_contacts() noexcept { keeps_contacts_ = true; }

  /// Changes the end of the substep until the narrow phase finds no contact.
  ResponseResult respond(Substep substep);

  double thickness() const noexcept { return model_.thickness(); }

 private:
  class Attempt;

  ResponseModel model_;
  bool repels_;  // elements that are nearer than the thickness
  ContactFinder finder_;
  Stepper* stepper_;
  bool measures_flows_ = false;
  bool keeps_contacts_ = false;
};

}  // namespace touchstone::sim
