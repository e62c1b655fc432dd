// SPDX-License-Identifier: MIT
#include "cli/generate/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <list>

#include <touchstone/error.hpp>

#include "cli/generate/whole_folder.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/words.hpp"
#include "frames/write_obj.hpp"
#include "generators/step.hpp"
#include "io/output_file.hpp"

namespace touchstone::cli {
namespace {

using generators::SceneName;
using generators::Step;

frames::Topology topology_of(const generators::Mesh& mesh) {
  frames::Topology topology;
  topology.vertex_count = mesh.corner_count;
  topology.faces = mesh.faces;
  if (mesh.faces.empty()) topology.edges = mesh.edges;  // else they are the edges of the faces
  for (const auto& object : mesh.objects) {
    topology.face_parts.resize(object.first_face, static_cast<std::uint32_t>(topology.parts.size() - 1));
    topology.parts.push_back(object.name);
  }
  topology.face_parts.resize(mesh.faces.size(), static_cast<std::uint32_t>(topology.parts.size() - 1));
  return topology;
}

/// So many digits that the names of all frames sort by number.
std::string frame_name(std::size_t number, std::size_t steps) {
  return fmt::format("frame-{:0{}}.obj", number, std::max<std::size_t>(4, std::to_string(steps).size()));
}

void check_crossing(const std::vector<SceneName>& scenes, const GenerateOptions& options) {
  if (!options.crossing) return;
  const std::size_t steps = options.candidates.steps;
  if (scenes.size() != 1 || scenes.front() != SceneName::drape) {
    throw InvalidQuery("--crossing is for the scene drape alone: in the other scenes elements meet anyway");
  }
  if (*options.crossing >= steps) {
    throw InvalidQuery(fmt::format(
        "--crossing {}: the vertex comes back in the step after, and --steps is {}; {}", *options.crossing, steps,
        steps == 1 ? "more steps would be right" : fmt::format("a number from 1 to {} would be right", steps - 1)));
  }
}

using Progress = std::function<void(std::string_view task, double fraction)>;

/// Writes one scene's frames, uncommitted. @returns the summary for a person
std::string write_scene(SceneName scene, const GenerateOptions& options, WholeFolder& folder,
                        const Progress& progress) {
  const auto& candidates = options.candidates;
  Step step(scene, candidates.seed, candidates.edges, candidates.speed, 0, candidates.placement);
  const frames::Topology topology = topology_of(step.mesh());
  const std::size_t faces = topology.faces.size(), edges = topology.edges.size();
  std::string summary =
      fmt::format("{}: {} of {} vertices and {} {}\n", folder.name(), counted(candidates.steps + 1, "frame"),
                  grouped(topology.vertex_count), grouped(faces == 0 ? edges : faces), faces == 0 ? "edges" : "faces");
  std::string text;
  for (std::size_t number = 0; number <= candidates.steps; ++number) {
    progress(fmt::format("writing {}", generators::scene_name(scene)),
             static_cast<double>(number) / static_cast<double>(candidates.steps + 1));
    if (number > 0) step.advance();
    if (options.crossing == number) {
      const std::uint64_t vertex = std::uint64_t{step.plant_crossing().value()} + 1;
      summary += fmt::format("vertex {} goes through the sphere in step {}, which ends at {}, and back in step {}\n",
                             vertex, number, frame_name(number, candidates.steps), number + 1);
    }
    text.clear();
    frames::append_obj(text, topology, &step.end()[0].x);
    io::OutputFile file(folder.path(frame_name(number, candidates.steps)));
    file.write(text);
    file.commit();
  }
  return summary;
}

}  // namespace

int write_frames(const GenerateOptions& options) {
  std::vector<SceneName> scenes = options.scenes;
  if (scenes.empty()) scenes = {SceneName::drape};
  for (auto scene = scenes.begin(); scene != scenes.end(); ++scene) {
    if (std::find(scenes.begin(), scene, *scene) == scene) continue;
    throw InvalidQuery(fmt::format("--scene {} is given twice, and a folder holds the frames of one run",
                                   generators::scene_name(*scene)));
  }
  check_crossing(scenes, options);
  NewFolders folders;
  folders.make(options.out);
  std::list<WholeFolder> written;
  std::string summary;
  {
    ProgressLine line;
    const Progress progress = draw_fraction_on(line);
    for (const SceneName scene : scenes) {
      WholeFolder& folder = written.emplace_back(std::filesystem::path(options.out) / generators::scene_name(scene));
      summary += write_scene(scene, options, folder, progress);
    }
  }
  for (WholeFolder& folder : written) folder.commit();
  folders.keep();
  auto console = io::OutputFile::standard_output();
  console.write(summary);
  console.commit();
  return kAllHold;
}

}  // namespace touchstone::cli
