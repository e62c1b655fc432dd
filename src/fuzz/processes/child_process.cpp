// SPDX-License-Identifier: MIT
#include "fuzz/processes/child_process.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/syscall.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <thread>

#include <touchstone/error.hpp>

#include "fuzz/processes/supervisor.hpp"
#include "io/fail.hpp"

namespace touchstone::fuzz {
namespace {

constexpr std::size_t kTail = 4096;

[[noreturn]] void fail(const char* what) { throw Error(std::string(what) + ": " + io::system_reason(errno)); }

// ---- in the child, between fork and the solver's code

void give_up() { ::_exit(126); }

/// Puts input, output, errors and spare at descriptors 0 to 3 and closes all others.
void arrange_descriptors(const ChildProcess::Setup& setup, int errors) {
  const int null = ::open("/dev/null", O_RDWR);
  if (null < 0) give_up();
  // First out of the way of 0 to 3, then into place.
  const std::array<int, 4> streams{setup.input < 0 ? null : setup.input, setup.output < 0 ? null : setup.output, errors,
                                   setup.spare < 0 ? null : setup.spare};
  std::array<int, 4> high{};
  for (std::size_t i = 0; i < streams.size(); ++i) {
    high[i] = ::fcntl(streams[i], F_DUPFD, 10);
    if (high[i] < 0) give_up();
  }
  for (int i = 0; i < 4; ++i) {
    if (::dup2(high[static_cast<std::size_t>(i)], i) < 0) give_up();
  }
  close_from(setup.spare < 0 ? 3 : 4);
  if (setup.spare >= 0) ::fcntl(3, F_SETFD, FD_CLOEXEC);
}

void limit_to(int resource, std::uint64_t amount) {
  rlimit limit{};
  if (::getrlimit(static_cast<decltype(RLIMIT_CORE)>(resource), &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(static_cast<rlim_t>(amount), limit.rlim_max);
  limit.rlim_max = limit.rlim_cur;
  ::setrlimit(static_cast<decltype(RLIMIT_CORE)>(resource), &limit);
}

/// Bytes of address space that the process has already; 0 where nobody tells.
std::uint64_t mapped_bytes() {
  const int file = ::open("/proc/self/statm", O_RDONLY);
  if (file < 0) return 0;
  std::array<char, 64> text{};
  const ssize_t count = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  if (count <= 0) return 0;
  return std::strtoull(text.data(), nullptr, 10) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void unblock_signals() {
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

void default_signals() {
  for (int signal = 1; signal < NSIG; ++signal) {
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    ::sigaction(signal, &action, nullptr);  // some cannot be changed, which is well
  }
}

constexpr bool kSanitized =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    true;
#else
    false;
#endif
#else
    false;
#endif

void become_child(const ChildProcess::Setup& setup, int errors, pid_t parent) {
  supervise(parent);
  ::setsid();
  if (!kSanitized) default_signals();  // sanitizers report through handlers of their own
  unblock_signals();
  arrange_descriptors(setup, errors);
  limit_to(RLIMIT_CORE, 0);
  // Sanitizers map terabytes that they never touch.
  if (!kSanitized && setup.memory > 0) limit_to(RLIMIT_AS, mapped_bytes() + setup.memory);
}

// ---- in the parent

/// Every signal is blocked in this thread as long as this lives; in a forked child, until the child changes that.
class AllSignalsBlocked {
 public:
  AllSignalsBlocked() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~AllSignalsBlocked() {
    if (::getpid() == owner_) ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  AllSignalsBlocked(const AllSignalsBlocked&) = delete;
  AllSignalsBlocked& operator=(const AllSignalsBlocked&) = delete;

 private:
  sigset_t before_{};
  pid_t owner_ = ::getpid();
};

std::string signal_text(int signal) {
  const char* const name = ::strsignal(signal);
  return "signal " + std::to_string(signal) + (name == nullptr ? "" : " (" + std::string(name) + ")");
}

}  // namespace

ChildProcess::ChildProcess(const Setup& setup, const std::function<void()>& run) {
  Pipe errors;
  set_nonblocking(errors.read);
  const pid_t parent = ::getpid();
  {
    // A signal that comes before the supervisor awaits it stays pending there, and runs no handler of ours.
    const AllSignalsBlocked blocked;
    pid_ = ::fork();
    if (pid_ == 0) become_child(setup, errors.write, parent);
  }
  if (pid_ < 0) fail("no process can be made for the solver");
  if (pid_ == 0) {
    try {
      run();
    } catch (...) {
      ::abort();
    }
    ::_exit(0);
  }
  errors_ = errors.read;
  errors.read = -1;
}

ChildProcess::~ChildProcess() {
  kill();
  ::close(errors_);
}

void ChildProcess::reap(int options) {
  // Looked at first and waited for last: as long as nobody has waited for it, its number and its group's are its own.
  siginfo_t ended{};
  int error = 0;
  do {
    error = ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOWAIT | options) == 0 ? 0 : errno;
  } while (error == EINTR);
  if (error == 0 && ended.si_pid != pid_) return;
  if (error == 0) ::kill(-pid_, SIGKILL);  // the rest of its group, where it has no supervisor
  int status = 0;
  while (error == 0 && ::waitpid(pid_, &status, 0) < 0) error = errno == EINTR ? 0 : errno;
  status_ = status;  // of a process that somebody else has waited for, nobody knows how it ended
  drain();
}

bool ChildProcess::ended() {
  if (!status_) reap(WNOHANG);
  return status_.has_value();
}

bool ChildProcess::wait_until(Clock::time_point deadline) {
  auto pause = std::chrono::microseconds(50);
  while (!ended()) {
    const auto now = Clock::now();
    if (now >= deadline) return false;
    std::this_thread::sleep_for(std::min<Clock::duration>(pause, deadline - now));
    pause = std::min(2 * pause, std::chrono::microseconds(5000));
  }
  return true;
}

void ChildProcess::kill() {
  if (ended()) return;
#ifdef __linux__
  // The supervisor ends the solver and its daemons; it cannot when the solver's code has stopped or killed it.
  constexpr auto kPatience = std::chrono::seconds(5);
  ::kill(pid_, SIGTERM);
  ::kill(pid_, SIGCONT);
  if (wait_until(Clock::now() + kPatience)) return;
#endif
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);  // before it has its own group, that is how to reach it
  if (!status_) reap(0);
}

std::string ChildProcess::story() {
  std::string text = "still running";
  if (status_) {
    text = WIFSIGNALED(*status_) ? signal_text(WTERMSIG(*status_))
                                 : "exit status " + std::to_string(WEXITSTATUS(*status_));
  }
  const std::string words = last_words();
  return words.empty() ? text : text + ": " + words;
}

void ChildProcess::drain() {
  std::array<char, kTail> bytes;
  // As much as a pipe holds and no more: a process that writes for ever must not be read for ever.
  for (int i = 0; i < 16; ++i) {
    const ssize_t count = ::read(errors_, bytes.data(), bytes.size());
    if (count == 0) errors_ended_ = true;
    if (count <= 0) return;
    tail_.append(bytes.data(), static_cast<std::size_t>(count));
    if (tail_.size() > kTail) tail_.erase(0, tail_.size() - kTail);
  }
}

std::string ChildProcess::last_words() {
  drain();
  std::string_view text = tail_;
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  if (last == std::string_view::npos) return {};
  text = text.substr(0, last + 1);
  const std::size_t line = text.find_last_of('\n');
  if (line != std::string_view::npos) text.remove_prefix(line + 1);
  return io::printable(text.substr(0, 200));
}

void leave_at_exit() {
#ifdef __GLIBC__
  ::on_exit([](int status, void*) { ::_exit(status); }, nullptr);
#else
  std::atexit([] { ::_exit(1); });
#endif
}

void close_from(int first) {
#ifdef SYS_close_range
  if (::syscall(SYS_close_range, static_cast<unsigned>(first), ~0U, 0U) == 0) return;
#endif
  rlimit limit{};
  const bool known = ::getrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  const int end = known ? static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 1 << 20)) : 1 << 16;
  for (int descriptor = first; descriptor < end; ++descriptor) ::close(descriptor);
}

Pipe::Pipe() {
  std::array<int, 2> ends{};
#ifdef __linux__
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("no pipe can be made");
#else
  if (::pipe(ends.data()) != 0) fail("no pipe can be made");
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
#endif
  read = ends[0];
  write = ends[1];
}

Pipe::~Pipe() {
  close_read();
  close_write();
}

void Pipe::close_read() noexcept {
  if (read >= 0) ::close(read);
  read = -1;
}

void Pipe::close_write() noexcept {
  if (write >= 0) ::close(write);
  write = -1;
}

void set_nonblocking(int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags < 0 || ::fcntl(descriptor, F_SETFL, flags | O_NONBLOCK) < 0) fail("a pipe cannot be set up");
}

}  // namespace touchstone::fuzz
