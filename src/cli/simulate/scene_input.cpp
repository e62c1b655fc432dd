// SPDX-License-Identifier: MIT
#include "cli/simulate/scene_input.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "cli/shared/interrupt.hpp"
#include "io/input_file.hpp"
#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"

namespace touchstone::cli {
namespace {

std::string whole_file(const std::string& path) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 30;
  auto file = io::InputFile::open(path, throw_if_interrupted);
  std::string text;
  std::array<char, 1 << 16> block;
  for (std::size_t count; (count = file.read(block.data(), block.size())) > 0;) {
    text.append(block.data(), count);
    if (text.size() > kMostBytes) io::fail(path, "is larger than 1 GiB");
  }
  return text;
}

/// The result of make(text of the file).
template <class Make>
auto from_file(const std::string& path, Make make) {
  const std::string text = whole_file(path);
  return naming_file(path, [&] { return make(text); });
}

}  // namespace

sim::Scene scene_of(const SimulateOptions& options) {
  if (sim::find_shipped_scene(options.scene) != nullptr) return sim::make_shipped_scene(options.scene, options.size);
  if (options.size) throw Error("--size: only shipped scenes are made to a size, and " + options.scene + " is none");
  const bool looks_like_a_name = options.scene.find_first_of("./") == std::string::npos;
  if (looks_like_a_name && !std::filesystem::exists(options.scene)) {
    std::string names;
    for (const auto& shipped : sim::shipped_scenes()) names.append(names.empty() ? "" : ", ").append(shipped.name);
    throw Error(fmt::format("{} is no file, and no scene that comes with the program: these are {}",
                            io::in_quotes(options.scene), names));
  }
  return from_file(options.scene, sim::scene_from_json);
}

sim::Checkpoint read_checkpoint(const std::string& path) { return from_file(path, sim::checkpoint_from_json); }

}  // namespace touchstone::cli
