// SPDX-License-Identifier: MIT
#include "cli/shared/progress/interrupt.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <initializer_list>

namespace touchstone::cli {
namespace {

volatile std::sig_atomic_t noted_signal = 0;
std::atomic<bool> has_signal = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // so that a signal handler may set it

void note(int signal) {
  noted_signal = signal;
  has_signal = true;
}

}  // namespace

void watch_for_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN)
      continue;  // nohup, or a shell's background job
    struct sigaction action {};
    action.sa_handler = note;  // and no SA_RESTART: a read that waits for a pipe must end, too
    ::sigaction(signal, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void occupy_closed_descriptors() {
  // The next file that is opened would take the number of a closed standard stream, and output for the stream would go
  // into that file. A descriptor that is open for reading only refuses writes, as the closed stream would.
  for (;;) {
    const int descriptor = ::open("/dev/null", O_RDONLY);
    if (descriptor > STDERR_FILENO) ::close(descriptor);
    if (descriptor < 0 || descriptor > STDERR_FILENO) return;
  }
}

bool interrupted() noexcept { return has_signal; }

const std::atomic<bool>& interruption() noexcept { return has_signal; }

void throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

void end_by_signal() { end_by_signal(noted_signal); }

void end_by_signal(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  std::_Exit(2);
}

}  // namespace touchstone::cli
