// Ctrl-C in the middle of a long call of the library.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/mesh.hpp>

#include "cli/shared/progress/interrupt.hpp"

namespace touchstone::cli {

/// What the work returns, unless Ctrl-C stops it. @throws Interrupted
template <class Work>
auto stoppable(const Work& work) {
  try {
    return work();
  } catch (const Stopped&) {
    throw Interrupted();
  }
}

}  // namespace touchstone::cli
