// The progress line of a long command is drawn on a terminal only, and is erased at the end.
// SPDX-License-Identifier: MIT
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/progress/waiting_line.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "support/catch.hpp"

using namespace touchstone::cli;

namespace {

/// Standard error goes to `descriptor` while this lives.
class StandardErrorTo {
 public:
  explicit StandardErrorTo(int descriptor) : before_(::dup(STDERR_FILENO)) {
    std::fflush(stderr);
    if (before_ < 0 || ::dup2(descriptor, STDERR_FILENO) < 0) throw std::runtime_error("standard error stays");
  }
  ~StandardErrorTo() {
    std::fflush(stderr);
    ::dup2(before_, STDERR_FILENO);
    ::close(before_);
  }
  StandardErrorTo(const StandardErrorTo&) = delete;
  StandardErrorTo& operator=(const StandardErrorTo&) = delete;

 private:
  int before_;
};

struct Terminal {
  int ours = ::posix_openpt(O_RDWR | O_NOCTTY);
  int theirs = -1;

  Terminal() {
    if (ours < 0 || ::grantpt(ours) != 0 || ::unlockpt(ours) != 0) return;
    theirs = ::open(::ptsname(ours), O_RDWR | O_NOCTTY);
  }
  ~Terminal() {
    if (theirs >= 0) ::close(theirs);
    if (ours >= 0) ::close(ours);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
};

std::string waiting_on(int descriptor) {
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
  std::array<char, 4096> buffer;
  const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
  return count > 0 ? std::string(buffer.data(), static_cast<std::size_t>(count)) : std::string();
}

/// Whether something comes on `descriptor` within a minute.
bool comes_on(int descriptor) {
  pollfd polled{descriptor, POLLIN, 0};
  return ::poll(&polled, 1, 60000) == 1;
}

constexpr auto kAtOnce = std::chrono::seconds(0);
constexpr auto kNever = std::chrono::hours(1);

/// Draws "first" on a line that waits for an hour, and then "second" on one that does not wait.
void draw_twice(int& calls) {
  ProgressLine patient(kNever), line(kAtOnce);
  patient.draw([&] {
    ++calls;
    return std::string("first");
  });
  draw_fraction_on(line)("second", 0.42);
}

}  // namespace

TEST_CASE("a progress line is drawn on a terminal, not too often, and wiped at the end") {
  const Terminal terminal;
  if (terminal.theirs < 0) {
    WARN("this machine gives no pseudo-terminal; nothing is checked");
    return;
  }
  int calls = 0;
  {
    const StandardErrorTo standard_error(terminal.theirs);
    draw_twice(calls);
  }
  CHECK(waiting_on(terminal.ours) == "\r\033[K 42 %  second\r\033[K");
  CHECK(calls == 0);
}

TEST_CASE("a progress line is not drawn again before its pause is over") {
  const Terminal terminal;
  if (terminal.theirs < 0) {
    WARN("this machine gives no pseudo-terminal; nothing is checked");
    return;
  }
  constexpr auto kPause = std::chrono::milliseconds(20);
  std::array<std::chrono::steady_clock::time_point, 4> drawn;
  {
    const StandardErrorTo standard_error(terminal.theirs);
    ProgressLine line(kPause);
    drawn[0] = std::chrono::steady_clock::now();
    for (std::size_t count = 1; count < drawn.size();)
      line.draw([&] {
        drawn[count++] = std::chrono::steady_clock::now();
        return std::string("again");
      });
  }
  // However slow the machine is: the line reads the clock before the first, and before each text.
  CHECK(drawn[3] - drawn[0] >= 2 * kPause);
}

TEST_CASE("a line tells for how long a command waits, and is wiped when it does no longer") {
  const Terminal terminal;
  if (terminal.theirs < 0) {
    WARN("this machine gives no pseudo-terminal; nothing is checked");
    return;
  }
  bool has_come = false;
  {
    const StandardErrorTo standard_error(terminal.theirs);
    WaitingLine patient(kNever), line;
    patient.begin("short");
    line.begin("1 of 2: long");
    has_come = comes_on(terminal.ours);
    line.end();
    patient.end();
  }
  CHECK(has_come);
  const std::string drawn = waiting_on(terminal.ours);
  CAPTURE(drawn);
  CHECK(drawn.find("short") == std::string::npos);
  CHECK(drawn.starts_with("\r\033[K1 of 2: long, "));
  CHECK_FALSE(drawn.starts_with("\r\033[K1 of 2: long, 0 s"));
  CHECK(drawn.ends_with(" s\r\033[K"));
}

TEST_CASE("a progress line is not drawn into a file") {
  std::FILE* const file = std::tmpfile();
  REQUIRE(file != nullptr);
  int calls = 0;
  {
    const StandardErrorTo standard_error(::fileno(file));
    draw_twice(calls);
  }
  CHECK(std::fseek(file, 0, SEEK_END) == 0);
  CHECK(std::ftell(file) == 0);
  CHECK(calls == 0);
  std::fclose(file);
}

TEST_CASE("a progress bar fills from left to right") {
  CHECK(progress_bar(0) == "[........................]");
  CHECK(progress_bar(0.25) == "[######..................]");
  CHECK(progress_bar(1) == "[########################]");
  CHECK(progress_bar(1.5) == progress_bar(1));
  CHECK(progress_bar(-1) == progress_bar(0));
}
