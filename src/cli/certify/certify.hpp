// `touchstone certify`: exact verdicts on claimed answers.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <touchstone/certify.hpp>

#include "certify/time_errors.hpp"
#include "cli/certify/claims.hpp"
#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/common_options.hpp"

namespace touchstone::cli {

struct CertifyOptions : QueryOptions {
  std::string claims;   ///< an answers file; empty: the truth column
  std::string columns;  ///< of the claims; empty: as their header says
  io::MissingClaim missing = io::MissingClaim::refused;
  std::string report;  ///< empty: none
  std::string proofs;  ///< the file for the proofs of the exact answers; empty: none

  certify::Counting<Verdict> counting;  ///< which wrong claims count as refuted
  bool histogram = false;               ///< of how early and late the claims are
  bool json = false;                    ///< verdicts as lines of JSON on standard output, the summary beside it
};

int run_certify(const CertifyOptions& options);
void add_certify(CLI::App& program, Command& command);

}  // namespace touchstone::cli
