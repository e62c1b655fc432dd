// What questions about whole bodies return to Python: BodyPairs, BodyIntersections, FirstBodyContact,
// FreeBodyStep, BodyScrewAnswer, BodyDistance.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/bodies.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "python/define.hpp"

namespace touchstone::python {

/// What a question leaves out, and what it changed before.
struct LeftOut {
  std::size_t excluded = 0;       ///< pairs of bodies, by the rules
  std::vector<BodyIndex> turned;  ///< the bodies that took the shorter turn in place of the one that was given
};

/// Pairs of elements of bodies and, of contacts, the answers to their queries.
struct BodyPairs {
  using BoundToPython = void;

  std::vector<BodyPair> pairs;
  std::vector<double> separations;
  std::vector<Answer> answers;
  LeftOut left_out;
};

BodyPairs pairs_of(const std::vector<BodyContact>& contacts, LeftOut left_out);

struct BodyIntersections {
  using BoundToPython = void;

  std::vector<BodyIntersection> all;
  BodiesLeftOut left_out;
};

/// A first contact, and what was asked.
struct FoundBodyContact {
  using BoundToPython = void;

  FirstBodyContact found;
  std::vector<BodyIndex> turned;  ///< the bodies that took the shorter turn in place of the one that was given
  double t_max = 1;
};

struct FoundBodyStep {
  using BoundToPython = void;

  StepOutcome outcome = StepOutcome::whole;
  double length = 1;
  std::vector<std::array<double, 7>> poses;  ///< position and quaternion, in the order of the question
  FoundBodyContact first_contact;
  int proofs = 0;
};

/// The answer about turns at constant rates, and what was asked.
struct FoundBodyScrew {
  using BoundToPython = void;

  BodyScrewAnswer found;
  std::vector<BodyIndex> turned;  ///< as in FoundBodyContact
  double t_max = 1;
};

struct FoundBodyDistance {
  using BoundToPython = void;

  BodyDistance found;
};

/// Of them all.
void define_rigid_results(py::module_& module);

}  // namespace touchstone::python
