// A file that is read in a process of its own: values, errors, crashes, and a library that never ends.
// SPDX-License-Identifier: MIT
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/arrays/reading_process.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using Catch::Contains;
using frames::ReadingProcess;

namespace {

using Line = ReadingProcess::Line;

/// What take() throws where a library does this.
std::string error_of(const std::function<void(const Line&)>& serve) {
  int value = 0;
  try {
    ReadingProcess process("a.h5", "the library", nullptr, serve);
    process.take(&value, sizeof value);
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

bool has_no_child() { return ::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD; }

struct GivenUp {};
volatile std::sig_atomic_t asked_to_end = 0;
void note(int) { asked_to_end = 1; }
void give_up_when_asked() {
  if (asked_to_end != 0) throw GivenUp();
}

/// Notes an alarm again and again, as one could come just before the wait that it is to break off.
class Alarms {
 public:
  Alarms() {
    struct sigaction action {};
    action.sa_handler = note;
    ::sigaction(SIGALRM, &action, &before_);
    const itimerval often{{0, 20'000}, {0, 20'000}};
    ::setitimer(ITIMER_REAL, &often, nullptr);
  }
  ~Alarms() {
    const itimerval never{};
    ::setitimer(ITIMER_REAL, &never, nullptr);
    ::sigaction(SIGALRM, &before_, nullptr);
  }
  Alarms(const Alarms&) = delete;
  Alarms& operator=(const Alarms&) = delete;

 private:
  struct sigaction before_ {};
};

}  // namespace

TEST_CASE("a reading process answers requests until its object goes") {
  {
    ReadingProcess process("a.h5", "the library", nullptr, [](const Line& line) {
      for (std::size_t count = 0; line.next_request(&count, sizeof count);) {
        const std::vector<double> values(count, 0.5 + static_cast<double>(count));
        line.reply(values.data(), values.size() * sizeof(double));
      }
    });
    for (const std::size_t count : {std::size_t{1}, std::size_t{0}, std::size_t{3'000'000}}) {
      std::vector<double> values(count);
      process.request(&count, sizeof count);
      process.take(values.data(), count * sizeof(double));
      CHECK((values == std::vector<double>(count, 0.5 + static_cast<double>(count))));
    }
  }
  CHECK(has_no_child());
}

TEST_CASE("a library that crashes, ends the process or throws is an error of one line about the file") {
  CHECK(error_of([](const Line&) { ::raise(SIGSEGV); }) ==
        "a.h5: the library crashed on this file (signal 11, Segmentation fault); the file is damaged, or the library "
        "has a fault");
  CHECK_THAT(error_of([](const Line&) { std::abort(); }), Contains("crashed on this file (signal 6"));
  CHECK_THAT(error_of([](const Line& line) {
               line.reply("\1", 1);
               ::raise(SIGBUS);
             }),
             Contains("a.h5: the library gives another number of values"));
  CHECK_THAT(error_of([](const Line&) { ::raise(SIGKILL); }), Contains("the process that reads it was killed"));
  CHECK_THAT(error_of([](const Line&) { ::_exit(0); }), Contains("ended before it was done"));
  CHECK(error_of([](const Line&) { throw FileError("a.h5: is no file"); }) == "a.h5: is no file");
  CHECK_THROWS_AS(error_of([](const Line&) { throw std::bad_alloc(); }), std::bad_alloc);
  CHECK(has_no_child());
}

TEST_CASE("a library that never ends is given up when the caller is asked to end") {
  asked_to_end = 0;
  const Alarms alarms;
  const auto read = [] {
    ReadingProcess process("a.h5", "the library", give_up_when_asked, [](const Line&) {
      for (;;) ::pause();
    });
    int value = 0;
    process.take(&value, sizeof value);
  };
  CHECK_THROWS_AS(read(), GivenUp);
  CHECK(has_no_child());
}
