// The engines that an audit can ask.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fuzz/auditing/description.hpp"

namespace touchstone::cli {

struct AuditedEngine {
  std::string name;     ///< "fcl"
  std::string command;  ///< of its program, without a question; empty: there is none
  std::string missing;  ///< why it cannot be asked; empty: it can
  std::vector<fuzz::EngineQuestion> questions;
  bool is_given = false;  ///< by --engine: then it is a fault that it cannot be asked
};

/// Those that engines.txt lists, in libexec/touchstone/engines beside the program's folder or in its build folder, and
/// then the `commands`, "NAME=COMMAND". Each is called with --describe. Those that `names` does not name are left out;
/// of those named "ENGINE/QUESTION" only that question is left.
/// @throws Error  when a command is not of this form, or a name is of no engine or question
std::vector<AuditedEngine> audited_engines(const std::vector<std::string>& names,
                                           const std::vector<std::string>& commands);

}  // namespace touchstone::cli
