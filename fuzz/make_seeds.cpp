// make_seeds FOLDER: writes FOLDER/TARGET/seed-N for every target.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "seeds.hpp"
#include "targets.hpp"

namespace {

void write_seeds(const std::filesystem::path& root) {
  for (const auto& target : touchstone::fuzzing::kTargets) {
    const auto folder = root / target.name;
    std::filesystem::create_directories(folder);
    const auto seeds = touchstone::fuzzing::seeds_for(target.name);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      const auto path = folder / ("seed-" + std::to_string(i));
      std::ofstream file(path, std::ios::binary);
      file << seeds[i];
      if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
    }
    std::printf("%s: %zu seeds\n", folder.c_str(), seeds.size());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_seeds FOLDER\n", stderr);
    return 2;
  }
  try {
    write_seeds(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_seeds: %s\n", error.what());
    return 2;
  }
  return 0;
}
