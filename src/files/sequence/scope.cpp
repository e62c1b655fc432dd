// SPDX-License-Identifier: MIT
#include "sequence/scope.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "io/counted.hpp"
#include "sequence/report_json.hpp"

namespace touchstone::sequence {
namespace {

using io::counted;

/// The meshes of a run: one, or that of each frame.
struct Meshes {
  MeshFacts sum;
  std::size_t count = 0;
  std::size_t without_pairs = 0, with_points_alone = 0;  ///< of the meshes
  std::size_t points_alone = 0;                          ///< of the latter

  void add(const MeshFacts& facts) {
    ++count;
    sum.add_counts(facts);
    if (!facts.has_pairs()) {
      ++without_pairs;
    } else if (!facts.has_elements()) {
      ++with_points_alone;
      points_alone += facts.points;
    }
  }

  /// "" or " in 2 of 3 frames".
  std::string where(std::size_t some) const {
    return count == 1 ? std::string() : fmt::format(" in {} of {} frames", io::grouped(some), io::grouped(count));
  }
};

/// "1 surface, 2 wires and 3 loose points in 2 of 3 frames are wholly inside a closed surface, ..."
std::string enclosed_text(const Heading& heading, const ResultCounts& counts) {
  const EnclosedCounts& enclosed = counts.enclosed;
  std::vector<std::string> items;
  if (enclosed.surfaces > 0) items.push_back(counted(enclosed.surfaces, "surface"));
  if (enclosed.wires > 0) items.push_back(counted(enclosed.wires, "wire"));
  if (enclosed.points > 0) items.push_back(counted(enclosed.points, "loose point"));
  std::string text = items.front();
  for (std::size_t i = 1; i < items.size(); ++i) text += (i + 1 < items.size() ? ", " : " and ") + items[i];
  if (heading.question == Question::rest && counts.results > 1) {
    text += fmt::format(" in {} of {} frames", io::grouped(counts.frames_enclosing), io::grouped(counts.results));
  }
  return fmt::format(
      "{} {} wholly inside a closed surface, which is no contact (vertex {} inside the surface of face {})", text,
      enclosed.all() == 1 ? "is" : "are", enclosed.vertex.vertices[0], enclosed.face.face);
}

Meshes meshes_of(const Heading& heading, const std::vector<FrameEntry>& frames) {
  Meshes meshes;
  if (heading.facts) {
    meshes.add(*heading.facts);
    return meshes;
  }
  for (const FrameEntry& frame : frames) {
    if (frame.facts) meshes.add(*frame.facts);
  }
  return meshes;
}

}  // namespace

std::string scope_of(const Heading& heading, const std::vector<FrameEntry>& frames) {
  const Meshes meshes = meshes_of(heading, frames);
  std::string text = counted(meshes.sum.vertices, "vertex");
  if (meshes.sum.edges > 0) text += ", " + counted(meshes.sum.edges, "edge");
  if (meshes.sum.faces > 0) text += ", " + counted(meshes.sum.faces, "face");
  if (meshes.sum.points > 0) text += ", " + counted(meshes.sum.points, "loose point");
  if (meshes.count > 1) text += " in all";
  if (heading.separation.distance == 0 || meshes.sum.neighbours == 0) return text;
  return text + "; " + counted(meshes.sum.neighbours, "pair") + " with a common vertex asked about folding alone";
}

std::vector<std::string> warnings_of(const Heading& heading, const std::vector<FrameEntry>& frames,
                                     const ResultCounts& counts) {
  const Meshes meshes = meshes_of(heading, frames);
  const bool rest = heading.question == Question::rest;
  std::vector<std::string> warnings;
  if (meshes.with_points_alone > 0) {
    warnings.push_back(fmt::format("asked about {} alone{}: no file names edges or faces (for arrays: --topology)",
                                   counted(meshes.points_alone, "loose point"),
                                   meshes.where(meshes.with_points_alone)));
  }
  if (meshes.without_pairs > 0) {
    warnings.push_back(fmt::format("nothing was compared{}: there are no two elements that could meet",
                                   meshes.where(meshes.without_pairs)));
  }
  if (const std::size_t idle = meshes.sum.idle; idle > 0) {
    warnings.push_back(
        fmt::format("{} in no element {} left out", counted(idle, "vertex"), idle == 1 ? "was" : "were"));
  }
  if (heading.question == Question::steps && range_of(heading).first > 0) {
    warnings.push_back("whether the first frame of this shard intersects itself was not asked");
  }
  if (counts.enclosed.all() > 0) warnings.push_back(enclosed_text(heading, counts));
  if (const std::size_t polygons = meshes.sum.polygons; polygons > 0) {
    warnings.push_back(polygons == 1 ? std::string("whether anything is inside a closed polygon was not asked")
                                     : fmt::format("whether anything is inside one of {} closed polygons was not asked",
                                                   io::grouped(polygons)));
  }
  if (const std::size_t surfaces = meshes.sum.branching; surfaces > 0) {
    warnings.push_back(fmt::format("what is inside what is not known of {} with an edge of three faces or more",
                                   counted(surfaces, "surface")));
  }
  if (counts.in_open > 0) {
    warnings.push_back(fmt::format("{}{} in the box around an open surface, which has no inside",
                                   counted(counts.in_open, "part"), counts.in_open == 1 ? " is" : " are"));
  }
  if (const std::size_t joined = meshes.sum.joined; joined > 0) {
    warnings.push_back(
        fmt::format("whether solids touch at {} that several share was not asked: equal corners were joined",
                    counted(joined, "vertex")));
  }
  for (const std::string& text : left_out_by(heading.parts)) warnings.push_back(text);
  if (const auto& self = heading.self) {
    warnings.push_back(
        fmt::format("{} that {} within the separation and {} connected by edges of less than {} {} asked about "
                    "touching alone",
                    counted(self->pairs, "pair"), self->pairs == 1 ? "starts" : "start",
                    self->pairs == 1 ? "is" : "are", self->length, self->pairs == 1 ? "was" : "were"));
  }
  if (heading.scene && heading.scene->at_rest > 0) {
    const auto [parts, at_rest, numbered] = *heading.scene;
    std::string text = fmt::format("{} of {} {} at rest in all frames", io::grouped(at_rest), counted(parts, "part"),
                                   at_rest == 1 ? "is" : "are");
    if (numbered > 0) {
      text += fmt::format(", and the names of {} differ in numbers only: frames of one part are a pattern in quotes",
                          io::grouped(numbered));
    }
    warnings.push_back(std::move(text));
  }
  if (heading.dt) {
    warnings.push_back(
        fmt::format("the step ends at the positions and {} times the velocities, rounded to doubles", *heading.dt));
  }
  if (const std::size_t welded = meshes.sum.welded; welded > 0) {
    warnings.push_back(fmt::format("{} {} welded to others at the same positions", counted(welded, "vertex"),
                                   welded == 1 ? "was" : "were"));
  }
  if (const std::size_t dropped = meshes.sum.dropped; dropped > 0) {
    warnings.push_back(fmt::format("{} of the file {} left out: a vertex twice, or the vertices of another one",
                                   counted(dropped, "element"), dropped == 1 ? "was" : "were"));
  }
  if (const std::size_t animations = meshes.sum.animations; animations > 0) {
    warnings.push_back(
        fmt::format("{} of the file {} not read", counted(animations, "animation"), animations == 1 ? "was" : "were"));
  }
  if (const std::size_t unshown = meshes.sum.unshown; unshown > 0) {
    warnings.push_back(fmt::format("{} of the file {} in its scene, and {} not read", counted(unshown, "mesh"),
                                   unshown == 1 ? "is not" : "are not", unshown == 1 ? "was" : "were"));
  }
  if (const std::size_t moved = meshes.sum.moved; moved > 0) {
    warnings.push_back(
        fmt::format("the file moves {}, whose positions are rounded to doubles", counted(moved, "vertex")));
  }
  if (counts.flat > 0) {
    warnings.push_back(fmt::format("{}{} {} flat: that edges of one face lie on each other is no intersection",
                                   counted(counts.flat, "face"), counts.results > 1 && rest ? " of a frame" : "",
                                   counts.flat == 1 ? "is" : "are"));
  }
  if (counts.without_inside > 0) {
    const bool one = counts.without_inside == 1;
    warnings.push_back(fmt::format(
        "{} {} no solid and {} no inside: nothing is inside {}, and two of them only touch or cross (a solid has a "
        "closed "
        "surface, with its normals outwards, and nothing else; --weld joins the split vertices of a part)",
        counted(counts.without_inside, "part"), one ? "is" : "are", one ? "has" : "have", one ? "it" : "them"));
  }
  if (counts.turning > 0) {
    warnings.push_back(fmt::format("{} may be flat at a time of a step: no edges of one face are compared",
                                   counted(counts.turning, "face")));
  }
  if (const std::size_t steps = counts.from_intersecting; steps > 0) {
    warnings.push_back(fmt::format("{} {} from a frame that intersects itself", counted(steps, "free step"),
                                   steps == 1 ? "starts" : "start"));
  }
  return warnings;
}

std::string likely_cause(const Heading& heading, const ResultCounts& counts) {
  if (!heading.self && counts.own_neighbours > counts.coinciding) {
    return fmt::format(
        "{} within the separation at the start of a step {} by one edge: a surface is always so near itself; --self "
        "LENGTH asks such neighbours about touching alone, and --between-parts asks about none within a part",
        counted(counts.own_neighbours, "pair"), counts.own_neighbours == 1 ? "is connected" : "are connected");
  }
  if (counts.coinciding == 0) return {};
  const std::string of = heading.facts ? " of " + io::grouped(heading.facts->vertices) : std::string();
  return fmt::format(
      "{}{} vertices lie exactly on others: elements that meet there count as contacts; --weld joins such "
      "vertices of one part",
      io::grouped(counts.coinciding), of);
}

}  // namespace touchstone::sequence
