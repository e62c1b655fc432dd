// What questions about whole meshes return to Python: Pairs, Intersections, FirstContact, FreeStep,
// ClosestApproach.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/closest_approach.hpp>
#include <touchstone/mesh.hpp>

#include <string>
#include <vector>

#include "python/define.hpp"

namespace touchstone::python {

/// Pairs of elements and, of contacts, the answers to their queries.
struct Pairs {
  using BoundToPython = void;

  std::vector<MeshPair> pairs;
  std::vector<double> separations;
  std::vector<Answer> answers;
};

/// The outcome's name, in which '_' stands for '-' as in Python's own names.
std::string outcome_text(StepOutcome outcome);

Pairs pairs_of(const std::vector<MeshContact>& contacts);

struct Intersections {
  using BoundToPython = void;

  std::vector<Intersection> all;
};

/// A free step, and how many coordinates a vertex has.
struct Step {
  using BoundToPython = void;

  FreeStep step;
  int dimension;
};

template <class Archive>
void members(Archive& archive, Pairs& x) {
  archive(x.pairs, x.separations, x.answers);
}
template <class Archive>
void members(Archive& archive, Intersections& x) {
  archive(x.all);
}
template <class Archive>
void members(Archive& archive, Step& x) {
  archive(x.step, x.dimension);
}

/// Of them all.
void define_mesh_results(py::module_& module);

}  // namespace touchstone::python
