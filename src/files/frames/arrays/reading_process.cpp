// SPDX-License-Identifier: MIT
#include "frames/arrays/reading_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <utility>

#include <touchstone/error.hpp>

#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

enum class What : std::uint64_t { value, error, no_memory };

struct ReplyHeader {
  What what = What::value;
  std::uint64_t size = 0;  ///< of the bytes that follow
};

#ifdef MSG_NOSIGNAL
constexpr int kNoSignal = MSG_NOSIGNAL;  // the other end may be gone
#else
constexpr int kNoSignal = 0;
#endif

bool send_all(int descriptor, const void* from, std::size_t size) {
  const char* at = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t count = ::send(descriptor, at, size, kNoSignal);
    if (count < 0 && errno != EINTR) return false;
    at += std::max<ssize_t>(count, 0);
    size -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  }
  return true;
}

void send_reply(int descriptor, What what, const void* from, std::size_t size) {
  const ReplyHeader header{what, size};
  if (!send_all(descriptor, &header, sizeof header) || !send_all(descriptor, from, size)) ::_exit(1);
}

/// @returns whether all bytes came. @param checkpoint  called before every read, and when a signal breaks one off
bool receive_all(int descriptor, void* to, std::size_t size, io::InputFile::Checkpoint checkpoint) {
  char* at = static_cast<char*>(to);
  while (size > 0) {
    if (checkpoint != nullptr) checkpoint();
    const ssize_t count = ::recv(descriptor, at, size, 0);
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    at += std::max<ssize_t>(count, 0);
    size -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  }
  return true;
}

/// A crash is an answer here: it leaves no core file and no words, and no handler of the parent's looks at it.
void prepare_for_crashes([[maybe_unused]] pid_t parent) {
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(signal, SIG_DFL);
  const int null = ::open("/dev/null", O_WRONLY);
  if (null >= 0) ::dup2(null, STDERR_FILENO);
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it ended before it could be watched
#endif
}

}  // namespace

bool ReadingProcess::Line::next_request(void* to, std::size_t size) const {
  return receive_all(descriptor_, to, size, nullptr);
}

void ReadingProcess::Line::reply(const void* from, std::size_t size) const {
  send_reply(descriptor_, What::value, from, size);
}

ReadingProcess::ReadingProcess(std::string file, std::string library, io::InputFile::Checkpoint checkpoint,
                               const std::function<void(const Line&)>& serve)
    : file_(std::move(file)), library_(std::move(library)), checkpoint_(checkpoint) {
  const auto no_process = [this](int error) {
    io::fail(file_, "cannot be read: no process can be started for " + library_ + ": " + io::system_reason(error));
  };
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) no_process(errno);
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  const pid_t parent = ::getpid();
  child_ = ::fork();
  const int error = errno;
  if (child_ == 0) {
    prepare_for_crashes(parent);
    ::close(ends[0]);
    try {
      serve(Line(ends[1]));
    } catch (const std::bad_alloc&) {
      send_reply(ends[1], What::no_memory, nullptr, 0);
    } catch (const std::exception& problem) {
      send_reply(ends[1], What::error, problem.what(), std::strlen(problem.what()));
    }
    ::_exit(0);  // neither flushes nor destroys the parent's objects a second time
  }
  ::close(ends[1]);
  descriptor_ = ends[0];
  if (child_ > 0) return;
  ::close(descriptor_);
  no_process(error);
}

ReadingProcess::~ReadingProcess() {
  ::close(descriptor_);
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) continue;
}

void ReadingProcess::request(const void* from, std::size_t size) {
  if (!send_all(descriptor_, from, size)) fail_at_end();
}

void ReadingProcess::take(void* to, std::size_t size) {
  ReplyHeader header;
  receive(&header, sizeof header);
  if (header.what == What::no_memory) throw std::bad_alloc();
  if (header.what == What::error && header.size <= std::size_t{1} << 20) {
    std::string words(header.size, '\0');
    receive(words.data(), words.size());
    throw FileError(words);
  }
  if (header.what != What::value || header.size != size) io::fail(file_, library_ + " gives another number of values");
  receive(to, size);
}

void ReadingProcess::receive(void* to, std::size_t size) {
  if (!receive_all(descriptor_, to, size, checkpoint_)) fail_at_end();
}

void ReadingProcess::fail_at_end() {
  int status = 0;
  pid_t waited = 0;
  do {
    waited = ::waitpid(child_, &status, 0);
  } while (waited < 0 && errno == EINTR);
  child_ = -1;
  if (waited > 0 && WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const char* const words = ::strsignal(signal);
    const std::string text = "signal " + std::to_string(signal) + (words == nullptr ? "" : std::string(", ") + words);
    if (signal == SIGKILL) io::fail(file_, "cannot be read: the process that reads it was killed (" + text + ")");
    io::fail(file_, library_ + " crashed on this file (" + text + "); the file is damaged, or the library has a fault");
  }
  io::fail(file_, "cannot be read: the process that reads it ended before it was done");
}

}  // namespace touchstone::frames
