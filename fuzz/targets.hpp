// The fuzz targets. libFuzzer drives them, and an ordinary test replays fuzz/corpus through them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>

namespace touchstone::fuzzing {

using Bytes = std::span<const std::uint8_t>;

/// A fault of the project; the message names it and the input.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

struct Target {
  std::string_view name;  ///< also the name of its corpus, fuzz/corpus/NAME
  std::string_view about;
  void (*run)(Bytes input);  ///< @throws Finding; any other exception is a finding, too
};

void fuzz_query(Bytes input);         // query_target.cpp
void fuzz_query_file(Bytes input);    // query_file_target.cpp
void fuzz_answers_file(Bytes input);  // answers_file_target.cpp
void fuzz_pipe_lines(Bytes input);    // pipe_lines_target.cpp
void fuzz_scene_file(Bytes input);    // scene_file_target.cpp
void fuzz_mesh_file(Bytes input);     // mesh_file_target.cpp

inline constexpr std::array<Target, 6> kTargets{{
    {"query", "the cascade against the exact level and, now and then, the oracle: every field of the answer",
     fuzz_query},
    {"query_file", "the reader of query files: the same however it is read, and what is written reads back",
     fuzz_query_file},
    {"answers_file", "the reader of answers files: the same however it is read", fuzz_answers_file},
    {"pipe_lines", "the readers of the lines that other people's programs read and write", fuzz_pipe_lines},
    {"scene_file", "the readers of scenes and checkpoints: what is written reads back", fuzz_scene_file},
    {"mesh_file", "the readers of mesh files: a mesh that is written reads back", fuzz_mesh_file},
}};

/// The target of this name, or null.
constexpr const Target* find_target(std::string_view name) noexcept {
  for (const Target& target : kTargets) {
    if (target.name == name) return &target;
  }
  return nullptr;
}

inline std::string_view as_text(Bytes input) noexcept {
  return {reinterpret_cast<const char*>(input.data()), input.size()};
}

/// A number that depends on all the bytes (FNV-1a). Rare checks use it to choose the same inputs in every run.
constexpr std::uint64_t hash_of(Bytes input) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::uint8_t byte : input) hash = (hash ^ byte) * 0x100000001b3;
  return hash ^ (hash >> 32);
}

}  // namespace touchstone::fuzzing
