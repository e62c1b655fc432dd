// SPDX-License-Identifier: MIT
#include "cli/bodies/bodies.hpp"

#include <fmt/format.h>

#include <utility>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "cli/bodies/body_files.hpp"
#include "cli/bodies/body_results.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/stoppable.hpp"
#include "cli/shared/progress/waiting_line.hpp"
#include "frames/content.hpp"
#include "io/fail.hpp"
#include "numbers/roots/vanishing.hpp"

namespace touchstone::cli {

namespace {

void check_output(const BodiesRunOptions& options, std::vector<std::string> inputs) {
  if (options.free_step.empty()) return;
  if (options.free_step == "-") throw Error("--free-step: name a file to write");
  for (std::size_t i = 0, count = inputs.size(); i < count; ++i) {
    const std::vector<std::string> beside = frames::files_beside(inputs[i]);
    inputs.insert(inputs.end(), beside.begin(), beside.end());
  }
  inputs.push_back(options.poses);
  refuse_to_overwrite(options.free_step, inputs);
}

/// @throws FileError  where the quaternion is zero on the way
void check_turn(const BodiesRunOptions& options, const RigidMotion& motion, const std::string& body,
                const std::string& step) {
  if (!numbers::zero_between(motion.q0, motion.q1)) return;
  io::fail(options.poses, fmt::format("{}: by the signs of its quaternions body {} makes a whole turn, about no axis; "
                                      "without --as-given it makes none",
                                      step, io::in_quotes(body)));
}

}  // namespace

int run_bodies(const BodiesRunOptions& options) {
  BodyFiles files(options);
  check_output(options, files.files());
  const RecordedPoses poses = read_poses(options.poses, files.names(), options.order);
  BodyResults results(options, files, poses);

  BodyStepOptions how;
  how.threads = thread_count(options.threads);
  how.stop = &interruption();
  how.check_start = options.check_start;
  const std::size_t steps = poses.times.size() - 1, count = files.names().size();
  WaitingLine waiting;
  for (std::size_t step = 0; step < steps; ++step) {
    throw_if_interrupted();
    const std::string label = step_label(poses, step);
    std::vector<RigidMotion> motions(count);
    std::size_t longer = 0;
    for (std::size_t body = 0; body < count; ++body) {
      const Pose start = poses.at(body, step), end = poses.at(body, step + 1);
      longer += takes_longer_turn(motion_between(start, end, Turn::as_given)) ? 1 : 0;
      motions[body] = motion_between(start, end, options.turn);
      check_turn(options, motions[body], files.names()[body], label);
    }
    waiting.begin(fmt::format("{} of {}: {}", step + 1, steps, label));
    const FreeBodyStep found = stoppable([&] {
      if (!options.free_step.empty()) return free_step(files.bodies(), motions, how);
      FreeBodyStep first;
      first.first_contact = first_contact(files.bodies(), motions, how);
      return first;
    });
    waiting.end();
    if (found.first_contact.excluded == count * (count - 1) / 2) {
      throw Error("--ignore and --only-between leave no pair of bodies to ask about");
    }
    results.add(found, longer);
    how.check_start = !found.first_contact.free();  // a free step from a free start ends free
  }
  return results.finish() ? kAllHold : kRefuted;
}

}  // namespace touchstone::cli
