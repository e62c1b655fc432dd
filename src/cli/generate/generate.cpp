// SPDX-License-Identifier: MIT
#include "cli/generate/generate.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <list>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "cli/generate/frames.hpp"
#include "cli/shared/interrupt.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/query_progress.hpp"
#include "cli/shared/summary.hpp"
#include "cli/shared/words.hpp"
#include "io/output_file.hpp"
#include "io/query_writer.hpp"
#include "io/separation_text.hpp"

namespace touchstone::cli {
namespace {

using generators::Batch;
using generators::CandidateOptions;
using generators::SceneName;

/// One file that is being written.
struct Target {
  Kind kind;
  io::OutputFile file;
  std::uint64_t queries = 0;
  std::uint64_t contacts = 0;
};

/// Both kinds, the one that was asked for, or none when that one is not in the scene.
std::vector<Kind> kinds_of(SceneName scene, std::optional<Kind> asked) {
  std::vector<Kind> kinds;
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    if (kind == Kind::vertex_face && !generators::has_faces(scene)) continue;
    if (!asked || *asked == kind) kinds.push_back(kind);
  }
  return kinds;
}

void write_batch(const Batch& batch, const Separation& separation, Target& target, Counts& counts) {
  throw_if_interrupted();
  std::string text;
  for (const Query& query : batch.queries) {
    const Answer answer = solve(query, separation);
    io::append_query(text, query, answer.contact);
    target.contacts += answer.contact;
    counts.add(answer);
  }
  target.file.write(text);
  target.queries += batch.queries.size();
}

/// Writes one scene's files, uncommitted.
void write_scene(SceneName scene, const GenerateOptions& options, NewFolders& folders, std::list<Target>& targets,
                 Counts& counts, QueryProgress& progress) {
  CandidateOptions wanted = options.candidates;
  const Separation& separation = options.separation.separation;
  wanted.scene = scene;
  wanted.separation = separation.distance;
  wanted.edge_edge = wanted.vertex_face = false;
  std::array<Target*, 2> target_of{};  // by Kind
  for (const Kind kind : kinds_of(scene, options.kind)) {
    const auto folder = std::filesystem::path(options.out) / generators::scene_name(scene) / kind_name(kind);
    folders.make(folder);
    const auto file = folder / fmt::format("seed-{}.csv", wanted.seed);
    (kind == Kind::edge_edge ? wanted.edge_edge : wanted.vertex_face) = true;
    Target& target = targets.emplace_back(Target{kind, io::OutputFile(file.string())});
    if (separation.distance > 0) target.file.write(io::separation_comment(separation));
    target_of[static_cast<std::size_t>(kind)] = &target;
  }
  generators::for_each_batch(wanted, [&](const Batch& batch) {
    write_batch(batch, separation, *target_of[static_cast<std::size_t>(batch.kind)], counts);
    progress.add(0, batch.queries.size());
  });
  for (const Target* target : target_of) {
    if (target != nullptr && target->queries == 0) {
      throw InvalidQuery(fmt::format("scene {} of {} edges has no {} candidates in {}; ask for more edges or steps",
                                     generators::scene_name(scene), wanted.edges, kind_name(target->kind),
                                     counted(wanted.steps, "step")));
    }
  }
}

}  // namespace

int run_generate(const GenerateOptions& options) {
  if (options.meshes) return write_frames(options);
  std::vector<SceneName> scenes = options.scenes;
  if (scenes.empty()) scenes.assign(generators::kScenes.begin(), generators::kScenes.end());
  NewFolders folders;
  std::list<Target> targets;
  Counts counts;
  QueryProgress progress({});
  for (const SceneName scene : scenes) write_scene(scene, options, folders, targets, counts, progress);
  if (targets.empty()) {
    throw InvalidQuery(fmt::format("scene {} has no faces, so there are no {} queries in it",
                                   generators::scene_name(scenes.front()), kind_name(*options.kind)));
  }
  for (Target& target : targets) target.file.commit();
  folders.keep();

  auto console = io::OutputFile::standard_output();
  for (const Target& target : targets) {
    console.write(fmt::format("{}: {}, {} with contact\n", target.file.name(), counted(target.queries, "query"),
                              percentage(target.contacts, target.queries)));
  }
  console.write(counts_for_person(counts));
  console.commit();
  return kAllHold;
}

}  // namespace touchstone::cli
