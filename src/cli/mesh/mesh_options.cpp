// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "cli/mesh/mesh.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/mesh_file_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::cli {
namespace {

/// "2/4" as a shard; nothing for other texts.
std::optional<sequence::Shard> shard_from(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const std::string number = text.substr(0, slash), count = text.substr(slash + 1);
  if (!check_whole_number(count, 1).empty()) return std::nullopt;
  if (!check_whole_number(number, 1, std::stoull(count)).empty()) return std::nullopt;
  return sequence::Shard{std::stoull(number), std::stoull(count)};
}

/// A decimal or a hexfloat, or one over another: 1/60 is the double that is nearest to it.
/// @returns nothing, and the fault, for other texts
std::optional<double> time_step_from(const std::string& text, std::string& fault) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) {
    const auto value = io::parse_finite_double(text);
    if (!value) fault = text + fault_of_number(text) + "; right is, for example, 0.01 or 1/60";
    return value;
  }
  // The quotient of two doubles is rounded once.
  const std::string number = text.substr(0, slash), by = text.substr(slash + 1);
  for (const std::string& each : {number, by}) {
    if (numbers::is_exactly_a_double(each)) continue;
    fault = text + " has " + io::in_quotes(each) + ", which is no double; a fraction has whole numbers, such as 1/60";
    return std::nullopt;
  }
  const double quotient = *io::parse_finite_double(number) / *io::parse_finite_double(by);
  if (std::isfinite(quotient)) return quotient;
  fault = text + " is no finite number";
  return std::nullopt;
}

}  // namespace

void add_mesh(CLI::App& program, Command& command) {
  const auto options = std::make_shared<MeshRunOptions>();
  CLI::App* const subcommand =
      program.add_subcommand("mesh", "Check an animation: is each step between its frames free of contact?");
  subcommand
      ->add_option(
          "FRAME", options->files,
          "Mesh files, one a frame, or files with several frames. A folder stands for the mesh files in it, and a "
          "pattern in quotes is expanded")
      ->required()
      ->type_name("");
  CLI::Option* const check = subcommand->add_flag(
      "--check", options->check, "Ask about each frame at rest: does the mesh intersect itself? Steps are not checked");
  subcommand->add_flag("--in-order", options->in_order,
                       "The files are the frames of one animation in the order given, whatever their names are. With "
                       "--check, each file is a frame by itself, and their elements may differ");
  subcommand
      ->add_flag("--parts", options->as_parts,
                 "The arguments are the parts of one scene: a file is at rest, unless it holds several frames, and a "
                 "folder or a pattern in quotes is one part with these frames. With --check each file is a part. A "
                 "part has the name of its files, whatever objects they have")
      ->excludes("--in-order");
  add_repair_options(*subcommand, options->repairs, options->triangulate,
                     "Elements name the first of a part's vertices at exactly one position in place of the others: for "
                     "meshes with a vertex for each face. The first frame says which. Objects and groups are parts");
  add_separation_options(*subcommand, options->separation, "The distance at which two elements are in contact");
  CLI::Option* const separation = subcommand->get_option("--separation")->excludes(check);
  const auto check_metric = add_clearance_option(
      *subcommand, options->clearance,
      "Find the least distance of two elements in each step, too, or at rest with --check: rounded up "
      "to a double, between the elements as they are. Elements of one part count that share no vertex");
  subcommand
      ->add_flag("--classes", options->classes,
                 "Say how each two parts lie to each other, too: touching, overlapping, one inside the other, the same "
                 "or, where one has no inside, crossing. The other pairs are clear of each other")
      ->needs(check);
  add_pair_options(*subcommand, options->parts,
                   "Ask about these two parts against each other, and about nothing else: objects or groups of the "
                   "file, or patterns with * ? [. A,A asks about pairs within A. It may be given several times",
                   "Do not ask about these two parts; A,A leaves out pairs within A");
  CLI::Option* const between =
      subcommand->add_flag("--between-parts", options->parts.between_parts, "Do not ask about pairs within one part")
          ->excludes("--only-between");
  subcommand
      ->add_option_function<std::string>(
          "--self", [options](const std::string& text) { options->self = *io::parse_finite_double(text); },
          "Ask about the separation within a part, too, but not of its own neighbours: two elements that are within "
          "it in the first frame, and that edges connect whose lengths have a sum below LENGTH, are asked about "
          "touching alone")
      ->type_name("LENGTH")
      ->needs(separation)
      ->excludes(between)
      ->check([](const std::string& text) {
        const auto length = io::parse_finite_double(text);
        if (!length) return text + fault_of_number(text);
        return *length > 0 ? std::string() : text + " must be greater than 0";
      });
  add_threads_option(*subcommand, options->threads, "; no result depends on it");
  subcommand
      ->add_option_function<std::string>(
          "--shard", [options](const std::string& text) { options->shard = shard_from(text); },
          "Check part I of N of the steps only. `touchstone merge` puts the reports of all parts together")
      ->type_name("I/N")
      ->check([](const std::string& text) {
        return shard_from(text) ? std::string()
                                : text + " must be two whole numbers, such as 2/4: part 2 of 4, counted from 1";
      });
  CLI::Option* const report =
      subcommand
          ->add_option("--report", options->report,
                       "Write a JSON report with a result for every step; - writes it to standard output instead of "
                       "the summary")
          ->type_name("FILE")
          ->check(named_as(Output::json));
  subcommand
      ->add_flag("--resume", options->resume,
                 "Go on with the run that was to write this report and was stopped. Its finished steps are in "
                 "FILE.progress")
      ->needs(report);
  subcommand->add_flag("--json", options->json,
                       "Write a JSON object a line for each step or frame to standard output, with decimals, and the "
                       "verdict to standard error");
  subcommand->add_option("--pairs", options->pairs, "Write a table (CSV) with a row for each pair in contact")
      ->type_name("FILE")
      ->check(named_as(Output::csv));
  add_numbers_option(*subcommand, options->numbers);
  subcommand->get_option("--numbers")->needs("--pairs");
  subcommand
      ->add_option("--queries", options->queries,
                   "Write the pairs in contact as FOLDER/KIND/contacts.csv, query files for explain and certify")
      ->type_name("FOLDER");
  add_animation_option(*subcommand, options->html, "its contacts and its intersections");
  subcommand
      ->add_option("--prove", options->prove,
                   "Write the frames' positions as FOLDER/motion.txt and a proof for each pair of each step as "
                   "FOLDER/proofs.txt, for touchstone-check. The folder must be new or empty")
      ->type_name("FOLDER")
      ->excludes(check);
  subcommand
      ->add_option("--topology", options->topology,
                   "The file with the elements of the mesh, for frames that hold positions only")
      ->type_name("FILE");
  CLI::Option* const velocity =
      subcommand
          ->add_option("--velocity", options->velocity,
                       "An array of the vertices' velocities, (vertices, 3), or text (.csv, .txt) with a row x,y,z "
                       "for each: the step goes from the one FRAME to its positions and DT times the velocities, "
                       "rounded to doubles")
          ->type_name("FILE")
          ->excludes(check)
          ->excludes("--parts");
  CLI::Option* const dt = subcommand
                              ->add_option_function<std::string>(
                                  "--dt",
                                  [options](const std::string& text) {
                                    std::string no_fault;
                                    options->dt = time_step_from(text, no_fault).value_or(0);
                                  },
                                  "The time of that step, a number or a fraction such as 1/60, rounded to a double")
                              ->type_name("DT")
                              ->needs(velocity)
                              ->check([](const std::string& text) {
                                std::string fault;
                                time_step_from(text, fault);
                                return fault;
                              });
  velocity->needs(dt);
  subcommand->add_option("--dataset", options->dataset, "The name of the data set in HDF5 files")->type_name("NAME");
  for (const char* name : {"--queries", "--prove", "--topology", "--velocity"}) {
    subcommand->get_option(name)->check(not_empty);
  }
  subcommand->footer(
      "Vertices move on straight lines from each frame to the next. Files whose names differ in one number are sorted\n"
      "by it, and a missing number is an error. Files of other names are frames with --in-order only, and parts of one "
      "scene\n"
      "with --parts. All frames must have the same vertices and elements. The first frame must not intersect\n"
      "itself. Decimal coordinates are taken as the nearest doubles, and those are compared exactly.\n\n"
      "Examples\n"
      "  touchstone mesh cloth-*.obj\n"
      "  touchstone mesh --separation 1e-3 --report report.json --resume 'cloth-*.obj'\n"
      "  touchstone mesh --shard 2/4 --report part-2.json cloth-*.obj\n"
      "  touchstone mesh --check body.ply\n"
      "  touchstone mesh --check --clearance --between-parts engine.obj\n"
      "  touchstone mesh --check --parts --clearance --between-parts hull.stl wheel-*.stl\n"
      "  touchstone mesh --check --parts --classes wall-*.stl\n"
      "  touchstone mesh --parts --clearance --between-parts plate.obj 'lid-*.obj' arm/\n"
      "  touchstone mesh --clearance --only-between 'gripper*,bottle' grasp-*.obj\n"
      "  touchstone mesh --in-order rest.obj bent.obj\n"
      "  touchstone mesh --html cloth.html cloth-*.obj\n"
      "  touchstone mesh --prove proved cloth-*.obj && touchstone-check proved/proofs.txt proved/motion.txt\n\n"
      "Exit status: 0 every step is free and the first frame does not intersect itself (--check: no frame does), 1\n"
      "otherwise, 2 bad usage or bad input.");
  subcommand->callback([=, &command] {
    check_metric();
    command = [options] { return run_mesh(*options); };
  });
}

}  // namespace touchstone::cli
