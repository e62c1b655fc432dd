/* A program in C11 that uses the library: a query, a batch, a mesh, bodies, and an error. Exit status 0 when all is right.
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <touchstone/c.h>
#include <touchstone/plugin.h> /* both headers in one program */

static int failures = 0;

static void check(int truth, const char* what) {
  if (!truth) {
    printf("wrong: %s (%s)\n", what, touchstone_last_error());
    ++failures;
  }
}

/* A vertex that falls through the triangle z = 0 at t = 1/2. */
static const double fall_start[12] = {0.25, 0.25, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
static const double fall_end[12] = {0.25, 0.25, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0};

static void one_query(void) {
  struct touchstone_answer answer;
  struct touchstone_options options = TOUCHSTONE_OPTIONS_INIT;

  check(touchstone_solve(TOUCHSTONE_KIND_VERTEX_FACE, fall_start, fall_end, NULL, &answer) == TOUCHSTONE_OK, "solve");
  check(answer.contact == 1 && answer.toi == 0.5 && answer.toi_upper == 0.5, "the time is 1/2");
  check(strcmp(touchstone_nature_name(answer.nature), "crossing") == 0, "the vertex crosses the face");
  check(strcmp(touchstone_feature_name(answer.feature_b), "f") == 0, "it meets the face's interior");
  check(answer.weights_b[0] == 0.5 && answer.weights_b[1] == 0.25, "the weights");

  options.separation = 0.5;
  check(touchstone_solve(TOUCHSTONE_KIND_VERTEX_FACE, fall_start, fall_end, &options, &answer) == TOUCHSTONE_OK,
        "solve with a separation");
  check(answer.toi == 0.25, "half a unit above at t = 1/4");

  options.t_max = 0.125;
  options.wanted = TOUCHSTONE_WANTED_CONTACT;
  check(touchstone_solve(TOUCHSTONE_KIND_VERTEX_FACE, fall_start, fall_end, &options, &answer) == TOUCHSTONE_OK,
        "contact alone");
  check(answer.contact == 0, "no contact until t = 1/8");
}

static void batch(void) {
  struct touchstone_answer answers[2];
  double start[24], end[24];
  memcpy(start, fall_start, sizeof fall_start);
  memcpy(end, fall_end, sizeof fall_end);
  memcpy(start + 12, fall_start, sizeof fall_start);
  memcpy(end + 12, fall_start, sizeof fall_start); /* at rest */
  check(touchstone_solve_rows(TOUCHSTONE_KIND_VERTEX_FACE, 2, start, end, NULL, answers) == TOUCHSTONE_OK, "rows");
  check(answers[0].contact == 1 && answers[1].contact == 0 && isinf(answers[1].toi),
        "the first falls, the other rests");
}

static void mesh(void) {
  const uint32_t faces[6] = {0, 1, 2, 3, 4, 5};
  const double x0[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 0.25, 0.5, 2, 0.5, 0.25, 2};
  double x1[18], y[18], length = -1;
  struct touchstone_mesh_elements elements = TOUCHSTONE_MESH_ELEMENTS_INIT;
  touchstone_mesh* handle = NULL;
  touchstone_contacts* first = NULL;
  struct touchstone_first_contact result = TOUCHSTONE_FIRST_CONTACT_INIT;
  struct touchstone_mesh_pair pair;
  int outcome = -1, i;

  for (i = 0; i < 18; ++i) x1[i] = x0[i] - (i >= 9 && i % 3 == 2 ? 2 : 0);
  elements.vertex_count = 6;
  elements.faces = faces;
  elements.face_count = 2;
  check(touchstone_mesh_create(&elements, &handle) == TOUCHSTONE_OK, "a mesh");
  check(touchstone_mesh_first_contact(handle, x0, x1, 18, NULL, &result, &first, NULL) == TOUCHSTONE_OK, "first");
  check(result.contact == 1 && result.free == 0 && result.toi == 0.5, "the tip meets the lower face at t = 1/2");
  check(touchstone_contacts_count(first) == 1, "one pair");
  check(touchstone_contacts_get(first, 0, &pair, NULL) == TOUCHSTONE_OK && pair.kind == TOUCHSTONE_KIND_VERTEX_FACE &&
            pair.first == 3 && pair.second == 0,
        "vertex 3 and face 0");
  check(touchstone_contacts_get(first, 1, &pair, NULL) == TOUCHSTONE_INVALID_ARGUMENT, "no second pair");
  check(touchstone_mesh_free_step(handle, x0, x1, 18, NULL, y, &length, &outcome, NULL) == TOUCHSTONE_OK, "free_step");
  check(outcome == TOUCHSTONE_STEP_SHORTENED && length < 0.5 && length > 0.49 && y[11] > 0, "a step that is free");
  touchstone_contacts_destroy(first);
  touchstone_mesh_destroy(handle);
}

/* An edge makes a quarter turn about z, beside a plate at y = 1.375 that its points reach on the way. */
static void bodies(void) {
  const uint32_t edge[2] = {0, 1}, face[3] = {0, 1, 2};
  const double edge_points[6] = {1, 1, -3, 1, 1, 3}, face_points[9] = {-9, 0, -9, 9, 0, -9, 0, 0, 9};
  const double start[14] = {0, 0, 0, 1, 0, 0, 0, 0, 1.375, 0, 1, 0, 0, 0}; /* x y z, w x y z */
  const double end[14] = {0, 0, 0, 1, 0, 0, 1, 0, 1.375, 0, 1, 0, 0, 0};
  double poses[14], length = -1;
  struct touchstone_mesh_elements bar = TOUCHSTONE_MESH_ELEMENTS_INIT, wall = TOUCHSTONE_MESH_ELEMENTS_INIT;
  struct touchstone_bodies_elements elements = TOUCHSTONE_BODIES_ELEMENTS_INIT;
  struct touchstone_first_body_contact result = TOUCHSTONE_FIRST_BODY_CONTACT_INIT;
  struct touchstone_body_pair pair;
  touchstone_mesh* meshes[2] = {NULL, NULL};
  touchstone_body* made[2] = {NULL, NULL};
  const touchstone_body* both[2];
  touchstone_bodies* handle = NULL;
  touchstone_body_contacts* first = NULL;
  touchstone_body_pairs* pairs = NULL;
  struct touchstone_body_screw_answer screw = TOUCHSTONE_BODY_SCREW_ANSWER_INIT;
  struct touchstone_body_distance near = TOUCHSTONE_BODY_DISTANCE_INIT;
  int outcome = -1, i;

  bar.vertex_count = 2, bar.edges = edge, bar.edge_count = 1;
  wall.vertex_count = 3, wall.faces = face, wall.face_count = 1;
  check(touchstone_mesh_create(&bar, &meshes[0]) == TOUCHSTONE_OK, "the mesh of the bar");
  check(touchstone_mesh_create(&wall, &meshes[1]) == TOUCHSTONE_OK, "the mesh of the wall");
  check(touchstone_body_create(meshes[0], edge_points, 6, &made[0]) == TOUCHSTONE_OK, "the bar");
  check(touchstone_body_create(meshes[1], face_points, 9, &made[1]) == TOUCHSTONE_OK, "the wall");
  both[0] = made[0], both[1] = made[1];
  elements.bodies = both, elements.body_count = 2;
  check(touchstone_bodies_create(&elements, &handle) == TOUCHSTONE_INVALID_ARGUMENT, "the order is to be named");
  elements.quaternion = TOUCHSTONE_QUATERNION_WXYZ;
  check(touchstone_bodies_create(&elements, &handle) == TOUCHSTONE_OK, "bodies");
  for (i = 0; i < 2; ++i) {
    touchstone_mesh_destroy(meshes[i]);
    touchstone_body_destroy(made[i]);
  }
  check(touchstone_bodies_first_contact(handle, start, end, 14, NULL, &result, &first, NULL) == TOUCHSTONE_OK,
        "the first contact of bodies");
  check(result.contact == 1 && result.free == 0 && result.toi > 0.2 && result.toi < 0.3, "the bar meets the wall");
  check(touchstone_body_contacts_count(first) == 2, "both of its points");
  check(touchstone_body_contacts_get(first, 1, &pair, NULL) == TOUCHSTONE_OK &&
            pair.kind == TOUCHSTONE_KIND_VERTEX_FACE && pair.first_body == 0 && pair.first == 1 &&
            pair.second_body == 1 && pair.second == 0,
        "vertex 1 of the bar and face 0 of the wall");
  check(touchstone_bodies_free_step(handle, start, end, 14, NULL, poses, &length, &outcome, NULL) == TOUCHSTONE_OK,
        "the free step of bodies");
  check(outcome == TOUCHSTONE_STEP_SHORTENED && length > 0.2 && length <= result.toi, "it ends before the contact");
  check(touchstone_bodies_solve_screw(handle, start, end, 14, NULL, 0, NULL, &screw, NULL) == TOUCHSTONE_OK, "a screw");
  check(screw.verdict == TOUCHSTONE_SCREW_CONTACT && screw.free == 0 && screw.free_until <= screw.contact_by,
        "it meets the wall at a constant rate, too");
  check(touchstone_bodies_distance(handle, start, 14, NULL, &near, NULL, NULL) == TOUCHSTONE_OK, "a distance");
  check(near.distance == 0.375 && near.intersections == 0, "the bar is 3/8 from the wall");
  check(touchstone_bodies_candidates(handle, start, end, 14, NULL, &pairs) == TOUCHSTONE_OK, "candidates");
  check(touchstone_body_pairs_count(pairs) >= 2, "both points of the bar are among them");
  touchstone_body_contacts_destroy(first);
  touchstone_body_pairs_destroy(pairs);
  touchstone_bodies_destroy(handle);
}

static void error(void) {
  struct touchstone_answer answer;
  double start[12];
  memcpy(start, fall_start, sizeof start);
  start[4] = NAN;
  check(touchstone_solve(TOUCHSTONE_KIND_VERTEX_FACE, start, fall_end, NULL, &answer) == TOUCHSTONE_INVALID_QUERY,
        "a NaN is refused");
  check(strstr(touchstone_last_error(), "f0") != NULL, "the message names the corner");
}

int main(void) {
  check(touchstone_c_version() == TOUCHSTONE_C_VERSION, "header and library are of one version");
  check(strlen(touchstone_last_error()) == 0, "no error yet");
  one_query();
  batch();
  mesh();
  bodies();
  error();
  return failures == 0 ? 0 : 1;
}
