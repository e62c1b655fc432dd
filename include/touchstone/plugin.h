/* Touchstone: the interface of a shared library that `touchstone fuzz --solver ./theirs.so` can attack, for queries, or
 * `touchstone fuzz-steps --solver ./theirs.so`, for steps of whole meshes.
 * SPDX-License-Identifier: MIT
 */
#ifndef TOUCHSTONE_PLUGIN_H
#define TOUCHSTONE_PLUGIN_H

/** @file
 * The interface of a solver in a shared library.
 *
 * The command `touchstone fuzz --solver ./theirs.so` attacks the solver. The header is plain C99, and there is nothing
 * to link. Compile your solver with it into a shared library that exports the function `touchstone_solver` below:
 *
 *     cc -O2 -shared -fPIC -I PREFIX/include -o theirs.so theirs.c
 *
 * A query is two elements. Their corners move on straight lines from t = 0 to t = 1. `start` holds the corners at t = 0
 * and `end` holds the corners at t = 1: x y z of the first corner, then x y z of the second corner, and so on.
 *
 *     edge-edge    a0 a1 b0 b1    4 corners, 12 doubles in each
 *     vertex-face  v f0 f1 f2     4 corners, 12 doubles in each
 *     point-edge   p e0 e1        3 corners,  9 doubles in each
 *     point-point  p q            2 corners,  6 doubles in each
 *
 * All coordinates are finite. Zero, minus zero, subnormal and huge values are ordinary input. Elements touch when they
 * share a point; the ends of edges and the borders of faces belong to them, and contact at t = 0 or t = 1 counts.
 *
 * The library runs in a process of its own. The process has no input, its standard output is discarded, and the last
 * lines of its standard error go into the report. A crash, a call of exit() or a late answer is a finding. After it the
 * process is started again, and `init` is called again. One thread makes all calls, one at a time.
 */

#include <stdint.h>

#include <touchstone/kinds.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The version of this interface. */
#define TOUCHSTONE_PLUGIN_VERSION 2

/** The bit of a kind in `kinds`. */
#define TOUCHSTONE_KIND_BIT(kind) (1U << (kind))

/** The values that `solve` returns. Any other number is a finding. */
enum touchstone_status {
  TOUCHSTONE_NO_CONTACT = 0,  /**< the elements do not touch */
  TOUCHSTONE_CONTACT = 1,     /**< the elements touch, and *toi is the time of the first contact */
  TOUCHSTONE_CONTACT_ONLY = 2 /**< the elements touch, and the solver gives no time */
};

/** A solver: the functions to call. The library owns this object and keeps it as long as it is loaded. */
struct touchstone_solver_plugin {
  /** TOUCHSTONE_PLUGIN_VERSION of the header that the library was compiled with. */
  unsigned int version;

  /** The kinds that `solve` takes: TOUCHSTONE_KIND_BIT of each, combined by bitwise or. No other is ever asked. */
  unsigned int kinds;

  /** Called once before the first query. The pointer that it writes to *state is passed to every later call. It returns
   *  0 on success; any other number means that the solver cannot run here. NULL when there is nothing to do. */
  int (*init)(void** state);

  /** The first contact in [0, 1] of one query. `kind` is one of touchstone_kind. The function returns one of
   *  touchstone_status. *toi is NaN before the call, and it is read only after TOUCHSTONE_CONTACT. It should lie in
   *  [0, 1] and not after the exact time: a simulator that steps there must not pass through. */
  int (*solve)(void* state, int kind, const double* start, const double* end, double* toi);

  /** Called once after the last query, unless the process has ended before. NULL when there is nothing to do. */
  void (*teardown)(void* state);
};

/** Makes a function visible outside its shared library. */
#ifdef _WIN32
#define TOUCHSTONE_EXPORT __declspec(dllexport)
#else
#define TOUCHSTONE_EXPORT __attribute__((visibility("default")))
#endif

/** The function that is looked up by name; your library defines it. It returns a null pointer when the solver
 *  cannot run here. */
TOUCHSTONE_EXPORT const struct touchstone_solver_plugin* touchstone_solver(void);

/** A second function that is looked up by name, for `touchstone fuzz --separation D`; a library without it takes no
 *  separation. It is called before `init`, and with `--separation each` again before a query with another distance.
 *  From then on elements are in contact while their distance is at most `distance`, which is finite and above 0.
 *  `metric` is one of touchstone_metric. It returns 0 when the solver takes this separation; any other number means
 *  that it does not. */
TOUCHSTONE_EXPORT int touchstone_separation(double distance, int metric);

/** A step of a whole mesh, for `touchstone fuzz-steps`. Vertices move on straight lines. Numbers of vertices count from
 *  0. There are at most 64 vertices. */
struct touchstone_step {
  uint32_t vertices;              /**< how many */
  uint32_t edges;                 /**< how many: all edges, those of faces too */
  uint32_t faces;                 /**< how many */
  uint32_t points;                /**< how many loose points: vertices in no edge and no face that collide */
  const double* start;            /**< x y z of each vertex at t = 0 */
  const double* end;              /**< x y z of each vertex at t = 1 */
  const uint32_t* edge_vertices;  /**< two of each edge */
  const uint32_t* face_vertices;  /**< three of each face */
  const uint32_t* point_vertices; /**< the loose points */
  const uint32_t* groups;         /**< the group of each vertex; NULL without groups */
  uint32_t ignored;               /**< how many pairs of groups do not collide */
  const uint32_t* ignored_groups; /**< two of each such pair; both may be the same group */
  double separation; /**< elements are in contact while their distance is at most this; 0: when they touch */
  int metric;        /**< one of touchstone_metric, of the separation */
};

/** What a simulator's collision detection says of a step: one or more of three things. */
struct touchstone_step_reply {
  double free;          /**< the step is free of contact until this time, in [0, 1]; NaN before the call: not said */
  double first_contact; /**< the time of the first contact, infinity for none; NaN before the call: not said */
  int has_candidates;   /**< 0 before the call; not 0: the candidates of the broad phase are those that were added */

  /** Adds a candidate to the reply. `kind` is one of touchstone_kind. The elements are the numbers of edge and edge,
   *  vertex and face, vertex and edge, or vertex and vertex. */
  void (*add_candidate)(struct touchstone_step_reply* reply, int kind, uint32_t first, uint32_t second);
};

/** The function that `touchstone fuzz-steps --solver` looks up by name; the other two are not needed for it. It returns
 *  0; any other number ends the process, which is a finding, and so is a reply with more than 30,000 candidates.
 *  docs/fuzzing.md says what is judged. */
TOUCHSTONE_EXPORT int touchstone_ask_step(const struct touchstone_step* step, struct touchstone_step_reply* reply);

#ifdef __cplusplus
}
#endif

#endif /* TOUCHSTONE_PLUGIN_H */
