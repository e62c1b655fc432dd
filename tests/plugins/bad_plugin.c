/* A plugin that does whatever the first coordinate of the query, or the variable BAD_PLUGIN, tells it to.
 * SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include <touchstone/plugin.h>

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int told(const char* what) {
  const char* const order = getenv("BAD_PLUGIN");
  return order != NULL && strcmp(order, what) == 0;
}

static int calls = 0;

static int init(void** state) {
  if (told("init fails")) return 7;
  if (told("init crashes")) abort();
  if (told("init hangs")) pause();
  *state = &calls;
  return 0;
}

static void leave_a_note(void) {
  const char* const path = getenv("BAD_PLUGIN_NOTE");
  FILE* const file = path == NULL ? NULL : fopen(path, "a");
  if (file == NULL) return;
  fprintf(file, "%d\n", (int)getpid());
  fclose(file);
}

/* A process of its own session whose parent has ended, as daemons are. Returns once it runs. */
static void leave_a_daemon(void) {
  int ready[2];
  char byte = 0;
  if (pipe(ready) != 0) abort();
  if (fork() == 0) {
    setsid();
    if (fork() != 0) _exit(0);
    leave_a_note();
    if (write(ready[1], &byte, 1) != 1) _exit(1);
    for (;;) pause();
  }
  if (read(ready[0], &byte, 1) != 1) abort();
  close(ready[0]);
  close(ready[1]);
}

static void teardown(void* state) {
  if (told("teardown hangs")) pause();
  if (state == &calls) leave_a_note();
}

static int solve(void* state, int kind, const double* start, const double* end, double* toi) {
  (void)end;
  ++*(int*)state;
  switch ((int)start[0]) {
    case 1: abort();
    case 2: raise(SIGSEGV); break;
    case 3: exit(5);
    case 4: exit(0);
    case 5:
      for (;;) pause();
    case 6: return 42;
    case 7: *toi = nan(""); return TOUCHSTONE_CONTACT;
    case 8: return TOUCHSTONE_CONTACT; /* no time is written */
    case 9: *toi = HUGE_VAL; return TOUCHSTONE_CONTACT;
    case 10: *toi = 0.25; return TOUCHSTONE_CONTACT_ONLY;
    case 11: raise(SIGSTOP); break;
    case 12: raise(SIGKILL); break;
    case 13: /* much is said, and then no more */
      for (int i = 0; i < 20000; ++i) fputs("a word and another\n", stderr);
      fputs("the last words\n", stderr);
      abort();
    case 14: /* a child of its own that stays */
      if (fork() == 0) {
        leave_a_note();
        for (;;) pause();
      }
      sleep(1);
      abort();
    case 15:
      puts("to standard output");
      fflush(stdout);
      break;
    case 16: *toi = *(int*)state; return TOUCHSTONE_CONTACT; /* how many calls there were in this process */
    case 17: *toi = kind; return TOUCHSTONE_CONTACT;
    case 18: *toi = (double)getpid(); return TOUCHSTONE_CONTACT;
    case 19: /* the highest descriptor that is open */
      *toi = -1;
      for (int i = 0; i < 1000; ++i) {
        if (lseek(i, 0, SEEK_CUR) != -1 || write(i, "", 0) == 0) *toi = i;
      }
      return TOUCHSTONE_CONTACT;
    case 20: {                                         /* whether there is a gibibyte to be had */
      void* volatile memory = malloc((size_t)1 << 30); /* volatile: clang leaves an unused block out */
      *toi = memory == NULL ? 0 : 1;
      free(memory);
      return TOUCHSTONE_CONTACT;
    }
    case 21: leave_a_daemon(); break;
    case 22: leave_a_daemon(); abort();
    default: break;
  }
  return TOUCHSTONE_NO_CONTACT;
}

const struct touchstone_solver_plugin* touchstone_solver(void) {
  static struct touchstone_solver_plugin plugin = {
      TOUCHSTONE_PLUGIN_VERSION,
      TOUCHSTONE_KIND_BIT(TOUCHSTONE_KIND_EDGE_EDGE) | TOUCHSTONE_KIND_BIT(TOUCHSTONE_KIND_POINT_POINT), init, solve,
      teardown};
  if (told("loading crashes")) raise(SIGSEGV);
  if (told("null")) return NULL;
  if (told("another version")) plugin.version = 99;
  if (told("no kinds")) plugin.kinds = 0;
  if (told("unheard-of kinds")) plugin.kinds = 17;
  if (told("no solve")) plugin.solve = NULL;
  return &plugin;
}
