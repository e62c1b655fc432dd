#!/usr/bin/env python3
# A check of waypoints as a program that is asked about steps of whole rigid bodies over pipes:
#   touchstone fuzz-steps --bodies --solver-command "python3 bodies.py" --no-separation
#
# A line in is a JSON object: "bodies", each with its "points" in its own frame, "faces", "edges" (all of them),
# "loose_points" and, for spheres and capsules, "radii"; a motion of each, "motions"; "body_pairs" that never collide;
# and a "separation" with its "metric". At t from 0 to 1 a body has the orientation (1 - t) q0 + t q1, a quaternion
# [w, x, y, z] of any length, and its origin is at (1 - t) p0 + t p1.
# A line out is an object with one or more of
#   "free": 0.5              the part of the step that is free of contact, in [0, 1]
#   "first_contact": 0.25    the time of the first contact, 0 if there is one at the start, or null
#   "candidates": [["edge-edge", [0, 3], [1, 5]], ["vertex-face", [body, vertex], [body, face]], ["point-edge", ...],
#                  ["point-point", ...]]
# It must be flushed: the next line comes after the reply only.
#
# The program here is naive, as many are: it looks for edges through faces at some waypoints. Put your own in its place.
# SPDX-License-Identifier: MIT
import json
import sys

WAYPOINTS = 16


def between(a, b, t):
    return [(1 - t) * x + t * y for x, y in zip(a, b)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def placed(body, motion, t):
    """The body's points at a time."""
    w, *v = between(motion["q0"], motion["q1"], t)
    origin, length = between(motion["p0"], motion["p1"], t), w * w + dot(v, v)
    turned = [(x, cross(v, x)) for x in body["points"]]
    return [[o + c + 2 * (w * d + e) / length for o, c, d, e in zip(origin, x, u, cross(v, u))] for x, u in turned]


def pierces(edge, face):
    """Whether an edge goes through a face: both ends on other sides of it, and the edge within its three sides."""
    (a, b), (f, g, h) = edge, face
    normal = cross(minus(g, f), minus(h, f))
    sides = [dot(cross(minus(b, a), minus(p, a)), minus(q, a)) for p, q in ((f, g), (g, h), (h, f))]
    return dot(normal, minus(a, f)) * dot(normal, minus(b, f)) < 0 and (min(sides) > 0 or max(sides) < 0)


def is_free(step, t):
    points = [placed(body, motion, t) for body, motion in zip(step["bodies"], step["motions"])]
    pairs = [(a, b) for a in range(len(points)) for b in range(len(points))
             if a != b and [a, b] not in step["body_pairs"] and [b, a] not in step["body_pairs"]]
    return not any(pierces([points[a][v] for v in edge], [points[b][v] for v in face]) for a, b in pairs
                   for edge in step["bodies"][a]["edges"] for face in step["bodies"][b]["faces"])


for line in sys.stdin:
    step = json.loads(line)
    free = 0
    while free < WAYPOINTS and is_free(step, (free + 1) / WAYPOINTS):
        free += 1
    print(json.dumps({"free": free / WAYPOINTS if is_free(step, 0) else 0}), flush=True)
