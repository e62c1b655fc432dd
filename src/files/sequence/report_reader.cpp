// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

#include <touchstone/error.hpp>

#include "io/fail.hpp"
#include "io/queries/separation_text.hpp"
#include "io/sealed_json.hpp"
#include "io/times.hpp"
#include "json/json_node.hpp"
#include "sequence/frame_list.hpp"
#include "sequence/report_json.hpp"
#include "sequence/results_json.hpp"

namespace touchstone::sequence {
namespace {

using json::JsonNode;

constexpr std::uint64_t kMostElements = std::uint64_t{1} << 40;
constexpr std::uint64_t kMostPairs = std::uint64_t{1} << 63;

MeshFacts facts_from(const JsonNode& node) {
  node.check_keys({"sha256", "dimension", "vertices", "faces", "edges", "points", "idle_vertices",
                   "pairs_with_common_vertex", "closed_polygons", "branching_surfaces", "joined_vertices",
                   "welded_vertices", "dropped_elements", "animations_not_read", "meshes_outside_scene",
                   "moved_vertices"});
  const auto count = [&](const char* key) {
    return static_cast<std::size_t>(node.at(key).whole_number(0, kMostElements));
  };
  MeshFacts facts;
  facts.digest = digest_from(node.at("sha256"));
  facts.dimension = static_cast<int>(node.at("dimension").whole_number(2, 3));
  facts.vertices = count("vertices");
  facts.faces = count("faces");
  facts.edges = count("edges");
  facts.points = count("points");
  facts.idle = static_cast<std::size_t>(node.at("idle_vertices").whole_number(0, facts.vertices));
  facts.neighbours = static_cast<std::size_t>(node.at("pairs_with_common_vertex").whole_number(0, kMostPairs));
  facts.polygons = count("closed_polygons");
  facts.branching = count("branching_surfaces");
  facts.joined = count("joined_vertices");
  if (const auto welded = node.find("welded_vertices")) facts.welded = welded->whole_number(1, facts.vertices);
  if (const auto dropped = node.find("dropped_elements")) facts.dropped = dropped->whole_number(1, kMostElements);
  if (const auto all = node.find("animations_not_read")) facts.animations = all->whole_number(1, kMostElements);
  if (const auto all = node.find("meshes_outside_scene")) facts.unshown = all->whole_number(1, kMostElements);
  if (const auto moved = node.find("moved_vertices")) facts.moved = moved->whole_number(1, facts.vertices);
  return facts;
}

Separation separation_from(const JsonNode& root) {
  const auto distance = io::parse_finite_double(root.at("separation").text());
  if (!distance || *distance < 0) root.at("separation").fail("must be a hexfloat, 0 or greater");
  const auto metric = from_name<Metric>(root.at("metric").text());
  if (!metric) root.at("metric").fail("must be euclidean or max");
  return {*distance, *metric};
}

PartRules parts_from(const JsonNode& node) {
  const bool only = node.has("only");
  node.check_keys({only ? "only" : "ignored", "within"});
  PartRules rules;
  rules.rule = only ? GroupRule::only_listed : GroupRule::all_but_listed;
  const bool within = node.at("within").boolean();
  if (only && within) node.at("within").fail("must be false beside only");
  rules.within = only || within;
  for (const JsonNode& pair : node.at(only ? "only" : "ignored").items()) {
    const auto names = pair.items();
    if (names.size() != 2) pair.fail("must be two names");
    std::array<std::string, 2> parts = {clean_text_from(names[0]), clean_text_from(names[1])};
    if (!rules.pairs.empty() && !(rules.pairs.back() < parts)) pair.fail("must come after the pair before it");
    rules.pairs.push_back(std::move(parts));
  }
  if (rules.empty() || (only && rules.pairs.empty())) node.fail("leaves nothing out, or everything");
  return rules;
}

Shard shard_from(const JsonNode& node, std::uint64_t items) {
  node.check_keys({"number", "count"});
  Shard shard;
  shard.count = node.at("count").whole_number(1, items);
  shard.number = node.at("number").whole_number(1, shard.count);
  return shard;
}

Heading heading_of(const JsonNode& root) {
  root.at("touchstone_mesh").version(3);
  Heading heading;
  heading.program = root.at("touchstone").text();
  const std::string question = root.at("question").text();
  if (question != "steps" && question != "rest") root.at("question").fail("must be steps or rest");
  heading.question = question == "steps" ? Question::steps : Question::rest;
  heading.separation = separation_from(root);
  const bool steps = heading.question == Question::steps;
  heading.frame_count = root.at("frame_count").whole_number(steps ? 2 : 1, kMostFrames);
  heading.list_digest = digest_from(root.at("names_sha256"));
  if (const auto shard = root.find("shard")) {
    heading.shard = shard_from(*shard, item_count(heading.question, heading.frame_count));
  }
  if (const auto parts = root.find("parts")) heading.parts = parts_from(*parts);
  if (const auto clearance = root.find("clearance")) {
    heading.clearance = clearance->boolean();
    if (!heading.clearance) clearance->fail("must be true, or not be there");
  }
  if (const auto classes = root.find("classes")) {
    heading.classes = classes->boolean();
    if (!heading.classes || steps) classes->fail("must be true beside frames at rest, or not be there");
  }
  if (const auto self = root.find("self")) {
    self->check_keys({"length", "pairs", "frame_sha256"});
    const auto length = io::parse_finite_double(self->at("length").text());
    if (!length || !(*length > 0)) self->at("length").fail("must be a hexfloat greater than 0");
    heading.self = {*length, self->at("pairs").whole_number(0, kMostPairs), digest_from(self->at("frame_sha256"))};
    if (!steps || heading.separation.distance == 0) self->fail("must be beside steps and a separation");
  }
  if (const auto scene = root.find("scene")) {
    scene->check_keys({"parts", "at_rest", "numbered"});
    const std::size_t parts = scene->at("parts").whole_number(1, kMostElements);
    const std::size_t at_rest = scene->at("at_rest").whole_number(0, parts - 1);
    heading.scene = {parts, at_rest, scene->at("numbered").whole_number(0, at_rest)};
    if (!steps) scene->fail("must be beside steps");
  }
  if (const auto dt = root.find("dt")) {
    heading.dt = io::parse_finite_double(dt->text());
    if (!heading.dt || !steps || heading.frame_count != 2) dt->fail("must be a hexfloat, and beside two frames");
  }
  if (steps || root.has("mesh")) heading.facts = facts_from(root.at("mesh"));
  return heading;
}

void check_count(const JsonNode& node, std::size_t found, std::size_t right) {
  if (found != right) node.fail(fmt::format("must have {} items, and has {}", right, found));
}

}  // namespace

Heading heading_from(std::string_view text) {
  const json::JsonDocument document = json::parse_json(text);
  return heading_of(JsonNode(document.value(), "the heading"));
}

Report report_from(std::string_view text) {
  if (!io::seal_holds(text)) {
    throw Error("the report's digest does not match its content: the file is damaged, or no report of touchstone mesh");
  }
  const json::JsonDocument document = json::parse_json(text);
  const JsonNode root(document.value(), "the report");
  root.check_keys({"sha256",    "touchstone_mesh", "touchstone",   "question", "separation",
                   "metric",    "frame_count",     "names_sha256", "shard",    "parts",
                   "clearance", "classes",         "self",         "scene",    "dt",
                   "mesh",      "frames",          "results",      "counts",   "warnings"});
  Report report;
  report.heading = heading_of(root);
  const Question question = report.heading.question;
  const Range range = range_of(report.heading);

  const auto frames = root.at("frames").items();
  check_count(root.at("frames"), frames.size(), range.last - range.first);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].check_keys({"frame", "name", "sha256", "mesh"});
    frames[i].at("frame").whole_number(range.first + i, range.first + i);
    report.frames.push_back({clean_text_from(frames[i].at("name")), digest_from(frames[i].at("sha256"))});
    if (!report.heading.facts) report.frames.back().facts = facts_from(frames[i].at("mesh"));
  }
  const auto results = root.at("results").items();
  check_count(root.at("results"), results.size(), result_count(question, range));
  for (std::size_t i = 0; i < results.size(); ++i) {
    Result result = result_from(results[i]);
    const Result right = result_at(question, range, i);
    if (result.step != right.step || result.frame != right.frame) {
      results[i].fail("is about another frame or step than its place in the list");
    }
    if (result.clearance.has_value() != report.heading.clearance) {
      results[i].fail(report.heading.clearance ? "has no clearance, and the heading says true"
                                               : "has a clearance, and the heading does not say so");
    }
    if (result.classes.has_value() != report.heading.classes) {
      results[i].fail(report.heading.classes ? "has no classes, and the heading says true"
                                             : "has classes, and the heading does not say so");
    }
    report.results.push_back(std::move(result));
  }
  // The counts, the order of keys and the spelling of numbers are then right too.
  if (report_text(report) != text) throw Error("the report is not as touchstone mesh writes it");
  return report;
}

}  // namespace touchstone::sequence
