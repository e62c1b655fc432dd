#!/usr/bin/env python3
# A simulator's broad phase as a program that is asked about whole steps over pipes:
#   touchstone fuzz-steps --solver-command "python3 steps.py"
#
# A line in is a JSON object: "vertices", their positions "x0" and "x1" at both ends of the step, "edges" (all of them),
# "faces", loose "points", a "separation" with its "metric", and for groups of vertices "groups" and "ignored_groups".
# A line out is an object with one or more of
#   "free": 0.5              the part of the step that is free of contact, in [0, 1]
#   "first_contact": 0.25    the time of the first contact, or null
#   "candidates": [["edge-edge", 0, 3], ["vertex-face", 7, 1], ["point-edge", ...], ["point-point", ...]]
# It must be flushed: the next line comes after the reply only.
#
# The program here is naive, as many are: its boxes are those of the start, widened by a margin. Put your own in its
# place.
# SPDX-License-Identifier: MIT
import json
import sys

MARGIN = 0.1


def candidates(step):
    room = step["separation"] + 2 * MARGIN

    def box(corners):
        return [(min(step["x0"][v][k] for v in corners), max(step["x0"][v][k] for v in corners)) for k in range(3)]

    def pairs(kind, first, second):
        boxes = [[(corners, box(corners)) for corners in elements] for elements in (first, second)]
        for i, (a, box_a) in enumerate(boxes[0]):
            for j, (b, box_b) in enumerate(boxes[1]):
                if kind in ("edge-edge", "point-point") and i >= j or set(a) & set(b):
                    continue
                if all(p[0] - q[1] <= room and q[0] - p[1] <= room for p, q in zip(box_a, box_b)):
                    yield [kind, i, j]

    vertices = [[v] for v in range(step["vertices"])]
    edges, faces = step["edges"], step["faces"]
    return [*pairs("edge-edge", edges, edges), *pairs("vertex-face", vertices, faces),
            *pairs("point-edge", vertices, edges), *pairs("point-point", vertices, vertices)]


for line in sys.stdin:
    print(json.dumps({"candidates": candidates(json.loads(line))}), flush=True)
