// SPDX-License-Identifier: MIT
#include "fuzz/steps/plugin_steps.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <touchstone/plugin.h>
#include <nlohmann/json.hpp>
#include <touchstone/error.hpp>

#include "fuzz/processes/child_process.hpp"
#include "fuzz/processes/line_process.hpp"
#include "fuzz/processes/no_reply.hpp"
#include "fuzz/processes/pipe_run.hpp"
#include "fuzz/processes/plugin_file.hpp"
#include "fuzz/scenes/scene_json.hpp"
#include "fuzz/steps/pipe_steps.hpp"
#include "io/fail.hpp"

namespace touchstone::fuzz {
namespace {

using nlohmann::json;

static_assert(static_cast<int>(Metric::euclidean) == TOUCHSTONE_METRIC_EUCLIDEAN);
static_assert(static_cast<int>(Metric::max) == TOUCHSTONE_METRIC_MAX);

const std::string kFault = "fault: ";  // begins a line that is no reply

using Ask = decltype(&touchstone_ask_step);

/// Ends the child. The parent reads the reason as its last words.
[[noreturn]] void end_child(const std::string& reason) {
  std::fprintf(stderr, "%s\n", reason.c_str());
  std::fflush(stderr);
  ::_exit(1);
}

Ask load_function(const std::string& path) {
  void* library = nullptr;
  std::string fault;
  const auto ask = reinterpret_cast<Ask>(load_plugin_function(path, "touchstone_ask_step", library, fault));
  if (ask == nullptr) end_child(fault);
  return ask;
}

/// The numbers of a list of rows, or of a list.
template <class Number>
std::vector<Number> numbers_of(const json& line, const char* key) {
  std::vector<Number> numbers;
  if (!line.contains(key)) return numbers;
  for (const json& row : line[key]) {
    if (!row.is_array()) {
      numbers.push_back(row.get<Number>());
    } else {
      for (const json& number : row) numbers.push_back(number.get<Number>());
    }
  }
  return numbers;
}

/// What the library says, with its candidates.
struct PluginReply : touchstone_step_reply {
  std::vector<std::pair<int, std::array<std::uint32_t, 2>>> candidates;

  PluginReply() : touchstone_step_reply{} {
    free = first_contact = std::numeric_limits<double>::quiet_NaN();
    add_candidate = [](touchstone_step_reply* reply, int kind, std::uint32_t first, std::uint32_t second) {
      static_cast<PluginReply*>(reply)->candidates.push_back({kind, {first, second}});
    };
  }

  /// What is no reply, in words for the author of a library; empty for a reply.
  std::string fault() const {
    if (std::isnan(free) && std::isnan(first_contact) && has_candidates == 0) {
      return "it says nothing: neither free, nor first_contact, nor has_candidates";
    }
    if (has_candidates == 0 && !candidates.empty()) return "it adds candidates, and has_candidates is 0";
    if (std::isinf(free) || first_contact == -std::numeric_limits<double>::infinity()) return "a time is infinite";
    for (const auto& [kind, elements] : candidates) {
      if (kind < 0 || kind > TOUCHSTONE_KIND_POINT_POINT) {
        return "it adds a candidate of the kind " + std::to_string(kind) + ", which is none of touchstone_kind";
      }
    }
    return {};
  }

  /// As a program writes it.
  std::string line() const {
    if (const std::string wrong = fault(); !wrong.empty()) return kFault + wrong + "\n";
    std::string text;
    const auto key = [&text](const char* name) {
      text.append(text.empty() ? "{\"" : ",\"").append(name).append("\":");
    };
    const auto number = [&](const char* name, double value) {
      if (std::isnan(value)) return;
      key(name);
      if (std::isfinite(value)) {
        append_json(text, value);
      } else {
        text.append("null");
      }
    };
    number("free", free);
    number("first_contact", first_contact);
    if (has_candidates != 0) {
      key("candidates");
      const char* before = "[";
      for (const auto& [kind, elements] : candidates) {
        text.append(std::exchange(before, ",")).append("[\"").append(name_of(static_cast<Kind>(kind))).append("\",");
        append_json(text, elements[0]);
        append_json(text.append(","), elements[1]);
        text.append("]");
      }
      text.append(candidates.empty() ? "[]" : "]");
    }
    return text + "}\n";
  }
};

std::string reply_of(Ask ask, std::string_view text) {
  const json line = json::parse(text);
  const auto start = numbers_of<double>(line, "x0"), end = numbers_of<double>(line, "x1");
  const auto edges = numbers_of<std::uint32_t>(line, "edges"), faces = numbers_of<std::uint32_t>(line, "faces"),
             points = numbers_of<std::uint32_t>(line, "points"), groups = numbers_of<std::uint32_t>(line, "groups"),
             ignored = numbers_of<std::uint32_t>(line, "ignored_groups");
  const auto count = [](std::size_t numbers) { return static_cast<std::uint32_t>(numbers); };
  touchstone_step step{};
  step.vertices = line["vertices"].get<std::uint32_t>();
  step.edges = count(edges.size() / 2);
  step.faces = count(faces.size() / 3);
  step.points = count(points.size());
  step.start = start.data();
  step.end = end.data();
  step.edge_vertices = edges.data();
  step.face_vertices = faces.data();
  step.point_vertices = points.data();
  step.groups = groups.empty() ? nullptr : groups.data();
  step.ignored = count(ignored.size() / 2);
  step.ignored_groups = ignored.data();
  step.separation = line["separation"].get<double>();
  step.metric = static_cast<int>(from_name<Metric>(line["metric"].get<std::string>()).value());
  PluginReply reply;
  const int status = ask(&step, &reply);
  if (status != 0) end_child("its touchstone_ask_step returned " + std::to_string(status));
  return reply.line();
}

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno != EINTR) ::_exit(1);
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// Our ends of the pipes, which the library does not find at its standard input and output.
struct KeptApart {
  int steps, replies;

  KeptApart() : steps(moved(STDIN_FILENO, O_RDONLY)), replies(moved(STDOUT_FILENO, O_WRONLY)) {}

 private:
  static int moved(int from, int mode) {
    constexpr int kOutOfTheWay = 100;
    const int kept = ::fcntl(from, F_DUPFD_CLOEXEC, kOutOfTheWay), nowhere = ::open("/dev/null", mode);
    if (kept < 0 || nowhere < 0 || ::dup2(nowhere, from) < 0) end_child("its input and output cannot be kept apart");
    ::close(nowhere);
    return kept;
  }
};

/// In the child.
void serve_steps(const std::string& path) {
  leave_at_exit();
  const KeptApart pipes;
  const Ask ask = load_function(path);
  std::FILE* const steps = ::fdopen(pipes.steps, "r");
  char* line = nullptr;
  std::size_t size = 0;
  for (ssize_t count; steps != nullptr && (count = ::getline(&line, &size, steps)) > 0;) {
    write_all(pipes.replies, reply_of(ask, {line, static_cast<std::size_t>(count)}));
  }
}

}  // namespace

StepSolver run_step_plugin(const std::string& path, const Limits& limits) {
  const std::string file = plugin_file(path);
  const std::function<void()> try_it = [&] {
    leave_at_exit();
    const KeptApart pipes;
    load_function(file);
    write_all(pipes.replies, "loaded");
  };
  try {
    if (PipeRun(try_it, limits).read_all(limits.start, limits.line).empty()) throw Error("it ends while it is loaded");
  } catch (const Error& reason) {
    io::fail(path, std::string("the plugin cannot be used: ") + reason.what());
  }
  const auto start = [=] { return std::make_unique<PipeRun>([file] { serve_steps(file); }, limits); };
  const auto read = [](std::string_view line) {
    if (line.starts_with(kFault)) throw NoReply(FuzzFailure::malformed, std::string(line.substr(kFault.size())));
    return read_step_reply(line);
  };
  return ask_program(start, limits, step_line, read);
}

}  // namespace touchstone::fuzz
