// SPDX-License-Identifier: MIT
#include "cli/bodies/body_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/shared/command_line/separation_options.hpp"
#include "cli/shared/mesh_results.hpp"
#include "cli/shared/words.hpp"
#include "io/answers/answer_writer.hpp"
#include "sequence/parts/part_rules.hpp"
#include "sequence/results_json.hpp"
#include "sequence/scope.hpp"

namespace touchstone::cli {
namespace {

constexpr std::size_t kShownSteps = 10;  // of those that are not free; --json has all

std::string decimal(double value) { return io::number_text(value, io::Numbers::decimals); }

std::string list_of(const std::array<double, 3>& weights) {
  return fmt::format("[{},{},{}]", decimal(weights[0]), decimal(weights[1]), decimal(weights[2]));
}

/// The bodies as one mesh at rest, for the words about what is left out of it.
sequence::Heading heading_of(const BodyFiles& files) {
  sequence::Heading heading;
  heading.question = sequence::Question::rest;
  heading.frame_count = 1;
  heading.facts = files.facts();
  return heading;
}

/// " is" for one, else " are".
const char* is(std::size_t count) { return count == 1 ? " is" : " are"; }

}  // namespace

std::string step_label(const RecordedPoses& poses, std::size_t step) {
  return decimal(poses.times[step]) + " -> " + decimal(poses.times[step + 1]);
}

BodyResults::BodyResults(const BodiesRunOptions& options, BodyFiles& files, const RecordedPoses& poses)
    : options_(options), files_(files), poses_(poses), console_(io::OutputFile::standard_output()) {
  if (options.free_step.empty()) return;
  free_step_.emplace(options.free_step);
  free_step_->write("from,to,outcome,length,body,x,y,z,qw,qx,qy,qz\n");
}

void BodyResults::write_poses(const FreeBodyStep& found) {
  const std::string step = fmt::format("{},{},{},{}", decimal(poses_.times[steps_]), decimal(poses_.times[steps_ + 1]),
                                       name_of(found.outcome), decimal(found.length));
  for (std::size_t body = 0; body < found.poses.size(); ++body) {
    const auto& [q, p] = found.poses[body];
    free_step_->write(fmt::format("{},{}", step, io::csv_field(files_.names()[body])));
    for (const double value : {p.x, p.y, p.z, q[0], q[1], q[2], q[3]})
      free_step_->write(fmt::format(",{}", decimal(value)));
    free_step_->write("\n");
  }
}

void BodyResults::add_clearance(const BodyDistance& found) {
  const bool is_least =
      clearances_.empty() || found.distance < *std::min_element(clearances_.begin(), clearances_.end());
  if (is_least) {
    nearest_ = least_distance_for_person(found.distance, files_.bodies().separation.metric);
    if (std::isfinite(found.distance)) nearest_ += " at time " + decimal(poses_.times[clearances_.size()]);
    if (!found.pairs.empty()) nearest_ += ": " + pair_for_person(files_.named(found.pairs.front()));
    if (found.pairs.size() > 1) nearest_ += fmt::format(" and {}", counted(found.pairs.size() - 1, "more pair"));
    if (found.pairs.empty() && !found.intersections.empty()) nearest_ += ": bodies intersect";
  }
  clearances_.push_back(found.distance);
}

void BodyResults::add(const FreeBodyStep& step, const Turns& turns) {
  const FirstBodyContact& found = step.first_contact;
  if (free_step_) write_poses(step);
  const bool later = found.at_start.empty() && found.start_intersections.empty();
  count(found, turns, "; the first at time ", later ? found.toi : 0);
}

void BodyResults::add(const BodyScrewAnswer& found, const Turns& turns) {
  const bool at_start = !found.start_intersections.empty();
  if (found.verdict == ScrewVerdict::within_bound && !at_start) ++open_;
  count(found, turns, at_start ? "; the first at time " : "; none before time ", at_start ? 0 : found.free_until);
}

template <class Found>
void BodyResults::count(const Found& found, const Turns& turns, const char* first, double fraction) {
  if (options_.json) {
    console_.write(json_of(found, turns));
    console_.commit();
  }
  if (found.free()) {
    ++free_;
  } else {
    if (first_.empty()) first_ = first + decimal(poses_.time_in(steps_, fraction));
    if (!options_.json && shown_++ < kShownSteps) lines_ += lines_of(found);
  }
  excluded_ = found.excluded;
  in_open_ = std::max(in_open_, found.in_open);
  cancelled_ = std::max(cancelled_, found.cancelled);
  turns_.longer += turns.longer;
  turns_.half += turns.half;
  ++steps_;
}

std::vector<sequence::RestContact> BodyResults::named(const std::vector<BodyIntersection>& found) const {
  std::vector<sequence::RestContact> named;
  for (const BodyIntersection& one : found) named.push_back(files_.named(one));
  return named;
}

std::string BodyResults::lines_of(const FirstBodyContact& found) const {
  std::string text = step_label(poses_, steps_) + ": ";
  const auto add_pairs = [&](const std::vector<BodyContact>& contacts, const char* indent) {
    for (std::size_t i = 0; i < std::min(kShownPairs, contacts.size()); ++i) {
      text += fmt::format("{}{}: {}\n", indent, pair_for_person(files_.named(contacts[i])),
                          contact_for_person(contacts[i].answer));
    }
    text += more_line(contacts.size(), indent);
  };
  const char* indent = "";
  if (found.contact) {
    text += fmt::format("first contact at {} of the step, time {}, {}\n", time_range(found.toi, found.toi_upper),
                        decimal(poses_.time_in(steps_, found.toi)), counted(found.earliest.size(), "pair"));
    add_pairs(found.earliest, "  ");
    indent = "  ";
  }
  if (!found.at_start.empty()) {
    text += indent + pairs_are(found.at_start.size()) + "\n";
    add_pairs(found.at_start, found.contact ? "    " : "  ");
    indent = "  ";
  }
  return text + start_lines(found.start_intersections, indent);
}

std::string BodyResults::start_lines(const std::vector<BodyIntersection>& found, const std::string& indent) const {
  if (found.empty()) return {};
  const std::vector<sequence::RestContact> contacts = named(found);
  sequence::IntersectionCounts counts;
  counts.add(contacts);
  return fmt::format("{}at the start {}\n", indent, intersections_for_person(counts)) +
         intersection_lines(contacts, indent + "  ");
}

std::string BodyResults::lines_of(const BodyScrewAnswer& found) const {
  std::string text = step_label(poses_, steps_) + ": ";
  if (found.verdict == ScrewVerdict::free) return text + start_lines(found.start_intersections, "");
  const double first = found.free_until, last = found.contact_by;
  const std::string first_time = decimal(poses_.time_in(steps_, first));
  if (found.verdict == ScrewVerdict::contact) {
    text +=
        fmt::format("a contact in t from {} to {} of the step, time {} to {}, and none before; {} may be the first\n",
                    decimal(first), decimal(last), first_time, decimal(poses_.time_in(steps_, last)),
                    counted(found.pairs.size(), "pair"));
  } else {
    text += fmt::format("open: free up to t = {} of the step, time {}, and then {} nearer than the bound tells\n",
                        decimal(first), first_time,
                        found.pairs.size() == 1 ? "1 pair comes" : counted(found.pairs.size(), "pair") + " come");
  }
  for (std::size_t i = 0; i < std::min(kShownPairs, found.pairs.size()); ++i) {
    const auto& [pair, answer] = found.pairs[i];
    text += fmt::format("  {}: ", pair_for_person(files_.named(BodyContact{pair, {}, {}})));
    text += answer.verdict == ScrewVerdict::contact
                ? fmt::format("contact, t from {} to {}\n", decimal(answer.free_until), decimal(answer.contact_by))
                : fmt::format("open from t = {}, by arcs that are off by at most {}\n", decimal(answer.free_until),
                              decimal(answer.deviation));
  }
  return text + more_line(found.pairs.size(), "  ") + start_lines(found.start_intersections, "  ");
}

template <class Found>
std::string BodyResults::json_head(const Found& found, const Turns& turns) const {
  std::string text = fmt::format(
      "{{\"step\":{},\"from\":{},\"to\":{},\"free\":{},\"longer_turns\":{},\"half_turns\":{},\"start_asked\":{}",
      steps_, decimal(poses_.times[steps_]), decimal(poses_.times[steps_ + 1]), found.free(), turns.longer, turns.half,
      found.start_checked);
  if (!clearances_.empty()) {
    const auto clearance = [&](std::size_t time) {
      return std::isfinite(clearances_[time]) ? decimal(clearances_[time]) : std::string("null");
    };
    text += fmt::format(",\"clearance\":[{},{}]", clearance(steps_), clearance(steps_ + 1));
  }
  return text;
}

std::string BodyResults::json_of(const FirstBodyContact& found, const Turns& turns) const {
  std::string text = json_head(found, turns);
  const auto list = [&](const char* key, const std::vector<BodyContact>& contacts) {
    text += fmt::format(",\"{}\":[", key);
    for (const BodyContact& contact : contacts) {
      if (&contact != &contacts.front()) text += ',';
      const Answer& answer = contact.answer;
      text += sequence::contact_json(
          files_.named(contact),
          fmt::format(",\"weights_a\":{},\"weights_b\":{}", list_of(answer.weights_a), list_of(answer.weights_b)));
    }
    text += "]";
  };
  if (!found.free()) {
    const auto number = [&](double value) { return found.contact ? decimal(value) : std::string("null"); };
    const auto time = [&](double fraction) { return number(found.contact ? poses_.time_in(steps_, fraction) : 0); };
    text += fmt::format(",\"toi\":{},\"toi_upper\":{},\"time\":{},\"time_upper\":{}", number(found.toi),
                        number(found.toi_upper), time(found.toi), time(found.toi_upper));
    list("first", found.earliest);
    list("at_start", found.at_start);
    text += ",\"intersections\":" + sequence::intersections_json(named(found.start_intersections));
  }
  return text + "}\n";
}

std::string BodyResults::json_of(const BodyScrewAnswer& found, const Turns& turns) const {
  std::string text = json_head(found, turns);
  text += fmt::format(",\"verdict\":\"{}\"", name_of(found.verdict));
  if (found.free()) return text + "}\n";
  text += fmt::format(",\"free_until\":{},\"contact_by\":{},\"pairs\":[", decimal(found.free_until),
                      found.verdict == ScrewVerdict::contact ? decimal(found.contact_by) : "null");
  for (const auto& [pair, answer] : found.pairs) {
    if (&answer != &found.pairs.front().answer) text += ',';
    const std::string by = answer.verdict == ScrewVerdict::contact ? decimal(answer.contact_by) : "null";
    text += sequence::elements_json(
        files_.named(BodyContact{pair, {}, {}}),
        fmt::format(",\"verdict\":\"{}\",\"free_until\":{},\"contact_by\":{},\"deviation\":{},\"arcs\":{}",
                    name_of(answer.verdict), decimal(answer.free_until), by, decimal(answer.deviation), answer.arcs));
  }
  return text + "],\"intersections\":" + sequence::intersections_json(named(found.start_intersections)) + "}\n";
}

std::vector<std::string> BodyResults::left_out() const {
  std::vector<std::string> texts = {"elements of one body were never compared"};
  if (options_.slerp) texts.emplace_back("turns were read as slerp has them, at a constant rate");
  const std::size_t bodies = files_.names().size(), rest = poses_.at_rest();
  if (rest > 0) {
    texts.push_back(fmt::format("{} of {} bodies{} at rest: no pose names {}", grouped(rest), grouped(bodies), is(rest),
                                rest == 1 ? "it" : "them"));
  }
  if (excluded_ > 0) {
    texts.push_back(fmt::format("{} of {} pairs of bodies {} left out", grouped(excluded_),
                                grouped(bodies * (bodies - 1) / 2), excluded_ == 1 ? "was" : "were"));
  }
  for (std::string& text : sequence::left_out_by(files_.rules(), "bodies")) texts.push_back(std::move(text));
  texts.push_back(options_.check_start ? "the start was asked about intersections, too"
                                       : "whether bodies intersect at the start was not asked");
  const auto pieces = [](std::size_t count) {
    return grouped(count) + (count == 1 ? " surface, wire or point is" : " surfaces, wires or points are");
  };
  if (in_open_ > 0) {
    texts.push_back(pieces(in_open_) +
                    " in the box around surfaces of another body that are open or branch, which have no inside: --weld "
                    "closes surfaces whose faces have vertices of their own");
  }
  if (cancelled_ > 0) {
    texts.push_back(pieces(cancelled_) +
                    " in closed surfaces of opposite orientation, which is no inside: as in a cavity");
  }
  const std::size_t longer = turns_.longer, half = turns_.half, all_turns = steps_ * (bodies - rest);
  if (longer > 0) {
    const std::string turns =
        fmt::format("{} of {} turns {} the longer way by the signs of the quaternions (q0 . q1 < 0)", grouped(longer),
                    grouped(all_turns), longer == 1 ? "goes" : "go");
    texts.push_back(turns + (options_.turn == Turn::shorter
                                 ? fmt::format(" and {} taken the shorter way", longer == 1 ? "was" : "were")
                                 : " and may be meant the shorter way"));
  }
  if (half > 0) {
    texts.push_back(fmt::format("{} of {} turns {} 180 degrees, one way or the other by the signs of the quaternions",
                                grouped(half), grouped(all_turns), half == 1 ? "has" : "have"));
  }
  if (!poses_.time_spacing.empty()) texts.push_back(poses_.time_spacing);
  if (poses_.not_unit > 0 && !options_.slerp) {
    texts.push_back(
        fmt::format("{} quaternion{} {} a length that is not 1, the first in row {}: the rate of a turn depends on it",
                    grouped(poses_.not_unit), poses_.not_unit == 1 ? "" : "s", poses_.not_unit == 1 ? "has" : "have",
                    poses_.not_unit_row));
  }
  if (!poses_.unread.empty()) {
    std::string names;
    for (const std::string& name : poses_.unread) names += (names.empty() ? "" : ", ") + name;
    texts.push_back(fmt::format("{} of the poses {} not read: {}", counted(poses_.unread.size(), "column"),
                                poses_.unread.size() == 1 ? "was" : "were", names));
  }
  for (std::string& text : sequence::warnings_of(heading_of(files_), {}, {})) texts.push_back(std::move(text));
  return texts;
}

std::string BodyResults::verdict() const {
  const std::size_t rest = steps_ - free_ - open_;
  std::string text = counted(steps_, "step");
  text += free_ == steps_ ? std::string(steps_ == 1 ? ", free of contact" : ", all free of contact")
                          : fmt::format(": {} free, {} not free", grouped(free_), grouped(rest));
  if (open_ > 0) text += fmt::format(", {} open", grouped(open_));
  text += fmt::format("{} ({}: {}", first_, counted(files_.names().size(), "body"),
                      sequence::scope_of(heading_of(files_), {}));
  const Separation& separation = files_.bodies().separation;
  if (separation.distance > 0) text += "; " + separation_for_person(separation);
  text += ")";
  if (!nearest_.empty()) text += "; " + nearest_ + "; the least distance between recorded poses was not asked";
  for (const std::string& one : left_out()) text += "; " + one;
  return text + "\n";
}

bool BodyResults::finish(const std::string& more) {
  const bool all_free = free_ == steps_;
  if (free_step_) free_step_->commit();
  if (options_.json) {
    print_error(verdict() + more);
  } else {
    console_.write(in_colour(verdict() + lines_, VerdictLine::first, all_free));
    if (shown_ > kShownSteps) {
      console_.write(fmt::format("and {} that {} not free; --json has all\n",
                                 counted(shown_ - kShownSteps, "more step"), shown_ - kShownSteps == 1 ? "is" : "are"));
    }
    console_.write(more);
    console_.commit();
  }
  return all_free;
}

}  // namespace touchstone::cli
