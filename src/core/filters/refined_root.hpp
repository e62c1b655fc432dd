// A certain contact's time driven to its neighbouring doubles, and its weights, by double-double evaluation.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "filters/coplanarity_form.hpp"
#include "filters/question.hpp"
#include "numbers/doubles/lanes.hpp"

namespace touchstone::filters {

using Magnitudes = MagnitudesOf<double>;

/// A simple root of V in plain numbers. It lies in [t - radius, t + radius], where V' keeps the sign of `slope` and is
/// at least half of it (see BernsteinCubic::Root). At h away from t, h at most the radius, V' differs from `slope` by
/// at most slope_error + curvature h.
template <class N>
struct SimpleRootOf {
  N t;  ///< 1 - t is a double
  N radius;
  N slope;
  N slope_error;
  N curvature;
  MagnitudesOf<N> magnitudes{};
  typename numbers::Lanes<N>::Axis axis{};    ///< along which n is certainly not zero at the root
  typename numbers::Lanes<N>::Mask inside{};  ///< the side conditions are known to hold; otherwise refine_root decides
};
using SimpleRoot = SimpleRootOf<double>;

/// The result of a closer look at a root: whether the elements touch there within [0, t_max].
struct RefinedRoot {
  Outcome finding = Outcome::uncertain;
  double toi = 0, toi_upper = 0;  ///< the neighbouring doubles around a contact's time
  /// Of a contact whose weights are wanted. Edge-edge: f1, f2 and 0, the fractions along the first and the second
  /// edge. Vertex-face: the weights of f0, f1 and f2.
  std::array<double, 3> weights{};
};

/// Decides a simple root of V. It asks for an exact value when the time is too close to a double. It is uncertain where
/// a time, a side or a weight cannot be certified: a touched corner or border, for one.
RefinedRoot refine_root(const Question& question, const SimpleRoot& root);

}  // namespace touchstone::filters
