/* A solver as a shared library: cc -O2 -shared -fPIC -I PREFIX/include -o naive.so plugin.c -lm
 * Then: touchstone fuzz --solver ./naive.so
 * SPDX-License-Identifier: MIT */
#include <touchstone/plugin.h>

#include "naive_solver.h"

static int solve(void* state, int kind, const double* start, const double* end, double* toi) {
  (void)state;
  return naive_solve(kind == TOUCHSTONE_KIND_EDGE_EDGE ? EDGES : FACE, start, end, toi) ? TOUCHSTONE_CONTACT
                                                                                        : TOUCHSTONE_NO_CONTACT;
}

static const struct touchstone_solver_plugin plugin = {
    TOUCHSTONE_PLUGIN_VERSION,
    TOUCHSTONE_KIND_BIT(TOUCHSTONE_KIND_EDGE_EDGE) | TOUCHSTONE_KIND_BIT(TOUCHSTONE_KIND_VERTEX_FACE), 0 /* init */,
    solve, 0 /* teardown */};

const struct touchstone_solver_plugin* touchstone_solver(void) { return &plugin; }
