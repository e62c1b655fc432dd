// SPDX-License-Identifier: MIT
#include "cli/simulate.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>

#include <touchstone/error.hpp>

#include "cli/interrupt.hpp"
#include "cli/simulate_output.hpp"
#include "cli/simulate_paths.hpp"
#include "cli/words.hpp"
#include "io/fail.hpp"
#include "io/input_file.hpp"
#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/checkpoint.hpp"
#include "sim/memory.hpp"

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

/// What `make` makes; its complaints name the file that it is made of.
template <class Make>
auto naming_file(const std::string& path, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    io::fail(path, error.what());
  }
}

template <class Make>
auto from_file(const std::string& path, Make make) {
  const std::string text = whole_file(path);
  return naming_file(path, [&] { return make(text); });
}

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

/// A line on standard error, only when that is a terminal.
class SimulateProgress {
 public:
  explicit SimulateProgress(std::uint64_t steps) : steps_(steps) {}
  ~SimulateProgress() {
    if (drawn_) print_error("\r\033[K");
  }

  void step() {
    ++done_;
    constexpr auto kPause = std::chrono::milliseconds(100);
    const auto now = Clock::now();
    if (!visible_ || now - last_ < kPause) return;
    last_ = now;
    drawn_ = true;
    constexpr std::size_t kWidth = 24;
    const auto filled = static_cast<std::size_t>(static_cast<double>(done_ * kWidth) / static_cast<double>(steps_));
    print_error(fmt::format("\r[{}{}] {} of {} steps, {:.0f} a second\033[K", std::string(filled, '#'),
                            std::string(kWidth - filled, '.'), grouped(done_), grouped(steps_), rate()));
    std::fflush(stderr);
  }

  double rate() const {
    return static_cast<double>(done_) / std::chrono::duration<double>(Clock::now() - start_).count();
  }
  std::uint64_t done() const noexcept { return done_; }

 private:
  using Clock = std::chrono::steady_clock;
  const bool visible_ = ::isatty(STDERR_FILENO) == 1;
  bool drawn_ = false;
  std::uint64_t done_ = 0, steps_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// Over all steps.
struct Totals {
  std::uint64_t parts = 0, gained = 0, first_order = 0;

  void add(const sim::SubstepRecord& record) {
    ++parts;
    gained += static_cast<std::uint64_t>(record.gained_energy);
    first_order += static_cast<std::uint64_t>(record.first_order);
  }
};

std::string outcome(const sim::Simulation& simulation, std::uint64_t steps, const Totals& totals, double rate) {
  std::string text;
  constexpr std::size_t kMostShown = 20;
  const auto& crossings = simulation.crossings();
  for (std::size_t i = 0; i < crossings.size() && i < kMostShown; ++i) {
    text += "crossing: " + sim::crossing_for_person(simulation, crossings[i]) + "\n";
  }
  if (crossings.size() > kMostShown) text += fmt::format("crossing: {} more\n", grouped(crossings.size() - kMostShown));
  const auto& refused = simulation.refused();
  if (totals.parts > steps) {
    text += fmt::format(
        "{} in {}: refused were {} that did not converge, {} without a response, {} that gained "
        "energy, {} that failed their proof\n",
        counted(steps, "step"), counted(totals.parts, "part"), refused.not_converged, refused.not_resolved,
        refused.gained_energy, refused.not_certified);
  }
  if (totals.gained > 0)
    text += fmt::format("in {} energy was gained: too short to be cut again\n", counted(totals.gained, "part"));
  if (totals.first_order > 0) {
    text +=
        fmt::format("{} of first order, by implicit-euler: the scene's integrator gained energy or did not converge\n",
                    counted(totals.first_order, "part"));
  }
  if (const auto& times = simulation.times(); times.total() > 0) {
    const auto share = [&](double seconds) { return 100 * seconds / times.total(); };
    text += fmt::format(
        "of {:.2f} s of processor time: integration {:.0f} %, solving with contacts {:.0f} %, finding and answering "
        "contacts {:.0f} %, proof {:.0f} %\n",
        times.total(), share(times.integration), share(times.contacts), share(times.response), share(times.proof));
  }
  text += fmt::format("{:.1f} steps a second\n", rate);
  return text + fmt::format("{} steps, {} crossings\n", steps, crossings.size());
}

}  // namespace

int run_simulate(const SimulateOptions& options) {
  if (options.resume.empty() == options.scene.empty()) {
    throw Error("name a scene, or a checkpoint with --resume, and not both");
  }
  if (!options.resume.empty() && options.size) throw Error("--size: a checkpoint has its size");
  check_paths(options);
  sim::give_memory_back();
  std::optional<sim::Checkpoint> checkpoint;
  if (!options.resume.empty()) checkpoint = from_file(options.resume, sim::checkpoint_from_json);
  sim::Scene scene = checkpoint ? checkpoint->scene : scene_of(options);
  if (!options.scene_out.empty()) {
    write_whole(options.scene_out, sim::scene_to_json(scene));
    return kAllHold;
  }
  std::optional<sim::Simulation> made;
  const auto make = [&] {
    made.emplace(std::move(scene), sim::SimulationOptions{options.narrow_phase, options.threads, throw_if_interrupted});
    if (checkpoint) made->resume(std::move(checkpoint->state), checkpoint->steps);
  };
  throw_if_interrupted();  // reading a large scene and setting it up take seconds each
  naming_file(options.resume.empty() ? options.scene : options.resume, make);
  throw_if_interrupted();
  sim::Simulation& simulation = *made;
  auto console = io::OutputFile::standard_output();
  if (options.explain) {
    console.write(sim::explain(simulation));
    console.commit();
    return kAllHold;
  }

  const auto& settings = simulation.scene().settings;
  const auto all = static_cast<std::uint64_t>(std::ceil(settings.duration / settings.time_step - 1e-6));
  const std::uint64_t steps = options.steps ? *options.steps : all - std::min(all, simulation.steps());
  SimulateOutput output(options, simulation);
  Totals totals;
  SimulateProgress progress(steps);
  for (std::uint64_t i = 0; i < steps; ++i) {
    try {
      const auto records = simulation.step();
      for (const auto& record : records) totals.add(record);
      output.step(records);
    } catch (...) {
      try {
        output.finish_early();
      } catch (const std::exception& error) {  // which must not hide why the run ends
        print_error(fmt::format("touchstone: what was proved is not all written: {}\n", error.what()));
      }
      throw;
    }
    progress.step();
  }
  const double rate = progress.rate();
  std::exception_ptr unwritten;  // a file, which does not change what has been proved
  try {
    output.finish();
  } catch (const Error&) {
    unwritten = std::current_exception();
  }
  console.write(outcome(simulation, steps, totals, rate));
  console.commit();
  if (unwritten) std::rethrow_exception(unwritten);
  if (const std::string hint = output.draw(); !hint.empty()) print_error(fmt::format("touchstone: {}\n", hint));
  return simulation.crossings().empty() ? kAllHold : kRefuted;
}

void add_simulate(CLI::App& program, Command& command) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("simulate", "Move particles, springs and cables that collide, and prove each step");
  std::string scenes;
  for (const auto& shipped : sim::shipped_scenes()) {
    scenes += fmt::format("  {:12} {} (--size: {}, {} to {}; {})\n", shipped.name, shipped.about, shipped.size_means,
                          shipped.least, shipped.most, shipped.usual);
  }
  subcommand->add_option("SCENE", options->scene, "A scene that comes with the program, or a JSON file")->type_name("");
  subcommand->add_option("--size", options->size, "How large a shipped scene is made")
      ->type_name("N")
      ->check(CLI::Range(std::uint32_t{1}, std::numeric_limits<std::uint32_t>::max()));
  subcommand->add_option("--steps", options->steps, "How many steps to make (default: the scene's duration)")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1'000'000'000'000}));
  subcommand
      ->add_option("--out", options->out, "A folder for frames (VTK, a series for ParaView), energies and their plot")
      ->type_name("FOLDER");
  subcommand->add_option("--frame-every", options->frame_every, "A frame each N steps (default: 2)")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}));
  subcommand->add_option("--proof", options->proof, "A table of each step's proof")->type_name("FILE");
  subcommand->add_option("--energies", options->energies, "A table of each step's energies and contacts")
      ->type_name("FILE");
  subcommand
      ->add_option(
          "--queries", options->queries,
          "Write every candidate pair of the proofs as FOLDER/KIND/candidates.csv, query files with true answers")
      ->type_name("FOLDER");
  subcommand->add_option("--checkpoint", options->checkpoint, "Where to write the state at the end")->type_name("FILE");
  subcommand->add_option("--resume", options->resume, "Go on from a checkpoint, as if the run had not stopped")
      ->type_name("FILE");
  CLI::Option* const scene_out =
      subcommand->add_option("--scene-out", options->scene_out, "Write the scene as JSON, and do no more")
          ->type_name("FILE");
  CLI::Option* const explain =
      subcommand->add_flag("--explain", options->explain, "Say which passes the scene needs and why, and do no more");
  subcommand
      ->add_option_function<std::string>(
          "--narrow-phase",
          [options](const std::string& name) {
            options->narrow_phase = name == "paper" ? sim::NarrowPhase::paper : sim::NarrowPhase::exact;
          },
          "Who finds the contacts that are answered: exact, or paper, the closed form in doubles, for edges only. The "
          "proof is exact, and with paper it reports the crossings instead of refusing the step")
      ->type_name("NAME")
      ->check(CLI::IsMember({"exact", "paper"}));
  subcommand
      ->add_option("--threads", options->threads,
                   "How many threads answer queries (default: 1); no result depends on it")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  subcommand->get_option("--frame-every")->needs(subcommand->get_option("--out"));
  for (const char* path : {"--out", "--proof", "--energies", "--queries", "--checkpoint", "--resume", "--scene-out"}) {
    subcommand->get_option(path)->check(
        [](const std::string& name) { return name.empty() ? std::string("the name is empty") : std::string(); });
  }
  // What these would leave undone is not asked for.
  scene_out->excludes(explain);
  for (const char* of_run : {"--steps", "--out", "--proof", "--energies", "--queries", "--checkpoint"}) {
    scene_out->excludes(subcommand->get_option(of_run));
    explain->excludes(subcommand->get_option(of_run));
  }
  subcommand->footer(
      "Scenes\n" + scenes +
      "\nUnits are SI. A step that would let two elements touch is not taken: its response is tried again "
      "in shorter\nparts. The last line is `N steps, 0 crossings`.\n\n"
      "Examples\n"
      "  touchstone simulate hoop --out hoop\n"
      "  touchstone simulate cable-drop --size 5000 --proof proof.csv\n"
      "  touchstone simulate hoop --scene-out hoop.json && touchstone simulate hoop.json\n"
      "  touchstone simulate hoop --narrow-phase paper\n\n"
      "Exit status: 0 done without a crossing, 1 crossings, 2 bad usage, a bad scene or a step that "
      "cannot be taken.");
  subcommand->callback([options, &command] { command = [options] { return run_simulate(*options); }; });
}

}  // namespace touchstone::cli
