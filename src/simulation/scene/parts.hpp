// Parts of which several shipped scenes are built: particles, springs, cables of a material, a floor.
// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

namespace touchstone::sim {

Index add_particle(Scene& scene, const Vector3& position, double mass);
Index add_pinned(Scene& scene, const Vector3& position);

/// @param thickness  m
void set_contact(ContactSettings& contact, double restitution, double friction, double thickness);

/// A spring at rest between two particles.
void add_spring(Scene& scene, Index a, Index b, double stiffness, double damping, bool collides);

/// E A, E I and G J of a round section of an isotropic material, and its mass.
void set_material(Cable& cable, double young, double poisson, double radius, double density);

/// E h, D = E h^3 / (12 (1 - poisson^2)) and the mass of a sheet of an isotropic material with the thickness h.
void set_material(Surface& surface, double young, double poisson, double thickness, double density);

/// Free particles at equal distances, without velocity, as a cable still to be added to the scene.
Cable straight_cable(Scene& scene, const Vector3& from, const Vector3& to, Index segments);

/// A square floor in the plane z = 0, of two faces.
void add_floor(Scene& scene, double half_width);

}  // namespace touchstone::sim
