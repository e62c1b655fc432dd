/* A solver as a program that is asked over pipes: cc -O2 -o naive program.c -lm
 * Then: touchstone fuzz --solver-command ./naive
 *
 * A line in is a kind and numbers: x y z of each corner at t = 0, then of each at t = 1. A line out is 0, or 1 and the
 * time of the first contact in [0, 1]. It must be flushed: the next line comes after the answer only.
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "naive_solver.h"

int main(void) {
  char line[4096];
  while (fgets(line, sizeof line, stdin) != NULL) {
    double numbers[24], toi = 0;
    char* at = strchr(line, ' ');
    int sort = 0, i;
    if (strncmp(line, "edge-edge ", 10) == 0) sort = EDGES;
    if (strncmp(line, "vertex-face ", 12) == 0) sort = FACE;
    if (sort == 0) {
      puts("unsupported");
    } else {
      for (i = 0; i < 24; ++i) numbers[i] = strtod(at, &at);
      if (naive_solve(sort, numbers, numbers + 12, &toi)) {
        printf("1 %a\n", toi);
      } else {
        puts("0");
      }
    }
    if (fflush(stdout) != 0) return 1;
  }
  return 0;
}
