// SPDX-License-Identifier: MIT
#include "sequence/report_json.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/fail.hpp"
#include "io/sealed_json.hpp"
#include "io/times.hpp"
#include "sequence/results_json.hpp"
#include "sequence/scope.hpp"

namespace touchstone::sequence {
namespace {

std::string question_name(Question question) { return question == Question::steps ? "steps" : "rest"; }

std::string shown_shard(const std::optional<Shard>& shard) {
  return shard ? fmt::format("shard {}/{}", shard->number, shard->count) : "a whole sequence";
}

std::string shown_separation(const Separation& separation) {
  if (separation.distance == 0) return fmt::format("touching, {}", name_of(separation.metric));
  return fmt::format("separation {}, {}", io::hexfloat(separation.distance), name_of(separation.metric));
}

std::string shown_parts(const PartRules& rules) {
  const std::vector<std::string> texts = left_out_by(rules);
  return texts.empty() ? "all parts" : fmt::format("{}", fmt::join(texts, "; "));
}

std::string json_of(const PartRules& rules) {
  std::string text = fmt::format("\"parts\": {{\"{}\": [", rules.rule == GroupRule::only_listed ? "only" : "ignored");
  for (const auto& [a, b] : rules.pairs) {
    text += fmt::format("{}[{}, {}]", text.back() == '[' ? "" : ", ", json_string(a), json_string(b));
  }
  const bool within = rules.within && rules.rule == GroupRule::all_but_listed;
  return text + fmt::format("], \"within\": {}}}", within);
}

std::string shown_self(const std::optional<SelfRule>& self) {
  return self ? fmt::format("separations within a surface beyond edges of {}", self->length)
              : std::string("separations of all pairs alike");
}

std::string shown_scene(const std::optional<SceneFacts>& scene) {
  return scene ? fmt::format("a scene of {} parts with {} of them at rest", scene->parts, scene->at_rest)
               : std::string("frames of one mesh");
}

std::string shown_facts(const std::optional<MeshFacts>& facts) {
  if (!facts) return "frames whose elements may differ";
  return fmt::format("a mesh of {} vertices and {} faces with the digest {}", facts->vertices, facts->faces,
                     facts->digest.substr(0, 16));
}

std::string json_of(const MeshFacts& facts) {
  std::string text = fmt::format(
      "\"mesh\": {{\"sha256\": \"{}\", \"dimension\": {}, \"vertices\": {}, \"faces\": {}, \"edges\": {}, \"points\": "
      "{}, "
      "\"idle_vertices\": {}, \"pairs_with_common_vertex\": {}, \"closed_polygons\": {}, \"branching_surfaces\": {}, "
      "\"joined_vertices\": {}",
      facts.digest, facts.dimension, facts.vertices, facts.faces, facts.edges, facts.points, facts.idle,
      facts.neighbours, facts.polygons, facts.branching, facts.joined);
  if (facts.welded > 0) text += fmt::format(", \"welded_vertices\": {}", facts.welded);
  if (facts.dropped > 0) text += fmt::format(", \"dropped_elements\": {}", facts.dropped);
  if (facts.animations > 0) text += fmt::format(", \"animations_not_read\": {}", facts.animations);
  if (facts.unshown > 0) text += fmt::format(", \"meshes_outside_scene\": {}", facts.unshown);
  if (facts.moved > 0) text += fmt::format(", \"moved_vertices\": {}", facts.moved);
  return text + "}";
}

}  // namespace

Range range_of(const Heading& heading) {
  return frames_of_shard(heading.question, heading.frame_count, heading.shard.value_or(Shard()));
}

ResultCounts counts_of(const Report& report) {
  ResultCounts counts;
  for (const Result& result : report.results) counts.add(report.heading.question, result);
  return counts;
}

std::string heading_json(const Heading& heading) {
  std::string text = fmt::format(
      " \"touchstone_mesh\": 3,\n \"touchstone\": {},\n \"question\": \"{}\",\n \"separation\": \"{}\",\n"
      " \"metric\": \"{}\",\n \"frame_count\": {},\n \"names_sha256\": \"{}\"",
      json_string(heading.program), question_name(heading.question), io::hexfloat(heading.separation.distance),
      name_of(heading.separation.metric), heading.frame_count, heading.list_digest);
  if (const auto& shard = heading.shard) {
    text += fmt::format(",\n \"shard\": {{\"number\": {}, \"count\": {}}}", shard->number, shard->count);
  }
  if (!heading.parts.empty()) text += ",\n " + json_of(heading.parts);
  if (heading.clearance) text += ",\n \"clearance\": true";
  if (heading.classes) text += ",\n \"classes\": true";
  if (const auto& self = heading.self) {
    text += fmt::format(",\n \"self\": {{\"length\": \"{}\", \"pairs\": {}, \"frame_sha256\": \"{}\"}}",
                        io::hexfloat(self->length), self->pairs, self->frame_digest);
  }
  if (const auto& scene = heading.scene) {
    text += fmt::format(",\n \"scene\": {{\"parts\": {}, \"at_rest\": {}, \"numbered\": {}}}", scene->parts,
                        scene->at_rest, scene->numbered);
  }
  if (heading.dt) text += fmt::format(",\n \"dt\": \"{}\"", io::hexfloat(*heading.dt));
  if (heading.facts) text += ",\n " + json_of(*heading.facts);
  return text;
}

std::string report_text(const Report& report) {
  std::string text = fmt::format("{{{},\n \"frames\": [", heading_json(report.heading));
  const std::size_t first = range_of(report.heading).first;
  for (std::size_t i = 0; i < report.frames.size(); ++i) {
    const auto& [label, digest, facts] = report.frames[i];
    text += fmt::format("{}\n  {{\"frame\": {}, \"name\": {}, \"sha256\": \"{}\"{}}}", i == 0 ? "" : ",", first + i,
                        json_string(label), digest, facts ? ", " + json_of(*facts) : std::string());
  }
  text += "\n ],\n \"results\": [";
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    text.append(i == 0 ? "\n  " : ",\n  ").append(result_json(report.results[i]));
  }
  const ResultCounts counts = counts_of(report);
  const bool steps = report.heading.question == Question::steps;
  text += fmt::format("\n ],\n \"counts\": {{\"{}\": {}, \"free\": {}, \"not_free\": {}", steps ? "steps" : "frames",
                      counts.results, counts.free, counts.results - counts.free);
  text += fmt::format(", \"intersections{0}\": {1}, \"folds{0}\": {2}, \"inside{0}\": {3}, \"enclosed_parts{0}\": {4}",
                      steps ? "_of_first_frame" : "", counts.intersections.all, counts.intersections.folds,
                      counts.intersections.inside, counts.enclosed.all());
  if (steps) text += fmt::format(", \"free_from_intersecting_frame\": {}", counts.from_intersecting);
  if (counts.least_distance && std::isfinite(counts.least_distance->distance)) {
    text += fmt::format(", \"least_distance\": \"{}\"", io::hexfloat(counts.least_distance->distance));
  }
  if (report.heading.classes) {
    text += ", \"classes\": {";
    for (std::size_t i = 0; i < mesh::kRelations; ++i) {
      const auto sort = static_cast<mesh::Relation>(i);
      if (sort == mesh::Relation::clear || sort == mesh::Relation::around) continue;
      text += fmt::format("{}\"{}\": {}", text.ends_with('{') ? "" : ", ", name_of(sort), counts.classes[i]);
    }
    text += "}";
  }
  text += "},\n \"warnings\": [";
  std::vector<std::string> warnings = warnings_of(report.heading, report.frames, counts);
  if (const std::string cause = likely_cause(report.heading, counts); !cause.empty()) warnings.push_back(cause);
  for (std::size_t i = 0; i < warnings.size(); ++i) text += (i == 0 ? "\n  " : ",\n  ") + json_string(warnings[i]);
  return io::sealed_json(text + "\n ]\n}\n");
}

std::string difference_of(const Heading& a, const Heading& b, std::string_view other) {
  const auto differ = [&](const std::string& one, const std::string& two) {
    return fmt::format("is about {}, and {} about {}", one, other, two);
  };
  if (a.program != b.program) {
    return fmt::format("was made by touchstone {}, and {} by touchstone {}", io::shortened(a.program), other,
                       io::shortened(b.program));
  }
  if (a.question != b.question) return differ(question_name(a.question), question_name(b.question));
  if (a.separation.distance != b.separation.distance || a.separation.metric != b.separation.metric) {
    return differ(shown_separation(a.separation), shown_separation(b.separation));
  }
  if (a.parts != b.parts) return differ(shown_parts(a.parts), shown_parts(b.parts));
  if (a.clearance != b.clearance) {
    return differ(a.clearance ? "the least distance, too" : "contacts alone",
                  b.clearance ? "the least distance, too" : "contacts alone");
  }
  if (a.classes != b.classes) {
    return differ(a.classes ? "classes of parts, too" : "intersections alone",
                  b.classes ? "classes of parts, too" : "intersections alone");
  }
  if (a.self != b.self) {
    const bool other_frame = a.self && b.self && a.self->length == b.self->length;
    return other_frame ? differ("another first frame", "the first frame given")
                       : differ(shown_self(a.self), shown_self(b.self));
  }
  if (a.scene != b.scene) return differ(shown_scene(a.scene), shown_scene(b.scene));
  if (a.dt != b.dt) {
    const auto shown = [](const std::optional<double>& dt) {
      return dt ? fmt::format("velocities and dt = {}", *dt) : std::string("frames alone");
    };
    return differ(shown(a.dt), shown(b.dt));
  }
  if (a.frame_count != b.frame_count) {
    return differ(fmt::format("{} frames", a.frame_count), fmt::format("{} frames", b.frame_count));
  }
  if (a.list_digest != b.list_digest) return differ("frames of other names", "the names given");
  if (a.shard.has_value() != b.shard.has_value() ||
      (a.shard && (a.shard->number != b.shard->number || a.shard->count != b.shard->count))) {
    return differ(shown_shard(a.shard), shown_shard(b.shard));
  }
  if (a.facts != b.facts) return differ(shown_facts(a.facts), shown_facts(b.facts));
  return {};
}

}  // namespace touchstone::sequence
