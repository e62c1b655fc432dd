#!/usr/bin/env python3
# A solver as a program that is asked over pipes: touchstone fuzz --solver-command "python3 program.py"
#
# A line in is a kind and numbers: x y z of each corner at t = 0, then of each at t = 1. A line out is 0, or 1 and the
# time of the first contact in [0, 1]. It must be flushed: the next line comes after the answer only.
#
# The solver here is a naive one, as many have it: two points meet when their distance falls below a tolerance at the
# time when it is least. Put your own in its place.
# SPDX-License-Identifier: MIT
import sys


separation = 0.0  # two points are in contact when they are so near


def point_point(start, end):
    """The time of the first contact of two moving points, or None."""
    apart = [start[k] - start[3 + k] for k in range(3)]
    change = [end[k] - end[3 + k] - apart[k] for k in range(3)]
    speed = sum(c * c for c in change)
    time = 0.0
    if speed > 0:
        time = min(1.0, max(0.0, -sum(a * c for a, c in zip(apart, change)) / speed))
    squared = sum((a + time * c) ** 2 for a, c in zip(apart, change))
    return time if squared < max(1e-18, separation ** 2) else None


SOLVERS = {"point-point": point_point}

for line in sys.stdin:
    kind, *numbers = line.split()
    if kind == "separation":  # with touchstone fuzz --separation only: one line before all queries
        separation = float.fromhex(numbers[0])
        print("ok" if numbers[1] == "euclidean" else "unsupported", flush=True)
        continue
    solver = SOLVERS.get(kind)
    if solver is None:
        print("unsupported", flush=True)
        continue
    numbers = [float.fromhex(number) for number in numbers]
    half = len(numbers) // 2
    toi = solver(numbers[:half], numbers[half:])
    print("0" if toi is None else f"1 {toi.hex()}", flush=True)
