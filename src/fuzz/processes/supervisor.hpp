// A process between us and somebody else's code, which ends all that this code leaves behind.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

namespace touchstone::fuzz {

/// Called in a forked process, with every signal blocked. On Linux this process becomes a supervisor: it forks once
/// more, and only the process below returns, with signals still blocked. A process whose parent ends becomes a child of
/// the supervisor (PR_SET_CHILD_SUBREAPER), also when it has left its session and group, as daemons do. When the
/// process below ends, when SIGTERM comes, or when the thread ends that forked the supervisor, the supervisor kills and
/// reaps all of its descendants, and then ends as the process below has ended. Elsewhere this does nothing, and a
/// daemon outlives the run.
/// @param parent  the process that forked the caller
void supervise(pid_t parent);

}  // namespace touchstone::fuzz
