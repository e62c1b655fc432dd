// SPDX-License-Identifier: MIT
#include "cli/generate.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <list>
#include <memory>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "cli/shared/interrupt.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/options.hpp"
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

namespace {

template <class Number>
void add_number(CLI::App& subcommand, const std::string& name, Number& value, std::uint64_t least,
                std::uint64_t greatest, const std::string& about) {
  subcommand.add_option(name, value, fmt::format("{} (default: {})", about, value))
      ->type_name("N")
      ->check([least, greatest](const std::string& text) { return check_whole_number(text, least, greatest); });
}

void add_scene_option(CLI::App& subcommand, GenerateOptions& options) {
  subcommand
      .add_option_function<std::vector<std::string>>(
          "--scene",
          [&options](const std::vector<std::string>& names) {
            for (const auto& name : names) options.scenes.push_back(*generators::scene_from_name(name));
          },
          "The moving scene: cloth, draped over a deforming sphere; sheets, two crumpled ones that slide along each "
          "other; "
          "cables, two bundles that whip across each other (default: all three; may be given more than once)")
      ->type_name("NAME")
      ->check([](const std::string& name) {
        return generators::scene_from_name(name) ? std::string()
                                                 : name + " is no scene; it must be cloth, sheets or cables";
      });
}

void add_kind(CLI::App& subcommand, GenerateOptions& options) {
  subcommand
      .add_option_function<std::string>(
          "--kind",
          [&options](const std::string& name) {
            options.kind = name == kind_name(Kind::edge_edge) ? Kind::edge_edge : Kind::vertex_face;
          },
          "Only these queries: edge-edge or vertex-face (default: both)")
      ->type_name("KIND")
      ->check(CLI::IsMember({"edge-edge", "vertex-face"}));
}

}  // namespace

void add_generate(CLI::App& program, Command& command) {
  constexpr std::uint64_t kAnyNumber = 1'000'000'000'000;
  const auto options = std::make_shared<GenerateOptions>();
  auto& candidates = options->candidates;
  candidates.count = 10'000;
  CLI::App* const subcommand =
      program.add_subcommand("generate", "Make query files like a simulation's, with true answers");
  add_scene_option(*subcommand, *options);
  add_kind(*subcommand, *options);
  add_number(*subcommand, "--count", candidates.count, 0, kAnyNumber,
             "The most queries of a file, drawn evenly from all steps; 0: every candidate");
  add_number(*subcommand, "--seed", candidates.seed, 0, kAnyNumber, "The seed of the scene's form and motion");
  add_number(*subcommand, "--size", candidates.edges, generators::kFewestEdges, generators::kMostEdges,
             "The approximate number of edges of a scene; surfaces have two faces for three edges");
  add_number(*subcommand, "--steps", candidates.steps, 1, 1'000'000, "The number of steps");
  subcommand
      ->add_option("--speed", candidates.speed,
                   "The speed: at 1 most corners move by a tenth of an edge's length in a step (default: 1)")
      ->type_name("X")
      ->check(CLI::Range(0.0, generators::kGreatestSpeed));
  add_separation_options(*subcommand, options->separation, "The distance at which two elements are in contact");
  subcommand->add_flag("--shared-corners", candidates.shared_corners,
                       "Include pairs that share a corner, where they touch all the time");
  subcommand->add_option("--out", options->out, "The folder for the query files; it is made when it is missing")
      ->required()
      ->type_name("FOLDER");
  subcommand->footer(
      "Writes FOLDER/SCENE/KIND/seed-S.csv. Smooth formulas, rounded to doubles, give a scene's corners at the ends "
      "of\n"
      "its steps; between them the corners move on straight lines. Candidates are the pairs whose boxes around the "
      "whole\n"
      "step overlap, as a simulator's broad phase finds them; about one in a hundred has contact. The truth column is "
      "the\n"
      "exact answer. The same options write the same bytes on every machine. The files appear when all of them are\n"
      "complete. After an error there are none. With --separation D the boxes are grown so that every pair that comes\n"
      "within D is a candidate, the truth column is about D, and a file's first line says so.\n\n"
      "Examples\n"
      "  touchstone generate --out queries && touchstone certify queries/*/*/*.csv\n"
      "  touchstone generate --separation 1e-3 --out near && touchstone certify near/*/*/*.csv\n"
      "  touchstone generate --scene cables --size 20000 --steps 1000 --count 1000000 --out big\n\n"
      "Exit status: 0 done, 2 bad usage or a file that cannot be written.");
  subcommand->callback([options, &command] { command = [options] { return run_generate(*options); }; });
}

}  // namespace touchstone::cli
