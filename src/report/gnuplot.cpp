// SPDX-License-Identifier: MIT
#include "report/gnuplot.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include <touchstone/error.hpp>

#include "io/fail.hpp"

namespace touchstone::report {

std::optional<std::string> find_gnuplot() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    const auto program = std::filesystem::absolute(folder.empty() ? "." : folder, ignored) / "gnuplot";
    if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) {
      return program.string();
    }
  }
  return std::nullopt;
}

void run_gnuplot(const std::string& gnuplot, const std::string& folder, const std::string& script) {
  // Nothing but calls that are safe after a fork in a program with threads: the words are made before it.
  std::string program = gnuplot, option = "-d", argument = script;
  char* const words[] = {program.data(), option.data(), argument.data(), nullptr};
  const pid_t child = ::fork();
  if (child < 0) throw Error("gnuplot cannot be started: " + io::system_reason(errno));
  if (child == 0) {
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    if (::chdir(folder.c_str()) == 0) ::execv(words[0], words);
    ::_exit(127);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw Error("gnuplot cannot be waited for: " + io::system_reason(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw Error(gnuplot + " failed on " + script + "; `cd " + folder + " && gnuplot " + script + "` shows why");
  }
}

}  // namespace touchstone::report
