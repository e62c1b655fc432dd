// SPDX-License-Identifier: MIT
#include "cli/simulate/scene_input.hpp"

#include <fmt/format.h>

#include <filesystem>

#include <touchstone/error.hpp>

#include "cli/shared/nearest_name.hpp"
#include "cli/shared/whole_file.hpp"
#include "io/fail.hpp"
#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"

namespace touchstone::cli {
namespace {

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
    std::vector<std::string> all;
    for (const auto& shipped : sim::shipped_scenes()) {
      names.append(names.empty() ? "" : ", ").append(shipped.name);
      all.emplace_back(shipped.name);
    }
    throw Error(fmt::format("{} is no file, and no scene that comes with the program: these are {}{}",
                            io::in_quotes(options.scene), names, did_you_mean(options.scene, all)));
  }
  return from_file(options.scene, sim::scene_from_json);
}

sim::Checkpoint read_checkpoint(const std::string& path) { return from_file(path, sim::checkpoint_from_json); }

}  // namespace touchstone::cli
