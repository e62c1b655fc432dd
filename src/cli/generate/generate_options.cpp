// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/generate/generate.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/kind_check.hpp"
#include "cli/shared/command_line/number_options.hpp"
#include "geometry/kind_aliases.hpp"
#include "io/queries/kind_of_file.hpp"

namespace touchstone::cli {
namespace {

constexpr std::uint64_t kMostSteps = 1'000'000;

template <class Number>
void add_count(CLI::App& subcommand, const std::string& name, Number& value, std::uint64_t least,
               std::uint64_t greatest, const std::string& about) {
  add_whole_number(subcommand, name, value, fmt::format("{} (default: {})", about, value), least, greatest);
}

void add_scene_option(CLI::App& subcommand, GenerateOptions& options) {
  subcommand
      .add_option_function<std::vector<std::string>>(
          "--scene",
          [&options](const std::vector<std::string>& names) {
            for (const auto& name : names) options.scenes.push_back(*generators::scene_from_name(name));
          },
          "The moving scene: cloth, draped over a deforming sphere; sheets, two crumpled ones that slide along each "
          "other; cables, two bundles that whip across each other; drape, a cloth that waves above a deforming sphere "
          "and meets nothing; or, along the axes: boxes, layers of cubes that slide on each other; bricks, a wall at "
          "rest; plane, cables that bend within one plane; grid, a plate that slides over another one in its plane; "
          "lying, a cloth on a box, at rest (default: cloth, sheets and cables; with --meshes: drape; may be given "
          "more than once)")
      ->type_name("NAME")
      ->check([](const std::string& name) {
        return generators::scene_from_name(name) ? std::string()
                                                 : name +
                                                       " is no scene; it must be cloth, sheets, cables, drape, "
                                                       "boxes, bricks, plane, grid or lying";
      });
  subcommand
      .add_option_function<std::string>(
          "--placed",
          [&options](const std::string& name) {
            options.candidates.placement = *generators::placement_from_name(name);
          },
          "How the whole scene is placed, with the noise of people's files: below (default: as-built)")
      ->type_name("WAY")
      ->check([](const std::string& name) {
        if (generators::placement_from_name(name)) return std::string();
        std::string known;
        for (const auto placement : generators::kAllPlacements) known += " " + std::string(placement_name(placement));
        return name + " is no placement; it must be one of" + known;
      });
}

/// --meshes and --crossing. Options that are about queries are refused beside them.
void add_mesh_options(CLI::App& subcommand, GenerateOptions& options) {
  CLI::Option* const meshes = subcommand.add_flag(
      "--meshes", options.meshes,
      "Write the scene as a sequence of OBJ files in place of queries: FOLDER/SCENE/frame-0000.obj, frame-0001.obj and "
      "so on, one more than there are steps");
  for (const char* of_queries : {"--kind", "--count", "--separation", "--metric", "--shared-corners"}) {
    meshes->excludes(subcommand.get_option(of_queries));
  }
  add_whole_number(
      subcommand, "--crossing", options.crossing,
      "With --meshes and the scene drape: one vertex of the cloth goes through the sphere in step N, which "
      "ends at frame N, and comes back in the step after. No other step has a contact",
      1, kMostSteps)
      ->needs(meshes);
}

void add_kind(CLI::App& subcommand, GenerateOptions& options) {
  subcommand
      .add_option_function<std::string>(
          "--kind", [&options](const std::string& name) { options.kind = geometry::kind_named(name); },
          "Only these queries: edge-edge or vertex-face; of curved families also point-edge or point-point (default: "
          "all)")
      ->type_name("KIND")
      ->check(kind_check());
}

/// --curved and --family. Options that are about scenes are refused beside them.
void add_family_options(CLI::App& subcommand, GenerateOptions& options) {
  constexpr std::uint64_t kUsualCount = 100;
  const auto of_families = [&subcommand, &options] {
    if (subcommand.count("--count") == 0) options.candidates.count = kUsualCount;
  };
  CLI::Option* const curved = subcommand.add_flag_callback(
      "--curved",
      [&options, of_families] {
        options.curved = true;
        of_families();
      },
      "Queries of all curved families of touchstone fuzz in place of scenes: FOLDER/FAMILY/KIND/seed-S.csv, --count of "
      "them each (default: 100)");
  CLI::Option* const family = subcommand
                                  .add_option_function<std::vector<std::string>>(
                                      "--family",
                                      [&options, of_families](const std::vector<std::string>& names) {
                                        for (const auto& name : names) {
                                          const families::Family named = families::find_family(name)->family;
                                          auto& chosen = options.families;
                                          if (std::find(chosen.begin(), chosen.end(), named) == chosen.end()) {
                                            chosen.push_back(named);
                                          }
                                        }
                                        of_families();
                                      },
                                      "Queries of this curved family alone; may be given more than once")
                                  ->type_name("FAMILY")
                                  ->check([](const std::string& name) {
                                    const families::FamilyInfo* const found = families::find_family(name);
                                    return found != nullptr && found->group == families::Group::curved
                                               ? std::string()
                                               : name + " is no curved family; touchstone fuzz --help lists them";
                                  });
  curved->excludes(family);
  for (CLI::Option* const option : {curved, family}) {
    for (const char* of_scenes :
         {"--scene", "--placed", "--size", "--steps", "--speed", "--shared-corners", "--meshes"}) {
      option->excludes(subcommand.get_option(of_scenes));
    }
  }
}

}  // namespace

void add_generate(CLI::App& program, Command& command) {
  constexpr std::uint64_t kAnyNumber = 1'000'000'000'000;
  const auto options = std::make_shared<GenerateOptions>();
  auto& candidates = options->candidates;
  candidates.count = 10'000;
  CLI::App* const subcommand = program.add_subcommand(
      "generate", "Make query files like a simulation's, with true answers; or frames of meshes");
  add_scene_option(*subcommand, *options);
  add_kind(*subcommand, *options);
  add_count(*subcommand, "--count", candidates.count, 0, kAnyNumber,
            "The most queries of a file, drawn evenly from all steps; 0: every candidate");
  add_count(*subcommand, "--seed", candidates.seed, 0, kAnyNumber, "The seed of the scene's form and motion");
  add_count(*subcommand, "--size", candidates.edges, generators::kFewestEdges, generators::kMostEdges,
            "The approximate number of edges of a scene; surfaces have two faces for three edges");
  add_count(*subcommand, "--steps", candidates.steps, 1, kMostSteps, "The number of steps");
  subcommand
      ->add_option(
          "--speed", candidates.speed,
          "The speed: at 1 most corners move by a tenth of an edge's length in a step; from 0 to 1000 (default: 1)")
      ->type_name("X")
      ->check(check_range("from 0 to 1000", [](double x) { return x >= 0 && x <= generators::kGreatestSpeed; }));
  add_separation_options(*subcommand, options->separation, "The distance at which two elements are in contact");
  subcommand->add_flag("--shared-corners", candidates.shared_corners,
                       "Include pairs that share a corner, where they touch all the time");
  subcommand->add_option("--out", options->out, "The folder for the files; it is made when it is missing")
      ->required()
      ->type_name("FOLDER");
  add_mesh_options(*subcommand, *options);
  add_family_options(*subcommand, *options);
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
      "WAY is as-built; turned, by a rotation that depends on the seed; turned-90 or turned-45, about the z axis and\n"
      "then about the x axis, in doubles; float32, moved by about a hundred and rounded to float32; moved, rounded to\n"
      "float32 and then moved by about a thousand in doubles; or far-corners, one corner in seventeen a thousand "
      "times\n"
      "as far away.\n\n"
      "With --meshes, FOLDER/SCENE is a new folder of frames. It appears when the frames are complete. In cloth, "
      "sheets\n"
      "and cables, elements pass through each other. A drape is free of contact between all frames, at every speed.\n\n"
      "Examples\n"
      "  touchstone generate --out queries && touchstone certify queries/*/*/*.csv\n"
      "  touchstone generate --separation 1e-3 --out near && touchstone certify near/*/*/*.csv\n"
      "  touchstone generate --curved --out curved && touchstone certify curved/*/*/*.csv\n"
      "  touchstone generate --scene cables --size 20000 --steps 1000 --count 1000000 --out big\n"
      "  touchstone generate --meshes --steps 100 --out frames\n"
      "  touchstone generate --meshes --steps 100 --crossing 42 --out crossed\n\n"
      "Exit status: 0 done, 2 bad usage or a file that cannot be written.");
  subcommand->callback([options, &command] { command = [options] { return run_generate(*options); }; });
}

}  // namespace touchstone::cli
