// SPDX-License-Identifier: MIT
#include "fuzz/processes/plugin_solver.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <optional>

#include <touchstone/plugin.h>
#include <touchstone/error.hpp>

#include "fuzz/processes/child_process.hpp"
#include "fuzz/processes/give_up.hpp"
#include "fuzz/processes/plugin_child.hpp"
#include "fuzz/processes/plugin_file.hpp"
#include "fuzz/processes/shared_call.hpp"
#include "io/fail.hpp"

namespace touchstone::fuzz {
namespace {

using Clock = ChildProcess::Clock;

/// Memory that this process and a child share.
class SharedMemory {
 public:
  explicit SharedMemory(const Separation& separation) {
    void* const memory = ::mmap(nullptr, sizeof(SharedCall), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw Error("no memory can be shared with a plugin: " + io::system_reason(errno));
    call_ = new (memory) SharedCall;
    call_->separation = separation.distance;
    call_->metric = separation.metric == Metric::euclidean ? TOUCHSTONE_METRIC_EUCLIDEAN : TOUCHSTONE_METRIC_MAX;
  }
  ~SharedMemory() { ::munmap(call_, sizeof(SharedCall)); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  SharedCall& call() noexcept { return *call_; }

 private:
  SharedCall* call_;
};

/// One process, from its start to its end.
class Run {
 public:
  Run(const std::string& path, const Limits& limits, const Separation& separation)
      : limits_(limits),
        memory_(separation),
        child_({-1, -1, -1, limits.memory}, [&] { serve_plugin(path, memory_.call()); }) {}

  ~Run() {
    // A child that is ready is told to end, so that its teardown runs. A child in the middle of a query is not.
    if (call().stage.load() != CallStage::ready || child_.ended()) return;
    call().ends = 1;
    raise(call(), Side::parent, call().asked);
    child_.wait_until(Clock::now() + limits_.farewell);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  SharedCall& call() noexcept { return memory_.call(); }
  ChildProcess& child() noexcept { return child_; }

  enum class End : std::uint8_t { answered, died, late };

  /// Waits for the next answer.
  End wait(std::chrono::nanoseconds time) {
    const auto deadline = Clock::now() + time;
    // The slices get longer: most answers come at once, and a death should be noticed soon.
    std::chrono::nanoseconds slice = std::chrono::microseconds(200);
    for (;;) {
      if (wait_for_change(call(), Side::parent, call().answered, answers_, slice)) break;
      child_.drain();
      if (child_.ended() && call().answered.load() == answers_) return End::died;
      if (Clock::now() >= deadline) return End::late;
      slice = std::min<std::chrono::nanoseconds>(2 * slice, std::chrono::milliseconds(5));
    }
    answers_ = call().answered.load();
    return End::answered;
  }

 private:
  Limits limits_;
  SharedMemory memory_;
  ChildProcess child_;
  std::uint32_t answers_ = 0;
};

std::string in_milliseconds(std::chrono::milliseconds time) { return std::to_string(time.count()) + " ms"; }

class PluginSolver : public SolverUnderTest {
 public:
  PluginSolver(const std::string& path, const Limits& limits, const Separation& separation)
      : name_(path), limits_(limits), separation_(separation) {
    path_ = plugin_file(path);
    const std::string reason = start();
    if (!reason.empty()) io::fail(path, "the plugin cannot be used: " + reason);
    kinds_ = run_->call().kinds;
  }

  const std::string& name() const override { return name_; }
  bool supports(Kind kind) const override { return (kinds_ & TOUCHSTONE_KIND_BIT(static_cast<unsigned>(kind))) != 0; }

  void change_separation(const Separation& separation) override { separation_ = separation; }

  Reply ask(const Query& query) override {
    if (!run_) {
      // A fork may catch another thread of this program in the middle of something that the child then waits for. A
      // second fork is unlikely to meet that again.
      std::string reason = start();
      if (!reason.empty()) reason = start();
      if (!reason.empty()) return give_up(run_, Reply::State::crashed, "it cannot be started again: " + reason);
    }
    SharedCall& call = run_->call();
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      put(query.start[i], &call.start[3 * i]);
      put(query.end[i], &call.end[3 * i]);
    }
    call.kind = static_cast<std::uint32_t>(query.kind);
    call.separation = separation_.distance;
    if (++since_drained_ % 256 == 0) run_->child().drain();
    raise(call, Side::parent, call.asked);
    switch (run_->wait(limits_.answer)) {
      case Run::End::answered:
        if (call.refused != 0)
          return no_answer(Reply::State::malformed, "touchstone_separation refuses the separation");
        return reply(call.status, call.toi);
      case Run::End::died: return give_up(run_, Reply::State::crashed, run_->child().story());
      case Run::End::late: break;
    }
    return give_up(run_, Reply::State::hung, "no answer within " + in_milliseconds(limits_.answer));
  }

 private:
  static void put(const Vec3& corner, double* to) {
    to[0] = corner.x;
    to[1] = corner.y;
    to[2] = corner.z;
  }

  static Reply reply(std::int32_t status, double toi) {
    Reply reply;
    switch (status) {
      case TOUCHSTONE_NO_CONTACT: return reply;
      case TOUCHSTONE_CONTACT: reply.toi = toi; [[fallthrough]];
      case TOUCHSTONE_CONTACT_ONLY: reply.contact = true; return reply;
      default: break;
    }
    return no_answer(Reply::State::malformed,
                     "solve returned " + std::to_string(status) + ", which is no touchstone_status");
  }

  /// @returns the reason when there is no process, else nothing
  std::string start() {
    run_ = std::make_unique<Run>(path_, limits_, separation_);
    const auto end = run_->wait(limits_.start);
    std::string reason;
    if (end == Run::End::answered) {
      const auto& failure = run_->call().failure;
      reason.assign(failure.begin(), std::find(failure.begin(), failure.end(), '\0'));
      if (reason.empty()) return reason;
      reason = io::printable(reason);
    } else {
      const bool loading = run_->call().stage.load() == CallStage::loading;
      reason = end == Run::End::died ? std::string("its process ended while it was ") +
                                           (loading ? "loaded" : "initialised") + ", by " + run_->child().story()
                                     : std::string(loading ? "loading it" : "its init") + " takes longer than " +
                                           in_milliseconds(limits_.start);
    }
    return give_up(run_, Reply::State::crashed, reason).detail;
  }

  std::string name_;
  std::string path_;
  Limits limits_;
  Separation separation_;
  std::uint32_t kinds_ = 0;
  std::uint32_t since_drained_ = 0;
  std::unique_ptr<Run> run_;
};

}  // namespace

std::unique_ptr<SolverUnderTest> load_plugin(const std::string& path, const Limits& limits,
                                             const Separation& separation) {
  return std::make_unique<PluginSolver>(path, limits, separation);
}

}  // namespace touchstone::fuzz
