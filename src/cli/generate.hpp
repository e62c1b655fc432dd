// `touchstone generate`: query files of simulation-like candidate pairs.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <touchstone/query.hpp>

#include "cli/shared/command.hpp"
#include "cli/shared/separation.hpp"
#include "generators/candidates.hpp"

namespace touchstone::cli {

struct GenerateOptions {
  std::vector<generators::SceneName> scenes;  ///< empty: all of them
  std::optional<Kind> kind;                   ///< nothing: edge-edge and vertex-face
  generators::CandidateOptions candidates;    ///< but for its scene and kinds
  SeparationOption separation;                ///< of a contact
  std::string out;                            ///< a folder, made when it is not there
};

int run_generate(const GenerateOptions& options);
void add_generate(CLI::App& program, Command& command);

}  // namespace touchstone::cli
