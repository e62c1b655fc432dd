// SPDX-License-Identifier: MIT
#include "engine.hpp"

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string_view>

namespace engine {
namespace {

/// The query in a line; its kind is empty when the line is none.
Query read_query(const std::string& line) {
  Query query;
  const std::size_t blank = line.find(' ');
  query.kind = line.substr(0, blank);
  const std::size_t corners = query.kind == "point-point" ? 2 : query.kind == "point-edge" ? 3 : 4;
  const char* at = blank == std::string::npos ? "" : line.c_str() + blank;
  for (auto* const points : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corners; ++i) {
      Point point{};
      for (double& x : point) {
        char* next = nullptr;
        x = std::strtod(at, &next);
        if (next == at) return {};
        at = next;
      }
      points->push_back(point);
    }
  }
  return query;
}

/// Whether the description has `kind` among its kinds.
bool takes(const Question& question, const std::string& kind) {
  std::istringstream lines(question.description);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("kinds ", 0) == 0) return (line + ' ').find(' ' + kind + ' ') != std::string::npos;
  }
  return false;
}

int answer_queries(const Question& question) {
  for (std::string line; std::getline(std::cin, line);) {
    if (line.rfind("separation ", 0) == 0) {
      // The audit tells the distance that the question itself has described.
      std::puts(question.description.find("\nseparation ") != std::string::npos ? "ok" : "unsupported");
    } else if (const Query query = read_query(line); query.kind.empty() || !takes(question, query.kind)) {
      std::puts("unsupported");
    } else if (const Answer answer = question.ask(query); !answer.known) {
      std::puts("unknown");
    } else if (answer.contact && answer.time) {
      std::printf("1 %a\n", *answer.time);
    } else {
      std::puts(answer.contact ? "1" : "0");
    }
    if (std::fflush(stdout) != 0) return 1;
  }
  return 0;
}

}  // namespace

int serve(int argc, char** argv, const std::vector<Question>& questions) {
  const std::string_view wanted = argc == 2 ? argv[1] : "";
  if (wanted == "--describe") {
    for (const Question& question : questions) {
      std::printf("question %s\n%s", question.name.c_str(), question.description.c_str());
    }
    return 0;
  }
  for (const Question& question : questions) {
    if (question.name == wanted) return answer_queries(question);
  }
  std::fprintf(stderr, "usage: %s --describe, or one of its questions:", argv[0]);
  for (const Question& question : questions) std::fprintf(stderr, " %s", question.name.c_str());
  std::fputs("\n", stderr);
  return 2;
}

}  // namespace engine
