/* Touchstone: what a shared library exports so that `touchstone fuzz --solver ./theirs.so` can attack the solver in it.
 * SPDX-License-Identifier: MIT
 *
 * Plain C99; nothing to link. Compile your solver with it into a shared library that exports the one function
 * `touchstone_solver` below:
 *
 *     cc -O2 -shared -fPIC -I PREFIX/include -o theirs.so theirs.c
 *
 * A query is two elements whose corners move on straight lines from t = 0 to t = 1. `start` and `end` hold the corners at
 * both ends of the step, x y z of the first corner, then of the second, and so on:
 *
 *     edge-edge    a0 a1 b0 b1    4 corners, 12 doubles in each
 *     vertex-face  v f0 f1 f2     4 corners, 12 doubles
 *     point-edge   p e0 e1        3 corners,  9 doubles
 *     point-point  p q            2 corners,  6 doubles
 *
 * All of them are finite; zero, minus zero, subnormal and huge ones are ordinary. Elements touch when they share a point,
 * ends and borders included; t = 0 and t = 1 count.
 *
 * The library is loaded into a process of its own, with no input, its standard output thrown away and the last words of
 * its standard error kept for the report. A crash, a call of exit() or an answer that does not come in time is a finding,
 * and the process is started again, with `init` called anew. Calls come one at a time, from one thread.
 */
#ifndef TOUCHSTONE_PLUGIN_H
#define TOUCHSTONE_PLUGIN_H

#ifdef __cplusplus
extern "C" {
#endif

/** The version of this interface. */
#define TOUCHSTONE_PLUGIN_VERSION 1

/** The kinds of query, each a bit of `kinds`. */
enum touchstone_kind {
  TOUCHSTONE_EDGE_EDGE = 1,
  TOUCHSTONE_VERTEX_FACE = 2,
  TOUCHSTONE_POINT_EDGE = 4,
  TOUCHSTONE_POINT_POINT = 8
};

/** What `solve` returns. Any other number is a finding. */
enum touchstone_status {
  TOUCHSTONE_NO_CONTACT = 0,
  TOUCHSTONE_CONTACT = 1,     /**< and *toi is the time of the first contact */
  TOUCHSTONE_CONTACT_ONLY = 2 /**< they touch; this solver does not say when */
};

/** What there is to call. The library owns it and keeps it as long as it is loaded. */
struct touchstone_solver_plugin {
  /** TOUCHSTONE_PLUGIN_VERSION, as it was when the library was compiled. */
  unsigned int version;

  /** The kinds that `solve` takes, or-ed together; it is never called with another. */
  unsigned int kinds;

  /** Called once before the first query; what it writes to *state is handed to every call. Returns 0 when all is well;
   *  any other number says that this solver cannot run here. NULL: there is nothing to do. */
  int (*init)(void** state);

  /** The first contact in [0, 1] of one query. `kind` is one of touchstone_kind; returns one of touchstone_status.
   *  *toi is NaN at first and read after TOUCHSTONE_CONTACT only. It should lie in [0, 1], and not after the exact time:
   *  a simulator that steps there must not have passed through. */
  int (*solve)(void* state, int kind, const double* start, const double* end, double* toi);

  /** Called once after the last query, unless the process ended before. NULL: there is nothing to do. */
  void (*teardown)(void* state);
};

#ifdef _WIN32
#define TOUCHSTONE_EXPORT __declspec(dllexport)
#else
#define TOUCHSTONE_EXPORT __attribute__((visibility("default")))
#endif

/** The one symbol that is looked up. Your library defines it; a null pointer says that it cannot run here. */
TOUCHSTONE_EXPORT const struct touchstone_solver_plugin* touchstone_solver(void);

#ifdef __cplusplus
}
#endif

#endif /* TOUCHSTONE_PLUGIN_H */
