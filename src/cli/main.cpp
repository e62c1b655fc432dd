// SPDX-License-Identifier: MIT
#include <csignal>
#include <iostream>

#include "cli/program.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "io/output_file.hpp"

int main(int argc, char** argv) {
  using namespace touchstone::cli;
  occupy_closed_descriptors();
  // CGAL prints "UNLUCKY PRIME !!" on std::cout when one of its greatest common divisors takes another prime. This
  // program writes to standard output by other means, so such lines would be all that std::cout says.
  std::cout.setstate(std::ios_base::failbit);
  watch_for_signals();
  try {
    return run_program(argc, argv);
  } catch (const Interrupted&) {
    end_by_signal();
  } catch (const touchstone::io::ReaderGone&) {
    end_by_signal(SIGPIPE);  // as other programs end before `head`
  }
}
