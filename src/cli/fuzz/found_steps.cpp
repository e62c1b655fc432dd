// SPDX-License-Identifier: MIT
#include "cli/fuzz/found_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include <touchstone/error.hpp>

#include "cli/shared/words.hpp"
#include "families/body_scenes.hpp"
#include "families/step_scenes.hpp"
#include "frames/frame.hpp"
#include "frames/write_obj.hpp"
#include "fuzz/bodies/body_steps.hpp"
#include "fuzz/bodies/fuzz_bodies.hpp"
#include "fuzz/bodies/pipe_bodies.hpp"
#include "fuzz/steps/fuzz_steps.hpp"
#include "fuzz/steps/pipe_steps.hpp"
#include "fuzz/steps/plugin_steps.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::cli {
namespace {

using families::BodyScene;
using families::StepScene;

fuzz::Limits limits_of(const FuzzStepsOptions& options) {
  fuzz::Limits limits;
  limits.answer = std::chrono::milliseconds(static_cast<std::int64_t>(std::ceil(1000 * options.limit)));
  limits.start = std::max(limits.start, limits.answer);
  limits.line = std::size_t{1} << 20;
  return limits;
}

std::string obj_text(const Mesh& mesh, const std::vector<Vec3>& positions) {
  frames::Topology topology;
  topology.vertex_count = mesh.vertex_count();
  topology.faces = mesh.faces();
  topology.edges = mesh.edges();
  topology.points = mesh.points();
  std::vector<double> numbers;
  for (const Vec3& at : positions) numbers.insert(numbers.end(), {at.x, at.y, at.z});
  std::string text;
  frames::append_obj(text, topology, numbers.data());
  return text;
}

std::string separation_words(const Separation& separation) {
  if (!(separation.distance > 0)) return {};
  return fmt::format(" --separation {} --metric {}", numbers::decimal_text(separation.distance),
                     name_of(separation.metric));
}

void add_files(const StepScene& scene, FoundStep& found) {
  const Mesh mesh = scene.mesh();
  found.files = {{"-0.obj", obj_text(mesh, scene.x0)},
                 {"-1.obj", obj_text(mesh, scene.x1)},
                 {".json", fuzz::step_line(mesh, Positions(scene.x0), Positions(scene.x1))}};
  const std::string words = separation_words(scene.elements.separation);
  const char* const note = scene.elements.rules.groups.empty() ? "" : "   # of all pairs: frames have no groups";
  found.show = [=](const std::string& path) {
    return fmt::format("  touchstone mesh{} --html step.html {} {}{}\n", words, shell_word(path + "-0.obj"),
                       shell_word(path + "-1.obj"), note);
  };
}

void add_files(const BodyScene& scene, FoundStep& found) {
  const Bodies bodies = scene.bodies();
  const auto name_of_body = [name = found.name](std::size_t body) { return fmt::format("{}-{}", name, body); };
  std::string poses = "time,body,x,y,z,qw,qx,qy,qz\n";
  bool has_radii = false;
  for (std::size_t b = 0; b < bodies.bodies.size(); ++b) {
    const RigidMotion& motion = scene.motions[b];
    const auto row = [&](int time, const Vec3& p, const std::array<double, 4>& q) {
      poses += fmt::format("{},{}", time, name_of_body(b));
      for (const double x : {p.x, p.y, p.z, q[0], q[1], q[2], q[3]}) poses += "," + numbers::decimal_text(x);
      poses += "\n";
    };
    row(0, motion.p0, motion.q0), row(1, motion.p1, motion.q1);
    found.files.emplace_back(fmt::format("-{}.obj", b), obj_text(bodies.bodies[b].mesh(), bodies.bodies[b].points()));
    const std::vector<double>& radii = scene.shapes[b].elements.radii;
    has_radii = has_radii || std::any_of(radii.begin(), radii.end(), [](double radius) { return radius > 0; });
  }
  found.files.emplace_back("-poses.csv", poses);
  found.files.emplace_back(".json", fuzz::bodies_line(bodies, scene.motions));
  std::string words = separation_words(scene.separation);
  for (const auto& [a, b] : scene.rules.body_pairs) words += " --ignore " + name_of_body(a) + "," + name_of_body(b);
  found.show = [=, count = bodies.bodies.size()](const std::string& path) {
    std::string files;
    for (std::size_t b = 0; b < count; ++b) files += " " + shell_word(fmt::format("{}-{}.obj", path, b));
    return fmt::format("  touchstone bodies{} --as-given --no-start{} --poses {} --html step.html{}\n", files, words,
                       shell_word(path + "-poses.csv"), has_radii ? "   # without the radii: files have none" : "");
  };
}

std::string text_of(const fuzz::StepFinding& finding) { return to_string(fuzz::finding_of(finding)); }
std::string text_of(const fuzz::BodyFinding& finding) { return to_string(finding); }

template <class Scene>
FoundSteps shown(const fuzz::SceneOutcome<Scene>& outcome, bool bodies) {
  FoundSteps all{outcome.scenes, outcome.failures, outcome.kinds_of_failure, outcome.stopped, {}};
  for (const fuzz::SceneFinding<Scene>& finding : outcome.findings) {
    FoundStep found;
    found.text = text_of(finding);
    found.case_name = fuzz::case_text(families_of_steps(bodies), finding.name);
    std::string question = finding.failure.question;
    std::replace(question.begin(), question.end(), ' ', '-');
    found.name = fmt::format("{}-{}", question, name_of(finding.failure.failure));
    add_files(finding.scene, found);
    all.found.push_back(found);
  }
  return all;
}

}  // namespace

std::vector<std::string_view> families_of_steps(bool bodies) {
  return bodies ? fuzz::body_families() : families::step_families();
}

FoundSteps find_steps(const FuzzStepsOptions& options, const StepFuzzOptions& search, const fuzz::SceneWatch& watch) {
  const auto known = families_of_steps(options.bodies);
  std::optional<fuzz::SceneCase> a_case;
  if (!options.a_case.empty()) {
    a_case = fuzz::parse_scene_case(known, options.a_case);
    if (!a_case) throw Error("--case: " + options.a_case + " is no case; it must be \"FAMILY SEED INDEX\"");
  }
  for (const std::string& name : search.families) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw Error("--family: " + name + " is no family" + (options.bodies ? " of bodies" : "") +
                "; see touchstone fuzz-steps --help");
  }
  const bool asks_library = options.command.empty() && options.plugin.empty();
  const auto find = [&](const auto& new_solver, const auto& search_all) {
    new_solver();  // a program that cannot be started is told before the search
    return shown(search_all(new_solver, search, a_case, watch), options.bodies);
  };
  if (options.bodies) {
    return find(
        [&]() -> fuzz::BodyStepSolver {
          if (asks_library) return fuzz::library_step_reply;
          return fuzz::run_body_command(options.command, limits_of(options));
        },
        fuzz::search_body_steps);
  }
  return find(
      [&]() -> StepSolver {
        if (asks_library) return fuzz::library_reply;
        if (!options.plugin.empty()) return fuzz::run_step_plugin(options.plugin, limits_of(options));
        return fuzz::run_step_command(options.command, limits_of(options));
      },
      fuzz::search_steps);
}

}  // namespace touchstone::cli
