/* A naive solver for edge-edge and vertex-face queries, as many simulators have one: it looks for a change of sign of
 * the signed volume at equal time steps, bisects, and asks with a tolerance whether the elements meet there. It misses
 * grazing contacts, planar motion and much more, which `touchstone fuzz` shows. Put your own solver in its place.
 * SPDX-License-Identifier: MIT */
#ifndef NAIVE_SOLVER_H
#define NAIVE_SOLVER_H

#include <math.h>
#include <string.h>

enum { EDGES = 1, FACE = 2 };

static void at_time(const double* start, const double* end, double t, double corners[12]) {
  int i;
  for (i = 0; i < 12; ++i) corners[i] = start[i] + t * (end[i] - start[i]);
}

static void minus(const double* a, const double* b, double d[3]) {
  int i;
  for (i = 0; i < 3; ++i) d[i] = a[i] - b[i];
}

static void cross(const double* a, const double* b, double c[3]) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* u and w span the plane; r leads from the one element to the other. */
static void frame(int sort, const double* c, double u[3], double w[3], double r[3]) {
  if (sort == EDGES) {
    minus(c + 3, c, u);
    minus(c + 9, c + 6, w);
    minus(c + 6, c, r);
  } else {
    minus(c + 6, c + 3, u);
    minus(c + 9, c + 3, w);
    minus(c, c + 3, r);
  }
}

static double volume(int sort, const double* start, const double* end, double t) {
  double c[12], u[3], w[3], r[3], n[3];
  at_time(start, end, t, c);
  frame(sort, c, u, w, r);
  cross(u, w, n);
  return dot(n, r);
}

/* Whether the elements meet where their lines, or point and plane, do. */
static int meet(int sort, const double* start, const double* end, double t) {
  const double tolerance = 1e-9;
  double c[12], u[3], w[3], r[3], n[3], rw[3], ru[3], f, g;
  at_time(start, end, t, c);
  frame(sort, c, u, w, r);
  cross(u, w, n);
  if (dot(n, n) == 0) return 0;
  cross(r, w, rw);
  cross(r, u, ru);
  f = dot(rw, n) / dot(n, n);
  g = dot(ru, n) / dot(n, n);
  if (sort == EDGES) {
    return f >= -tolerance && f <= 1 + tolerance && g >= -tolerance && g <= 1 + tolerance;
  }
  g = -g;
  return f >= -tolerance && g >= -tolerance && f + g <= 1 + tolerance;
}

/* 1 and *toi when the elements touch first at *toi in [0, 1], else 0. */
static int naive_solve(int sort, const double* start, const double* end, double* toi) {
  const int steps = 64;
  double before = volume(sort, start, end, 0);
  int i, k;
  for (i = 1; i <= steps; ++i) {
    const double after = volume(sort, start, end, (double)i / steps);
    if ((before <= 0 && after >= 0) || (before >= 0 && after <= 0)) {
      double low = (double)(i - 1) / steps, high = (double)i / steps;
      for (k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        const double value = volume(sort, start, end, middle);
        if ((before <= 0 && value >= 0) || (before >= 0 && value <= 0)) {
          high = middle;
        } else {
          low = middle;
        }
      }
      if (meet(sort, start, end, low) || meet(sort, start, end, high)) {
        *toi = low;
        return 1;
      }
    }
    before = after;
  }
  return 0;
}

#endif
