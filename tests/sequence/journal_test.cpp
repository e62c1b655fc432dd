// The journal of a run: what it holds after the run was killed at any byte, and what it refuses.
// SPDX-License-Identifier: MIT
#include "sequence/journal.hpp"

#include <filesystem>
#include <functional>
#include <string>

#include <touchstone/error.hpp>

#include "io/temporary_folder.hpp"
#include "sequence/refusal.hpp"
#include "sequence/results_json.hpp"
#include "sequence/sample_report.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sequence;
using touchstone::tests::has;
using touchstone::tests::refusal_of;
using touchstone::tests::sample_report;
using touchstone::tests::TemporaryFolder;

namespace {

Finished finished_of(const Report& report, std::size_t i) {
  const Result& result = report.results[i];
  Finished finished{result, {report.frames[result.frame].digest}};
  if (result.step) finished.digests.push_back(report.frames[result.frame + 1].digest);
  return finished;
}

/// The journal of a run that was killed after `count` results.
std::string journal_text(const TemporaryFolder& folder, std::size_t count) {
  const Report report = sample_report();
  {
    Journal journal(folder.path("j"), report.heading, Earlier::refused);
    for (std::size_t i = 0; i < count; ++i) journal.add(finished_of(report, i));
  }
  std::string text = std::filesystem::exists(folder.path("j")) ? folder.read("j") : std::string();
  std::filesystem::remove(folder.path("j"));
  return text;
}

}  // namespace

TEST_CASE("a journal that was cut anywhere gives back the results before the cut, and goes on to the same bytes",
          "[slow]") {
  const TemporaryFolder folder;
  const Report report = sample_report();
  const std::size_t all = report.results.size();
  const std::string whole = journal_text(folder, all);
  std::size_t last = 0, first_line = whole.find('\n') + 1;
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    folder.write("j", whole.substr(0, cut));
    {
      Journal journal(folder.path("j"), report.heading, Earlier::continued);
      const auto& finished = journal.finished();
      std::size_t lines = 0;
      for (std::size_t at = first_line; at < cut; ++at) lines += whole[at] == '\n' ? 1 : 0;
      CHECK(finished.size() == lines);
      CHECK(finished.size() >= last);
      last = finished.size();
      for (std::size_t i = 0; i < finished.size(); ++i) {
        CHECK(result_json(finished[i].result) == result_json(report.results[i]));
        CHECK(finished[i].digests == finished_of(report, i).digests);
      }
      for (std::size_t i = finished.size(); i < all; ++i) journal.add(finished_of(report, i));
    }
    CHECK(folder.read("j") == whole);
  }
  CHECK(last == all);
}

TEST_CASE("a damaged line ends what a journal gives back") {
  const TemporaryFolder folder;
  const Report report = sample_report();
  const std::string whole = journal_text(folder, report.results.size());
  for (std::size_t at = whole.find('\n') + 1; at < whole.size(); at += 3) {
    std::string bad = whole;
    bad[at] = static_cast<char>(bad[at] ^ 2);
    folder.write("j", bad);
    std::size_t lines_before = 0;
    for (std::size_t i = whole.find('\n') + 1; i < at; ++i) lines_before += whole[i] == '\n' ? 1 : 0;
    const Journal journal(folder.path("j"), report.heading, Earlier::continued);
    CHECK(journal.finished().size() == lines_before);
  }
}

TEST_CASE("the journal of an earlier run is refused unless it is to be continued") {
  const TemporaryFolder folder;
  const Report report = sample_report();
  folder.write("j", journal_text(folder, 3));
  CHECK(has(refusal_of([&] { Journal(folder.path("j"), report.heading, Earlier::refused); }),
            "/j: is there: an earlier run with this report did not finish; --resume goes on with it"));
  CHECK(folder.read("j") == journal_text(TemporaryFolder(), 3));
}

TEST_CASE("the journal of another run is refused, and the message says what differs") {
  const TemporaryFolder folder;
  const Report report = sample_report();
  const std::string text = journal_text(folder, 3);
  folder.write("j", text);
  const auto refused = [&](const std::function<void(Heading&)>& change) {
    Heading other = report.heading;
    change(other);
    const std::string refusal = refusal_of([&] { Journal(folder.path("j"), other, Earlier::continued); });
    CHECK(folder.read("j") == text);
    return refusal;
  };
  CHECK(has(refused([](Heading& h) { h.separation.distance = 0; }),
            "/j: is about separation 0x1p-3, max, and this run about touching"));
  CHECK(
      has(refused([](Heading& h) { h.separation.metric = Metric::euclidean; }), "about separation 0x1p-3, euclidean"));
  CHECK(has(refused([](Heading& h) { h.frame_count = 8; }), "is about 7 frames, and this run about 8 frames"));
  CHECK(has(refused([](Heading& h) { h.list_digest[3] ^= 1; }), "frames of other names"));
  CHECK(has(refused([](Heading& h) {
              h.shard = Shard{1, 2};
            }),
            "about a whole sequence, and this run about shard 1/2"));
  CHECK(
      has(refused([](Heading& h) { h.program = "9"; }), "was made by touchstone 0.1.0, and this run by touchstone 9"));
  CHECK(has(refused([](Heading& h) { h.facts->digest[3] = 'f'; }), "is about a mesh of 13 vertices"));
}

TEST_CASE("a file that is no journal is left alone") {
  const TemporaryFolder folder;
  const Report report = sample_report();
  for (const char* text : {"my notes\n", "\n", "0123456789abcdef {}\n", "my notes", "0123456789abcdef {", "{"}) {
    folder.write("j", text);
    CHECK(has(refusal_of([&] { Journal(folder.path("j"), report.heading, Earlier::continued); }), "is no journal"));
    CHECK(folder.read("j") == text);
  }
}

TEST_CASE("two runs cannot write one journal, and a run without a result leaves none") {
  const TemporaryFolder folder;
  const Report report = sample_report();
  {
    const Journal one(folder.path("j"), report.heading, Earlier::refused);
    for (const Earlier earlier : {Earlier::refused, Earlier::continued}) {
      CHECK(has(refusal_of([&] { Journal(folder.path("j"), report.heading, earlier); }), "is in use: another process"));
    }
  }
  CHECK(folder.names().empty());
  Journal two(folder.path("j"), report.heading, Earlier::refused);
  two.add(finished_of(report, 0));
  two.remove();
  CHECK(folder.names().empty());
}
