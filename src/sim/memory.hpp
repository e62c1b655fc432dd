// What a process that simulates asks of the C library. SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::sim {

/// Makes the allocator of this process return what large vectors leave. They come and go in each step; the C library
/// would soon keep their room, in holes that fit nothing else, and a pile would take a quarter more memory.
void give_memory_back() noexcept;

}  // namespace touchstone::sim
