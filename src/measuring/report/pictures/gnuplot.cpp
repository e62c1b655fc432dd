// SPDX-License-Identifier: MIT
#include "report/pictures/gnuplot.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>

#include <touchstone/error.hpp>

#include "io/fail.hpp"
#include "report/pictures/find_program.hpp"

namespace touchstone::report {

std::optional<std::string> find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    const auto program = std::filesystem::absolute(folder.empty() ? "." : folder, ignored) / name;
    if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0) {
      return program.string();
    }
  }
  return std::nullopt;
}

std::optional<std::string> find_gnuplot() { return find_program("gnuplot"); }

namespace {

/// The last line that is not blank.
std::string last_words(std::string_view text) {
  std::string last;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.find_first_not_of(" \t\r^") != std::string_view::npos) last = line;
  }
  return io::printable(last.substr(0, 200));
}

/// Everything until the other end is closed; only its end when it is long.
std::string read_all(int descriptor) {
  constexpr std::size_t kKept = 4096;
  std::string text;
  std::array<char, 4096> block;
  for (;;) {
    const ssize_t count = ::read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(count));
    if (text.size() > kKept) text.erase(0, text.size() - kKept);
  }
}

}  // namespace

void run_gnuplot(const std::string& gnuplot, const std::string& folder, const std::string& script) {
  // After the fork of a program with threads only some calls are safe; the arguments are therefore made before it.
  std::string program = gnuplot, option = "-d", argument = script;
  char* const words[] = {program.data(), option.data(), argument.data(), nullptr};
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw Error("gnuplot cannot be started: " + io::system_reason(errno));
  const pid_t child = ::fork();
  if (child < 0) {
    const int reason = errno;
    for (const int end : ends) ::close(end);
    throw Error("gnuplot cannot be started: " + io::system_reason(reason));
  }
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::dup2(ends[1], STDERR_FILENO);
    for (const int end : ends) ::close(end);
    if (::chdir(folder.c_str()) == 0) ::execv(words[0], words);
    ::_exit(127);
  }
  ::close(ends[1]);
  const std::string said = last_words(read_all(ends[0]));
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw Error("gnuplot cannot be waited for: " + io::system_reason(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw Error(gnuplot + " failed on " + script + (said.empty() ? "" : ": " + said));
  }
}

}  // namespace touchstone::report
