/* Touchstone for C: whole bodies that turn and move. touchstone/c.h includes this header.
 * SPDX-License-Identifier: MIT
 */
#ifndef TOUCHSTONE_C_BODIES_H
#define TOUCHSTONE_C_BODIES_H

/** @file
 * Whole bodies that turn and move, for C. The rules of touchstone/c.h hold here, too.
 *
 * A pose is 7 doubles: x y z of the body's origin, and then its quaternion, of any length but 0, in the order that the
 * bodies were made with. The poses of bodies follow one another.
 */

#include <stddef.h>
#include <stdint.h>

#include <touchstone/c.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A rigid body: a mesh, with its vertices in the body's own frame. */
typedef struct touchstone_body touchstone_body;

/** Bodies, and which of them never collide. */
typedef struct touchstone_bodies touchstone_bodies;

/** A list of contacts of bodies, which the library owns. */
typedef struct touchstone_body_contacts touchstone_body_contacts;

/** A list of pairs of elements of bodies, which the library owns. */
typedef struct touchstone_body_pairs touchstone_body_pairs;

/** A list of intersections of bodies at rest, which the library owns. */
typedef struct touchstone_body_intersections touchstone_body_intersections;

/** A list of pairs that meet on screws, or may meet, which the library owns. */
typedef struct touchstone_body_screws touchstone_body_screws;

/** Makes a body, once for any number of questions.
 *  @param mesh         its faces, edges and loose points, and their radii; its rules and separations do not count. It
 *                      is in three dimensions, and may be destroyed before the body
 *  @param points       the positions of the vertices in the body's own frame, 3 doubles for each
 *  @param value_count  the number of doubles in points
 *  @param body         becomes the body; touchstone_body_destroy ends it
 *  @return one of touchstone_status_code */
int touchstone_body_create(const touchstone_mesh* mesh, const double* points, size_t value_count,
                           touchstone_body** body);

/** Ends a body. Bodies that were made of it stay valid. A null pointer is allowed. */
void touchstone_body_destroy(touchstone_body* body);

/** The order of a quaternion's components. None is the default: both are common, and the wrong one gives other
 *  orientations without an error. */
enum touchstone_quaternion_order {
  TOUCHSTONE_QUATERNION_WXYZ = 1, /**< w first: Eigen's constructor, MuJoCo */
  TOUCHSTONE_QUATERNION_XYZW = 2  /**< w last: ROS, Unity, SciPy, glTF */
};

/** Which of both turns a body takes between two orientations: q and -q are the same orientation. */
enum touchstone_turn {
  TOUCHSTONE_TURN_SHORTER = 0, /**< the turn by at most 180 degrees, whatever the signs are */
  TOUCHSTONE_TURN_AS_GIVEN = 1 /**< the one that the signs say: longer than 180 degrees where q0 . q1 < 0 */
};

/** Which bodies are asked about. The arrays are copied. An array that is null has no members; its count must then be
 *  0. */
struct touchstone_bodies_elements {
  size_t size;                          /**< sizeof(struct touchstone_bodies_elements) */
  const touchstone_body* const* bodies; /**< the bodies; one may come several times */
  size_t body_count;                    /**< the number of bodies, below 2^32 - 1 */
  double separation;                    /**< bodies within this of each other are in contact; radii come on top */
  int32_t metric;                       /**< one of touchstone_metric */
  int32_t quaternion;                   /**< of all poses: one of touchstone_quaternion_order */
  int32_t turn;                         /**< of all motions: one of touchstone_turn */
  int32_t only_listed_groups;           /**< 0: the pairs of groups never collide; 1: these and no others collide */
  const uint32_t* excluded_bodies;      /**< the numbers of two bodies each, which never collide with each other */
  size_t excluded_body_count;           /**< the number of pairs of bodies */
  const uint32_t* groups;               /**< the group of each body */
  size_t group_count;                   /**< the number of bodies, or 0 without groups */
  const uint32_t* group_pairs;          /**< two groups each, which the rule is about */
  size_t group_pair_count;              /**< the number of pairs of groups */
};

/** No bodies, the shorter turns, and no order of a quaternion, which must be set. */
#define TOUCHSTONE_BODIES_ELEMENTS_INIT                                                                                \
  {                                                                                                                    \
    sizeof(struct touchstone_bodies_elements), NULL, 0, 0.0, 0, 0, TOUCHSTONE_TURN_SHORTER, 0, NULL, 0, NULL, 0, NULL, \
        0                                                                                                              \
  }

/** Makes bodies to ask about. What is wrong with the rules is said by the first question.
 *  @param elements  the bodies and the rules
 *  @param bodies    becomes them; touchstone_bodies_destroy ends them
 *  @return one of touchstone_status_code */
int touchstone_bodies_create(const struct touchstone_bodies_elements* elements, touchstone_bodies** bodies);

/** Ends bodies. Lists that were made with them stay valid. A null pointer is allowed. */
void touchstone_bodies_destroy(touchstone_bodies* bodies);

/** Elements of two bodies, of one of touchstone_kind. Of two edges, and of two vertices, the one of the lesser body is
 *  the first. */
struct touchstone_body_pair {
  int32_t kind;         /**< one of touchstone_kind */
  uint32_t first_body;  /**< the number of a body, from 0 */
  uint32_t first;       /**< the number of an edge in its mesh, or of a vertex for the other three kinds */
  uint32_t second_body; /**< the number of another body */
  uint32_t second;      /**< the number of an edge, face, edge or vertex in its mesh */
};

/** When bodies first come into contact. */
struct touchstone_first_body_contact {
  size_t size;     /**< sizeof(struct touchstone_first_body_contact) */
  int32_t contact; /**< 1 when two elements that are apart at the start come into contact in [0, t_max], otherwise 0 */

  /** 1 when there is no contact at all, at the start neither, and, where start_checked is 1, no intersection at the
   *  start; otherwise 0. Where start_checked is 0, a body inside another may be free. */
  int32_t free;
  double toi;       /**< the largest double <= the exact first time of such a contact; infinity without one */
  double toi_upper; /**< the smallest double >= this time; infinity without contact */

  /** How often bodies intersect at the start; 0 when that was not asked. touchstone_bodies_intersections says where. */
  size_t start_intersections;
  int32_t start_checked; /**< 1 when that was asked, by check_start of the options, otherwise 0 */
  int32_t reserved;      /**< of no meaning */

  /** Of the start: how many pieces of bodies lie in the box around the open surfaces of another body, which have no
   *  inside. */
  size_t in_open;
  size_t cancelled; /**< and how many in closed surfaces whose winding numbers add up to 0: they count as outside */
  size_t excluded;  /**< how many pairs of bodies the rules left out */
  size_t turned;    /**< how many bodies took the shorter turn in place of the longer one that the signs say */
};

/** No first contact. */
#define TOUCHSTONE_FIRST_BODY_CONTACT_INIT \
  { sizeof(struct touchstone_first_body_contact), 0, 0, 0.0, 0.0, 0, 0, 0, 0, 0, 0, 0 }

/** The first contact of bodies that move and turn. Over the step the quaternion is (1 - t) q0 + t q1, divided by its
 *  length, and the position (1 - t) p0 + t p1. Every pair of elements of two bodies has its exact answer.
 *  @param bodies       the bodies
 *  @param start        the poses at t = 0
 *  @param end          the poses at t = 1
 *  @param value_count  the number of doubles in start, and in end: 7 times the number of bodies
 *  @param options      the options, or null
 *  @param result       becomes the first contact; initialise it by its macro
 *  @param first        null; or becomes the list of all pairs whose contact begins at that time
 *  @param at_start     null; or becomes the list of all pairs that are in contact at the start
 *  @return one of touchstone_status_code */
int touchstone_bodies_first_contact(const touchstone_bodies* bodies, const double* start, const double* end,
                                    size_t value_count, const struct touchstone_options* options,
                                    struct touchstone_first_body_contact* result, touchstone_body_contacts** first,
                                    touchstone_body_contacts** at_start);

/** Every pair that comes into contact in [0, t_max], in the order of time.
 *  @param bodies       the bodies
 *  @param start        the poses at t = 0
 *  @param end          the poses at t = 1
 *  @param value_count  the number of doubles in start, and in end
 *  @param options      the options, or null
 *  @param contacts     becomes the list; touchstone_body_contacts_destroy ends it
 *  @return one of touchstone_status_code */
int touchstone_bodies_all_contacts(const touchstone_bodies* bodies, const double* start, const double* end,
                                   size_t value_count, const struct touchstone_options* options,
                                   touchstone_body_contacts** contacts);

/** A long step that is proved free of contact, and the rounded poses after it: the motion from start to these was asked
 *  about. The step is over [0, 1]: t_max must be 1.
 *  @param bodies       the bodies
 *  @param start        the poses at t = 0
 *  @param end          the poses at t = 1
 *  @param value_count  the number of doubles in start, in end and in poses
 *  @param options      the options, or null
 *  @param poses        becomes the poses after the step, in the same order; it may be start or end
 *  @param length       null; or becomes the fraction of the step, in [0, 1]
 *  @param outcome      null; or becomes one of touchstone_step_outcome
 *  @param contact      null; or becomes the first contact of the whole step; initialise it by its macro
 *  @return one of touchstone_status_code */
int touchstone_bodies_free_step(const touchstone_bodies* bodies, const double* start, const double* end,
                                size_t value_count, const struct touchstone_options* options, double* poses,
                                double* length, int* outcome, struct touchstone_first_body_contact* contact);

/** The number of contacts in a list; 0 for a null pointer. */
size_t touchstone_body_contacts_count(const touchstone_body_contacts* contacts);

/** One contact of a list.
 *  @param contacts  the list
 *  @param index     0 <= index < touchstone_body_contacts_count(contacts)
 *  @param pair      null; or becomes the elements
 *  @param answer    null; or becomes the answer for them
 *  @return one of touchstone_status_code */
int touchstone_body_contacts_get(const touchstone_body_contacts* contacts, size_t index,
                                 struct touchstone_body_pair* pair, struct touchstone_answer* answer);

/** Ends a list of contacts. A null pointer is allowed. */
void touchstone_body_contacts_destroy(touchstone_body_contacts* contacts);

/** Pairs of which every pair in contact in [0, 1] is one, in ascending order: boxes around their paths meet.
 *  @param bodies       the bodies
 *  @param start        the poses at t = 0
 *  @param end          the poses at t = 1
 *  @param value_count  the number of doubles in start, and in end
 *  @param options      the options, or null
 *  @param pairs        becomes the list; touchstone_body_pairs_destroy ends it
 *  @return one of touchstone_status_code */
int touchstone_bodies_candidates(const touchstone_bodies* bodies, const double* start, const double* end,
                                 size_t value_count, const struct touchstone_options* options,
                                 touchstone_body_pairs** pairs);

/** The number of pairs in a list; 0 for a null pointer. */
size_t touchstone_body_pairs_count(const touchstone_body_pairs* pairs);

/** One pair of a list.
 *  @param pairs  the list
 *  @param index  0 <= index < touchstone_body_pairs_count(pairs)
 *  @param pair   becomes the elements
 *  @return one of touchstone_status_code */
int touchstone_body_pairs_get(const touchstone_body_pairs* pairs, size_t index, struct touchstone_body_pair* pair);

/** Ends a list of pairs. A null pointer is allowed. */
void touchstone_body_pairs_destroy(touchstone_body_pairs* pairs);

/** Elements of two bodies that share a point at rest, or of which one is inside the other's surface. */
struct touchstone_body_intersection {
  int32_t first_element;  /**< one of touchstone_element: an edge, or a vertex that is a loose point, or inside */
  uint32_t first_body;    /**< the number of its body */
  uint32_t first;         /**< its number */
  int32_t second_element; /**< one of touchstone_element */
  uint32_t second_body;   /**< the number of its body */
  uint32_t second;        /**< its number */
  int32_t sort;           /**< one of touchstone_intersection_sort, but for TOUCHSTONE_FOLDS */
};

/** Where bodies intersect at rest, exactly. Separations and radii do not count.
 *  @param bodies         the bodies
 *  @param poses          their poses
 *  @param value_count    the number of doubles in poses: 7 times the number of bodies
 *  @param options        the options, or null
 *  @param intersections  becomes the list; touchstone_body_intersections_destroy ends it
 *  @return one of touchstone_status_code */
int touchstone_bodies_intersections(const touchstone_bodies* bodies, const double* poses, size_t value_count,
                                    const struct touchstone_options* options,
                                    touchstone_body_intersections** intersections);

/** The number of intersections in a list; 0 for a null pointer. */
size_t touchstone_body_intersections_count(const touchstone_body_intersections* intersections);

/** One intersection of a list.
 *  @param intersections  the list
 *  @param index          0 <= index < touchstone_body_intersections_count(intersections)
 *  @param intersection   becomes the intersection
 *  @return one of touchstone_status_code */
int touchstone_body_intersections_get(const touchstone_body_intersections* intersections, size_t index,
                                      struct touchstone_body_intersection* intersection);

/** Ends a list of intersections. A null pointer is allowed. */
void touchstone_body_intersections_destroy(touchstone_body_intersections* intersections);

/** How near bodies come to each other at rest. */
struct touchstone_body_distance {
  size_t size; /**< sizeof(struct touchstone_body_distance) */

  /** The least distance, rounded up to a double: some pair comes within it, and none within the next lesser double. 0
   *  where bodies intersect, and where one is inside the other. Infinity where no two elements may collide, or where
   *  all that may are farther apart than the greatest double. */
  double distance;
  size_t intersections; /**< how often bodies intersect */
  size_t in_open;       /**< as in touchstone_first_body_contact */
  size_t cancelled;     /**< as in touchstone_first_body_contact */
  size_t excluded;      /**< as in touchstone_first_body_contact */
};

/** No distance. */
#define TOUCHSTONE_BODY_DISTANCE_INIT \
  { sizeof(struct touchstone_body_distance), 0.0, 0, 0, 0, 0 }

/** The least distance of two elements of two bodies at rest, in the metric of the bodies: separations and radii do not
 *  count.
 *  @param bodies         the bodies
 *  @param poses          their poses
 *  @param value_count    the number of doubles in poses
 *  @param options        the options, or null
 *  @param result         becomes the distance; initialise it by its macro
 *  @param nearest        null; or becomes the list of all pairs within this distance, as contacts at t = 0 with this
 *                        separation. Of bodies that intersect these are the pairs that touch
 *  @param intersections  null; or becomes the list of where bodies intersect
 *  @return one of touchstone_status_code */
int touchstone_bodies_distance(const touchstone_bodies* bodies, const double* poses, size_t value_count,
                               const struct touchstone_options* options, struct touchstone_body_distance* result,
                               touchstone_body_contacts** nearest, touchstone_body_intersections** intersections);

/** What is proved about motion at a constant rate. */
enum touchstone_screw_verdict {
  TOUCHSTONE_SCREW_FREE = 0,        /**< there is certainly no contact in [0, t_max] */
  TOUCHSTONE_SCREW_CONTACT = 1,     /**< there certainly is one */
  TOUCHSTONE_SCREW_WITHIN_BOUND = 2 /**< elements come so near that the bound on the deviation leaves it open */
};

/** What is proved about two elements that meet on screws, or may meet. */
struct touchstone_screw_answer {
  int32_t verdict;   /**< one of touchstone_screw_verdict */
  int32_t arcs;      /**< the number of arcs that gave the verdict */
  double free_until; /**< no contact is at a time less than this */
  double contact_by; /**< for TOUCHSTONE_SCREW_CONTACT: there is a contact at this time or before it; t_max otherwise */
  double deviation;  /**< no corner was ever farther than this from where it should be, in the unit of length */
};

/** Whether bodies that turn at constant rates come into contact. Whatever the verdict is, they certainly have no
 *  contact before `free_until`, but for the start, if that was not asked about. */
struct touchstone_body_screw_answer {
  size_t size;     /**< sizeof(struct touchstone_body_screw_answer) */
  int32_t verdict; /**< one of touchstone_screw_verdict */

  /** 1 when there is certainly no contact, and, where start_checked is 1, no intersection at the start; otherwise 0. */
  int32_t free;
  double free_until;          /**< no contact is at a time less than this; t_max for TOUCHSTONE_SCREW_FREE */
  double contact_by;          /**< as in touchstone_screw_answer */
  size_t start_intersections; /**< as in touchstone_first_body_contact */
  int32_t start_checked;      /**< as in touchstone_first_body_contact */
  int32_t reserved;           /**< of no meaning */
  size_t in_open;             /**< as in touchstone_first_body_contact */
  size_t cancelled;           /**< as in touchstone_first_body_contact */
  size_t excluded;            /**< as in touchstone_first_body_contact */
  size_t turned;              /**< as in touchstone_first_body_contact */
};

/** No answer. */
#define TOUCHSTONE_BODY_SCREW_ANSWER_INIT \
  { sizeof(struct touchstone_body_screw_answer), 0, 0, 0.0, 0.0, 0, 0, 0, 0, 0, 0, 0 }

/** Whether bodies that turn at constant rates, as slerp and screw motions do, come into contact. No finite polynomial
 *  is such a motion, so the answer has three values; touchstone/screw.hpp says what is proved.
 *  @param bodies       the bodies
 *  @param start        the poses at t = 0
 *  @param end          the poses at t = 1
 *  @param value_count  the number of doubles in start, and in end
 *  @param inner        null: the bodies' origins go straight; or the control points of their Bezier curves between both
 *                      positions, x, y, z each: of every body one, for curves of degree 2, or two, for degree 3
 *  @param inner_count  the number of doubles in inner: 0, or 3 or 6 for each body
 *  @param options      the options, or null; arcs and most_arcs are some of them
 *  @param result       becomes the answer; initialise it by its macro
 *  @param open         null; or becomes the list of all pairs that meet or may meet by contact_by, in the order of
 *                      free_until
 *  @return one of touchstone_status_code */
int touchstone_bodies_solve_screw(const touchstone_bodies* bodies, const double* start, const double* end,
                                  size_t value_count, const double* inner, size_t inner_count,
                                  const struct touchstone_options* options, struct touchstone_body_screw_answer* result,
                                  touchstone_body_screws** open);

/** The number of pairs in a list; 0 for a null pointer. */
size_t touchstone_body_screws_count(const touchstone_body_screws* screws);

/** One pair of a list.
 *  @param screws  the list
 *  @param index   0 <= index < touchstone_body_screws_count(screws)
 *  @param pair    null; or becomes the elements
 *  @param answer  null; or becomes what is proved about them
 *  @return one of touchstone_status_code */
int touchstone_body_screws_get(const touchstone_body_screws* screws, size_t index, struct touchstone_body_pair* pair,
                               struct touchstone_screw_answer* answer);

/** Ends a list of such pairs. A null pointer is allowed. */
void touchstone_body_screws_destroy(touchstone_body_screws* screws);

#ifdef __cplusplus
}
#endif

#endif /* TOUCHSTONE_C_BODIES_H */
