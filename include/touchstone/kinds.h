/* Touchstone: the kinds of query and the metrics, by their numbers in C, in plugins and in files.
 * SPDX-License-Identifier: MIT
 */
#ifndef TOUCHSTONE_KINDS_H
#define TOUCHSTONE_KINDS_H

/** @file
 * The kinds of query and the metrics, for touchstone/c.h and touchstone/plugin.h. Plain C99. The numbers are those of
 * Kind and Metric in C++.
 */

/** The kinds of query. */
enum touchstone_kind {
  TOUCHSTONE_KIND_EDGE_EDGE = 0,   /**< a segment against a segment */
  TOUCHSTONE_KIND_VERTEX_FACE = 1, /**< a point against a triangle */
  TOUCHSTONE_KIND_POINT_EDGE = 2,  /**< a point against a segment */
  TOUCHSTONE_KIND_POINT_POINT = 3  /**< a point against a point */
};

/** The metrics of a separation. */
enum touchstone_metric {
  TOUCHSTONE_METRIC_EUCLIDEAN = 0, /**< the length of the difference of two points */
  TOUCHSTONE_METRIC_MAX = 1        /**< its largest absolute coordinate */
};

#endif /* TOUCHSTONE_KINDS_H */
