// SPDX-License-Identifier: MIT
#include "cli/bodies/bodies.hpp"

#include <fmt/format.h>

#include <utility>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "cli/bodies/body_animation.hpp"
#include "cli/bodies/body_files.hpp"
#include "cli/bodies/body_results.hpp"
#include "cli/shared/animation_file.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/mesh_file_options.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/stoppable.hpp"
#include "cli/shared/progress/waiting_line.hpp"
#include "cli/shared/proofs/motion_proofs.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "numbers/roots/vanishing.hpp"

namespace touchstone::cli {

namespace {

void check_outputs(const BodiesRunOptions& options, std::vector<std::string> inputs) {
  if (options.html == "-") throw Error("--html: name a file to write");
  if (options.free_step == "-") throw Error("--free-step: name a file to write");
  std::vector<std::pair<std::string, std::string>> outputs;
  if (!options.free_step.empty()) outputs.emplace_back("--free-step", options.free_step);
  if (!options.html.empty()) outputs.emplace_back("--html", options.html);
  MotionProofs::add_files(options.prove, outputs);
  inputs.push_back(options.poses);
  check_mesh_outputs(outputs, inputs);
}

/// @throws FileError  where the quaternion is zero on the way, or the turn has no proof
void check_turn(const BodiesRunOptions& options, const RigidMotion& motion, const std::string& body,
                const std::string& step) {
  const auto refuse = [&](const char* turn, const char* advice) {
    io::fail(options.poses, fmt::format("{}: by the signs of its quaternions body {} {}; {}", step, io::in_quotes(body),
                                        turn, advice));
  };
  if (numbers::zero_between(motion.q0, motion.q1)) {
    refuse("makes a whole turn, about no axis", "without --as-given it makes none");
  }
  if (!options.prove.empty() && takes_longer_turn(motion)) {
    refuse("turns by more than 180 degrees",
           "--prove is for shorter turns: leave out --as-given, or give a pose between them");
  }
}

proofs::MotionElements motion_elements(const Bodies& bodies) {
  proofs::MotionElements elements;
  for (BodyIndex body = 0; body < bodies.bodies.size(); ++body) {
    const Mesh& mesh = bodies.bodies[body].mesh();
    proofs::add_body(elements, body, bodies.bodies[body].points(),
                     proofs::colliding_vertices(mesh.edges(), mesh.points()), mesh.edges(), mesh.faces());
  }
  const BodyRules& rules = bodies.rules;  // of names: they have groups alone
  if (rules.groups.empty()) return elements;
  CollisionRules of_vertices;
  of_vertices.group_rule = rules.group_rule;
  of_vertices.group_pairs = rules.group_pairs;
  for (const proofs::BodyVertex& vertex : elements.on_bodies) {
    of_vertices.groups.push_back(rules.groups[vertex.body]);
  }
  elements.groups = proofs::motion_groups(of_vertices);
  return elements;
}

/// The poses at the end of a step. A motion has one pose of a body in a frame: where the step before ended with -q,
/// this one goes from there, with the other sign at its end, too. That is the same motion.
proofs::MotionFrame frame_after(const proofs::MotionFrame& frame, const std::vector<RigidMotion>& motions) {
  proofs::MotionFrame next;
  for (std::size_t body = 0; body < motions.size(); ++body) {
    next.poses.push_back({motions[body].q1, motions[body].p1});
    if (frame.poses[body].q == motions[body].q0) continue;
    for (double& component : next.poses[body].q) component = -component;
  }
  return next;
}

BodyScrewOptions slerp_options(const BodyStepOptions& how, int arcs) {
  BodyScrewOptions options;
  static_cast<BodyStepOptions&>(options) = how;
  options.arcs = kSlerpArcs;
  options.most_arcs = arcs;
  return options;
}

}  // namespace

int run_bodies(const BodiesRunOptions& options) {
  BodyFiles files(options);
  check_outputs(options, files.files());
  const RecordedPoses poses = read_poses(options.poses, files.names(), options.order);
  BodyStepOptions how;
  how.threads = thread_count(options.threads);
  std::optional<MotionProofs> proofs;
  if (!options.prove.empty()) {
    proofs.emplace(options.prove, motion_elements(files.bodies()), files.bodies().separation, how.threads);
  }
  proofs::MotionFrame frame;
  std::optional<io::OutputFile> page;
  std::optional<BodyAnimation> animation;
  if (!options.html.empty()) {
    page.emplace(options.html);
    animation.emplace(files, poses);
  }
  BodyResults results(options, files, poses);

  how.stop = &interruption();
  how.check_start = options.check_start;
  const std::size_t steps = poses.times.size() - 1, count = files.names().size();
  WaitingLine waiting;
  const auto ask_clearance = [&](std::size_t step) {
    if (!options.clearance) return;
    for (std::size_t time = step == 0 ? 0 : step + 1; time <= step + 1; ++time) {
      std::vector<Pose> at_rest(count);
      for (std::size_t body = 0; body < count; ++body) at_rest[body] = poses.at(body, time);
      results.add_clearance(stoppable([&] { return distance(files.bodies(), at_rest, how); }));
    }
  };
  for (std::size_t step = 0; step < steps; ++step) {
    throw_if_interrupted();
    const std::string label = step_label(poses, step);
    std::vector<RigidMotion> motions(count);
    BodyResults::Turns turns;
    for (std::size_t body = 0; body < count; ++body) {
      const Pose start = poses.at(body, step), end = poses.at(body, step + 1);
      const RigidMotion given = motion_between(start, end, Turn::as_given);
      turns.longer += takes_longer_turn(given) ? 1 : 0;
      turns.half += takes_half_turn(given) ? 1 : 0;
      motions[body] = motion_between(start, end, options.turn);
      check_turn(options, motions[body], files.names()[body], label);
    }
    waiting.begin(fmt::format("{} of {}: {}", step + 1, steps, label));
    if (options.slerp) {
      const BodyScrewAnswer found =
          stoppable([&] { return solve_screw(files.bodies(), motions, slerp_options(how, options.slerp_arcs)); });
      ask_clearance(step);
      waiting.end();
      results.add(found, turns);
      how.check_start = !found.free();
      continue;
    }
    const FreeBodyStep found = stoppable([&] {
      if (!options.free_step.empty()) return free_step(files.bodies(), motions, how);
      FreeBodyStep first;
      first.first_contact = first_contact(files.bodies(), motions, how);
      return first;
    });
    if (proofs) {
      if (step == 0) {
        for (const RigidMotion& motion : motions) frame.poses.push_back({motion.q0, motion.p0});
        proofs->add(frame);
      }
      frame = frame_after(frame, motions);
      proofs->add(frame);
    }
    if (animation) animation->add(motions, found.first_contact);
    ask_clearance(step);
    waiting.end();
    results.add(found, turns);
    how.check_start = !found.first_contact.free();  // a free step from a free start ends free
  }
  if (proofs) proofs->commit();
  std::string summary = proofs ? proofs->summary() : std::string();
  if (animation) {
    const std::uint64_t size = animation->write(*page, results.verdict());
    page->commit();
    summary += animation_summary(options.html, size);
  }
  const bool all_free = results.finish(summary);
  return all_free && (!proofs || proofs->contacts() == 0) ? kAllHold : kRefuted;
}

}  // namespace touchstone::cli
