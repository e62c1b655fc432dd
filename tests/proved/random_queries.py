#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes query files whose queries are mostly degenerate: lattices, fractions, scales far apart, and doubles.

    random_queries.py --count N FOLDER: FOLDER/KIND/random.csv, with N queries each
"""

import argparse
import os
import random
from fractions import Fraction

CORNERS = {"edge-edge": 4, "vertex-face": 4, "point-edge": 3, "point-point": 2}


def coordinate(rng, family):
    if family == 0:
        return Fraction(rng.randrange(-1, 2))
    if family == 1:
        return Fraction(rng.randrange(-3, 4), 2)
    if family == 2:
        return Fraction(rng.randrange(-9, 10), rng.randrange(1, 8))
    if family == 3:
        return Fraction(rng.randrange(-2, 3)) * Fraction(2) ** rng.randrange(-300, 300)
    return Fraction(rng.uniform(-1, 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("folder")
    arguments = parser.parse_args()
    for kind, corners in CORNERS.items():
        rng = random.Random(kind)
        os.makedirs(os.path.join(arguments.folder, kind))
        with open(os.path.join(arguments.folder, kind, "random.csv"), "w") as file:
            for number in range(arguments.count):
                start = [[coordinate(rng, number % 5) for _ in range(3)] for _ in range(corners)]
                end = [[coordinate(rng, number % 5) for _ in range(3)] for _ in range(corners)]
                flat = rng.choice([None, None, 2])  # everything moves in a plane
                for point in start + end:
                    row = [Fraction(0) if k == flat else x for k, x in enumerate(point)]
                    file.write(",".join(f"{x.numerator},{x.denominator}" for x in row) + "\n")


if __name__ == "__main__":
    main()
