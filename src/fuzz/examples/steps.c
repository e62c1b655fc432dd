/* A simulator's broad phase as a shared library that is asked about whole steps:
 *   cc -O2 -shared -fPIC -I PREFIX/include -o steps.so steps.c
 *   touchstone fuzz-steps --solver ./steps.so
 * It is naive, as many are: its boxes are those of the start, widened by a margin. Put your own in its place.
 * SPDX-License-Identifier: MIT */
#include <stddef.h>

#include <touchstone/plugin.h>

#define MARGIN 0.1

/* Whether two elements, of so many vertices, have none in common and boxes that are near each other. */
static int near(const struct touchstone_step* step, const uint32_t* a, int as, const uint32_t* b, int bs) {
  double room = step->separation + 2 * MARGIN;
  int i, j, k;
  for (i = 0; i < as; ++i) {
    for (j = 0; j < bs; ++j) {
      if (a[i] == b[j]) return 0;
    }
  }
  for (k = 0; k < 3; ++k) {
    double low[2], high[2];
    for (i = 0; i < as + bs; ++i) {
      int side = i < as ? 0 : 1;
      double x = step->start[3 * (size_t)(i < as ? a[i] : b[i - as]) + (size_t)k];
      if (i == 0 || i == as || x < low[side]) low[side] = x;
      if (i == 0 || i == as || x > high[side]) high[side] = x;
    }
    if (low[0] - high[1] > room || low[1] - high[0] > room) return 0;
  }
  return 1;
}

int touchstone_ask_step(const struct touchstone_step* step, struct touchstone_step_reply* reply) {
  uint32_t i, j;
  reply->has_candidates = 1;
  for (i = 0; i < step->edges; ++i) {
    for (j = i + 1; j < step->edges; ++j) {
      if (near(step, step->edge_vertices + 2 * (size_t)i, 2, step->edge_vertices + 2 * (size_t)j, 2)) {
        reply->add_candidate(reply, TOUCHSTONE_KIND_EDGE_EDGE, i, j);
      }
    }
  }
  for (i = 0; i < step->vertices; ++i) {
    for (j = 0; j < step->faces; ++j) {
      if (near(step, &i, 1, step->face_vertices + 3 * (size_t)j, 3)) {
        reply->add_candidate(reply, TOUCHSTONE_KIND_VERTEX_FACE, i, j);
      }
    }
    for (j = 0; j < step->edges; ++j) {
      if (near(step, &i, 1, step->edge_vertices + 2 * (size_t)j, 2)) {
        reply->add_candidate(reply, TOUCHSTONE_KIND_POINT_EDGE, i, j);
      }
    }
    for (j = i + 1; j < step->vertices; ++j) {
      if (near(step, &i, 1, &j, 1)) reply->add_candidate(reply, TOUCHSTONE_KIND_POINT_POINT, i, j);
    }
  }
  return 0;
}
