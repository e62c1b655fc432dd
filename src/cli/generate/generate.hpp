// `touchstone generate`: query files of simulation-like candidate pairs or of curved families, and sequences of meshes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/query.hpp>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/separation_options.hpp"
#include "families/families.hpp"
#include "generators/candidates.hpp"

namespace touchstone::cli {

struct GenerateOptions {
  std::vector<generators::SceneName> scenes;  ///< empty: kScenes, or the drape with `meshes`
  std::vector<families::Family> families;     ///< of curved queries, in place of scenes; empty: all with `curved`
  bool curved = false;                        ///< curved queries of families in place of scenes
  std::optional<Kind> kind;                   ///< nothing: edge-edge and vertex-face; of families every kind
  generators::CandidateOptions candidates;    ///< but for its scene and kinds; of families the seed and the count
  SeparationOption separation;                ///< of a contact
  std::string out;                            ///< a folder, made when it is not there
  bool meshes = false;                        ///< frames in place of queries
  std::optional<std::uint64_t> crossing;  ///< with meshes: the step, from 1, in which a vertex goes through a surface
};

int run_generate(const GenerateOptions& options);
void add_generate(CLI::App& program, Command& command);

}  // namespace touchstone::cli
