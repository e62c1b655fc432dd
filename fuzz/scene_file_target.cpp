// The readers of scenes and checkpoints, which are JSON. Any bytes are a scene or an error of one line. A scene that is
// written reads back as the same text.
// SPDX-License-Identifier: MIT
#include <string>

#include <touchstone/error.hpp>

#include "io/sealed_json.hpp"
#include "scene/scene_file.hpp"
#include "sim/checkpoint.hpp"
#include "targets.hpp"

namespace touchstone::fuzzing {
namespace {

/// A few bytes can ask for long lists of elements, which show no more than short ones.
constexpr std::size_t kMostParticles = 20'000;

void check_error(const Error& error) {
  const std::string what = error.what();
  if (what.empty() || what.find('\n') != std::string::npos) throw Finding("the error is not one line: " + what);
}

/// The text of an object after its opening brace, or after the line of a digest.
std::string body_of(std::string_view text) {
  const bool sealed = text.starts_with("{\"sha256\"") && text.find('\n') != std::string_view::npos;
  if (sealed) return std::string(text.substr(text.find('\n') + 1));
  return std::string(text.starts_with('{') ? text.substr(1) : text);
}

void check_written(const sim::Scene& scene) {
  if (scene.particles.size() > kMostParticles) return;
  const std::string text = sim::scene_to_json(scene);
  std::string again;
  try {
    again = sim::scene_to_json(sim::scene_from_json(text));
  } catch (const Error& error) {
    throw Finding("what was written does not read back: " + std::string(error.what()) + "\n" + text);
  }
  if (again != text) throw Finding("read back it is another scene:\n" + text + "\nand\n" + again);
}

}  // namespace

void fuzz_scene_file(Bytes input) {
  const std::string_view text = as_text(input);
  try {
    check_written(sim::scene_from_json(text));
  } catch (const Error& error) {
    check_error(error);
  }
  try {
    sim::checkpoint_from_json(text);
    if (!io::seal_holds(text)) throw Finding("a checkpoint is accepted whose digest does not match");
  } catch (const Error& error) {
    check_error(error);
  }
  try {
    // Chance finds no digest: without one that matches, nothing behind it would be tried.
    check_written(sim::checkpoint_from_json(io::sealed_json(std::string("{").append(body_of(text)))).scene);
  } catch (const Error& error) {
    check_error(error);
  }
}

}  // namespace touchstone::fuzzing
