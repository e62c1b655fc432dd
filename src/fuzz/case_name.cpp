// SPDX-License-Identifier: MIT
#include "fuzz/case_name.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include <touchstone/error.hpp>

namespace touchstone::fuzz {
namespace {

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (text.empty()) return words;
    const std::size_t length = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
}

/// Stands where a family's name would.
constexpr std::string_view kGiven = "given";

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc{} || end != last) return std::nullopt;
  return number;
}

}  // namespace

std::string case_text(const CaseName& name) {
  std::string text = families::case_name(name.start);
  if (name.given) text.replace(0, text.find(' '), kGiven);
  if (name.step > 0) text += " +" + std::to_string(name.step);
  return text;
}

std::optional<CaseName> parse_case_text(std::string_view text) {
  const std::vector<std::string_view> words = words_of(text);
  if (words.size() != 4 && words.size() != 5) return std::nullopt;
  CaseName name{};
  name.given = words[0] == kGiven;
  bool family_known = name.given, kind_known = false;
  if (const families::FamilyInfo* const family = families::find_family(words[0])) {
    name.start.family = family->family;
    family_known = true;
  }
  for (const Kind kind : kKinds) {
    if (name_of(kind) != words[1]) continue;
    name.start.kind = kind;
    kind_known = true;
  }
  const auto seed = whole_number(words[2]);
  const auto index = whole_number(words[3]);
  if (!family_known || !kind_known || !seed || !index) return std::nullopt;
  name.start.seed = *seed;
  name.start.index = *index;
  if (words.size() == 5) {
    const auto step = words[4].starts_with('+') ? whole_number(words[4].substr(1)) : std::nullopt;
    if (!step || *step > kMostClimbSteps) return std::nullopt;
    name.step = *step;
  }
  return name;
}

namespace {

/// The start of a case, and the generator of its climb.
struct Start {
  Asked asked;
  families::Rng rng;
};

Start made_start(const CaseName& name, const CaseSource& source) {
  Start start{{{}, source.separation, 1}, families::rng_of(name.start)};
  if (name.given) {
    if (name.start.index >= source.given.size() || kind_of(source.given[name.start.index]) != name.start.kind) {
      throw InvalidQuery(case_text(name) + ": no such query was given");
    }
    start.asked.query = source.given[name.start.index];
  } else if (families::is_curved(name.start.family)) {
    families::CurvedSample made;
    if (source.own) {
      const families::CurvedSeparated separated =
          families::make_curved_separated(name.start.family, name.start.kind, source.separation.metric, start.rng);
      made = separated.sample;
      start.asked.separation.distance = separated.distance;
    } else {
      made = families::make_curved(name.start.family, name.start.kind, start.rng);
    }
    start.asked.query = made.query;
    start.asked.t_max = made.t_max;
  } else if (source.own) {
    const families::Separated made =
        families::make_separated(name.start.family, name.start.kind, source.separation.metric, start.rng);
    start.asked.query = made.query;
    start.asked.separation.distance = made.distance;
  } else {
    start.asked.query = families::make(name.start.family, name.start.kind, start.rng);
  }
  if (source.claims != nullptr) {
    if (auto* const straight = std::get_if<Query>(&start.asked.query))
      *straight = nearest_claimed(*straight, *source.claims);
  }
  return start;
}

}  // namespace

Asked start_of_case(const CaseName& name, const CaseSource& source) { return made_start(name, source).asked; }

Climb climb_from(const CaseName& name, const CaseSource& source) {
  const Start start = made_start(name, source);
  return Climb(start.asked.query, start.rng, start.asked.separation);
}

Asked asked_in_case(const CaseName& name, const CaseSource& source) {
  Asked asked = start_of_case(name, source);
  if (name.step == 0) return asked;
  Climb climb = climb_from(name, source);
  for (std::uint64_t i = 1; i < name.step; ++i) climb.next();
  asked.query = climb.next();
  return asked;
}

Query query_of_case(const CaseName& name, const std::vector<AnyQuery>& given) {
  return std::get<Query>(asked_in_case(name, {given}).query);
}

}  // namespace touchstone::fuzz
