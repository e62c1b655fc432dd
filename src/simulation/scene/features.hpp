// Features that a scene may lack. A scene without one does not pay for it: tests/cost compares its instruction counts
// with those of a build in which the constant here is false and the code is not there at all.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::sim {

#ifdef TOUCHSTONE_SIM_WITHOUT_FACES
constexpr bool kFaces = false;
#else
constexpr bool kFaces = true;
#endif

/// Edges that share a particle, and can fold.
#ifdef TOUCHSTONE_SIM_WITHOUT_FOLDS
constexpr bool kFolds = false;
#else
constexpr bool kFolds = true;
#endif

#ifdef TOUCHSTONE_SIM_WITHOUT_FRICTION
constexpr bool kFriction = false;
#else
constexpr bool kFriction = true;
#endif

/// Cables that bend or twist.
#ifdef TOUCHSTONE_SIM_WITHOUT_RODS
constexpr bool kRods = false;
#else
constexpr bool kRods = true;
#endif

/// Cloth.
#ifdef TOUCHSTONE_SIM_WITHOUT_CLOTH
constexpr bool kCloth = false;
#else
constexpr bool kCloth = true;
#endif

/// Elements with a radius, which keep a distance from each other.
#ifdef TOUCHSTONE_SIM_WITHOUT_SEPARATIONS
constexpr bool kSeparations = false;
#else
constexpr bool kSeparations = true;
#endif

}  // namespace touchstone::sim
