// The child's side of a plugin: loads it, and answers what the parent asks.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fuzz/shared_call.hpp"

namespace touchstone::fuzz {

/// Runs in the child process until it is told to end. `path` is absolute. What prevents the plugin from running is
/// left in `call.failure`.
void serve_plugin(const std::string& path, SharedCall& call);

/// The bit of plugin.h, 1 to 8, for a kind given by its number.
constexpr std::uint32_t kind_bit(unsigned kind) noexcept { return 1U << kind; }

}  // namespace touchstone::fuzz
