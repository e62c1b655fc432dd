// SPDX-License-Identifier: MIT
#include "report/sets/body_steps.hpp"

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "families/body_scenes.hpp"
#include "seeded/rng.hpp"

namespace touchstone::report {
namespace {

using baselines::MovingBodies;
using families::BodyFamily;
using families::BodyScene;
using families::BodyShape;
using seeded::Rng;

/// A ring of radius 1 and a circular section, about the z axis.
BodyShape ring_shape(MeshIndex around, MeshIndex across, double thickness) {
  BodyShape shape;
  shape.elements.vertex_count = std::size_t{around} * across;
  const double turn = 2 * std::acos(-1.0);
  for (MeshIndex i = 0; i < around; ++i) {
    for (MeshIndex k = 0; k < across; ++k) {
      const double a = turn * i / around, b = turn * k / across, r = 1 + thickness * std::cos(b);
      shape.points.push_back({r * std::cos(a), r * std::sin(a), thickness * std::sin(b)});
      const MeshIndex next = (i + 1) % around * across, up = (k + 1) % across, here = i * across;
      shape.elements.faces.push_back({here + k, next + k, next + up});
      shape.elements.faces.push_back({here + k, next + up, here + up});
    }
  }
  return shape;
}

/// Two rings through each other, which turn and slide as links of a slack chain do.
BodyScene two_links(Rng& random) {
  BodyScene scene;
  for (int i = 0; i < 2; ++i) {
    scene.shapes.push_back(ring_shape(8, 4, 0.2));
    Pose start, end;
    if (i == 1) {
      start.orientation = {1, 1, 0, 0};
      start.position = {random.uniform(0.4, 1.6), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
    }
    end = start;
    for (double& component : end.orientation) component += random.uniform(-0.4, 0.4);
    end.position.x += random.uniform(-0.3, 0.3);
    end.position.z += random.uniform(-0.3, 0.3);
    scene.motions.push_back(motion_between(start, end));
  }
  return scene;
}

/// Whether it is a plain question, to which all methods have an answer.
bool is_fit(const BodyScene& scene) {
  return scene.shapes.size() == 2 && scene.separation.distance == 0 && scene.shapes[0].elements.radii.empty() &&
         scene.shapes[1].elements.radii.empty();
}

MovingBodies step_of(const BodyScene& scene) { return {scene.bodies(), scene.motions}; }

/// The second body is moved aside until the two just touch, or just miss each other, by 2^-20 to 2^-4. Nothing where
/// they do not meet as they are.
std::optional<MovingBodies> nearly_touching(const BodyScene& scene, Rng& random) {
  const Vec3 way{random.symmetric(), random.symmetric(), random.symmetric()};
  MovingBodies step = step_of(scene);
  const auto move_aside = [&](double by) {
    RigidMotion& motion = step.motions[1] = scene.motions[1];
    for (Vec3* const p : {&motion.p0, &motion.p1}) *p = {p->x + by * way.x, p->y + by * way.y, p->z + by * way.z};
  };
  const auto meet = [&](double by) {
    move_aside(by);
    return !first_contact(step.bodies, step.motions).free();
  };
  double within = 0, beyond = 8;
  if (!meet(within) || meet(beyond)) return std::nullopt;
  while (beyond - within > 0x1p-24) {
    const double middle = (within + beyond) / 2;
    (meet(middle) ? within : beyond) = middle;
  }
  const double by = std::ldexp(1, -random.between(4, 20));
  move_aside(random.one_in(2) ? within - by : beyond + by);
  return step;
}

bool starts_free(const MovingBodies& step) {
  StepOptions start;
  start.t_max = 0;
  return all_contacts(step.bodies, step.motions, start).empty() &&
         first_contact(step.bodies, step.motions).start_intersections.empty();
}

/// @param make  a step, or nothing
QuerySet set_of(const std::string& name, const std::string& about, std::size_t count, const BodyPulse& pulse,
                const std::function<std::optional<MovingBodies>(std::uint64_t index)>& make) {
  QuerySet set;
  set.name = "bodies/" + name;
  set.about = "Steps of two whole bodies that turn: " + about;
  for (std::uint64_t index = 0; set.steps.size() < count; ++index) {
    pulse();
    auto step = make(index);
    if (step && starts_free(*step)) set.steps.push_back(std::move(*step));
  }
  return set;
}

}  // namespace

std::vector<QuerySet> body_step_sets(std::uint64_t seed, std::size_t count, const BodyPulse& pulse) {
  const auto near = [seed](std::uint64_t stream, const std::function<BodyScene(Rng&, std::uint64_t)>& make) {
    return [=](std::uint64_t index) -> std::optional<MovingBodies> {
      Rng random(seeded::seed_of_stream(seed + stream, index));
      const BodyScene scene = make(random, index);
      if (!is_fit(scene)) return std::nullopt;
      return nearly_touching(scene, random);
    };
  };
  const auto of_family = [seed](BodyFamily family) {
    return [seed, family](Rng&, std::uint64_t index) { return families::body_scene(family, seed, index); };
  };
  const std::string nearly = ". They just touch or just miss each other";
  return {
      set_of("random", "boxes, faces and edges in random poses" + nearly, count, pulse,
             near(40, of_family(BodyFamily::bodies_random))),
      set_of("touching", "boxes that touch at 1/2 or 1, or miss each other by an ulp", count, pulse,
             [seed](std::uint64_t index) -> std::optional<MovingBodies> {
               const BodyScene scene = families::body_scene(BodyFamily::bodies_touch, seed, index);
               if (!is_fit(scene)) return std::nullopt;
               return step_of(scene);
             }),
      set_of("gears", "gears of 12 to 20 faces" + nearly, count, pulse, near(41, of_family(BodyFamily::bodies_gears))),
      set_of("links", "rings of 64 faces through each other, like links of a slack chain" + nearly, count, pulse,
             near(42, [](Rng& random, std::uint64_t) { return two_links(random); }))};
}

}  // namespace touchstone::report
