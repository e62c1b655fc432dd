// SPDX-License-Identifier: MIT
#include "sequence/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "io/fail.hpp"
#include "sequence/frame_list.hpp"
#include "sequence/report_json.hpp"

namespace touchstone::sequence {
namespace {

const Shard& shard_of(const ShardReport& shard) { return *shard.report.heading.shard; }

/// The numbers that are not there: "2", "2, 5 and 3 more".
std::string missing_numbers(const std::vector<ShardReport>& shards, std::size_t count) {
  constexpr std::size_t kShown = 10;
  std::string text;
  std::size_t at = 0, shown = 0;
  for (std::size_t number = 1; number <= count && shown < kShown; ++number) {
    if (at < shards.size() && shard_of(shards[at]).number == number) {
      ++at;
      continue;
    }
    text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
    ++shown;
  }
  const std::size_t missing = count - shards.size();
  return missing > shown ? text + fmt::format(" and {} more", missing - shown) : text;
}

void check_all_there(const std::vector<ShardReport>& shards) {
  const std::size_t count = shard_of(shards.front()).count;
  for (std::size_t i = 1; i < shards.size(); ++i) {
    if (shard_of(shards[i]).number != shard_of(shards[i - 1]).number) continue;
    io::fail(shards[i].file, fmt::format("is shard {}/{}, and so is {}", shard_of(shards[i]).number, count,
                                         io::printable(shards[i - 1].file)));
  }
  if (shards.size() == count) return;
  io::fail(shards.front().file,
           fmt::format("is one of {} shards, and {} given; missing: {}", count,
                       shards.size() == 1 ? "only this one is" : fmt::format("only {} are", shards.size()),
                       missing_numbers(shards, count)));
}

/// Neighbouring shards of steps read one frame both.
void check_shared_frame(const ShardReport& before, const ShardReport& after) {
  const FrameEntry &last = before.report.frames.back(), &first = after.report.frames.front();
  if (last.label == first.label && last.digest == first.digest) return;
  io::fail(after.file, fmt::format("read another {} than {} did: the frame has changed between the two runs",
                                   io::printable(first.label), io::printable(before.file)));
}

}  // namespace

Report merged(std::vector<ShardReport> shards) {
  Report whole;
  if (shards.empty()) return whole;
  const Heading heading = shards.front().report.heading;
  for (const ShardReport& shard : shards) {
    if (!shard.report.heading.shard) io::fail(shard.file, "is the report of a whole run, and no shard");
    Heading other = shard.report.heading;
    if (other.shard->count == heading.shard->count) other.shard = heading.shard;
    const std::string difference = difference_of(other, heading, io::printable(shards.front().file));
    if (!difference.empty()) io::fail(shard.file, difference);
  }
  std::stable_sort(shards.begin(), shards.end(),
                   [](const ShardReport& a, const ShardReport& b) { return shard_of(a).number < shard_of(b).number; });
  check_all_there(shards);

  whole.heading = heading;
  whole.heading.shard.reset();
  for (std::size_t i = 0; i < shards.size(); ++i) {
    Report& shard = shards[i].report;
    const bool continues = i > 0 && heading.question == Question::steps;
    if (continues) check_shared_frame(shards[i - 1], shards[i]);
    const auto frames = shard.frames.begin() + (continues ? 1 : 0);
    whole.frames.insert(whole.frames.end(), frames, shard.frames.end());
    whole.results.insert(whole.results.end(), std::make_move_iterator(shard.results.begin()),
                         std::make_move_iterator(shard.results.end()));
  }
  std::vector<std::string> labels;
  for (const FrameEntry& frame : whole.frames) labels.push_back(frame.label);
  if (digest_of(labels) != heading.list_digest) {
    io::fail(shards.front().file, "and the other shards do not have the names of the sequence that they are shards of");
  }
  return whole;
}

}  // namespace touchstone::sequence
