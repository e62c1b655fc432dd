// SPDX-License-Identifier: MIT
#include "fuzz/auditing/description.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include <touchstone/error.hpp>

#include "fuzz/processes/pipe_run.hpp"
#include "io/fail.hpp"
#include "io/times.hpp"

namespace touchstone::fuzz {
namespace {

// A few dozen units in the last place, relative to the greatest coordinate, for the roundings of one answer.
constexpr double kRoundingOfFloats = 0x1p-19, kRoundingOfDoubles = 0x1p-48;
// The same of a time, which lies in [0, 1].
constexpr double kRoundingOfFloatTimes = 0x1p-21, kRoundingOfTimes = 0x1p-50;

/// The first word of `text`, which is left with the rest.
std::string_view take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

std::optional<double> size(std::string_view text) {
  const auto value = io::parse_finite_double(text);
  return value && *value >= 0 ? value : std::nullopt;
}

bool set_size(double& target, std::string_view text) {
  const auto value = size(text);
  if (value) target = *value;
  return value.has_value();
}

bool set_motion(Claims& claims, std::string_view text) {
  static const std::map<std::string_view, ClaimedMotion> names{{"straight", ClaimedMotion::straight},
                                                               {"translations", ClaimedMotion::translations},
                                                               {"cast", ClaimedMotion::cast},
                                                               {"still", ClaimedMotion::still}};
  const auto found = names.find(text);
  if (found != names.end()) claims.motion = found->second;
  return found != names.end();
}

bool set_kinds(std::vector<Kind>& kinds, std::string_view text) {
  kinds.clear();
  while (!text.empty()) {
    const auto kind = from_name<Kind>(take_word(text));
    if (!kind || std::find(kinds.begin(), kinds.end(), *kind) != kinds.end()) return false;
    kinds.push_back(*kind);
  }
  return !kinds.empty();
}

bool set_sizes(Claims& claims, std::string_view text) {
  const auto least = size(take_word(text)), greatest = size(text);
  // A power of two times any number lies between them.
  if (!least || !greatest || *greatest < 2 * *least || *greatest == 0) return false;
  claims.least = *least;
  claims.greatest = *greatest;
  return true;
}

/// A question while its lines are read.
struct Draft {
  EngineQuestion question;
  bool moves = false;  ///< it has said how
  bool tolerance = false;
};

using Setter = std::function<bool(Draft&, std::string_view)>;

/// The lines of a question by their first word. Each says whether it could read the rest.
const std::map<std::string_view, Setter>& setters() {
  const auto text = [](std::string EngineQuestion::*member) {
    return [member](Draft& d, std::string_view rest) {
      d.question.*member = rest;
      return !rest.empty();
    };
  };
  const auto word = [](bool Claims::*member, std::string_view plain, std::string_view set) {
    return [member, plain, set](Draft& d, std::string_view rest) {
      d.question.claims.*member = rest == set;
      return rest == plain || rest == set;
    };
  };
  const auto tolerance = [](double EngineTolerance::*member) {
    return [member](Draft& d, std::string_view rest) {
      d.tolerance = true;
      return set_size(d.question.tolerance.*member, rest);
    };
  };
  static const std::map<std::string_view, Setter> all{
      {"engine", text(&EngineQuestion::engine)},
      {"asks", text(&EngineQuestion::asks)},
      {"note",
       [](Draft& d, std::string_view rest) {
         d.question.notes.emplace_back(rest);
         return !rest.empty();
       }},
      {"kinds", [](Draft& d, std::string_view rest) { return set_kinds(d.question.kinds, rest); }},
      {"motion",
       [](Draft& d, std::string_view rest) {
         d.moves = true;
         return set_motion(d.question.claims, rest);
       }},
      {"space", word(&Claims::in_plane, "3", "2")},
      {"numbers", word(&Claims::floats, "double", "float")},
      {"starts", word(&Claims::starts_apart, "anywhere", "apart")},
      {"elements", [](Draft& d, std::string_view rest) { return set_size(d.question.claims.least_element, rest); }},
      {"sizes", [](Draft& d, std::string_view rest) { return set_sizes(d.question.claims, rest); }},
      {"separation", [](Draft& d, std::string_view rest) { return set_size(d.question.separation, rest); }},
      {"tolerance-length", tolerance(&EngineTolerance::length)},
      {"tolerance-relative", tolerance(&EngineTolerance::relative)},
      {"tolerance-time", tolerance(&EngineTolerance::time)}};
  return all;
}

bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= 40 &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos && text[0] != '-';
}

EngineQuestion finished(Draft draft) {
  EngineQuestion& q = draft.question;
  const auto require = [&q](bool said, const char* line) {
    if (!said) throw Error("its question " + q.name + " has no line '" + line + "'");
  };
  require(!q.engine.empty(), "engine");
  require(!q.asks.empty(), "asks");
  require(!q.kinds.empty(), "kinds");
  require(draft.moves, "motion");
  require(!q.claims.floats || q.claims.least > 0, "sizes, which single precision needs");
  q.tolerance.time = std::max(q.tolerance.time, q.claims.floats ? kRoundingOfFloatTimes : kRoundingOfTimes);
  if (!draft.tolerance) q.tolerance.relative = q.claims.floats ? kRoundingOfFloats : kRoundingOfDoubles;
  return std::move(q);
}

}  // namespace

std::vector<EngineQuestion> parse_description(std::string_view text) {
  std::vector<EngineQuestion> questions;
  std::optional<Draft> draft;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty()) continue;
    const std::string_view whole = line, word = take_word(line);
    const auto refuse = [&](const std::string& why) { throw Error("its line " + io::in_quotes(whole) + " " + why); };
    if (word == "question") {
      if (!is_name(line)) refuse("must name a question with at most 40 small letters, digits and -");
      if (draft) questions.push_back(finished(std::move(*draft)));
      draft.emplace();
      draft->question.name = line;
      for (const EngineQuestion& before : questions) {
        if (before.name == line) refuse("names a question that was described before");
      }
      continue;
    }
    if (!draft) refuse("comes before the first line 'question NAME'");
    const auto setter = setters().find(word);
    if (setter == setters().end()) refuse("is none that a description has (docs/audit.md lists them)");
    if (!setter->second(*draft, line)) refuse("has a value that cannot be (docs/audit.md lists them)");
  }
  if (draft) questions.push_back(finished(std::move(*draft)));
  if (questions.empty()) throw Error("it describes no question");
  return questions;
}

std::vector<EngineQuestion> describe_engine(const std::string& command) {
  Limits limits;
  limits.memory = 0;
  constexpr std::size_t kLongest = 1 << 16;
  PipeRun run(command + " --describe", limits);
  const std::string text = run.read_all(limits.start, kLongest);
  return parse_description(text);
}

}  // namespace touchstone::fuzz
