/* A plugin that claims as the time the separation that it was told, or 1 - it with the other metric, so that a test can
 * see it. It refuses separations above 1. SPDX-License-Identifier: MIT */
#include <touchstone/plugin.h>

static double told = 0;

int touchstone_separation(double distance, int metric) {
  if (distance > 1) return 1;
  told = metric == TOUCHSTONE_METRIC_MAX ? 1 - distance : distance;
  return 0;
}

static int solve(void* state, int kind, const double* start, const double* end, double* toi) {
  (void)state, (void)kind, (void)start, (void)end;
  *toi = told;
  return TOUCHSTONE_CONTACT;
}

static const struct touchstone_solver_plugin plugin = {TOUCHSTONE_PLUGIN_VERSION,
                                                       TOUCHSTONE_KIND_BIT(TOUCHSTONE_KIND_POINT_POINT), 0, solve, 0};

const struct touchstone_solver_plugin* touchstone_solver(void) { return &plugin; }
