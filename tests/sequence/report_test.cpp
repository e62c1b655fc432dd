// Reports: the text and back, shards, and text that no run has written.
// SPDX-License-Identifier: MIT
#include "sequence/report_json.hpp"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "io/sealed_json.hpp"
#include "seeded/rng.hpp"
#include "sequence/merge.hpp"
#include "sequence/pairs_table.hpp"
#include "sequence/sample_report.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::sequence;
using seeded::Rng;
using touchstone::tests::sample_report;
using touchstone::tests::sample_shard;

namespace {

std::string refusal_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

std::string refusal_of(const std::string& text) {
  return refusal_of([&] { static_cast<void>(report_from(text)); });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The report with `from` replaced by `to`, and a seal that holds.
std::string forged(const std::string& from, const std::string& to, const Report& report = sample_report()) {
  std::string text = report_text(report);
  text = "{" + text.substr(text.find('\n') + 1);
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return io::sealed_json(text.replace(at, from.size(), to));
}

std::vector<ShardReport> all_shards(std::size_t count) {
  std::vector<ShardReport> shards;
  for (std::size_t i = 1; i <= count; ++i) shards.push_back({"s" + std::to_string(i), sample_shard(i, count)});
  return shards;
}

}  // namespace

TEST_CASE("a report is JSON that says everything, and is read back") {
  const std::string text = report_text(sample_report());
  CHECK(io::seal_holds(text));
  CHECK(report_text(report_from(text)) == text);
  const auto json = nlohmann::json::parse(text);
  CHECK(json["counts"] == nlohmann::json({{"steps", 6},
                                          {"free", 4},
                                          {"not_free", 2},
                                          {"intersections_of_first_frame", 4},
                                          {"folds_of_first_frame", 1},
                                          {"inside_of_first_frame", 1},
                                          {"enclosed_parts_of_first_frame", 6},
                                          {"free_from_intersecting_frame", 3},
                                          {"least_distance", "0x0p+0"}}));
  CHECK(json["mesh"]["idle_vertices"] == 1);
  CHECK(json["mesh"]["pairs_with_common_vertex"] == 24);
  CHECK(json["results"][0]["coinciding_vertices"] == 5);
  CHECK(json["mesh"]["closed_polygons"] == 0);
  CHECK(json["mesh"]["branching_surfaces"] == 0);
  CHECK(json["mesh"]["joined_vertices"] == 0);
  CHECK(json["results"][0]["enclosed_parts"]["points"] == 3);
  CHECK(json["results"][0]["enclosed_parts"]["face"]["number"] == 17);
  REQUIRE(json["warnings"].size() == 8);
  CHECK(json["warnings"][0] == "1 vertex in no element was left out");
  CHECK(
      json["warnings"][1] ==
      "1 surface, 2 wires and 3 loose points are wholly inside a closed surface, which is no contact (vertex 1 inside "
      "the surface of face 17)");
  CHECK(json["warnings"][2] == "pairs within one part were left out");
  CHECK(json["warnings"][3] == "these parts were not asked about: a \"b\" and c,d, c,d and e");
  CHECK(json["warnings"][4] ==
        "1,234 pairs that start within the separation and are connected by edges of less than 0.5 were asked about "
        "touching alone");
  CHECK(json["warnings"][5] ==
        "3 of 4 parts are at rest in all frames, and the names of 2 differ in numbers only: frames of one part are a "
        "pattern in quotes");
  CHECK(json["warnings"][6] == "3 free steps start from a frame that intersects itself");
  CHECK(has(json["warnings"][7], "5 of 13 vertices lie exactly on others: "));
  CHECK(json["parts"]["ignored"].dump() == R"([["a \"b\"","c,d"],["c,d","e"]])");
  CHECK(json["parts"]["within"] == false);
  CHECK(json["clearance"] == true);
  CHECK(json["results"][0]["clearance"] == nlohmann::json({{"distance", "0x0p+0"}}));
  CHECK(json["results"][3]["clearance"]["pairs"] == 2);
  CHECK(json["results"][4]["clearance"]["distance"].is_null());
  CHECK(json["separation"] == "0x1p-3");
  CHECK(json["frames"].size() == 7);
  CHECK(json["results"].size() == 7);
  CHECK(json["results"][2]["toi"] == "0x1.5555555555555p-2");
  CHECK(json["results"][2]["first"][0]["second"] ==
        nlohmann::json({{"element", "face"}, {"number", 17}, {"vertices", {4, 5, 6}}, {"part", "c,d"}}));
  CHECK(json["results"][5]["toi"].is_null());
  CHECK(json["results"][1] ==
        nlohmann::json({{"from", 0}, {"to", 1}, {"free", true}, {"clearance", {{"distance", nullptr}}}}));
}

TEST_CASE("the table of pairs has a row for each pair, and every row has all columns") {
  const std::string table = pairs_table(sample_report(), io::Numbers::decimals);
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 4 + 2 + 2);
  CHECK(has(table,
            "\nc-1.obj,c-2.obj,first,vertex-face,vertex,1,,\"a \"\"b\"\"\xc3\xa9\",face,4 5 6,17,\"c,d\","
            "0.3333333333333333,0.33333333333333337,entering,v,f01,approaching\n"));
  CHECK(has(table, "\nc-0.obj,,folds,,edge,4 5,,,face,4 5 6,17,\"c,d\",,,,,,\n"));
  CHECK(has(table, "\nc-0.obj,,inside,,vertex,1,,\"a \"\"b\"\"\xc3\xa9\",face,4 5 6,17,\"c,d\",,,,,,\n"));
  CHECK(has(table, "\nc-2.obj,,pierces,,edge,4 5,,,face,4 5 6,17,\"c,d\",,,,,,\n"));
  CHECK(has(table,
            "\nc-4.obj,c-5.obj,at_start,edge-edge,edge,4 5,,,edge,4 5,,,0,0,sustained,overlap,overlap,"
            "constant\n"));
}

TEST_CASE("a report about frames at rest has the one mesh of all frames, or that of each frame") {
  Report report;
  report.heading.question = Question::rest;
  report.heading.program = "0.1.0";
  report.heading.frame_count = 2;
  report.heading.list_digest = std::string(64, 'b');
  for (std::size_t i = 0; i < 2; ++i) {
    report.frames.push_back({std::string("c-").append(std::to_string(i)), std::string(64, 'd')});
    report.results.push_back(result_at(Question::rest, {0, 2}, i));
  }
  const MeshFacts triangle{std::string(64, 'a'), 3, 3, 1, 3, 0, 0, 6},
      points{std::string(64, 'c'), 3, 9, 0, 0, 9, 0, 0};
  Report each = report;
  report.heading.facts = points;
  each.frames[0].facts = triangle;
  each.frames[1].facts = points;
  for (const Report& one : {report, each}) CHECK(report_text(report_from(report_text(one))) == report_text(one));
  CHECK(nlohmann::json::parse(report_text(each))["frames"][1]["mesh"]["points"] == 9);
  CHECK(nlohmann::json::parse(report_text(each))["warnings"].size() == 2);
  CHECK(
      difference_of(each.heading, report.heading, "this run") ==
      "is about frames whose elements may differ, and this run about a mesh of 9 vertices and 0 faces with the digest "
      "cccccccccccccccc");
  each.frames[1].facts.reset();
  CHECK(has(refusal_of(report_text(each)), "frames[1]"));
}

TEST_CASE("a report has the classes of parts") {
  Report report;
  report.heading.question = Question::rest;
  report.heading.program = "0.1.0";
  report.heading.frame_count = 1;
  report.heading.list_digest = std::string(64, 'b');
  report.heading.facts = MeshFacts{std::string(64, 'a'), 3, 16, 24, 36, 0};
  report.heading.classes = true;
  report.frames.push_back({"c", std::string(64, 'd')});
  report.results.push_back(result_at(Question::rest, {0, 1}, 0));
  using Class = mesh::Relation;
  report.results[0].classes = {{"a", "b", Class::touching}, {"a", "c", Class::inside}, {"c", "d", Class::inside}};
  const std::string text = report_text(report);
  CHECK(report_text(report_from(text)) == text);
  CHECK(nlohmann::json::parse(text)["counts"]["classes"].dump() ==
        R"({"crossing":0,"inside":2,"overlapping":0,"same":0,"touching":1})");
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& words) {
    CAPTURE(from, to);
    CHECK(has(refusal_of(forged(from, to, report)), words));
  };
  refused("\"class\":\"inside\"", "\"class\":\"around\"", "class: is no name that belongs here");
  refused("\"class\":\"inside\"", "\"class\":\"near\"", "class: is no name that belongs here");
  refused("\"first\":\"c\"", "\"first\":\"\"", "must be one line of text");
  refused("\"inside\": 2", "\"inside\": 1", "not as touchstone mesh writes it");
  refused(",\n \"classes\": true", "", "results[0]: has classes, and the heading does not say so");
  refused("\"classes\": true", "\"classes\": false", "classes: must be true beside frames at rest");
  report.results[0].classes.reset();
  CHECK(has(refusal_of(report_text(report)), "results[0]: has no classes, and the heading says true"));
}

TEST_CASE("shards divide the steps evenly, each step once, and neighbours share a frame") {
  for (const Question question : {Question::steps, Question::rest}) {
    for (std::size_t frames = 2; frames < 20; ++frames) {
      const std::size_t items = item_count(question, frames);
      for (std::size_t count = 1; count <= items; ++count) {
        std::size_t next = 0, results = 0;
        for (std::size_t number = 1; number <= count; ++number) {
          const Range range = frames_of_shard(question, frames, {number, count});
          const std::size_t own = range.last - range.first - (question == Question::steps ? 1 : 0);
          CHECK(range.first == next);
          CHECK(own >= items / count);
          CHECK(own <= items / count + 1);
          next = range.first + own;
          results += result_count(question, range);
        }
        CHECK(next == items);
        CHECK(results == result_count(question, {0, frames}));
      }
    }
  }
}

TEST_CASE("all shards together are the whole report, in any order") {
  const std::string whole = report_text(sample_report());
  for (std::size_t count = 1; count <= 6; ++count) {
    auto shards = all_shards(count);
    for (auto& shard : shards) shard.report = report_from(report_text(shard.report));
    CHECK(report_text(merged(shards)) == whole);
    std::reverse(shards.begin(), shards.end());
    CHECK(report_text(merged(shards)) == whole);
  }
}

TEST_CASE("shards that do not fit together are refused, and the message says which") {
  const auto refused = [](std::vector<ShardReport> shards) {
    return refusal_of([&] { static_cast<void>(merged(std::move(shards))); });
  };
  auto shards = all_shards(4);
  shards.erase(shards.begin() + 2);
  CHECK(has(refused(shards), "s1: is one of 4 shards, and only 3 are given; missing: 3"));
  shards = {all_shards(6)[4]};
  CHECK(has(refused(shards), "only this one is given; missing: 1, 2, 3, 4, 6"));
  shards = all_shards(4);
  shards.push_back(shards[1]);
  shards.back().file = "copy";
  CHECK(has(refused(shards), "copy: is shard 2/4, and so is s2"));
  shards = all_shards(4);
  shards[3].report.heading.separation.distance = 0.25;
  CHECK(has(refused(shards), "s4: is about separation 0x1p-2, max, and s1 about separation 0x1p-3, max"));
  shards = all_shards(4);
  shards[2] = {"other", sample_shard(3, 5)};
  CHECK(has(refused(shards), "other: is about shard 3/5, and s1 about shard 1/4"));
  shards = all_shards(4);
  shards[2].report.heading.facts->digest[5] = 'c';
  CHECK(has(refused(shards), "s3: is about a mesh of 13 vertices"));
  shards = all_shards(4);
  shards[1].report.heading.list_digest[0] ^= 1;
  CHECK(has(refused(shards), "s2: is about frames of other names"));
  shards = all_shards(4);
  shards[2].report.frames.front().digest[0] = 'c';
  CHECK(has(refused(shards), "s3: read another c-4.obj than s2 did"));
  shards = all_shards(4);
  shards[2].report.frames[1].label = "stranger.obj";  // a name that only the digest of all names covers
  shards[3].report.frames[0].label = "stranger.obj";
  CHECK(has(refused(shards), "do not have the names"));
  shards = all_shards(1);
  shards[0].report.heading.shard.reset();
  CHECK(has(refused(shards), "is the report of a whole run"));
}

TEST_CASE("a report with a wrong digest is refused") {
  std::string text = report_text(sample_report());
  for (std::size_t at = 0; at < text.size(); at += 7) {
    std::string bad = text;
    bad[at] = static_cast<char>(bad[at] ^ 1);
    CHECK_FALSE(refusal_of(bad).empty());
  }
  CHECK(has(refusal_of(text.substr(0, text.size() / 2)), "digest"));
  CHECK(has(refusal_of(std::string()), "digest"));
  CHECK(has(refusal_of(std::string("{}")), "digest"));
}

TEST_CASE("a report with a right digest and wrong content is refused by its key") {
  const auto check = [](const std::string& from, const std::string& to, const std::string& message) {
    const std::string refusal = refusal_of(forged(from, to));
    CAPTURE(from, to, refusal);
    CHECK(has(refusal, message));
  };
  check("\"touchstone_mesh\": 3", "\"touchstone_mesh\": 2", "touchstone_mesh: must be 3");
  check("\"frame_count\": 7", "\"frame_count\": 8", "frames: must have 8 items");
  check("\"frame_count\": 7", "\"frame_count\": 1", "frame_count: must be a whole number from 2");
  check("\"frame_count\": 7", "\"frame_count\": -7", "frame_count");
  check("\"frame_count\": 7", "\"frame_count\": 7.0", "frame_count");
  check("\"frame_count\": 7", "\"frame_count\": 1e99", "frame_count");
  check("\"question\": \"steps\"", "\"question\": \"why\"", "question: must be steps or rest");
  check("\"separation\": \"0x1p-3\"", "\"separation\": \"-0x1p-3\"", "separation");
  check("\"separation\": \"0x1p-3\"", "\"separation\": \"0.125\"", "not as touchstone mesh writes it");
  check("\"metric\": \"max\"", "\"metric\": \"sup\"", "metric");
  check("\"free\":true", "\"free\":1", "results[1].free: must be true or false");
  check("\"free\":true", "\"free\":false", "results[1]");
  check("\"from\":1,\"to\":2", "\"from\":1,\"to\":3", "results[2].to");
  check("\"from\":0,\"to\":1", "\"from\":1,\"to\":2", "results[1]");
  check("0x1.5555555555556p-2", "0x1.5555555555557p-2", "toi_upper: must be toi, or the double after it");
  check("0x1.5555555555555p-2", "0x1p+1", "toi: must be a hexfloat in [0, 1]");
  check("\"kind\":\"vertex-face\"", "\"kind\":\"edge-edge\"", "has elements of other sorts");
  check("\"kind\":\"vertex-face\"", "\"kind\":\"\"", "kind: is no name");
  check("\"nature\":\"entering\"", "\"nature\":\"hit\"", "nature: is no name");
  check("\"feature_b\":\"f01\"", "\"feature_b\":5", "feature_b: must be a string");
  check("\"vertices\":[4,5,6]", "\"vertices\":[4,5]", "vertices: must have a number for each corner");
  check("\"vertices\":[4,5,6]", "\"vertices\":[4,5,99999999999]", "must be a whole number");
  check("\"sort\":\"folds\"", "\"sort\":\"touches\"", "not as touchstone mesh writes it");
  check("\"sort\":\"inside\"", "\"sort\":\"outside\"", "results[0].intersections[3].sort: is no name");
  check("\"not_free\": 2", "\"not_free\": 0", "not as touchstone mesh writes it");
  check("\"name\": \"c-0.obj\"", "\"name\": null", "frames[0].name: must be a string");
  check("\"name\": \"c-0.obj\"", "\"name\": \"c-0\\u001b[2J\"", "frames[0].name: must be one line of text");
  check("\"part\":\"c,d\"", "\"part\":\"c\\nd\"", "part: must be one line of text");
  check("\"part\":\"c,d\"", "\"part\":\"\"", "part: must be one line of text");
  check("\"frame\": 3", "\"frame\": 4", "frames[3].frame");
  check("\"counts\"", "\"count\"", "has no key 'count'");
  check("\"results\": [", "\"results\": {}, \"results\": [", "twice");
  check("\"dimension\": 3", "\"dimension\": 4", "mesh.dimension");
  check("\"idle_vertices\": 1", "\"idle_vertices\": 14", "mesh.idle_vertices");
  check("\"idle_vertices\": 1", "\"idle_vertices\": 0", "not as touchstone mesh writes it");
  check("\"wires\":2", "\"wires\":1", "not as touchstone mesh writes it");
  check("\"wires\":2", "\"wires\":-2", "results[0].enclosed_parts.wires");
  check("\"surfaces\":1,\"wires\":2,\"points\":3", "\"surfaces\":0,\"wires\":0,\"points\":0",
        "results[0].enclosed_parts: counts nothing");
  check("\"enclosed_parts\":{", "\"enclosed_parts\":{\"rods\":1,", "has no key 'rods'");
  check("\"closed_polygons\": 0", "\"closed_polygons\": -1", "mesh.closed_polygons");
  check("\"branching_surfaces\": 0", "\"branching_surfaces\": 1", "not as touchstone mesh writes it");
  check("\"joined_vertices\": 0", "\"joined_vertices\": -1", "mesh.joined_vertices");
  check("\"enclosed_parts\":{", "\"flat_faces\":0,\"enclosed_parts\":{", "results[0].flat_faces");
  check("\"coinciding_vertices\":5", "\"coinciding_vertices\":0", "results[0].coinciding_vertices");
  check("\"own_neighbours_at_start\":1", "\"own_neighbours_at_start\":3", "results[5].own_neighbours_at_start");
  check("\"within\": false", "\"within\": 0", "parts.within: must be true or false");
  check("[\"c,d\", \"e\"]", "[\"c,d\"]", "parts.ignored[1]: must be two names");
  check("\"ignored\"", "\"only\"", "not as touchstone mesh writes it");
  check("\"clearance\": true", "\"clearance\": false", "clearance: must be true, or not be there");
  check(",\n \"clearance\": true", "", "results[0]: has a clearance, and the heading does not say so");
  check(",\"clearance\":{\"distance\":null}", "", "results[1]: has no clearance, and the heading says true");
  check("[\"c,d\", \"e\"]", "[\"a \\\"b\\\"\", \"c,d\"]", "parts.ignored[1]: must come after the pair before it");
  check("\"distance\":\"0x1.8p-3\"", "\"distance\":\"-0x1.8p-3\"", "distance: must be null or a hexfloat");
  check("\"pairs\":2", "\"pairs\":0", "results[3].clearance.pairs");
  check("\"length\": \"0x1p-1\"", "\"length\": \"0x0p+0\"", "self.length: must be a hexfloat greater than 0");
  check("\"length\": \"0x1p-1\"", "\"length\": \"0x1p-2\"", "not as touchstone mesh writes it");
  check("\"pairs\": 1234", "\"pairs\": -1", "self.pairs");
  check("\"separation\": \"0x1p-3\"", "\"separation\": \"0x0p+0\"", "self: must be beside steps and a separation");
  check("\"at_rest\": 3", "\"at_rest\": 4", "scene.at_rest");
  check("\"numbered\": 2", "\"numbered\": 4", "scene.numbered");
  check("\"numbered\": 2", "\"numbered\": 1", "not as touchstone mesh writes it");
  check("start from a frame", "start with a frame", "not as touchstone mesh writes it");
}

TEST_CASE("no sealed text crashes the reader, and what it takes is what it writes") {
  std::string text = report_text(sample_report());
  text = text.substr(text.find('\n') + 1);
  Rng rng(20260114);
  const auto rounds = static_cast<int>(tests::effort(3000));
  int taken = 0;
  for (int round = 0; round < rounds; ++round) {
    std::string bad = text;
    const int changes = 1 + static_cast<int>(rng.below(3));
    for (int change = 0; change < changes; ++change) {
      const std::size_t at = rng.below(bad.size());
      const std::size_t from = rng.below(bad.size());
      const std::size_t length = rng.below(40);
      const std::uint64_t sort = rng.below(4);
      if (sort == 0) bad[at] = static_cast<char>(rng.below(256));
      if (sort == 1) bad.erase(at, length);
      if (sort == 2) bad.insert(at, bad.substr(from, length));
      if (sort == 3) bad[at] = "0123456789[]{},:\"-"[rng.below(18)];
      if (bad.empty()) bad = " ";
    }
    const std::string sealed = io::sealed_json("{" + bad);
    if (!refusal_of(sealed).empty()) continue;
    CHECK(report_text(report_from(sealed)) == sealed);
    ++taken;
  }
  CHECK(taken < rounds / 4);
}
