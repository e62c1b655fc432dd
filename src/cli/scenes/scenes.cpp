// SPDX-License-Identifier: MIT
#include "cli/scenes/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "cli/scenes/public_scene.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/words.hpp"
#include "io/answers/answer_writer.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "io/sha256.hpp"
#include "report/own_process.hpp"

namespace touchstone::cli {
namespace {

/// Each time is the least of so many.
constexpr int kRepetitions = 3;

struct StepResult {
  std::size_t candidates = 0, contacts = 0;
  std::size_t judged = 0, wrong = 0;  ///< pairs with a truth, and those of which it is not ours
  std::size_t besides = 0;            ///< contacts of pairs without a truth
  std::optional<double> toi;          ///< of the first contact
  double seconds_of_candidates = 0, seconds_of_answers = 0, seconds_of_contacts = 0, seconds_of_first = 0;
  std::optional<std::uint64_t> memory;  ///< bytes that the first contact takes, on one thread; nothing: not known
  std::string digest;                   ///< of all contacts' answers

  double nanoseconds_a_candidate() const {
    return 1e9 * seconds_of_answers / static_cast<double>(std::max<std::size_t>(1, candidates));
  }
};

/// The result of `work`, and the least time that it takes.
template <class Work>
auto timed(double& seconds, const Work& work) {
  seconds = std::numeric_limits<double>::infinity();
  decltype(work()) result;
  for (int i = 0; i < kRepetitions; ++i) {
    throw_if_interrupted();
    const auto start = std::chrono::steady_clock::now();
    result = work();
    seconds = std::min(seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return result;
}

std::string digest_of(const std::vector<MeshContact>& contacts) {
  io::Sha256 digest;
  for (const MeshContact& contact : contacts) {
    const Answer& answer = contact.answer;
    digest.add(fmt::format("{} {} {} {:a} {:a} {} {} {}\n", name_of(contact.pair.kind), contact.pair.first,
                           contact.pair.second, answer.toi, answer.toi_upper, name_of(answer.nature),
                           name_of(answer.feature_a), name_of(answer.feature_b)));
  }
  return digest.digest();
}

/// Adds the time that the answers to all candidates take, by themselves.
void time_answers(const PublicStep& step, const std::vector<MeshPair>& pairs, int threads, StepResult& result) {
  constexpr std::size_t kAtATime = 65'536;
  std::vector<Query> queries;
  std::vector<Answer> answers(kAtATime);
  BatchOptions options;
  options.threads = threads;
  for (std::size_t i = 0; i < pairs.size();) {
    queries.clear();
    for (; i < pairs.size() && queries.size() < kAtATime; ++i) {
      queries.push_back(query_of(step.mesh, pairs[i], {step.x0, 3}, {step.x1, 3}));
    }
    double seconds = 0;
    timed(seconds, [&] {
      solve_batch(queries.data(), queries.size(), answers.data(), options);
      return true;
    });
    result.seconds_of_answers += seconds;
  }
}

StepResult check(const PublicStep& step, int threads) {
  StepResult result;
  const Positions x0(step.x0, 3), x1(step.x1, 3);
  try {
    result.memory = report::run_in_own_process([] {}, [&] { return first_contact(step.mesh, x0, x1).contact; }).memory;
  } catch (const Error&) {  // no process can be started, or it lacks memory: the rest does not need it
  }
  StepOptions options;
  options.threads = threads;
  FirstContactOptions first_options;
  first_options.threads = threads;
  const std::vector<MeshPair> pairs =
      timed(result.seconds_of_candidates, [&] { return candidates(step.mesh, x0, x1, options); });
  result.candidates = pairs.size();
  time_answers(step, pairs, threads, result);
  const FirstContact first =
      timed(result.seconds_of_first, [&] { return first_contact(step.mesh, x0, x1, first_options); });
  if (first.contact) result.toi = first.toi;
  const std::vector<MeshContact> contacts =
      timed(result.seconds_of_contacts, [&] { return all_contacts(step.mesh, x0, x1, options); });
  result.contacts = contacts.size();
  result.digest = digest_of(contacts);

  std::vector<MeshPair> touching;
  for (const MeshContact& contact : contacts) touching.push_back(contact.pair);
  std::sort(touching.begin(), touching.end());
  std::vector<MeshPair> judged;
  for (const JudgedPair& pair : step.judged) {
    judged.push_back(pair.pair);
    result.wrong += std::binary_search(touching.begin(), touching.end(), pair.pair) != pair.touches ? 1 : 0;
  }
  result.judged = judged.size();
  std::sort(judged.begin(), judged.end());
  for (const MeshPair& pair : step.has_truth ? touching : std::vector<MeshPair>()) {
    result.besides += std::binary_search(judged.begin(), judged.end(), pair) ? 0 : 1;
  }
  return result;
}

/// "5 pairs: all as said; 0 contacts besides".
std::string comparison(std::size_t judged, std::size_t wrong, std::size_t besides) {
  return fmt::format("{}: {}; {} besides", counted(judged, "pair"),
                     wrong == 0 ? "all as said" : counted(wrong, "verdict") + (wrong == 1 ? " differs" : " differ"),
                     counted(besides, "contact"));
}

std::string for_person(const PublicStep& step, const StepResult& result) {
  std::string text = fmt::format("{}: {} vertices, {}\n", io::printable(step.name), grouped(step.mesh.vertex_count()),
                                 counted(step.mesh.faces().size(), "face"));
  text += fmt::format("  candidates     {} in {:.2f} ms; each is answered in {:.0f} ns\n", grouped(result.candidates),
                      1e3 * result.seconds_of_candidates, result.nanoseconds_a_candidate());
  text += fmt::format("  first contact  {} in {:.2f} ms{}\n", result.toi ? time_for_person(*result.toi) : "none",
                      1e3 * result.seconds_of_first,
                      result.memory ? fmt::format(" and {:.1f} MB", 1e-6 * static_cast<double>(*result.memory)) : "");
  text += fmt::format("  all contacts   {} in {:.2f} ms\n", grouped(result.contacts), 1e3 * result.seconds_of_contacts);
  text += fmt::format("  truth          {}\n", step.has_truth ? comparison(result.judged, result.wrong, result.besides)
                                                              : "none: no boxes and mma_bool of this step are here");
  return text + fmt::format("  digest         {}\n", result.digest);
}

constexpr std::string_view kHeader =
    "step,vertices,faces,candidates,contacts,judged,wrong,besides,toi,candidates_ms,first_contact_ms,all_contacts_ms,"
    "ns_per_candidate,first_contact_bytes,digest\n";

std::string csv_row(const PublicStep& step, const StepResult& result) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{:.3f},{:.3f},{:.3f},{:.2f},{},{}\n", io::csv_field(step.name),
                     step.mesh.vertex_count(), step.mesh.faces().size(), result.candidates, result.contacts,
                     result.judged, result.wrong, result.besides, result.toi ? fmt::format("{:a}", *result.toi) : "",
                     1e3 * result.seconds_of_candidates, 1e3 * result.seconds_of_first,
                     1e3 * result.seconds_of_contacts, result.nanoseconds_a_candidate(),
                     result.memory ? fmt::format("{}", *result.memory) : "", result.digest);
}

}  // namespace

int run_scenes(const ScenesOptions& options) {
  const std::vector<PublicStepFiles> steps = find_public_steps(options.folders);
  std::optional<io::OutputFile> table;
  if (!options.csv.empty()) {
    std::vector<std::string> inputs;
    for (const PublicStepFiles& files : steps)
      for (const std::string& file : files.all()) inputs.push_back(file);
    refuse_to_overwrite(options.csv, inputs);
    table.emplace(options.csv);
    table->write(kHeader);
  }
  const int threads = thread_count(options.threads);
  std::size_t judged = 0, wrong = 0, besides = 0, without_truth = 0;
  for (const PublicStepFiles& files : steps) {
    const PublicStep step = read_public_step(files);
    const StepResult result = check(step, threads);
    judged += result.judged;
    wrong += result.wrong;
    besides += result.besides;
    without_truth += step.has_truth ? 0 : 1;
    if (table) table->write(csv_row(step, result));
    auto console = io::OutputFile::standard_output();
    console.write(for_person(step, result));
    console.commit();
  }
  if (table) table->commit();
  std::string summary = counted(steps.size(), "step") + ", ";
  summary += judged + besides == 0 ? "nothing was compared" : comparison(judged, wrong, besides);
  if (without_truth > 0) summary += fmt::format("; {} without a truth", counted(without_truth, "step"));
  auto console = io::OutputFile::standard_output();
  console.write(summary + "\n");
  console.commit();
  return judged > 0 && wrong + besides == 0 ? kAllHold : kRefuted;
}

}  // namespace touchstone::cli
