// SPDX-License-Identifier: MIT
#include "fuzz/steps/pipe_steps.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <touchstone/error.hpp>

#include "fuzz/processes/pipe_run.hpp"
#include "fuzz/scenes/scene_search.hpp"
#include "fuzz/steps/judge_step.hpp"
#include "io/fail.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::fuzz {
namespace {

void append_number(std::string& line, double x) { line.append(numbers::decimal_text(x)); }
void append_number(std::string& line, MeshIndex x) { line.append(std::to_string(x)); }

template <class Number>
void append_list(std::string& line, const Number* numbers, std::size_t count) {
  line.append("[");
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) line.append(",");
    append_number(line, numbers[i]);
  }
  line.append("]");
}

template <class Rows>
void append_rows(std::string& line, const char* name, const Rows& rows) {
  line.append(",\"").append(name).append("\":[");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0) line.append(",");
    append_list(line, rows[i].data(), rows[i].size());
  }
  line.append("]");
}

std::vector<std::array<double, 3>> rows_of(const Positions& positions) {
  std::vector<std::array<double, 3>> rows;
  for (std::size_t v = 0; v < positions.count; ++v) {
    std::array<double, 3> row{};
    for (std::size_t k = 0; k < 3; ++k) {
      row[k] = positions.data[static_cast<std::ptrdiff_t>(v) * positions.vertex_stride +
                              static_cast<std::ptrdiff_t>(k) * positions.coordinate_stride];
    }
    rows.push_back(row);
  }
  return rows;
}

[[noreturn]] void refuse(const std::string& reason) { throw NoReply(FuzzFailure::malformed, reason); }

MeshPair read_pair(const nlohmann::json& entry, const Mesh& mesh) {
  const auto is_number = [](const nlohmann::json& word) { return word.is_number_unsigned(); };
  const bool has_shape =
      entry.is_array() && entry.size() == 3 && entry[0].is_string() && is_number(entry[1]) && is_number(entry[2]);
  const auto kind = has_shape ? from_name<Kind>(entry[0].get<std::string>()) : std::nullopt;
  // A value that may be deep is not written again: that would take a call for each level.
  if (!kind) refuse("a candidate must be such as [\"edge-edge\", 0, 3]");
  const auto first = entry[1].get<std::uint64_t>(), second = entry[2].get<std::uint64_t>();
  if (!has_pair(mesh, *kind, first, second)) {
    refuse("the candidate " + io::in_quotes(entry.dump()) + " names an element that the mesh has not");
  }
  return {*kind, static_cast<MeshIndex>(first), static_cast<MeshIndex>(second)};
}

class StepProcess {
 public:
  StepProcess(std::string command_line, const Limits& limits)
      : command_line_(std::move(command_line)),
        limits_(limits),
        run_(std::make_unique<PipeRun>(command_line_, limits_)) {}

  StepReply ask(const Mesh& mesh, const Positions& x0, const Positions& x1) {
    if (!run_) {
      run_ = std::make_unique<PipeRun>(command_line_, limits_);
      is_new_ = true;
    }
    // An interpreter takes some time to start, for the first time most of all.
    const auto restart = std::max(limits_.answer, std::chrono::milliseconds(2000));
    const auto time = is_first_ ? limits_.start : is_new_ ? restart : limits_.answer;
    const PipeRun::Exchange exchange = run_->exchange(step_line(mesh, x0, x1), time);
    using End = PipeRun::Exchange::End;
    is_first_ = is_new_ = false;
    try {
      const std::string said = exchange.line.empty() ? "" : "; it had said " + io::in_quotes(exchange.line);
      if (exchange.end == End::died) throw NoReply(FuzzFailure::crash, run_->child().story() + said);
      if (exchange.end == End::late) {
        throw NoReply(FuzzFailure::hang,
                      "no reply within " + std::to_string(time.count()) + " ms (are replies flushed?)" + said);
      }
      if (exchange.end != End::line) refuse("it says more than it was asked, or too long a line" + said);
      return read_step_reply(exchange.line, mesh);
    } catch (const NoReply&) {
      run_->child().kill();
      run_.reset();
      throw;
    }
  }

 private:
  std::string command_line_;
  Limits limits_;
  std::unique_ptr<PipeRun> run_;
  bool is_first_ = true, is_new_ = true;
};

}  // namespace

std::string step_line(const Mesh& mesh, const Positions& x0, const Positions& x1) {
  const MeshElements elements = mesh.elements();
  std::string line = "{\"vertices\":" + std::to_string(mesh.vertex_count());
  append_rows(line, "x0", rows_of(x0));
  append_rows(line, "x1", rows_of(x1));
  append_rows(line, "edges", mesh.edges());
  append_rows(line, "faces", mesh.faces());
  line.append(",\"points\":");
  append_list(line, mesh.points().data(), mesh.points().size());
  line.append(",\"separation\":");
  append_number(line, elements.separation.distance);
  line.append(",\"metric\":\"").append(name_of(elements.separation.metric)).append("\"");
  if (!elements.rules.groups.empty()) {
    line.append(",\"groups\":");
    append_list(line, elements.rules.groups.data(), elements.rules.groups.size());
    append_rows(line, "ignored_groups", elements.rules.group_pairs);
  }
  return line + "}\n";
}

StepReply read_step_reply(std::string_view line, const Mesh& mesh) {
  const auto text = nlohmann::json::parse(line, nullptr, false);
  const auto right = [] {
    return std::string(
        R"(; a reply is such as {"free": 0.5}, {"first_contact": null} or {"candidates": [["edge-edge", 0, 3]]})");
  };
  if (!text.is_object() || text.empty()) refuse(io::in_quotes(std::string(line)) + " is no reply" + right());
  StepReply reply;
  for (const auto& [key, value] : text.items()) {
    const bool is_null = value.is_null() && key == "first_contact";
    if (key == "candidates" && value.is_array()) {
      reply.candidates.emplace();
      for (const auto& entry : value) reply.candidates->push_back(read_pair(entry, mesh));
    } else if ((key == "free" || key == "first_contact") && (value.is_number() || is_null)) {
      const double number = is_null ? std::numeric_limits<double>::infinity() : value.get<double>();
      (key == "free" ? reply.free : reply.first_contact) = number;
    } else {
      refuse(io::in_quotes(key) + " is no word of a reply, or has no such value" + right());
    }
  }
  return reply;
}

StepSolver run_step_command(const std::string& command_line, const Limits& limits) {
  const auto process = std::make_shared<StepProcess>(command_line, limits);
  return [process](const Mesh& mesh, const Positions& x0, const Positions& x1) { return process->ask(mesh, x0, x1); };
}

}  // namespace touchstone::fuzz
