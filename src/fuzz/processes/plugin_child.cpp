// SPDX-License-Identifier: MIT
#include "fuzz/processes/plugin_child.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include <touchstone/plugin.h>
#include <touchstone/query.hpp>

#include "fuzz/processes/child_process.hpp"
#include "fuzz/processes/plugin_file.hpp"

namespace touchstone::fuzz {
namespace {

static_assert(static_cast<int>(Kind::edge_edge) == TOUCHSTONE_KIND_EDGE_EDGE);
static_assert(static_cast<int>(Kind::vertex_face) == TOUCHSTONE_KIND_VERTEX_FACE);
static_assert(static_cast<int>(Kind::point_edge) == TOUCHSTONE_KIND_POINT_EDGE);
static_assert(static_cast<int>(Kind::point_point) == TOUCHSTONE_KIND_POINT_POINT);
constexpr unsigned kAllKinds = 15;

void refuse(SharedCall& call, std::string_view reason) {
  const std::size_t size = std::min(reason.size(), call.failure.size() - 1);
  std::copy_n(reason.begin(), size, call.failure.begin());
  call.failure[size] = '\0';
}

/// The library's function that is told a separation; null when it has none.
using Tell = int (*)(double, int);

/// Tells the library the separation, if there is one.
bool takes_separation(Tell tell, double separation, int metric) {
  return separation == 0 || (tell != nullptr && tell(separation, metric) == 0);
}

const touchstone_solver_plugin* load(const std::string& path, SharedCall& call, Tell& tell) {
  using Entry = const touchstone_solver_plugin* (*)();
  void* library = nullptr;
  std::string fault;
  const auto entry = reinterpret_cast<Entry>(load_plugin_function(path, "touchstone_solver", library, fault));
  if (entry == nullptr) {
    refuse(call, fault);
    return nullptr;
  }
  const touchstone_solver_plugin* const plugin = entry();
  if (plugin == nullptr) {
    refuse(call, "its touchstone_solver() returned a null pointer");
  } else if (plugin->version != TOUCHSTONE_PLUGIN_VERSION) {
    refuse(call, "it was compiled for version " + std::to_string(plugin->version) +
                     " of touchstone/plugin.h, this is " + std::to_string(TOUCHSTONE_PLUGIN_VERSION));
  } else if (plugin->kinds == 0 || (plugin->kinds & ~kAllKinds) != 0) {
    refuse(call, "its kinds are " + std::to_string(plugin->kinds) + ", which is no sum of bits of TOUCHSTONE_KIND_BIT");
  } else if (plugin->solve == nullptr) {
    refuse(call, "its solve is a null pointer");
  } else if (tell = reinterpret_cast<Tell>(::dlsym(library, "touchstone_separation"));
             !takes_separation(tell, call.separation, call.metric)) {
    refuse(call, "it takes no such separation (see touchstone_separation in touchstone/plugin.h)");
  } else {
    return plugin;
  }
  return nullptr;
}

}  // namespace

void serve_plugin(const std::string& path, SharedCall& call) {
  leave_at_exit();
  const pid_t parent = ::getppid();
  Tell tell = nullptr;
  const touchstone_solver_plugin* const plugin = load(path, call, tell);
  double told = call.separation;
  void* state = nullptr;
  if (plugin != nullptr && plugin->init != nullptr) {
    call.stage = CallStage::initialising;
    const int status = plugin->init(&state);
    if (status != 0) refuse(call, "its init returned " + std::to_string(status));
  }
  if (plugin != nullptr) call.kinds = plugin->kinds;
  call.stage = CallStage::ready;
  raise(call, Side::child, call.answered);
  if (call.failure[0] != '\0') return;

  for (std::uint32_t seen = 0;; ++seen) {
    while (!wait_for_change(call, Side::child, call.asked, seen, std::chrono::seconds(1))) {
      if (::getppid() != parent) return;  // where no signal tells
    }
    if (call.ends != 0) break;
    const std::array<double, 12> start = call.start, end = call.end;  // so that the plugin has no business in `call`
    double toi = std::numeric_limits<double>::quiet_NaN();
    call.stage = CallStage::solving;
    if (const double separation = call.separation; separation != told) {
      call.refused = takes_separation(tell, separation, call.metric) ? 0 : 1;
      told = separation;
    }
    call.status =
        call.refused != 0 ? 0 : plugin->solve(state, static_cast<int>(call.kind), start.data(), end.data(), &toi);
    call.toi = toi;
    call.stage = CallStage::ready;
    raise(call, Side::child, call.answered);
  }
  call.stage = CallStage::ending;
  if (plugin->teardown != nullptr) plugin->teardown(state);
}

}  // namespace touchstone::fuzz
