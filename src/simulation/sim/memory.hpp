// A setting of the C library for processes that simulate.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::sim {

/// Makes the allocator of this process return the memory of large vectors that are freed. They come and go in each
/// step. The C library would keep their memory after a while, in holes that fit nothing else, and a pile of cables
/// would take a quarter more.
void give_memory_back() noexcept;

}  // namespace touchstone::sim
