// Replaces clock.cpp when Google Benchmark is not installed.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include "cli/bench/clock.hpp"

namespace touchstone::cli {

void require_benchmark_library() {
  throw Error(
      "bench needs Google Benchmark, which was not there when this program was built: install libbenchmark-dev "
      "(Debian, Ubuntu), google-benchmark-devel (Fedora) or benchmark (Arch) and build again");
}

std::vector<std::vector<double>> measure(const std::vector<std::function<void()>>&, int, double) {
  require_benchmark_library();
  return {};
}

}  // namespace touchstone::cli
