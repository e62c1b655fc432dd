// SPDX-License-Identifier: MIT
#include "cli/program.hpp"
#include "cli/shared/interrupt.hpp"

int main(int argc, char** argv) {
  using namespace touchstone::cli;
  occupy_closed_descriptors();
  watch_for_signals();
  try {
    return run_program(argc, argv);
  } catch (const Interrupted&) {
    end_by_signal();
  }
}
