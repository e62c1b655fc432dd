// SPDX-License-Identifier: MIT
#include "cli/generate/generate.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <list>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "cli/generate/frames.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/query_progress.hpp"
#include "cli/shared/progress/summary.hpp"
#include "cli/shared/words.hpp"
#include "io/output_file.hpp"
#include "io/queries/curved_rows.hpp"
#include "io/queries/query_writer.hpp"
#include "io/queries/separation_text.hpp"

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

/// The file FOLDER/SOURCE/KIND/seed-S.csv.
Target& open_target(const GenerateOptions& options, std::string_view source, Kind kind, NewFolders& folders,
                    std::list<Target>& targets) {
  const auto folder = std::filesystem::path(options.out) / source / name_of(kind);
  folders.make(folder);
  const auto file = folder / fmt::format("seed-{}.csv", options.candidates.seed);
  Target& target = targets.emplace_back(Target{kind, io::OutputFile(file.string())});
  const Separation& separation = options.separation.separation;
  if (separation.distance > 0) target.file.write(io::separation_comment(separation));
  return target;
}

template <class AnyQuery>
void write_queries(const std::vector<AnyQuery>& queries, const Separation& separation, Target& target, Counts& counts) {
  throw_if_interrupted();
  std::string text;
  for (const AnyQuery& query : queries) {
    const Answer answer = solve(query, {.separation = separation});
    io::append_query(text, query, answer.contact);
    target.contacts += answer.contact;
    counts.add(answer);
  }
  target.file.write(text);
  target.queries += queries.size();
}

/// Writes the files of one family of curved queries, uncommitted.
void write_family(families::Family family, const GenerateOptions& options, NewFolders& folders,
                  std::list<Target>& targets, Counts& counts, QueryProgress& progress) {
  constexpr std::uint64_t kBlock = 256;
  for (const Kind kind : kKinds) {
    if (options.kind && *options.kind != kind) continue;
    Target& target = open_target(options, families::info(family).name, kind, folders, targets);
    target.file.write(std::string(io::kCurvedHeader) + "\n");
    std::vector<CurvedQuery> block;
    const std::uint64_t count = options.candidates.count;
    for (std::uint64_t index = 0; index < count; ++index) {
      block.push_back(families::make_curved({family, kind, options.candidates.seed, index}).query);
      if (block.size() < kBlock && index + 1 < count) continue;
      write_queries(block, options.separation.separation, target, counts);
      progress.add(0, block.size());
      block.clear();
    }
  }
}

/// Writes one scene's files, uncommitted.
void write_scene(SceneName scene, const GenerateOptions& options, NewFolders& folders, std::list<Target>& targets,
                 Counts& counts, QueryProgress& progress) {
  CandidateOptions candidates = options.candidates;
  const Separation& separation = options.separation.separation;
  candidates.scene = scene;
  candidates.separation = separation.distance;
  candidates.edge_edge = candidates.vertex_face = false;
  std::array<Target*, 2> target_of{};  // by Kind
  for (const Kind kind : kinds_of(scene, options.kind)) {
    (kind == Kind::edge_edge ? candidates.edge_edge : candidates.vertex_face) = true;
    target_of[static_cast<std::size_t>(kind)] =
        &open_target(options, generators::scene_name(scene), kind, folders, targets);
  }
  generators::for_each_batch(candidates, [&](const Batch& batch) {
    write_queries(batch.queries, separation, *target_of[static_cast<std::size_t>(batch.kind)], counts);
    progress.add(0, batch.queries.size());
  });
  for (const Target* target : target_of) {
    if (target != nullptr && target->queries == 0) {
      throw InvalidQuery(fmt::format("scene {} of {} edges has no {} candidates in {}; ask for more edges or steps",
                                     generators::scene_name(scene), candidates.edges, name_of(target->kind),
                                     counted(candidates.steps, "step")));
    }
  }
}

bool of_families(const GenerateOptions& options) { return options.curved || !options.families.empty(); }

std::vector<SceneName> selected_scenes(const GenerateOptions& options) {
  if (of_families(options)) return {};
  if (options.kind == Kind::point_edge || options.kind == Kind::point_point) {
    throw InvalidQuery(
        fmt::format("--kind {}: the scenes have edge-edge and vertex-face queries; with --curved there "
                    "are queries of every kind",
                    name_of(*options.kind)));
  }
  if (!options.scenes.empty()) return options.scenes;
  return {generators::kScenes.begin(), generators::kScenes.end()};
}

std::vector<families::Family> selected_families(const GenerateOptions& options) {
  if (of_families(options) && options.candidates.count == 0) {
    throw InvalidQuery("--count 0: a family has queries without end; a number from 1 would be right");
  }
  if (!options.curved) return options.families;
  std::vector<families::Family> all;
  for (const families::FamilyInfo& family : families::curved_families()) all.push_back(family.family);
  return all;
}

}  // namespace

int run_generate(const GenerateOptions& options) {
  if (options.meshes) return write_frames(options);
  NewFolders folders;
  std::list<Target> targets;
  Counts counts;
  QueryProgress progress({});
  const std::vector<SceneName> scenes = selected_scenes(options);
  for (const SceneName scene : scenes) write_scene(scene, options, folders, targets, counts, progress);
  for (const families::Family family : selected_families(options)) {
    write_family(family, options, folders, targets, counts, progress);
  }
  if (targets.empty()) {
    throw InvalidQuery(fmt::format("scene {} has no faces, so there are no {} queries in it",
                                   generators::scene_name(scenes.front()), name_of(*options.kind)));
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
