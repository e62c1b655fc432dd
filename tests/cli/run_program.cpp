// SPDX-License-Identifier: MIT
#include "cli/run_program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace touchstone::tests {
namespace {

int open_for_writing(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
  if (descriptor < 0) throw std::runtime_error("cannot write " + path);
  return descriptor;
}

int closed_pipe() {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  ::close(ends[0]);
  return ends[1];
}

/// Waits until a program has set its own answer to SIGINT, for a minute at most: before that, the signal's time would
/// say how busy the machine is. Where there is no /proc, nothing is waited for.
void wait_for_its_handler(pid_t program) {
  for (int i = 0; i < 6000; ++i) {
    std::ifstream facts("/proc/" + std::to_string(program) + "/status");
    std::string word;
    while (facts >> word && word != "SigCgt:") {
      if (word == "State:" && facts >> word && word == "Z") return;  // it has ended
    }
    std::uint64_t caught = 0;
    if (!(facts >> std::hex >> caught) || (caught >> (SIGINT - 1) & 1) != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace

Run run_program(const std::vector<std::string>& arguments, const RunOptions& options) {
  const TemporaryFolder folder;
  const std::string out = options.standard_output.empty() ? folder.path("out") : options.standard_output;
  const int out_descriptor = options.closed_pipe ? closed_pipe() : open_for_writing(out);
  const int err_descriptor = open_for_writing(folder.path("err"));

  std::vector<std::string> words = {options.program.empty() ? TOUCHSTONE_PROGRAM : options.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  int started[2];  // closed by the exec: until then the process has the handlers of the tests
  if (::pipe2(started, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    if (options.own_group && ::setpgid(0, 0) != 0) ::_exit(126);
    if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) ::_exit(126);
    if (options.address_space > 0) {
      const rlimit limit{options.address_space, options.address_space};
      if (::setrlimit(RLIMIT_AS, &limit) != 0) ::_exit(126);
    }
    if (options.file_size > 0) {
      const rlimit limit{options.file_size, options.file_size};
      if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(126);
    }
    if (!options.standard_input.empty()) {
      const int in_descriptor = ::open(options.standard_input.c_str(), O_RDONLY);
      if (in_descriptor < 0 || ::dup2(in_descriptor, STDIN_FILENO) < 0) ::_exit(126);
    }
    ::dup2(out_descriptor, STDOUT_FILENO);
    ::dup2(err_descriptor, STDERR_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  ::close(out_descriptor);
  ::close(err_descriptor);
  ::close(started[1]);
  char byte = 0;
  (void)!::read(started[0], &byte, 1);
  ::close(started[0]);
  if (child < 0) throw std::runtime_error("cannot fork");
  if (options.interrupt_after > 0) {
    wait_for_its_handler(child);
    std::this_thread::sleep_for(std::chrono::duration<double>(options.interrupt_after));
    ::kill(options.own_group ? -child : child, SIGINT);
  }
  if (options.kill_after > 0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(options.kill_after));
    ::kill(child, SIGKILL);
  }
  int status = 0;
  struct rusage usage {};
  if (::wait4(child, &status, 0, &usage) != child) throw std::runtime_error("cannot wait");
  Run run;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (options.standard_output.empty() && !options.closed_pipe) run.out = folder.read("out");
  run.err = folder.read("err");
  run.peak_kilobytes = usage.ru_maxrss;
  return run;
}

Run run_here(const std::function<int()>& command) {
  const TemporaryFolder folder;
  const int saved = ::dup(STDOUT_FILENO);
  const int captured = open_for_writing(folder.path("out"));
  ::dup2(captured, STDOUT_FILENO);
  ::close(captured);
  const auto restore = [&] {
    ::dup2(saved, STDOUT_FILENO);
    ::close(saved);
  };
  Run run;
  try {
    run.status = command();
  } catch (...) {
    restore();
    throw;
  }
  restore();
  run.out = folder.read("out");
  return run;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

}  // namespace touchstone::tests
