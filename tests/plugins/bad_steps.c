/* A plugin about whole steps that does what the variable BAD_STEPS says. SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <touchstone/plugin.h>

int touchstone_ask_step(const struct touchstone_step* step, struct touchstone_step_reply* reply) {
  const char* what = getenv("BAD_STEPS");
  uint32_t i;
  if (what == NULL) return 1;
  puts("{\"free\": 1}"); /* what it prints is no reply */
  fflush(stdout);
  if (strcmp(what, "says nothing") == 0) return 0;
  if (strcmp(what, "refuses") == 0) return 3;
  if (strcmp(what, "crashes") == 0) abort();
  if (strcmp(what, "leaves") == 0) exit(0);
  if (strcmp(what, "no kind") == 0 || strcmp(what, "a kind beyond a byte") == 0) {
    reply->has_candidates = 1;
    reply->add_candidate(reply, what[0] == 'n' ? 7 : 256, 0, 1);
  } else if (strcmp(what, "hidden candidates") == 0) {
    reply->free = 0.5;
    reply->add_candidate(reply, TOUCHSTONE_KIND_EDGE_EDGE, 0, 1);
  } else if (strcmp(what, "reads its input") == 0) {
    if (getchar() != EOF) return 11; /* there is nothing to read */
    fclose(stdin);
    reply->free = 0;
  } else if (strcmp(what, "no step") == 0) {
    reply->free = 0;
    /* Lists, as they are promised. */
    for (i = 0; i < 2 * step->edges; ++i) {
      if (step->edge_vertices[i] >= step->vertices) return 4;
    }
    for (i = 0; i < 3 * step->faces; ++i) {
      if (step->face_vertices[i] >= step->vertices) return 5;
    }
    for (i = 0; i < step->points; ++i) {
      if (step->point_vertices[i] >= step->vertices) return 6;
    }
    for (i = 0; i < 3 * step->vertices; ++i) {
      if (!(fabs(step->start[i]) < HUGE_VAL) || !(fabs(step->end[i]) < HUGE_VAL)) return 7;
    }
    for (i = 0; step->groups != NULL && i < step->vertices; ++i) {
      if (step->groups[i] > 99) return 8;
    }
    for (i = 0; i < 2 * step->ignored; ++i) {
      if (step->groups == NULL || step->ignored_groups[i] > 99) return 9;
    }
    if (step->separation < 0 || step->metric < 0 || step->metric > 1) return 10;
    reply->first_contact = INFINITY;
  } else {
    reply->free = INFINITY;
  }
  return 0;
}
