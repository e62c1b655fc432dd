// The description of a simulation: particles, springs, cables and faces, and the settings of a run. Units are SI
// throughout.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/body.hpp"

namespace touchstone::sim {

using Index = std::uint32_t;

/// A point of a driven particle's path, which is straight between waypoints and rests before and after them.
struct Waypoint {
  double time = 0;  ///< s
  Vector3 position = Vector3::Zero();
};

struct Particle {
  Vector3 position = Vector3::Zero();  ///< m
  Vector3 velocity = Vector3::Zero();  ///< m/s
  Vector3 force = Vector3::Zero();     ///< N, constant
  double mass = 0;                     ///< kg, without the mass that its cables add
  std::array<bool, 3> fixed{};         ///< coordinates that never change
  std::vector<Waypoint> path;          ///< not empty: driven, and all three coordinates follow it
  bool collides = true;                ///< false: nothing can hit it, and it is no corner of an element that collides
  double radius = 0;                   ///< m, of a particle that is in no edge or face that collides

  bool pinned() const noexcept { return !path.empty() || (fixed[0] && fixed[1] && fixed[2]); }
};

struct Spring {
  Index a = 0, b = 0;
  double stiffness = 0;    ///< N/m
  double damping = 0;      ///< N s/m
  double rest_length = 0;  ///< m
  bool collides = true;    ///< whether it is an edge for collisions, or only a force
  double radius = 0;       ///< m, in contacts
};

/// An end of a cable. Clamped: its direction and, when it twists, its material frame are held as well.
struct CableEnd {
  bool clamped = false;
  double twist_rate = 0;     ///< rad/s at which a clamped end is turned about its axis
  double twist_until = 1e9;  ///< s after which it rests
};

/// A discrete elastic rod through particles, with a circular cross-section.
struct Cable {
  std::vector<Index> particles;
  bool closed = false;                        ///< a ring: the last particle is joined to the first one
  double radius = 0;                          ///< m
  bool solid = false;                         ///< whether contacts keep its radius, or only its centreline apart
  double density = 0;                         ///< kg/m^3
  double stretch = 0;                         ///< E A, N
  double bend = 0;                            ///< E I, N m^2; 0: it does not resist bending
  double twist = 0;                           ///< G J, N m^2; 0: it does not resist twist, and has no angles
  double damping = 0;                         ///< s: internal stress is stiffness * (strain + damping * strain rate)
  std::array<double, 2> natural_curvature{};  ///< 1/m, in the material frame
  bool rest_is_bent = false;                  ///< the bends at rest are those of the initial positions
  double length_scale = 1;                    ///< length at rest over the initial one: above 1 slack, below 1 taut
  CableEnd start, end;
  double closing_twist_rate = 0;     ///< rad/s at which a ring is cut, turned and joined again
  double closing_twist_until = 1e9;  ///< s

  std::size_t edge_count() const noexcept { return closed ? particles.size() : particles.size() - 1; }
};

using Edge = std::array<Index, 2>;
using Face = std::array<Index, 3>;

/// An edge that only collides.
struct Wire {
  Edge particles{};
  double radius = 0;  ///< m, in contacts

  bool operator==(const Wire&) const = default;
};

/// Cloth: triangles that stretch, shear, bend and collide. Its rest lengths are those of the initial positions.
struct Surface {
  std::vector<Face> faces;
  double stretch = 0;         ///< N/m: Young's modulus times the thickness of the sheet
  double poisson = 0.3;       ///< of stretching
  double bend = 0;            ///< N m: E h^3 / (12 (1 - poisson^2)) of a sheet of thickness h; 0: it does not bend back
  double areal_density = 0;   ///< kg/m^2
  double damping = 0;         ///< s: internal stress is stiffness * (strain + damping * strain rate)
  double strain_limit = 0;    ///< no principal stretch reaches 1 + this; 0: there is no limit
  bool rest_is_bent = false;  ///< the bends at rest are those of the initial positions, and not zero
  double radius = 0;          ///< m, in contacts: half the thickness that they keep
};

/// A face, which only collides.
struct Facet {
  Face particles{};
  double radius = 0;  ///< m, in contacts: half the thickness of what it stands for

  bool operator==(const Facet&) const = default;
};

enum class Integrator : std::uint8_t {
  implicit_euler,     ///< first order, damps motion that is too fast for the step: the default
  tr_bdf2,            ///< second order, and still damps motion that is too fast
  implicit_midpoint,  ///< second order, keeps the energy of linear springs
  symplectic_euler    ///< explicit: cheap, for soft scenes; the step must be shorter than the stiffest period / pi
};
std::string_view integrator_name(Integrator integrator) noexcept;
/// By its name; nothing for any other text.
std::optional<Integrator> find_integrator(std::string_view name) noexcept;

struct ContactSettings {
  double restitution = 0.5;  ///< in [0, 1]
  double friction = 0;       ///< Coulomb's coefficient, >= 0
  /// m: elements with a smaller gap between their surfaces are pushed apart gently; 0: a fiftieth of the shortest edge
  /// that moves
  double thickness = 0;
  int passes = 8;  ///< of impulses, before the fail-safe
  // The three answers to contacts, in their order (Bridson et al. 2002):
  bool repulsion = true;  ///< of elements that begin a substep nearer than the thickness, with friction
  bool impulses = true;   ///< at contacts on the way, or contacts in the potential where elements are stiff
  bool zones = true;      ///< rigid impact zones, for contacts that are left
};

struct Settings {
  double time_step = 1.0 / 60;  ///< s
  double duration = 1;          ///< s
  Integrator integrator = Integrator::implicit_euler;
  Vector3 gravity{0, 0, -9.81};    ///< m/s^2
  double drag = 0;                 ///< 1/s: force -drag * mass * velocity
  double newton_tolerance = 1e-6;  ///< m/s: a step's velocities are converged to about this
  double tolerance = 0;   ///< m/s: the error of positions that integration may make in a second; 0: steps are not cut
  double least_step = 0;  ///< s: `tolerance` cuts no substep into shorter ones; 0: 1/1024 of the step
  ContactSettings contact;
};

struct Scene {
  std::string name;
  Settings settings;
  std::vector<Particle> particles;
  std::vector<Spring> springs;
  std::vector<Cable> cables;
  std::vector<Wire> wires;
  std::vector<Facet> faces;
  std::vector<Surface> surfaces;  ///< cloth; a surface of springs is springs and faces
  std::vector<Body> bodies;
};

constexpr std::size_t kMostParticles = 10'000'000;

// m. The least radius is as small as the least distance of neighbours: the stiffness of a section goes with its radius
// to the fourth power, and underflows to 0 for much smaller ones.
constexpr double kLeastRadius = 1e-12, kMostRadius = 1e3;

/// Why an element cannot have this radius in contacts; empty when it can.
std::string wrong_radius(double radius);

/// Whether any element has a radius in contacts.
bool has_radii(const Scene& scene);

/// @throws Error naming the element whose numbers make no sense (indices, ranges, not finite)
void check_scene(const Scene& scene);

}  // namespace touchstone::sim
