// A scene does not pay for a feature that it lacks. Valgrind counts
// the instructions of its steps, also in a build without the feature.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "support/catch.hpp"
#include "support/skip.hpp"

namespace {

struct Counted {
  std::uint64_t instructions = 0;
  std::string out;
};

/// Instructions within Simulation::step of one run of `program`.
Counted count(const std::string& program, const std::string& arguments) {
  const std::string command =
      "valgrind --tool=callgrind --callgrind-out-file=/dev/null "
      "'--toggle-collect=touchstone::sim::Simulation::step()' " TOUCHSTONE_COST_FOLDER "/cost_" +
      program + " " + arguments + " 2>&1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  REQUIRE(pipe != nullptr);
  Counted counted;
  char line[512];
  while (std::fgets(line, sizeof line, pipe.get()) != nullptr) counted.out += line;
  CAPTURE(command, counted.out);
  const std::string word = "Collected : ";
  const auto at = counted.out.find(word);
  REQUIRE(at != std::string::npos);
  counted.instructions = std::stoull(counted.out.substr(at + word.size()));
  REQUIRE(counted.instructions > 1'000'000);
  const auto end = counted.out.find(" contacts, ");
  REQUIRE(end != std::string::npos);
  // The steps must meet contacts, or they say nothing of the passes that answer them.
  const auto begin = counted.out.rfind('\n', end) + 1;
  CHECK(std::stoull(counted.out.substr(begin)) > 0);
  return counted;
}

double ratio(const Counted& a, const Counted& b) {
  return static_cast<double>(a.instructions) / static_cast<double>(b.instructions);
}

}  // namespace

TEST_CASE_WITH("valgrind",
               "a scene without cloth, faces, shared particles, friction, cables, radii or bodies pays under 1 %") {
  for (const std::string feature : {"cloth", "faces", "folds", "friction", "rods", "separations", "bodies"}) {
    const Counted whole = count("whole", feature), without = count("without_" + feature, feature);
    CAPTURE(feature, whole.instructions, without.instructions);
    CHECK(ratio(whole, without) < 1.01);
    CHECK(ratio(whole, without) > 0.99);

    // The comparison can see the feature: where a scene has it, the build that does not know it does other work.
    const Counted with = count("whole", feature + " with"), ignored = count("without_" + feature, feature + " with");
    CAPTURE(with.instructions, ignored.instructions);
    CHECK(std::abs(ratio(with, ignored) - 1) > 2 * std::abs(ratio(whole, without) - 1));
  }
}
