// SPDX-License-Identifier: MIT
#include "fuzz/processes/supervisor.hpp"

#ifdef __linux__

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "fuzz/processes/child_process.hpp"

namespace touchstone::fuzz {
namespace {

constexpr int kCannotStart = 126;

/// SIGKILL to every child that the process has now.
void kill_children() {
  const int file = ::open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  std::array<char, 4096> text;  // numbers, each with a blank after it; the last may be cut, and comes next time
  const ssize_t count = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  if (count <= 0) return;
  text[static_cast<std::size_t>(count)] = '\0';
  const char* at = text.data();
  for (char* end = nullptr;; at = end + 1) {
    const long number = std::strtol(at, &end, 10);
    if (end == at || *end != ' ') return;
    ::kill(static_cast<pid_t>(number), SIGKILL);
  }
}

/// Kills and reaps all descendants; those of a killed process become children here, and are found the next time. Notes
/// how `solver` ends, which nobody has reaped so far.
void end_descendants(pid_t solver, int& solver_status) {
  // First its group, which needs no list of children: /proc may be missing, or have none.
  ::kill(-solver, SIGKILL);
  ::kill(solver, SIGKILL);
  constexpr int kRounds = 2000;  // a millisecond each: a process that cannot be killed is not waited for for ever
  for (int round = 0; round < kRounds; ++round) {
    int status = 0;
    pid_t reaped = 0;
    while ((reaped = ::waitpid(-1, &status, WNOHANG)) > 0) {
      if (reaped == solver) solver_status = status;
    }
    if (reaped < 0) return;  // there is none
    kill_children();
    constexpr timespec kPause{0, 1'000'000};
    ::nanosleep(&kPause, nullptr);
  }
}

/// Waits until the solver has ended or SIGTERM comes. The solver is not reaped: its number, which is its group's too,
/// remains its own.
void wait_for_end(pid_t solver) {
  sigset_t awaited;
  ::sigemptyset(&awaited);
  ::sigaddset(&awaited, SIGCHLD);
  ::sigaddset(&awaited, SIGTERM);
  for (;;) {
    for (;;) {
      siginfo_t ended{};
      if (::waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == 0) break;
      if (ended.si_pid == solver) return;
      ::waitpid(ended.si_pid, nullptr, WNOHANG);
    }
    if (::sigwaitinfo(&awaited, nullptr) == SIGTERM) return;
  }
}

/// Ends this process as the solver has ended, so that our parent sees that.
[[noreturn]] void end_as(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::signal(signal, SIG_DFL);
    sigset_t one;
    ::sigemptyset(&one);
    ::sigaddset(&one, signal);
    ::sigprocmask(SIG_UNBLOCK, &one, nullptr);
    ::kill(::getpid(), signal);
  }
  ::_exit(WIFEXITED(status) ? WEXITSTATUS(status) : kCannotStart);
}

}  // namespace

void supervise(pid_t parent) {
  ::setsid();
  ::signal(SIGCHLD, SIG_DFL);  // where it is ignored, nobody can be waited for
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  if (::getppid() != parent) ::_exit(kCannotStart);  // it died before it could be watched
  const pid_t supervisor = ::getpid();
  const pid_t solver = ::fork();
  if (solver == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != supervisor) ::_exit(kCannotStart);
    return;
  }
  if (solver < 0) ::_exit(kCannotStart);
  close_from(0);         // an end of a pipe that stays open here would look like the solver's
  int status = SIGKILL;  // as waitpid tells of a process that was killed
  wait_for_end(solver);
  end_descendants(solver, status);
  end_as(status);
}

}  // namespace touchstone::fuzz

#else

namespace touchstone::fuzz {

void supervise(pid_t) {}

}  // namespace touchstone::fuzz

#endif
