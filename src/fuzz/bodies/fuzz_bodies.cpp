// SPDX-License-Identifier: MIT
#include "fuzz/bodies/fuzz_bodies.hpp"

#include <initializer_list>
#include <sstream>
#include <utility>

#include "fuzz/bodies/shrink_bodies.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::fuzz {
namespace {

using families::BodyScene;

std::string in_brackets(std::initializer_list<double> values) {
  std::string text = "(";
  for (const double x : values) text.append(text.size() > 1 ? ", " : "").append(numbers::decimal_text(x));
  return text + ")";
}

std::string scene_text_of(const Vec3& p) { return in_brackets({p.x, p.y, p.z}); }
std::string scene_text_of(const std::array<double, 4>& q) { return in_brackets({q[0], q[1], q[2], q[3]}); }

template <class Value>
std::string scene_text_of_change(const Value& start, const Value& end) {
  const std::string first = scene_text_of(start), second = scene_text_of(end);
  return first == second ? first + " at all times" : first + " -> " + second;
}

template <class Elements>
std::string scene_text_of_elements(const char* name, const Elements& elements) {
  std::string text;
  for (const auto& corners : elements) {
    text.empty() ? text.append("; ").append(name).append(" ") : text.append(", ");
    for (std::size_t c = 0; c < corners.size(); ++c) text.append(c > 0 ? "-" : "").append(std::to_string(corners[c]));
  }
  return text;
}

}  // namespace

std::vector<std::string_view> body_families() {
  std::vector<std::string_view> names;
  for (const families::BodyFamily family : families::kEveryBodyFamily) names.push_back(families::name_of(family));
  return names;
}

std::string to_string(const BodyFinding& finding) {
  std::ostringstream out;
  const BodyScene& scene = finding.scene;
  out << headline_of(finding.failure, finding.count);
  for (std::size_t b = 0; b < scene.shapes.size(); ++b) {
    const auto& [elements, points] = scene.shapes[b];
    out << "  body " << b << "  points";
    for (const Vec3& point : points) out << " " << scene_text_of(point);
    out << scene_text_of_elements("faces", elements.faces) << scene_text_of_elements("edges", elements.edges);
    for (std::size_t r = 0; r < elements.radii.size(); ++r) {
      out << (r == 0 ? "; radii " : ", ") << numbers::decimal_text(elements.radii[r]);
    }
    const RigidMotion& motion = scene.motions[b];
    out << "\n    orientation " << scene_text_of_change(motion.q0, motion.q1) << "\n    position "
        << scene_text_of_change(motion.p0, motion.p1) << "\n";
  }
  for (const auto& [a, b] : scene.rules.body_pairs) out << "  bodies " << a << " and " << b << " never collide\n";
  if (scene.separation.distance > 0) {
    out << "  separation " << numbers::decimal_text(scene.separation.distance) << ", "
        << touchstone::name_of(scene.separation.metric) << "\n";
  }
  out << "  found as " << case_text(body_families(), finding.name) << "\n";
  return out.str();
}

SceneSort<BodyScene> body_scenes(std::function<BodyScene(const SceneCase&)> make,
                                 std::function<SceneJudge<BodyScene>()> new_judge) {
  SceneSort<BodyScene> sort;
  sort.families = body_families();
  sort.make = std::move(make);
  sort.new_judge = std::move(new_judge);
  sort.difficulty = [](const BodyScene& scene) { return difficulty(scene); };
  sort.shrink = shrink_bodies;
  return sort;
}

std::vector<std::string> left_out_of_bodies(const StepFuzzOptions& options) {
  std::vector<std::string> left_out;
  if (!options.separations) left_out.emplace_back("separations and radii");
  if (!options.groups) left_out.emplace_back("pairs of bodies that never collide");
  return left_out;
}

BodyFuzzOutcome fuzz_bodies(const BodySolver& solver, const SceneSettings& settings, const SceneWatch& watch) {
  const auto make = [](const SceneCase& name) {
    return families::body_scene(families::kEveryBodyFamily.at(name.family), name.seed, name.index);
  };
  const auto new_judge = [&] { return [&](const BodyScene& scene) { return judge_bodies(scene, solver); }; };
  return search_scenes(body_scenes(make, new_judge), settings, watch);
}

}  // namespace touchstone::fuzz
