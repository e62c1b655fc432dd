// A report with every sort of result.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "sequence/frame_list.hpp"
#include "sequence/report_json.hpp"

namespace touchstone::tests {

/// Of seven frames; frame 0 intersects itself, step 1 -> 2 has a first contact, step 4 -> 5 one at its start.
inline sequence::Report sample_report() {
  using namespace sequence;
  Report report;
  report.heading.program = "0.1.0";
  report.heading.separation = {0.125, Metric::max};
  report.heading.parts = {GroupRule::all_but_listed, false, {{"a \"b\"", "c,d"}, {"c,d", "e"}}};
  report.heading.clearance = true;
  report.heading.self = SelfRule{0.5, 1234, std::string(64, '0')};
  report.heading.scene = SceneFacts{4, 3, 2};
  report.heading.frame_count = 7;
  report.heading.facts = MeshFacts{std::string(64, 'a'), 3, 13, 4, 12, 0, 1, 24};
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < 7; ++i) {
    labels.push_back(std::string("c-").append(std::to_string(i)).append(".obj"));
    report.frames.push_back({labels.back(), std::string(64, static_cast<char>('0' + i))});
  }
  report.heading.list_digest = digest_of(labels);
  const NamedElement vertex{MeshElement::vertex, {1, 0, 0}, 0, "a \"b\"\xc3\xa9"};
  const NamedElement edge{MeshElement::edge, {4, 5, 0}, 0, ""};
  const NamedElement face{MeshElement::face, {4, 5, 6}, 17, "c,d"};
  for (std::size_t i = 0; i < result_count(Question::steps, {0, 7}); ++i) {
    report.results.push_back(result_at(Question::steps, {0, 7}, i));
  }
  using Sort = IntersectionSort;
  report.results[0].intersections = {{edge, face, Sort::pierces},
                                     {vertex, face, Sort::touches},
                                     {edge, face, Sort::folds},
                                     {vertex, face, Sort::inside}};
  report.results[0].coinciding = 5;
  report.results[0].enclosed = {1, 2, 3, vertex, face};
  Result& first = report.results[2];
  first.toi = 0x1.5555555555555p-2;
  first.toi_upper = 0x1.5555555555556p-2;
  first.first = {{Kind::vertex_face, vertex, face, Nature::entering, Feature::v, Feature::f01, Trend::approaching}};
  first.intersections = {{edge, face, Sort::pierces}};
  report.results[0].clearance = {.distance = 0};
  report.results[3].clearance = {0x1.8p-3, 0x1p-2, 0x1.0000000000001p-2, 2, first.first[0]};
  for (const std::size_t i : {1, 2, 4, 5, 6}) report.results[i].clearance = Clearance();
  report.results[5].at_start = {
      {Kind::edge_edge, edge, edge, Nature::sustained, Feature::overlap, Feature::overlap, Trend::constant},
      {Kind::point_edge, vertex, edge, Nature::isolated, Feature::p, Feature::e, Trend::leaving}};
  report.results[5].own_neighbours = 1;
  return report;
}

/// The report of one shard of it.
inline sequence::Report sample_shard(std::size_t number, std::size_t count) {
  using namespace sequence;
  const Report whole = sample_report();
  Report part;
  part.heading = whole.heading;
  part.heading.shard = Shard{number, count};
  const Range range = range_of(part.heading);
  for (std::size_t i = range.first; i < range.last; ++i) part.frames.push_back(whole.frames[i]);
  for (std::size_t i = 0; i < result_count(Question::steps, range); ++i) {
    const Result right = result_at(Question::steps, range, i);
    for (const Result& result : whole.results) {
      if (result.step == right.step && result.frame == right.frame) part.results.push_back(result);
    }
  }
  return part;
}

}  // namespace touchstone::tests
