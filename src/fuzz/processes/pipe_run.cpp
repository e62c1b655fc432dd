// SPDX-License-Identifier: MIT
#include "fuzz/processes/pipe_run.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <sstream>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "io/fail.hpp"

namespace touchstone::fuzz {
namespace {

using Clock = ChildProcess::Clock;

/// Plain words, or the shell's.
std::vector<std::string> words_of(const std::string& command_line) {
  // Without a shell in between, the program itself dies with us.
  if (command_line.find_first_of("\"'\\$`|&;<>()*?[]{}#~=%!\n") != std::string::npos) {
    return {"/bin/sh", "-c", command_line};
  }
  std::istringstream text(command_line);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

/// Writes to a pipe whose reader has gone raise a signal, which is nobody's business but ours.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    ::sigpending(&pending);
    was_pending_ = ::sigismember(&pending, SIGPIPE) == 1;
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoPipeSignal() {
    sigset_t pending;
    ::sigpending(&pending);
    if (!was_pending_ && ::sigismember(&pending, SIGPIPE) == 1) {
      int signal = 0;
      ::sigwait(&pipe_, &signal);
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  sigset_t pipe_{}, before_{};
  bool was_pending_ = false;
};

}  // namespace

void PipeRun::start(const std::function<void()>& serve, int spare) {
  child_.emplace(ChildProcess::Setup{in_.read, out_.write, spare, limits_.memory}, serve);
  in_.close_read();
  out_.close_write();
  set_nonblocking(in_.write);
  set_nonblocking(out_.read);
}

PipeRun::PipeRun(const std::function<void()>& serve, const Limits& limits) : limits_(limits) { start(serve, -1); }

PipeRun::PipeRun(const std::string& command_line, const Limits& limits) : limits_(limits) {
  std::vector<std::string> words = words_of(command_line);
  if (words.empty()) throw Error("the solver's command is empty");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  Pipe trouble;  // closed by a successful exec; else it brings the reason
  const auto become_program = [&arguments] {
    ::execvp(arguments[0], arguments.data());
    const int error = errno;
    constexpr int kSpare = 3;
    if (::write(kSpare, &error, sizeof error) < 0) ::_exit(126);
    ::_exit(127);
  };
  start(become_program, trouble.write);
  trouble.close_write();
  int error = 0;
  ssize_t count = 0;
  do {
    count = ::read(trouble.read, &error, sizeof error);
  } while (count < 0 && errno == EINTR);
  if (count == sizeof error) {
    throw Error(io::in_quotes(words[0]) + ": the solver's command cannot be started: " + io::system_reason(error));
  }
}

PipeRun::~PipeRun() {
  in_.close_write();
  if (child_ && !child_->ended()) child_->wait_until(Clock::now() + limits_.farewell);
}

bool PipeRun::take_line(std::string& line) {
  const std::size_t end = buffer_.find('\n');
  if (end == std::string::npos) return false;
  line.assign(buffer_, 0, end);
  buffer_.erase(0, end + 1);
  return true;
}

/// @returns whether there was anything
bool PipeRun::read_some() {
  std::array<char, 4096> bytes;
  const ssize_t count = ::read(out_.read, bytes.data(), bytes.size());
  if (count == 0) closed_ = true;
  if (count > 0) buffer_.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0;
}

/// @returns false when nobody will ever read it
bool PipeRun::write_some(std::string_view& rest) {
  const NoPipeSignal guard;
  const ssize_t count = ::write(in_.write, rest.data(), rest.size());
  if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  return count >= 0 || errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

PipeRun::Exchange PipeRun::exchange(std::string_view line, std::chrono::milliseconds time) {
  const auto deadline = Clock::now() + time;
  using End = Exchange::End;
  read_some();
  if (!buffer_.empty()) return {End::unasked, buffer_};

  Exchange result{End::line, {}};
  std::string_view rest = line;
  while (!closed_) {
    // A program may answer before it has read the whole query, or stop reading. Its answer is judged all the same.
    if (!rest.empty() && !write_some(rest)) rest = {};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) {
      result.end = End::late;
      break;
    }
    // Standard error is read as soon as there is anything: a program that writes much there waits for that before it
    // answers. Negative descriptors are left out.
    std::array<pollfd, 3> ends{
        {{out_.read, POLLIN, 0}, {child_->errors(), POLLIN, 0}, {rest.empty() ? -1 : in_.write, POLLOUT, 0}}};
    constexpr std::int64_t kLongest = 3'600'000;
    const int ready = ::poll(ends.data(), ends.size(), static_cast<int>(std::min<std::int64_t>(left, kLongest)));
    if (ready == 0) ++idle_waits_;
    if (ready > 0 && ends[1].revents != 0) child_->drain();
    if (ready > 0 && ends[0].revents != 0) read_some();
    if (take_line(result.line)) {
      if (result.line.size() > limits_.line) result.end = End::too_long;
      if (!buffer_.empty()) return {End::unasked, result.line + '\n' + buffer_};
      return result;
    }
    if (buffer_.size() > limits_.line) {
      result.end = End::too_long;
      break;
    }
  }
  if (result.end == End::line) {  // it has closed its output
    result.end = child_->wait_until(std::min(deadline, Clock::now() + limits_.farewell)) ? End::died : End::late;
  }
  result.line = buffer_;
  return result;
}

std::string PipeRun::read_all(std::chrono::milliseconds time, std::size_t most) {
  const auto deadline = Clock::now() + time;
  in_.close_write();
  while (!closed_ && buffer_.size() <= most) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) throw Error("it has not ended within " + std::to_string(time.count()) + " ms");
    std::array<pollfd, 2> ends{{{out_.read, POLLIN, 0}, {child_->errors(), POLLIN, 0}}};
    if (::poll(ends.data(), ends.size(), static_cast<int>(left)) <= 0) continue;
    if (ends[1].revents != 0) child_->drain();
    if (ends[0].revents != 0) read_some();
  }
  if (buffer_.size() > most) throw Error("it writes more than " + std::to_string(most) + " bytes");
  if (!child_->wait_until(std::min(deadline, Clock::now() + limits_.farewell))) {
    throw Error("it has closed its output and does not end");
  }
  if (!child_->succeeded()) throw Error(child_->story());
  return std::exchange(buffer_, {});
}

}  // namespace touchstone::fuzz
