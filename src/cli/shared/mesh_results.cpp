// SPDX-License-Identifier: MIT
#include "cli/shared/mesh_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/shared/command_line/separation_options.hpp"
#include "cli/shared/words.hpp"
#include "io/times.hpp"
#include "sequence/report_json.hpp"
#include "sequence/scope.hpp"

namespace touchstone::cli {

std::string element_for_person(const sequence::NamedElement& element) {
  std::string corners;
  for (std::size_t i = 0; i < element.corner_count(); ++i) {
    corners += fmt::format("{}{}", i == 0 ? "" : "-", element.vertices[i]);
  }
  std::string text = element.element == MeshElement::face ? fmt::format("face {} ({})", element.face, corners)
                                                          : fmt::format("{} {}", name_of(element.element), corners);
  if (!element.part.empty()) text += " of " + element.part;
  return text;
}

std::string pair_for_person(const sequence::PairContact& pair) {
  return element_for_person(pair.first) + " and " + element_for_person(pair.second);
}

std::string time_range(double toi, double toi_upper) {
  if (toi == toi_upper) return "t = " + time_for_person(toi);
  return fmt::format("t in [{}, {}] ({})", io::hexfloat(toi), io::hexfloat(toi_upper), toi);
}

std::string pairs_are(std::size_t count) {
  return count == 1 ? "1 pair is in contact at the start" : counted(count, "pair") + " are in contact at the start";
}

std::string more_line(std::size_t count, const std::string& indent) {
  return count > kShownPairs ? fmt::format("{}and {} more\n", indent, grouped(count - kShownPairs)) : std::string();
}

std::string intersection_lines(const std::vector<sequence::RestContact>& contacts, const std::string& indent) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kShownPairs, contacts.size()); ++i) {
    text += fmt::format("{}{} {} {}\n", indent, element_for_person(contacts[i].first),
                        intersection_verb(contacts[i].sort), element_for_person(contacts[i].second));
  }
  return text + more_line(contacts.size(), indent);
}

std::string intersections_for_person(const sequence::IntersectionCounts& counts) {
  std::string text = counted(counts.all, "intersection");
  if (counts.folds > 0)
    text += fmt::format(", {} of them {}", grouped(counts.folds), counts.folds == 1 ? "a fold" : "folds");
  if (counts.inside > 0) {
    text += fmt::format(", {} of them {}", grouped(counts.inside),
                        counts.inside == 1 ? "a part inside a closed surface" : "parts inside closed surfaces");
  }
  return text;
}

std::string least_distance_for_person(double distance, Metric metric) {
  if (std::isinf(distance)) return "no two elements have a distance";
  return fmt::format("least distance {}{}", distance, metric == Metric::max ? " in the max metric" : "");
}

namespace {

std::string classes_for_person(const sequence::ResultCounts& counts) {
  std::string text;
  std::size_t all = 0;
  for (std::size_t i = 0; i < counts.classes.size(); ++i) {
    if (counts.classes[i] == 0) continue;
    all += counts.classes[i];
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(counts.classes[i]),
                        name_of(static_cast<mesh::Relation>(i)));
  }
  if (all == 0) return "all parts are clear of each other";
  return fmt::format("{} of parts not clear of each other: {}", counted(all, "pair"), text);
}

}  // namespace

std::string counts_for_person(const sequence::Heading& heading, const std::vector<sequence::FrameEntry>& frames,
                              const sequence::ResultCounts& counts) {
  const bool steps = heading.question == sequence::Question::steps;
  const std::size_t rest = counts.results - counts.free;
  std::string text = sequence::likely_cause(heading, counts);
  if (!text.empty()) text += "\n";
  text += heading.shard ? fmt::format("shard {}/{}: ", heading.shard->number, heading.shard->count) : "";
  text += counted(counts.results, steps ? "step" : "frame");
  if (steps) {
    text += rest == 0 ? ", all free" : fmt::format(": {} free, {} not free", grouped(counts.free), grouped(rest));
  } else {
    if (heading.frame_count > 1) text += ", each by itself";
    const std::string none = heading.frame_count > 1 ? ": no intersection" : ", no intersection";
    text += rest == 0 ? none
                      : fmt::format(": {} without intersections, {} with {}", grouped(counts.free), grouped(rest),
                                    intersections_for_person(counts.intersections));
  }
  if (steps && counts.intersections.all > 0) {
    text += fmt::format("; the first frame has {}", intersections_for_person(counts.intersections));
  }
  if (const auto& least = counts.least_distance) {
    text += "; " + least_distance_for_person(least->distance, heading.separation.metric);
    if (std::isfinite(least->distance) && heading.frame_count > 1 && !frames.empty()) {
      const auto name = [&](std::size_t frame) { return frames[frame - sequence::range_of(heading).first].label; };
      text += fmt::format(" in {}{}", name(least->frame), least->step ? " -> " + name(least->frame + 1) : "");
    }
  }
  if (heading.classes) text += "; " + classes_for_person(counts);
  text += " (" + sequence::scope_of(heading, frames);
  if (heading.separation.distance > 0) text += "; " + separation_for_person(heading.separation);
  text += ")";
  for (const std::string& warning : sequence::warnings_of(heading, frames, counts)) text += "; " + warning;
  return text + "\n";
}

}  // namespace touchstone::cli
