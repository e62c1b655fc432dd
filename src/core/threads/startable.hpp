// Whether the system starts as many threads as are requested.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::threads {

/// `requested`, or 1 where a limit of processes or of memory keeps the system from starting so many threads beside the
/// calling one. oneTBB ends the program when it cannot start a thread. So this starts them first, all at a time, unless
/// as many were there once. Some may be too many as soon as memory is used, so that none is asked for then.
int startable_threads(int requested);

}  // namespace touchstone::threads
