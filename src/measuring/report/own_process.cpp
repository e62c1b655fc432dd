// SPDX-License-Identifier: MIT
#include "report/own_process.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <string>

#include <touchstone/error.hpp>

#include "io/fail.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace touchstone::report {
namespace {

/// The header that comes through the pipe before the result, or before the message of an exception.
struct Header {
  bool done = false;
  long resident_before = -1;  ///< bytes; -1: not known
  std::size_t length = 0;     ///< of the bytes that follow
};

/// Bytes, or -1 when the system does not report it.
long resident_now() {
  std::ifstream pages("/proc/self/statm");
  long all = 0, resident = 0;
  return pages >> all >> resident ? resident * ::sysconf(_SC_PAGESIZE) : -1;
}

/// Memory that was freed but that the allocator keeps would be used again, and the process would not grow.
void give_back_free_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

/// From now on the process's peak is counted, where Linux does so: the child of a large process begins with its peak.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

bool write_all(int descriptor, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(descriptor, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool read_all(int descriptor, void* data, std::size_t size) {
  char* at = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = ::read(descriptor, at, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

[[noreturn]] void be_the_child(int pipe, const std::function<void()>& prepare, const std::function<void()>& work,
                               const void* result, std::size_t size) {
  Header header;
  std::string words;
  try {
    prepare();
    give_back_free_memory();
    forget_peak();
    header.resident_before = resident_now();
    work();
    header.done = true;
    header.length = size;
  } catch (const std::exception& error) {
    words = error.what();
    header.length = words.size();
  }
  const bool told =
      write_all(pipe, &header, sizeof header) && write_all(pipe, header.done ? result : words.data(), header.length);
  ::_exit(told ? 0 : 1);  // neither flushes nor destroys the parent's objects a second time
}

}  // namespace

std::optional<std::uint64_t> run_in_own_process(const std::function<void()>& prepare, const std::function<void()>& work,
                                                void* result, std::size_t size) {
  int ends[2];
  if (::pipe(ends) != 0) throw Error("a process cannot be started: " + io::system_reason(errno));
  const pid_t child = ::fork();
  const int reason = errno;
  if (child == 0) {
    ::close(ends[0]);
    be_the_child(ends[1], prepare, work, result, size);
  }
  ::close(ends[1]);
  Header header;
  std::string words;
  bool told = child > 0 && read_all(ends[0], &header, sizeof header);
  if (told && header.done) told = read_all(ends[0], result, size);
  if (told && !header.done) {
    words.resize(header.length);
    told = read_all(ends[0], words.data(), words.size());
  }
  ::close(ends[0]);
  if (child < 0) throw Error("a process cannot be started: " + io::system_reason(reason));

  int status = 0;
  struct rusage usage {};
  while (::wait4(child, &status, 0, &usage) < 0) {
    if (errno != EINTR) throw Error("a process cannot be waited for: " + io::system_reason(errno));
  }
  if (!told && WIFSIGNALED(status)) throw Error(std::string("a process was ended by ") + ::strsignal(WTERMSIG(status)));
  if (!told) throw Error("a process ended before its work was done");
  if (!header.done) throw Error(words);
  if (header.resident_before < 0) return std::nullopt;
  // On systems with /proc/self/statm, ru_maxrss counts KB.
  const long grown = 1024 * usage.ru_maxrss - header.resident_before;
  return static_cast<std::uint64_t>(std::max(grown, 0L));
}

}  // namespace touchstone::report
