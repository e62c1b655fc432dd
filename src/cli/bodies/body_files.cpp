// SPDX-License-Identifier: MIT
#include "cli/bodies/body_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <touchstone/error.hpp>

#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "frames/frame.hpp"
#include "geometry/kind_traits.hpp"
#include "io/fail.hpp"
#include "sequence/checks.hpp"
#include "sequence/parts/scene_parts.hpp"

namespace touchstone::cli {
namespace {

frames::ReadOptions reading_of(const BodiesRunOptions& options) {
  frames::ReadOptions reading;
  reading.triangulate = options.triangulate;
  reading.checkpoint = throw_if_interrupted;
  return reading;
}

/// "left" of "left=a.obj"; empty where the whole argument is a file, or leads to a folder that there is.
std::string given_name(const std::string& argument) {
  std::error_code ignored;
  const std::size_t end = argument.find('=');
  const std::filesystem::path folder = std::filesystem::path(argument).parent_path();
  if (end == argument.npos || std::filesystem::exists(argument, ignored)) return {};
  if (!folder.empty() && folder.string().find('=') != std::string::npos && std::filesystem::exists(folder, ignored))
    return {};
  if (end == 0) throw Error(fmt::format("{} has no name before the =", io::in_quotes(argument)));
  if (end + 1 == argument.size()) throw Error(fmt::format("{} has no file behind the =", io::in_quotes(argument)));
  return argument.substr(0, end);
}

}  // namespace

BodyFiles::BodyFiles(const BodiesRunOptions& options) {
  std::vector<std::string> unnamed;
  for (const std::string& argument : options.files) {
    if (!given_name(argument).empty()) continue;
    if (std::count(unnamed.begin(), unnamed.end(), argument) > 0)
      io::fail(argument, "is given twice; two bodies of one file have names, such as one=a.obj two=a.obj");
    unnamed.push_back(argument);
  }
  for (const sequence::ScenePart& part : sequence::parts_at_rest(unnamed, reading_of(options))) {
    names_.push_back(part.name);
    files_.push_back(part.frames.front().file);
  }
  for (const std::string& argument : options.files) {
    const std::string name = given_name(argument);
    if (name.empty()) continue;
    const auto parts = sequence::parts_at_rest({argument.substr(name.size() + 1)}, reading_of(options));
    if (parts.size() > 1) throw Error(fmt::format("{} names {} files", io::in_quotes(argument), parts.size()));
    if (std::count(names_.begin(), names_.end(), name) > 0)
      throw Error(fmt::format("two bodies are named {}", io::in_quotes(name)));
    names_.push_back(name);
    files_.push_back(parts.front().frames.front().file);
  }
  if (files_.size() < 2) {
    throw Error(fmt::format("there {} only {}, and elements of one body are never compared; name two files or more",
                            files_.size() == 1 ? "is" : "are", files_.size() == 1 ? "1 body" : "0 bodies"));
  }
  bodies_.separation = options.separation.separation;
  for (std::size_t body = 0; body < files_.size(); ++body) read(options, body);
  for (std::size_t body = 0; body < files_.size(); ++body) {
    elements_.emplace_back(bodies_.bodies[body].mesh(), *topologies_[body]);
  }
  set_rules(options.rules);
}

void BodyFiles::read(const BodiesRunOptions& options, std::size_t body) {
  const std::string& file = files_[body];
  frames::Frame frame = frames::read_frame(file, 0, reading_of(options));
  if (frame.topology->dimension != 3) io::fail(file, "is a mesh in the plane; bodies are in space");
  sequence::RepairOptions repairs = options.repairs;
  repairs.is_one_part = true;
  sequence::Repairs(repairs, true).mend(frame, {file});
  sequence::check_positions(frame, {file});
  auto topology = std::make_shared<frames::Topology>(*frame.topology);
  const Mesh mesh = sequence::mesh_of(*topology, {}, file);
  sequence::MeshFacts facts = sequence::facts_of(mesh, *topology);
  facts.neighbours = 0;  // elements of one body are never compared
  facts_.add_counts(facts);
  topology->face_parts.clear();  // the body is what elements are named after
  topology->vertex_parts.clear();
  topologies_.push_back(std::move(topology));
  bodies_.bodies.emplace_back(mesh, Positions(frame.positions, 3));
}

void BodyFiles::set_rules(const sequence::PartOptions& options) {
  if (options.empty()) return;
  frames::Topology scene;  // a vertex for each body
  scene.parts = names_;
  scene.vertex_count = names_.size();
  for (std::size_t body = 0; body < names_.size(); ++body) {
    scene.vertex_parts.push_back(static_cast<std::uint32_t>(body));
  }
  const std::string option = options.only_between.empty() ? "--ignore" : "--only-between";
  rules_ = sequence::part_rules_of(scene, options, option, "bodies");
  const auto named = static_cast<std::size_t>(
      std::count_if(rules_.pairs.begin(), rules_.pairs.end(), [](const auto& pair) { return pair[0] != pair[1]; }));
  const bool are_asked = rules_.rule == GroupRule::only_listed;
  if (named == (are_asked ? 0 : names_.size() * (names_.size() - 1) / 2))
    throw Error("--ignore and --only-between leave no pair of bodies to ask about");
  CollisionRules rules = sequence::collision_rules(scene, rules_, option);
  if (rules.groups.empty()) return;
  bodies_.rules = {{}, std::move(rules.groups), rules.group_rule, std::move(rules.group_pairs)};
}

sequence::NamedElement BodyFiles::named(MeshElement sort, const BodyElement& element) {
  sequence::NamedElement named = elements_[element.body].element(sort, element.element);
  named.part = sequence::shown_part(names_[element.body]);
  return named;
}

sequence::PairContact BodyFiles::named(const BodyContact& contact) {
  const auto& [first, second] = geometry::traits_of(contact.pair.kind);
  const Answer& answer = contact.answer;
  return {contact.pair.kind,
          named(first.sort, contact.pair.first),
          named(second.sort, contact.pair.second),
          answer.nature,
          answer.feature_a,
          answer.feature_b,
          answer.trend};
}

sequence::RestContact BodyFiles::named(const BodyIntersection& one) {
  return {named(one.first_element, one.first), named(one.second_element, one.second), one.sort};
}

}  // namespace touchstone::cli
