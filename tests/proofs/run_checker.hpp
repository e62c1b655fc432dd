// Runs the checker of proofs on texts.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/temporary_folder.hpp"

namespace touchstone::tests {

/// The exit status of the checker, and what it prints.
struct CheckerRun {
  int status = -1;
  std::string text;
};

/// Runs the checker with these words of a shell, and at most 512 MiB of memory; without that limit under the address
/// sanitizer, which reserves more than there is.
inline CheckerRun run_checker(const std::string& words) {
#ifdef __SANITIZE_ADDRESS__
  const std::string limit;
#else
  const std::string limit = "ulimit -v 524288; ";
#endif
  const std::string command = limit + "exec " + std::string(TOUCHSTONE_CHECKER) + " " + words + " 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("the checker cannot be run");
  CheckerRun result;
  std::array<char, 4096> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) result.text += buffer.data();
  const int status = pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// Checks a text of proofs against texts of query files or motion files.
/// @param options  the words before the names
inline CheckerRun check_texts(const std::string& proofs, const std::vector<std::string>& files,
                              const std::string& options = "--allow-empty") {
  const TemporaryFolder folder;
  std::string words = options + " " + folder.write("proofs.txt", proofs);
  for (std::size_t i = 0; i < files.size(); ++i) {
    words += ' ';
    words += folder.write(std::string("file").append(std::to_string(i)), files[i]);
  }
  return run_checker(words);
}

}  // namespace touchstone::tests
