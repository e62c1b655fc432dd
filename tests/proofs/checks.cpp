// touchstone-check again and again in one process, for mutate_proofs.py: a process for each of a million mutants costs
// more than the checks. A line of the input holds the arguments, with tabs between them; a line of the output is the
// exit status.
// SPDX-License-Identifier: MIT
#define main check_once
#include "checker/checker.cpp"
#undef main

#include <unistd.h>

#include <iostream>

int main(int, char** argv) {
  std::FILE* const answers = fdopen(dup(STDOUT_FILENO), "w");  // the checks speak into the void
  if (answers == nullptr || std::freopen("/dev/null", "w", stdout) == nullptr ||
      std::freopen("/dev/null", "w", stderr) == nullptr) {
    return 2;
  }
  for (std::string line; std::getline(std::cin, line);) {
    std::vector<char*> arguments = {argv[0], line.data()};
    for (char& c : line) {
      if (c != '\t') continue;
      c = '\0';
      arguments.push_back(&c + 1);
    }
    arguments.push_back(nullptr);
    const int status = check_once(static_cast<int>(arguments.size()) - 1, arguments.data());
    if (std::fprintf(answers, "%d\n", status) < 0 || std::fflush(answers) != 0) return 2;
  }
  return 0;
}
