/* Touchstone: the library for C, and for every language that calls C.
 * SPDX-License-Identifier: MIT
 */
#ifndef TOUCHSTONE_C_H
#define TOUCHSTONE_C_H

/** @file
 * The library for C, and for every language that calls C.
 *
 * Plain C11, and C++. Link the library `touchstone`. The answers are those of the C++ functions. Whole bodies that turn
 * are in touchstone/c_bodies.h, which this header includes.
 *
 * Every function that can fail returns one of touchstone_status_code. No C++ exception leaves a function. After a
 * failure touchstone_last_error() says what is wrong, and nothing that the function wrote is valid; a handle that it
 * was to make is null. Any number of threads may call any function, and may use one handle at a time, but for
 * destroying it.
 *
 * A structure with the member `size` can grow. Initialise it by its macro, which sets `size`. A later version of the
 * library adds members at the end, and takes the smaller structure of a program that was compiled before. A larger one
 * than it knows is refused. The other structures stay as they are.
 *
 * Coordinates are x y z of the first corner, then x y z of the second corner, and so on: 12 doubles for edge-edge (a0
 * a1 b0 b1) and vertex-face (v f0 f1 f2), 9 for point-edge (p e0 e1), 6 for point-point (p q). `start` holds the
 * corners at t = 0 and `end` those at t = 1. For a query in two dimensions each z is 0.
 */

#include <stddef.h>
#include <stdint.h>

#include <touchstone/kinds.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The version of this interface. A number is added for each addition; nothing is taken away under one number. */
#define TOUCHSTONE_C_VERSION 8

/** The values that functions return. */
enum touchstone_status_code {
  TOUCHSTONE_OK = 0,               /**< the function did its work */
  TOUCHSTONE_INVALID_ARGUMENT = 1, /**< a null pointer, an unknown enumerator, a size or count that cannot be */
  TOUCHSTONE_INVALID_QUERY = 2,    /**< a coordinate or an option without meaning; InvalidQuery in C++ */
  TOUCHSTONE_INVALID_MESH = 3,     /**< a mesh without meaning; InvalidMesh in C++ */
  TOUCHSTONE_OUT_OF_MEMORY = 4,    /**< memory ran out */
  TOUCHSTONE_INTERNAL_ERROR = 5    /**< any other error */
};

/** What is wanted of contacts. Each value leaves out more than the one before, and costs less. */
enum touchstone_what_is_wanted {
  TOUCHSTONE_WANTED_ALL = 0,      /**< everything */
  TOUCHSTONE_WANTED_FEATURES = 1, /**< all but the weights */
  TOUCHSTONE_WANTED_TIME = 2,     /**< toi, toi_upper and starts_within */
  TOUCHSTONE_WANTED_CONTACT = 3   /**< whether there is one */
};

/** How queries are decided. The answers are the same, but for the level and the last digits of weights. */
enum touchstone_method {
  TOUCHSTONE_METHOD_FAST = 0,     /**< error-bounded filters, and exact arithmetic where they are uncertain */
  TOUCHSTONE_METHOD_EXACT = 1,    /**< exact arithmetic alone */
  TOUCHSTONE_METHOD_ORACLE = 2,   /**< CGAL's algebraic kernel: slow. It needs a library with CGAL */
  TOUCHSTONE_METHOD_FAST_CGAL = 3 /**< as fast, with CGAL where the filters are uncertain. It needs CGAL, too */
};

/** The options of queries and meshes. A null pointer in place of options means TOUCHSTONE_OPTIONS_INIT. A function
 *  refuses an option that it has not, unless it is as TOUCHSTONE_OPTIONS_INIT sets it; `threads` each one takes. */
struct touchstone_options {
  size_t size;     /**< sizeof(struct touchstone_options) */
  double t_max;    /**< of steps: the end of the time range, 0 <= t_max <= 1; a free step has none */
  int32_t threads; /**< of a batch or mesh: 1 to 1024; 0 takes as many as the machine has; it changes no answer */
  int32_t metric;  /**< of queries: one of touchstone_metric; a mesh has its own */

  /** Of queries: elements are in contact while their distance is at most this; finite and not negative. With 0, contact
   *  is touching. A mesh has its own separations. */
  double separation;
  const double* separations; /**< null; or of a batch, in place of separation: one distance for each query */
  size_t separation_count;   /**< the number of separations: that of the queries, or 0 */

  /** Of touchstone_mesh_free_step: the fraction of its distance that each pair keeps, in [0, 1). */
  double kept_fraction;

  /** Of touchstone_solve and batches: one of touchstone_what_is_wanted. What is not wanted of a contact is as without
   *  contact, except that unwanted times are NaN. */
  int32_t wanted;

  /** Of touchstone_mesh_free_step: 1 to end the step at positions that are float32 numbers, 0 otherwise. The start must
   *  then be of such numbers, too. */
  int32_t float32;

  /** Of first contacts and free steps: 1 to ask also whether the mesh intersects itself at the start, or bodies each
   *  other, 0 to leave that out. A step is about a start that is free: where one element passes through another at the
   *  start, or a body is inside another, and no pair touches, no contact need follow. */
  int32_t check_start;

  int32_t reserved;   /**< of no meaning; earlier structures end here */
  int32_t method;     /**< of touchstone_solve and batches: one of touchstone_method */
  int32_t reserved_2; /**< of no meaning; earlier structures end here */

  /** Of touchstone_bodies_solve_screw: into how many arcs a step is cut first, and at most while a verdict is left
   *  open: powers of two from 4 to 2^20, or 0 for the default. */
  int32_t arcs;
  int32_t most_arcs; /**< it has no effect when it is less than `arcs` */
};

/** The options by default: the whole step, touching, one thread. */
#define TOUCHSTONE_OPTIONS_INIT                                                                      \
  {                                                                                                  \
    sizeof(struct touchstone_options), 1.0, 1, 0, 0.0, NULL, 0, 0.0, TOUCHSTONE_WANTED_ALL, 0, 0, 0, \
        TOUCHSTONE_METHOD_FAST, 0, 8, 256                                                            \
  }

/** The answer to one query. Without contact both times are infinity, and only `contact` and `level` have a meaning.
 *  Names for the numbers: touchstone_nature_name and the other functions that end in _name. */
struct touchstone_answer {
  uint8_t contact;       /**< 1 when the elements touch at any time in [0, t_max], otherwise 0 */
  uint8_t level;         /**< the level that decided */
  uint8_t nature;        /**< how the elements meet at the first contact */
  uint8_t feature_a;     /**< the touched part of the first element */
  uint8_t feature_b;     /**< the touched part of the second element */
  uint8_t starts_within; /**< 1 when the contact exists at t = 0 already, otherwise 0 */
  uint8_t trend;         /**< what the distance does after the first contact, with a separation above 0 */
  uint8_t reserved;      /**< of no meaning */
  double toi;            /**< the largest double <= the exact first time of contact */
  double toi_upper;      /**< the smallest double >= the exact first time of contact */
  double weights_a[3];   /**< barycentric coordinates on the first element, each within 2^-50 of its true value */
  double weights_b[3];   /**< the same on the second element */
};

/** The version of this interface that the linked library has: the TOUCHSTONE_C_VERSION that it was compiled with. */
uint32_t touchstone_c_version(void);

/** The version of the linked library, "MAJOR.MINOR.PATCH". */
const char* touchstone_version(void);

/** What was wrong in this thread's latest call that failed; empty before one. The text is valid until this thread's
 *  next call. It is cut after 1000 bytes. */
const char* touchstone_last_error(void);

/** The name of a touchstone_answer's nature: "crossing", "grazing", "sustained", "isolated", "entering"; otherwise
 *  empty. */
const char* touchstone_nature_name(int nature);

/** The name of a touchstone_answer's feature: "a0", "a", "f01", "overlap", ...; otherwise empty. */
const char* touchstone_feature_name(int feature);

/** The name of a touchstone_answer's level: "filter", "bracket", "exact", "oracle"; otherwise empty. */
const char* touchstone_level_name(int level);

/** The name of a touchstone_answer's trend: "approaching", "constant", "leaving"; otherwise empty. */
const char* touchstone_trend_name(int trend);

/** The first contact of one query.
 *  @param kind     one of touchstone_kind
 *  @param start    the corners at t = 0
 *  @param end      the corners at t = 1
 *  @param options  the options, or null
 *  @param answer   becomes the answer
 *  @return one of touchstone_status_code */
int touchstone_solve(int kind, const double* start, const double* end, const struct touchstone_options* options,
                     struct touchstone_answer* answer);

/** The answers to many queries of one kind, in columns: the fastest way to ask.
 *  @param kind     one of touchstone_kind
 *  @param count    the number of queries, and the length of each column
 *  @param start    a pointer for each coordinate of each corner: 12, 9 or 6 columns, x y z of the first corner first
 *  @param end      the same at t = 1
 *  @param options  the options, or null
 *  @param answers  room for `count` answers
 *  @return one of touchstone_status_code */
int touchstone_solve_columns(int kind, size_t count, const double* const* start, const double* const* end,
                             const struct touchstone_options* options, struct touchstone_answer* answers);

/** The answers to many queries of one kind, in rows. Blocks of rows are copied into columns.
 *  @param kind     one of touchstone_kind
 *  @param count    the number of queries
 *  @param start    12, 9 or 6 doubles for each query, one query after another
 *  @param end      the same at t = 1
 *  @param options  the options, or null
 *  @param answers  room for `count` answers
 *  @return one of touchstone_status_code */
int touchstone_solve_rows(int kind, size_t count, const double* start, const double* end,
                          const struct touchstone_options* options, struct touchstone_answer* answers);

/** A mesh whose elements were checked. */
typedef struct touchstone_mesh touchstone_mesh;

/** A list of contacts, which the library owns. */
typedef struct touchstone_contacts touchstone_contacts;

/** A list of intersections at rest, which the library owns. */
typedef struct touchstone_intersections touchstone_intersections;

/** Two elements of a mesh, of one of touchstone_kind: edge and edge, vertex and face, vertex and edge, or vertex
 *  and vertex. */
struct touchstone_mesh_pair {
  int32_t kind;    /**< one of touchstone_kind */
  uint32_t first;  /**< the number of an edge, or of a vertex for the other three kinds */
  uint32_t second; /**< the number of an edge, face, edge or vertex */
};

/** What a mesh is made of. The arrays are copied. An array that is null has no members; its count must then be 0. */
struct touchstone_mesh_elements {
  size_t size;           /**< sizeof(struct touchstone_mesh_elements) */
  size_t vertex_count;   /**< the number of vertices, below 2^32 - 1 */
  int32_t dimension;     /**< 2 or 3 */
  int32_t metric;        /**< one of touchstone_metric */
  double separation;     /**< the separation of every pair */
  const double* radii;   /**< a radius for each vertex, in place of the separation, which must then be 0 */
  size_t radius_count;   /**< the number of radii: that of the vertices, or 0 */
  const uint32_t* faces; /**< three vertices for each face */
  size_t face_count;     /**< the number of faces */
  const uint32_t* edges; /**< two vertices for each edge; those of the faces need not be given */
  size_t edge_count;     /**< the number of edges */

  /** The vertices that collide without an edge. If it is null, these are all vertices that are in no edge. */
  const uint32_t* points;
  size_t point_count;                                /**< the number of points */
  const uint32_t* excluded_vertices;                 /**< two vertices each, which never collide with each other */
  size_t excluded_vertex_count;                      /**< the number of pairs of vertices */
  const struct touchstone_mesh_pair* excluded_pairs; /**< pairs of elements that never collide */
  size_t excluded_pair_count;                        /**< the number of pairs of elements */
  const struct touchstone_mesh_pair* separate_pairs; /**< pairs of elements with a separation of their own */
  const double* pair_separations;                    /**< their separations */
  size_t separate_pair_count;                        /**< the number of pairs, and of their separations */
  const uint32_t* groups;                            /**< the group of each vertex */
  size_t group_count;                                /**< the number of vertices, or 0 without groups */
  const uint32_t* group_pairs;                       /**< two groups each, which the rule is about */
  size_t group_pair_count;                           /**< the number of pairs of groups */
  int32_t only_listed_groups; /**< 0: the pairs of groups never collide; 1: these and no others collide */
};

/** A mesh without vertices in three dimensions. */
#define TOUCHSTONE_MESH_ELEMENTS_INIT                                                                                  \
  {                                                                                                                    \
    sizeof(struct touchstone_mesh_elements), 0, 3, 0, 0.0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, \
        NULL, 0, NULL, 0, NULL, 0, 0                                                                                   \
  }

/** Makes a mesh.
 *  @param elements  what it is made of
 *  @param mesh      becomes the mesh; touchstone_mesh_destroy ends it
 *  @return one of touchstone_status_code */
int touchstone_mesh_create(const struct touchstone_mesh_elements* elements, touchstone_mesh** mesh);

/** Ends a mesh. Lists that were made with it stay valid. A null pointer is allowed. */
void touchstone_mesh_destroy(touchstone_mesh* mesh);

/** Says whether a mesh keeps memory, and the pairs that may meet, from one question about a step to the next. Questions
 *  that are alike, such as the tries of a line search, are then answered sooner, with the same results. Such a mesh is
 *  used by one thread at a time. A mesh keeps nothing at first. touchstone/mesh_steps.hpp says what is alike.
 *  @param mesh  the mesh
 *  @param keep  1 to keep them, from nothing; 0 to give all memory back that is kept
 *  @return one of touchstone_status_code */
int touchstone_mesh_keep(touchstone_mesh* mesh, int keep);

/** Says whether there are two elements that could meet, and two groups of vertices that may collide, if there are
 *  groups. Where it is 0, no pair is asked about, and a verdict about the mesh says nothing.
 *  @param mesh       the mesh
 *  @param has_pairs  becomes 1 or 0
 *  @return one of touchstone_status_code */
int touchstone_mesh_has_pairs(const touchstone_mesh* mesh, int* has_pairs);

/** The corners of edge `edge` of a mesh: the edges that were given, and then the other edges of the faces.
 *  @param mesh     the mesh
 *  @param edge     the number of an edge
 *  @param corners  becomes the numbers of two vertices
 *  @return one of touchstone_status_code */
int touchstone_mesh_edge(const touchstone_mesh* mesh, size_t edge, uint32_t corners[2]);

/** When the elements of a mesh first come into contact. */
struct touchstone_first_contact {
  size_t size;     /**< sizeof(struct touchstone_first_contact) */
  int32_t contact; /**< 1 when two elements that are apart at the start come into contact in [0, t_max], otherwise 0 */

  /** 1 when there is no contact at all, at the start neither, and, where start_checked is 1, no intersection at the
   *  start; otherwise 0. Where start_checked is 0, a start that intersects itself may be free. */
  int32_t free;
  double toi;                 /**< the largest double <= the exact first time of such a contact; infinity without one */
  double toi_upper;           /**< the smallest double >= this time; infinity without contact */
  size_t start_intersections; /**< how often the mesh intersects itself at the start; 0 when that was not asked */
  int32_t start_checked;      /**< 1 when that was asked, by check_start of the options, otherwise 0 */
  int32_t reserved;           /**< of no meaning */
};

/** No first contact. */
#define TOUCHSTONE_FIRST_CONTACT_INIT \
  { sizeof(struct touchstone_first_contact), 0, 0, 0.0, 0.0, 0, 0, 0 }

/** The first contact while each vertex moves from its position in x0 to that in x1.
 *  @param mesh         the mesh
 *  @param x0           the positions at t = 0, 2 or 3 doubles for each vertex, as the mesh has dimensions
 *  @param x1           the positions at t = 1
 *  @param value_count  the number of doubles in x0, and in x1
 *  @param options      the options, or null
 *  @param result       becomes the first contact; initialise it by its macro
 *  @param first        null; or becomes the list of all pairs whose contact begins at that time
 *  @param at_start     null; or becomes the list of all pairs that are in contact at the start
 *  @return one of touchstone_status_code */
int touchstone_mesh_first_contact(const touchstone_mesh* mesh, const double* x0, const double* x1, size_t value_count,
                                  const struct touchstone_options* options, struct touchstone_first_contact* result,
                                  touchstone_contacts** first, touchstone_contacts** at_start);

/** Every pair that comes into contact in [0, t_max], in the order of time.
 *  @param mesh         the mesh
 *  @param x0           the positions at t = 0, 2 or 3 doubles for each vertex, as the mesh has dimensions
 *  @param x1           the positions at t = 1
 *  @param value_count  the number of doubles in x0, and in x1
 *  @param options      the options, or null
 *  @param contacts     becomes the list; touchstone_contacts_destroy ends it
 *  @return one of touchstone_status_code */
int touchstone_mesh_all_contacts(const touchstone_mesh* mesh, const double* x0, const double* x1, size_t value_count,
                                 const struct touchstone_options* options, touchstone_contacts** contacts);

/** The number of contacts in a list; 0 for a null pointer. */
size_t touchstone_contacts_count(const touchstone_contacts* contacts);

/** One contact of a list.
 *  @param contacts  the list
 *  @param index     0 <= index < touchstone_contacts_count(contacts)
 *  @param pair      null; or becomes the elements
 *  @param answer    null; or becomes the answer for them
 *  @return one of touchstone_status_code */
int touchstone_contacts_get(const touchstone_contacts* contacts, size_t index, struct touchstone_mesh_pair* pair,
                            struct touchstone_answer* answer);

/** Ends a list of contacts. A null pointer is allowed. */
void touchstone_contacts_destroy(touchstone_contacts* contacts);

/** The sorts of element that intersect. */
enum touchstone_element {
  TOUCHSTONE_ELEMENT_VERTEX = 0, /**< a vertex */
  TOUCHSTONE_ELEMENT_EDGE = 1,   /**< an edge */
  TOUCHSTONE_ELEMENT_FACE = 2    /**< a face */
};

/** How two elements meet at rest. touchstone/mesh.hpp has the definitions. */
enum touchstone_intersection_sort {
  TOUCHSTONE_TOUCHES = 0, /**< they share a point, and no vertex */
  TOUCHSTONE_PIERCES = 1, /**< the edge passes through */
  TOUCHSTONE_FOLDS = 2,   /**< they share a vertex, and also a point that is no shared vertex */
  TOUCHSTONE_INSIDE = 3   /**< the vertex's closed surface lies wholly inside the face's; they may share vertices */
};

/** Two elements of a mesh that share a point at rest, or of which one is inside the other's surface. */
struct touchstone_intersection {
  int32_t first_element;    /**< one of touchstone_element */
  uint32_t first;           /**< its number */
  int32_t second_element;   /**< one of touchstone_element */
  uint32_t second;          /**< its number */
  int32_t pierces;          /**< 1 when an edge passes through, otherwise 0 */
  int32_t sort;             /**< one of touchstone_intersection_sort */
  double weights_first[3];  /**< a common point: barycentric coordinates on the first element */
  double weights_second[3]; /**< the same on the second element */
};

/** Where a mesh intersects itself, exactly.
 *  @param mesh           the mesh
 *  @param x              the positions, 2 or 3 doubles for each vertex, as the mesh has dimensions
 *  @param value_count    the number of doubles in x
 *  @param options        the options, or null
 *  @param intersections  becomes the list; touchstone_intersections_destroy ends it
 *  @return one of touchstone_status_code */
int touchstone_mesh_intersections(const touchstone_mesh* mesh, const double* x, size_t value_count,
                                  const struct touchstone_options* options, touchstone_intersections** intersections);

/** Whether a mesh intersects itself, exactly: whether touchstone_mesh_intersections finds any. It ends at the first.
 *  @param mesh         the mesh
 *  @param x            the positions, 2 or 3 doubles for each vertex, as the mesh has dimensions
 *  @param value_count  the number of doubles in x
 *  @param options      the options, or null
 *  @param intersects   becomes 1 or 0
 *  @return one of touchstone_status_code */
int touchstone_mesh_intersects(const touchstone_mesh* mesh, const double* x, size_t value_count,
                               const struct touchstone_options* options, int* intersects);

/** The number of intersections in a list; 0 for a null pointer. */
size_t touchstone_intersections_count(const touchstone_intersections* intersections);

/** One intersection of a list.
 *  @param intersections  the list
 *  @param index          0 <= index < touchstone_intersections_count(intersections)
 *  @param intersection   becomes the intersection
 *  @return one of touchstone_status_code */
int touchstone_intersections_get(const touchstone_intersections* intersections, size_t index,
                                 struct touchstone_intersection* intersection);

/** Ends a list of intersections. A null pointer is allowed. */
void touchstone_intersections_destroy(touchstone_intersections* intersections);

/** How a step was shortened. */
enum touchstone_step_outcome {
  TOUCHSTONE_STEP_WHOLE = 0,              /**< the whole step is free: the positions are x1, bit for bit */
  TOUCHSTONE_STEP_SHORTENED = 1,          /**< the step was shortened, and some vertex moves */
  TOUCHSTONE_STEP_NO_ROOM = 2,            /**< every step that moves a vertex to another double ends in a contact */
  TOUCHSTONE_STEP_CONTACT_AT_START = 3,   /**< some pair is in contact at the start; the positions are x0 */
  TOUCHSTONE_STEP_INTERSECTS_AT_START = 4 /**< with check_start: the mesh intersects itself at the start; they are x0 */
};

/** The longest step that is proved free of contact, and the rounded positions after it: the path from x0 to these was
 *  asked about. The step is over [0, 1]: t_max must be 1.
 *  @param mesh         the mesh
 *  @param x0           the positions at t = 0, 2 or 3 doubles for each vertex, as the mesh has dimensions
 *  @param x1           the positions at t = 1
 *  @param value_count  the number of doubles in x0, in x1 and in positions
 *  @param options      the options, or null; kept_fraction is one of them
 *  @param positions    becomes the positions after the step; it may be x0 or x1
 *  @param length       null; or becomes the fraction of the step, in [0, 1]
 *  @param outcome      null; or becomes one of touchstone_step_outcome
 *  @param contact      null; or becomes the first contact of the whole step, about the distances that the step is to
 *                      keep, which says whether the start was asked about; initialise it by its macro
 *  @return one of touchstone_status_code */
int touchstone_mesh_free_step(const touchstone_mesh* mesh, const double* x0, const double* x1, size_t value_count,
                              const struct touchstone_options* options, double* positions, double* length, int* outcome,
                              struct touchstone_first_contact* contact);

#ifdef __cplusplus
}
#endif

#include <touchstone/c_bodies.h>

#endif /* TOUCHSTONE_C_H */
