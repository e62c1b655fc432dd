// SPDX-License-Identifier: MIT
#include "cli/shared/command_line/typed_command.hpp"

#include "cli/shared/words.hpp"

namespace touchstone::cli {
namespace {

std::string& typed() {
  static std::string command;
  return command;
}

}  // namespace

void remember_command(int argc, const char* const* argv) {
  typed() = "touchstone";
  for (int i = 1; i < argc; ++i) typed().append(1, ' ').append(shell_word(argv[i]));
}

const std::string& typed_command() noexcept { return typed(); }

}  // namespace touchstone::cli
