// Replays the inputs that fuzzing once found, and its
// seeds, through the same functions that libFuzzer calls.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "seeds.hpp"
#include "support/catch.hpp"
#include "targets.hpp"

using namespace touchstone::fuzzing;
namespace fs = std::filesystem;

namespace {

const fs::path kCorpus = fs::path(TOUCHSTONE_SOURCE_DIR) / "fuzz/corpus";

void replay(const Target& target, const std::string& input) {
  target.run({reinterpret_cast<const std::uint8_t*>(input.data()), input.size()});
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("the corpus of every target is there, and replays without a finding") {
  for (const Target& target : kTargets) {
    CAPTURE(target.name);
    const auto files = files_in(kCorpus / target.name);
    CHECK(files.size() >= 3);
    for (const fs::path& file : files) {
      CAPTURE(file.string());
      std::ifstream in(file, std::ios::binary);
      REQUIRE(in);
      CHECK_NOTHROW(replay(target, {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}));
    }
  }
}

TEST_CASE("no folder of the corpus belongs to no target") {
  std::size_t folders = 0;
  for (const auto& entry : fs::directory_iterator(kCorpus)) {
    CAPTURE(entry.path().string());
    CHECK(entry.is_directory());
    CHECK(find_target(entry.path().filename().string()) != nullptr);
    ++folders;
  }
  CHECK(folders == kTargets.size());
}

TEST_CASE("the seeds of every target replay without a finding, whole and cut") {
  for (const Target& target : kTargets) {
    CAPTURE(target.name);
    const auto seeds = seeds_for(target.name);
    CHECK(seeds.size() >= 4);
    CHECK(std::set<std::string>(seeds.begin(), seeds.end()).size() > seeds.size() / 2);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      CAPTURE(i);
      CHECK_NOTHROW(replay(target, seeds[i]));
      CHECK_NOTHROW(replay(target, seeds[i].substr(0, seeds[i].size() / 2)));
      std::string changed = seeds[i];
      changed[(7 * i) % changed.size()] ^= static_cast<char>(1U << i % 8);
      CHECK_NOTHROW(replay(target, changed));
    }
  }
  CHECK(seeds_for("no such target").empty());
}
