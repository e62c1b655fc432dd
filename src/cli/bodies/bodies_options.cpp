// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <bit>
#include <memory>

#include "cli/bodies/bodies.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/mesh_file_options.hpp"
#include "cli/shared/command_line/output_names.hpp"

namespace touchstone::cli {
namespace {

constexpr int kMostArcs = 1 << 20;  // of BodyScrewOptions

std::string check_arcs(const std::string& text) {
  const std::string reason = check_whole_number(text, kSlerpArcs, kMostArcs);
  if (!reason.empty()) return reason;
  return std::has_single_bit(std::stoul(text)) ? std::string() : text + " must be a power of two, such as 1024";
}

}  // namespace

void add_bodies(CLI::App& program, Command& command) {
  const auto options = std::make_shared<BodiesRunOptions>();
  CLI::App* const subcommand = program.add_subcommand(
      "bodies", "Check rigid bodies that move and turn: is each step between their recorded poses free of contact?");
  subcommand
      ->add_option("FILE", options->files,
                   "Mesh files, each a body in its own frame and named by its file without the ending, or by the whole "
                   "argument where two of these names are one. NAME=FILE gives it another name: two bodies may have "
                   "one file, such as left=box.obj right=box.obj")
      ->required()
      ->type_name("");
  subcommand
      ->add_option(
          "--poses", options->poses,
          "The table (CSV) of the bodies' poses: its first line names the columns time, body, x, y, z, qw, qx, "
          "qy and qz, in any order. - is standard input. A body without poses rests in its own frame")
      ->type_name("FILE")
      ->required()
      ->check(not_empty);
  subcommand
      ->add_option_function<std::string>(
          "--quaternion",
          [options](const std::string& name) {
            options->order = name == "wxyz" ? QuaternionOrder::wxyz : QuaternionOrder::xyzw;
          },
          "The order of a quaternion in a table whose columns have no names: time, body, x, y, z and these")
      ->type_name("ORDER")
      ->check(CLI::IsMember({"wxyz", "xyzw"}));
  subcommand->add_flag_callback(
      "--as-given", [options] { options->turn = Turn::as_given; },
      "Take the turn that the signs of two quaternions say, which is the longer one where q0 . q1 < 0 (default: the "
      "shorter one, because q and -q are the same orientation)");
  CLI::Option* const slerp =
      subcommand->add_flag("--slerp", options->slerp,
                           "Read each turn as one at a constant rate, as slerp has it. No such motion is a polynomial: "
                           "a step is proved free, or proved to have a contact in a range of times, or is left open "
                           "where elements come so near that a bound does not tell");
  subcommand
      ->add_option("--arcs", options->slerp_arcs,
                   "With --slerp: the most arcs that a step is cut into where fewer leave it open, a power of two from "
                   "64 to 1048576. Each doubling makes the bound eight times as narrow")
      ->type_name("N")
      ->capture_default_str()
      ->needs(slerp)
      ->check(check_arcs);
  add_separation_options(*subcommand, options->separation, "The distance at which two bodies are in contact");
  const auto check_metric = add_clearance_option(
      *subcommand, options->clearance,
      "Find the least distance of two bodies in each of the recorded poses, too: rounded up to a double, between the "
      "elements as they are");
  add_pair_options(*subcommand, options->rules,
                   "Ask about these two bodies against each other, and about no other pair: their names, or "
                   "patterns with * ? [. It may be given several times",
                   "Do not ask about these two bodies");
  subcommand->add_flag_callback(
      "--no-start", [options] { options->check_start = false; },
      "Do not ask whether bodies intersect at the start of the first step");
  add_repair_options(*subcommand, options->repairs, options->triangulate,
                     "Elements name the first of a body's vertices at exactly one position in place of the others: for "
                     "meshes with a vertex for each face");
  add_threads_option(*subcommand, options->threads, "; no result depends on it");
  subcommand->add_flag("--json", options->json,
                       "Write a JSON object a line for each step to standard output, with decimals, and the verdict to "
                       "standard error");
  subcommand
      ->add_option(
          "--free-step", options->free_step,
          "Write a table (CSV) of the poses at which each step may end, free of contact: proved for these very "
          "poses. A row a body and step")
      ->type_name("FILE")
      ->check(named_as(Output::csv))
      ->excludes(slerp);
  add_animation_option(*subcommand, options->html, "the first contacts and the bodies that intersect");
  subcommand->get_option("--html")->excludes(slerp);
  subcommand
      ->add_option("--prove", options->prove,
                   "Write the bodies and their poses as FOLDER/motion.txt and a proof for each pair of each step as "
                   "FOLDER/proofs.txt, for touchstone-check. The folder must be new or empty")
      ->type_name("FOLDER")
      ->check(not_empty)
      ->excludes(slerp);
  subcommand->footer(
      "Between two poses a quaternion is (1 - t) q0 + t q1 and a position (1 - t) p0 + t p1, t in [0, 1]: the body "
      "turns\n"
      "about one axis, at a nearly constant rate, and both poses are exact. The contacts of this motion are exact:\n"
      "nothing is sampled. Elements of one body are never compared. --slerp has another motion.\n\n"
      "Examples\n"
      "  touchstone bodies box.obj wall.stl --poses poses.csv\n"
      "  touchstone bodies arm/*.stl table.obj --poses log.csv --ignore 'link1,link2' --separation 1e-3\n"
      "  touchstone bodies box.obj wall.obj --poses poses.csv --json > steps.jsonl\n"
      "  touchstone bodies box.obj wall.obj --poses poses.csv --prove proved && touchstone-check proved/proofs.txt "
      "proved/motion.txt\n\n"
      "Exit status: 0 every step is free and the bodies do not intersect at the start, 1 otherwise (a step that "
      "--slerp\n"
      "leaves open, too), 2 bad usage or bad input.");
  subcommand->callback([=, &command] {
    check_metric();
    command = [options] { return run_bodies(*options); };
  });
}

}  // namespace touchstone::cli
