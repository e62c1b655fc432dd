// The contacts of a substep as terms of its potential, while it is solved again and again.
// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <utility>
#include <vector>

#include "contact/contact_potential.hpp"
#include "dynamics/energy_flows.hpp"
#include "sim/response_model.hpp"

namespace touchstone::sim {

class ContactTerms {
 public:
  /// @param start  of the substep, as long as this lives  @param h  s
  /// @param tolerance  J: the gain of energy that counts as none in the substep
  ContactTerms(const ResponseModel& model, const State& start, double h, double tolerance,
               const std::vector<Contact>& contacts);

  const std::vector<ContactTerm>& all() const noexcept { return terms_; }

  /// The tolerance with the energy of the springs that push apart elements nearer than the thickness, J.
  double tolerance() const noexcept { return tolerance_; }

  /// The energy that the contacts give in a solve that ended at `end`.
  EnergyFlows flows(const State& end) const;

  /// Sets the limits of friction from the normal forces at the end of a solve. Friction changes how tension runs along
  /// a cable, and with it these forces. @returns whether the limits have settled
  bool update_friction(const VectorX& end);

  /// Takes in contacts that a solve left: new ones, and known ones that turned on the way.
  void take(const std::vector<Contact>& found);

 private:
  using PairKey = std::tuple<Kind, Index, Index>;
  static PairKey key(const Pair& pair) { return {pair.kind, pair.i, pair.j}; }

  void measure_hold();
  ContactTerm term_of(const Contact& contact) const;
  void add(const Contact& contact);

  const ResponseModel* model_;
  const State* start_;
  double h_;
  double tolerance_;
  std::vector<Eigen::Matrix3f> hold_;  // the stiffness that holds each particle in place, by direction, N/m; roughly
  std::vector<ContactTerm> terms_;
  std::vector<std::pair<PairKey, std::size_t>> term_of_pair_;  // sorted whenever it is searched
};

}  // namespace touchstone::sim
