/* A user's program in C: the library answers, and it is the version that was found.
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include <touchstone/c.h>

int main(void) {
  const double start[12] = {0.25, 0.25, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const double end[12] = {0.25, 0.25, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  struct touchstone_answer answer;
  if (strcmp(touchstone_version(), EXPECTED_VERSION) != 0) {
    printf("the library says that it is %s, not %s\n", touchstone_version(), EXPECTED_VERSION);
    return 1;
  }
  if (touchstone_solve(TOUCHSTONE_KIND_VERTEX_FACE, start, end, NULL, &answer) != TOUCHSTONE_OK) {
    printf("%s\n", touchstone_last_error());
    return 1;
  }
  if (answer.toi != 0.5 || answer.toi_upper != 0.5) {
    printf("the time is %a, not 0.5\n", answer.toi);
    return 1;
  }
  printf("C: contact at %g\n", answer.toi);
  return 0;
}
