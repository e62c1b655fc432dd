// SPDX-License-Identifier: MIT
#include "fuzz/bodies/body_steps.hpp"

#include <string>

#include "fuzz/bodies/fuzz_bodies.hpp"
#include "fuzz/bodies/judge_bodies.hpp"
#include "fuzz/bodies/shrink_bodies.hpp"
#include "fuzz/scenes/judge_reply.hpp"
#include "rigid/body_data.hpp"

namespace touchstone::fuzz {

using families::BodyScene;

BodyStepReply library_step_reply(const Bodies& bodies, const std::vector<RigidMotion>& motions) {
  BodyStepOptions contacts_alone;
  contacts_alone.check_start = false;
  const FreeBodyStep step = free_step(bodies, motions, contacts_alone);
  const FirstBodyContact& first = step.first_contact;
  return {step.length, first.at_start.empty() ? first.toi : 0, candidates(bodies, motions)};
}

BodyScene body_step_of(const SceneCase& name, const StepFuzzOptions& options) {
  BodyScene scene = families::body_scene(families::kEveryBodyFamily.at(name.family), name.seed, name.index);
  if (!options.groups) scene.rules = {};
  if (options.separations) return scene;
  scene.separation = {};
  for (families::BodyShape& shape : scene.shapes) shape.elements.radii.clear();
  return scene;
}

std::optional<SceneFailure> judge_body_step(const BodyScene& scene, const BodyStepSolver& solver,
                                            const StepFuzzOptions& options) {
  const Bodies bodies = scene.bodies();
  rigid::validate(bodies, scene.motions);
  const auto fault = [&bodies](const BodyPair& pair) {
    const auto has = [&bodies](MeshElement sort, const BodyElement& one) {
      return one.body < bodies.bodies.size() && has_element(bodies.bodies[one.body].mesh(), sort, one.element);
    };
    const auto& [first, second] = geometry::traits_of(pair.kind);
    if (has(first.sort, pair.first) && has(second.sort, pair.second)) return std::string();
    const auto text = [](const BodyElement& one) {
      return " [" + std::to_string(one.body) + ", " + std::to_string(one.element) + "]";
    };
    return std::string(name_of(pair.kind)) + text(pair.first) + text(pair.second) +
           " names an element that the bodies have not";
  };
  const auto describe = [&bodies](const BodyPair& pair) { return touchstone::describe(bodies, pair); };
  const auto intersects_at_start = [&] {
    std::vector<Pose> poses;
    for (const RigidMotion& motion : scene.motions) poses.push_back({motion.q0, motion.p0});
    return !intersections(bodies, poses).empty();
  };
  const ReplyJudge<BodyContact> judge(exact_contacts(bodies, scene.motions), fault, describe, intersects_at_start,
                                      options);
  return judge.judge([&] { return solver(bodies, scene.motions); });
}

SceneOutcome<BodyScene> search_body_steps(const std::function<BodyStepSolver()>& new_solver,
                                          const StepFuzzOptions& options, const std::optional<SceneCase>& a_case,
                                          const SceneWatch& watch) {
  const auto make = [&](const SceneCase& name) { return body_step_of(name, options); };
  const auto new_judge = [&] {
    return [&, solver = new_solver()](const BodyScene& scene) { return judge_body_step(scene, solver, options); };
  };
  return search_scenes(body_scenes(make, new_judge), options, a_case, watch);
}

}  // namespace touchstone::fuzz
