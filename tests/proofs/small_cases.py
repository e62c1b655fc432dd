#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Small proofs, written by hand: the verdicts of the checkers are those that docs/proofs.md asks for.

    small_cases.py [--checker PROGRAM]

Each case is a file of proofs, its query files and motion files, and the exit status that the page asks for. The cases
are about separations, query rows, curved motion and motions. Without --checker only check_proofs.py is asked. An accepted proof is
judged by exact_judge.py too: its answers must be true. The exit status is 0 if all verdicts are right.
"""

import argparse
import io
import math
import os
import subprocess
import sys
import tempfile
from fractions import Fraction

import check_proofs
from exact_judge import double_after, double_below
from exact_truth import claims, truths


def word(number):
    number = Fraction(number)
    return f"{'-' if number < 0 else ''}0x{abs(number.numerator):x}p-{number.denominator.bit_length() - 1}"


def contact(time):
    """The words of a contact at a rational time."""
    below = double_below(Fraction(time))
    return f"contact {word(below)} {word(below if below == time else double_after(below))}"


def rows(starts, ends):
    """The rows of a query."""
    points = [[Fraction(x) for x in point] for point in starts + ends]
    return "".join(",".join(f"{x.numerator},{x.denominator}" for x in point) + ",0\n" for point in points)


def still(*corners):
    return rows(list(corners), list(corners))


def proof_of(*blocks, end):
    """Each block is the separation's words or "", the kind, and the lines of the proofs."""
    text = "touchstone-proofs 1\n"
    for separation, kind, lines in blocks:
        text += f"separation {separation}\n" if separation else ""
        text += f"file {kind} - f\n" + "".join(line + "\n" for line in lines)
    return text + f"end {end}\n"


def one(name, status, separation, kind, text, *lines):
    """A case of one query."""
    contacts = int(" contact " in lines[0])
    return name, status, proof_of((separation, kind, lines), end=f"1 {contacts}"), [text]


ORIGIN = (0, 0, 0)
HALF = Fraction(1, 2)
TINY = Fraction(1, 1 << 60)
WEST = "d -1 0 0"
BOTH = ("w 0 1", "w 1 1")


def along_x(start, end, y=0, z=0):
    """The first point rests at the origin, the second one moves along x."""
    return rows([ORIGIN, (start, y, z)], [ORIGIN, (end, y, z)])


def point_point_cases():
    passing = along_x(-2, 1)
    third, two_thirds = contact(Fraction(1, 3)), contact(Fraction(2, 3))
    beside = along_x(-2, 1, z=1)
    slanted = along_x(-2, 1, y=HALF)  # |y - x|^2 - 1 is (36 t^2 - 48 t + 13) / 4
    early = double_below(Fraction((48 - math.sqrt(432)) / 72) - Fraction(1, 1 << 50))
    while 36 * double_after(early) ** 2 - 48 * double_after(early) + 13 > 0:
        early = double_after(early)
    irrational = f"contact {word(early)} {word(double_after(early))}"
    difference = "d -2 0x1p-1 0 3 0 0"
    diagonal = still(ORIGIN, (1, 1, 1))
    apart = still(ORIGIN, (-1, 0, 0))
    # The distance is 1 at t = 2^-1080.
    soon = rows([ORIGIN, (-1 - Fraction(1, 1 << 1070), 0, 0)], [ORIGIN, (1 << 10, 0, 0)])
    speed = (1 << 10) + 1 + Fraction(1, 1 << 1070)
    at_once = "contact 0 0x1p-1074"
    root = f"root {word(-Fraction(1, 1 << 1070))} {word(speed)}"

    over = along_x(-2, 2, y=1)
    pieces = "d -1 0 0 to 0x5p-4", "d 0 1 0 to 0xbp-4", "d 1 0 0"

    # x = -2^54 - 1 + 2^55 t is -1 at T = 1/2 and 3 at U. The contact for D = 1/8 begins and ends in between.
    far = (1 << 54) + 1
    fast, soon_after_half = along_x(-far, far - 2), "contact 0x1p-1 0x10000000000001p-53"

    def fast_case(name, status, metric, root, low, high):
        low, high = (word(Fraction(far + x) / (1 << 55)) for x in (low, high))
        g = f"root {word(-far - root)} 0x1p55 between {low} {high}"
        return case(name, status, f"{metric} 0x1p-3", fast, f"0 {soon_after_half}", WEST, g, *BOTH)

    def case(name, status, separation, text, *lines):
        return one("point-point: " + name, status, separation, "point-point", text, *lines)

    return [
        case("T = U", 0, "euclidean 0x1p-1", passing, "0 contact 0x1p-1 0x1p-1", WEST, *BOTH),
        case("T = U, max", 0, "max 0x1p-1", passing, "0 contact 0x1p-1 0x1p-1", WEST, *BOTH),
        case("T = U, D without exponent", 0, "max 001", along_x(-2, 2), "0 contact 0x1p-2 0x1p-2", WEST, *BOTH),
        case("the times for D = 0", 1, "max 0x1p-1", passing, "0 " + two_thirds, WEST, "root -2 3", *BOTH),
        case("the times for D > 0 at D = 0", 1, "", passing, "0 contact 0x1p-1 0x1p-1", WEST, *BOTH),
        case("T < U", 0, "euclidean 1", passing, "0 " + third, WEST, "root -1 3", *BOTH),
        case("T < U, max", 0, "max 1", passing, "0 " + third, WEST, "root -1 3", *BOTH),
        case("T < U, another g", 1, "max 1", passing, "0 " + third, WEST, "root -2 3", *BOTH),
        case("T < U, no piece", 1, "max 1", passing, "0 " + third, "root -1 3", *BOTH),
        case("T < U, no weights", 1, "max 1", passing, "0 " + third, WEST, "root -1 3"),
        case("T < U, a weight that is a multiple of g", 1, "max 1", passing, "0 " + third, WEST, "root -1 3",
             "w 0 -1 3", "w 1 1"),
        case("grazing", 0, "euclidean 1", beside, "0 " + two_thirds, "d -2 0 1 3 0 0", "root -2 3", *BOTH),
        case("grazing, the metric max meets earlier", 0, "max 1", beside, "0 " + third, WEST, "root -1 3", *BOTH),
        case("grazing, the times of max for euclidean", 1, "euclidean 1", beside, "0 " + third, WEST, "root -1 3",
             *BOTH),
        case("grazing, missed by little", 0, f"euclidean {word(1 - TINY)}", beside, "0 none", "d 0 0 1"),
        case("grazing, denied", 1, "euclidean 1", beside, "0 none", "d 0 0 1"),
        case("grazing, denied with the difference", 1, "euclidean 1", beside, "0 none", "d -2 0 1 3 0 0"),
        case("irrational time", 0, "euclidean 1", slanted, "0 " + irrational, f"{difference} to 0x1p-2", difference,
             "root 13 -48 36", *BOTH),
        case("irrational time, linear g", 1, "euclidean 1", slanted, "0 " + irrational, f"{difference} to 0x1p-2",
             difference, f"root {word(-early - double_after(early))} 2", *BOTH),
        case("the metrics differ, none", 0, "euclidean 0x3p-1", diagonal, "0 none", "d 1 1 1"),
        case("the metrics differ, no direction of max", 1, "max 0x3p-1", diagonal, "0 none", "d 1 1 1"),
        case("the metrics differ, contact at 0", 0, "max 0x3p-1", diagonal, "0 contact 0 0", *BOTH),
        case("the metrics differ, no contact at 0", 1, "euclidean 0x3p-1", diagonal, "0 contact 0 0", *BOTH),
        case("contact at 0, exactly D", 0, "euclidean 1", apart, "0 contact 0 0", *BOTH),
        case("contact at 0, exactly D, max", 0, "max 1", apart, "0 contact 0 0", *BOTH),
        case("contact at 0, D too small", 1, f"euclidean {word(1 - TINY)}", apart, "0 contact 0 0", *BOTH),
        case("contact at 0, D too small, max", 1, f"max {word(1 - TINY)}", apart, "0 contact 0 0", *BOTH),
        case("contact at 0, D too small, max, the other side", 1, f"max {word(1 - TINY)}",
             still(ORIGIN, (1, 0, 0)), "0 contact 0 0", *BOTH),
        case("contact at 0, claimed at 1", 1, "max 1", apart, "0 contact 1 1", WEST, *BOTH),
        case("contact at 0, with a piece", 1, "max 1", apart, "0 contact 0 0", WEST, *BOTH),
        case("contact before the least double", 0, "euclidean 1", soon, f"0 {at_once}", WEST, root, *BOTH),
        case("T is zero with an exponent", 0, "euclidean 1", soon, "0 contact 0x0p-2000 0x1p-1074", WEST, root, *BOTH),
        case("contact before the least double, max", 0, "max 1", soon, f"0 {at_once}", WEST, root, *BOTH),
        case("contact before the least double, no piece", 1, "max 1", soon, f"0 {at_once}", root, *BOTH),
        case("none", 0, f"euclidean {word(1 - TINY)}", apart, "0 none", WEST),
        case("none, the other sign", 0, f"euclidean {word(1 - TINY)}", apart, "0 none", "d 1 0 0"),
        case("none, max", 0, f"max {word(1 - TINY)}", apart, "0 none", WEST),
        case("none, max, the other sign", 0, f"max {word(1 - TINY)}", apart, "0 none", "d 1 0 0"),
        case("contact at 0, D too small, max, along z", 1, f"max {word(1 - TINY)}", still(ORIGIN, (0, 0, 1)),
             "0 contact 0 0", *BOTH),
        case("contact at 0, D too small, max, along -y", 1, f"max {word(1 - TINY)}", still(ORIGIN, (0, -1, 0)),
             "0 contact 0 0", *BOTH),
        *(fast_case(f"{name}, {metric}", status, metric, *numbers) for metric in ("euclidean", "max")
          for name, status, *numbers in [
              ("within D from LOW to HIGH", 0, Fraction(1, 16), Fraction(-1, 16), Fraction(1, 8)),
              ("within D at LOW, not at the root", 1, HALF, 0, 1),
              ("within D at HIGH, not at the root", 1, -HALF, -1, 0),
              ("within D at the root, not proved", 1, 0, Fraction(-1, 16), 1),
              ("LOW before T", 1, Fraction(1, 16), -2, Fraction(1, 8)),
              ("HIGH after U", 1, Fraction(1, 16), Fraction(-1, 16), 4)]),
        case("T is the contact", 1, "euclidean 0x1p-1", passing, f"0 {soon_after_half}", WEST,
             f"root {word(-1 - Fraction(1, 1 << 53))} 2", *BOTH),
        case("none within D", 1, "euclidean 1", still(ORIGIN, (-HALF, 0, 0)), "0 none", WEST),
        case("none within D, max", 1, "max 1", still(ORIGIN, (-HALF, 0, 0)), "0 none", WEST),
        case("zero at the end of a piece that is not the last one", 1, "max 0x1p-1", passing,
             "0 contact 0x3p-2 0x3p-2", f"{WEST} to 0x1p-1", WEST, *BOTH),
        case("zero at the end of a piece before another direction", 1, "max 1", along_x(-2, 0, y=2),
             "0 none", f"{WEST} to 0x1p-1", "d 0 1 0"),
        case("another NUMBER", 1, "max 0x1p-1", apart, "1 none", WEST),
        case("an end of a piece with as many places as there may be", 0, "max 0x1p-1", apart, "0 none",
             f"{WEST} to 0x1.000p-20000", WEST),
        case("an end of a piece with more places", 2, "max 0x1p-1", apart, "0 none", f"{WEST} to 0x.8p-20000", WEST),
        case("T with more places than there may be", 2, "max 1", apart, "0 contact 0x.8p-20000 1", WEST, *BOTH),
        case("U with more places than there may be", 2, "max 1", apart, "0 contact 0 0x.8p-20000", WEST, *BOTH),
        case("LOW with more places than there may be", 2, "euclidean 1", soon, f"0 {at_once}", WEST,
             root + " between 0x.8p-20000 0x1p-1074", *BOTH),
        case("HIGH with more places than there may be", 2, "euclidean 1", soon, f"0 {at_once}", WEST,
             root + " between 0 0x.8p-20000", *BOTH),
        case("LOW with as many places as there may be", 0, "euclidean 1", soon, f"0 {at_once}", WEST,
             root + " between 0x1p-20000 0x1p-1074", *BOTH),
        case("NUMBER with a leading zero", 1, "max 0x1p-1", apart, "00 none", WEST),
        case("none, three pieces", 0, "euclidean 0x1p-1", over, "0 none", *pieces),
        case("none, three pieces, max", 0, "max 0x1p-1", over, "0 none", *pieces),
        case("none, three pieces, D too large", 1, "max 0x3p-2", over, "0 none", *pieces),
        case("none, pieces swapped", 1, "max 0x1p-1", over, "0 none", "d 0 1 0 to 0x5p-4",
             "d -1 0 0 to 0xbp-4", pieces[2]),
        case("none, a piece widened", 1, "max 0x1p-1", over, "0 none", "d -1 0 0 to 0xbp-4", pieces[2]),
        case("none at the distance D", 1, "euclidean 1", apart, "0 none", WEST),
        case("none at the distance D, max", 1, "max 1", apart, "0 none", WEST),
        case("none, a direction of mixed signs", 1, "max 0x1p-1", still(ORIGIN, (1, 0, 0)), "0 none", "d 1 -1 0"),
        case("none, a zero direction", 1, "euclidean 0x1p-1", apart, "0 none", "d 0 0 0"),
        case("none, a zero direction, max", 1, "max 0x1p-1", apart, "0 none", "d 0 0 0"),
        case("none, exception only at a contact", 1, "max 1", along_x(-2, -1), "0 none", WEST),
    ]


def corner_cases():
    """Edges and faces."""
    crossing = rows([(-1, 0, 0), (1, 0, 0), (0, -1, 1), (0, 1, 1)], [(-1, 0, 0), (1, 0, 0), (0, -1, -2), (0, 1, -2)])
    four = ("w 0 1", "w 1 1", "w 2 1", "w 3 1")
    triangle = [ORIGIN, (4, 0, 0), (0, 4, 0)]
    falling = rows([(1, 1, 2)] + triangle, [(1, 1, -1)] + triangle)
    inside = ("w 0 1", "w 1 2", "w 2 1", "w 3 1")
    slope = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    sliding = rows([(2, 2, 2)] + slope, [ORIGIN] + slope)
    centre = ("w 0 1", "w 1 1", "w 2 1", "w 3 1")
    edge = [ORIGIN, (2, 0, 0)]
    landing = rows([(1, 2, 0)] + edge, [ORIGIN[:1] + (0, 0)] + edge)
    between = still(ORIGIN, (-1, 0, 0), (1, 0, 0))
    after = contact(Fraction(7, 24))
    slide = contact(Fraction(7, 12))
    return [
        one("edge-edge", 0, "euclidean 0x1p-2", "edge-edge", crossing, "0 contact 0x1p-2 0x1p-2", "n", *four),
        one("edge-edge, max", 0, "max 0x1p-2", "edge-edge", crossing, "0 contact 0x1p-2 0x1p-2", "n", *four),
        one("edge-edge, T < U", 0, "euclidean 0x1p-3", "edge-edge", crossing, "0 " + after, "n", "root -7 24", *four),
        one("edge-edge, T < U, max", 0, "max 0x1p-3", "edge-edge", crossing, "0 " + after, "d 0 0 1", "root -7 24",
            *four),
        one("edge-edge, a point of the element too far", 1, "max 0x1p-3", "edge-edge", crossing, "0 " + after, "n",
            "root -7 24", "w 0 1", "w 2 1", "w 3 1"),
        one("edge-edge, D = 0", 1, "", "edge-edge", crossing, "0 " + after, "n", "root -7 24", *four),
        one("edge-edge, none", 1, "euclidean 0x1p-3", "edge-edge", crossing, "0 none", "n"),
        one("vertex-face", 0, "euclidean 0x1p-1", "vertex-face", falling, "0 contact 0x1p-1 0x1p-1", "n", *inside),
        one("vertex-face, max", 0, "max 0x1p-1", "vertex-face", falling, "0 contact 0x1p-1 0x1p-1", "n", *inside),
        one("vertex-face, a negative weight", 1, "max 0x1p-1", "vertex-face", falling, "0 contact 0x1p-1 0x1p-1", "n",
            "w 0 1", "w 1 6", "w 2 -1", "w 3 -1"),
        one("vertex-face, none", 0, f"euclidean {word(1 - TINY)}", "vertex-face",
            rows([(1, 1, 2)] + triangle, [(1, 1, 1)] + triangle), "0 none", "n"),
        one("vertex-face, none at the distance D", 1, "euclidean 1", "vertex-face",
            rows([(1, 1, 2)] + triangle, [(1, 1, 1)] + triangle), "0 none", "n"),
        one("slope, max", 0, "max 0x1p-1", "vertex-face", sliding, "0 " + slide, "n", "root -7 12", *centre),
        one("slope, the times of max for euclidean", 1, "euclidean 0x1p-1", "vertex-face", sliding, "0 " + slide, "n",
            "root -7 12", *centre),
        one("point-edge", 0, "euclidean 1", "point-edge", landing.replace("0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n2,",
            "1,1,0,1,0,1,0\n0,1,0,1,0,1,0\n2,"), "0 contact 0x1p-1 0x1p-1", "d 0 -1 0", "w 0 1", "w 1 1", "w 2 1"),
        one("point-edge, n", 1, "euclidean 1", "point-edge", landing, "0 none", "n"),
        one("point-edge, corners on both sides", 1, "euclidean 0x1p-1", "point-edge", between, "0 none", "d 1 0 0"),
        one("point-edge, corners on both sides, max", 1, "max 0x1p-1", "point-edge", between, "0 none", "d 1 0 0"),
        one("point-edge, contact at 0 by a weight alone", 0, "euclidean 1", "point-edge", between, "0 contact 0 0",
            "w 0 1", "w 2 1"),
        one("point-edge, no weight of an element", 1, "euclidean 1", "point-edge", between, "0 contact 0 0", "w 0 1"),
    ]


def line_cases():
    """The line `separation` itself."""
    apart = still(ORIGIN, (-1, 0, 0))
    none = ["0 none", WEST]
    good = proof_of(("max 0x1p-1", "point-point", none), end="1 0")
    cases = [(name, status, good.replace("separation max 0x1p-1", line), [apart]) for name, status, line in [
        ("spaces", 0, "  separation  max   0x8p-4  "),
        ("a comment after the line", 0, "separation max 0x1p-1\n \t# comment\n"),
        ("carriage return", 0, "separation max 0x1p-1\r"),
        ("zero", 1, "separation max 0"),
        ("zero with an exponent", 1, "separation euclidean 0x0p5"),
        ("negative", 1, "separation max -1"),
        ("no D", 1, "separation max"),
        ("no metric", 1, "separation 0x1p-1"),
        ("another metric", 1, "separation sum 0x1p-1"),
        ("upper case", 1, "separation Max 0x1p-1"),
        ("a word too many", 1, "separation max 0x1p-1 0x1p-1"),
        ("twice", 1, "separation max 0x1p-1\nseparation max 0x1p-1"),
        ("no number", 2, "separation max half"),
        ("a decimal point", 2, "separation max 0.5"),
        ("the least exponent", 0, "separation max 0x1p-20000"),
        ("an exponent beyond the limits", 2, "separation max 0x1p-20001"),
        ("as many digits as there may be", 0, f"separation max 0x{4095 * '0'}8p-4"),
        ("more digits than there may be", 2, f"separation max 0x{16384 * '0'}8p-4"),
        ("as many digits and digits of the exponent as there may be", 0,
         f"separation max 0x.{16383 * '0'}1p+{4096 * '0'}"),
        ("more digits of the exponent than there may be", 2, f"separation max 0x.1p+{4097 * '0'}"),
    ]]
    touching = still(ORIGIN, (-HALF, 0, 0))
    blocks = ("max 0x1p-1", "point-point", none), ("", "point-point", none)
    cases += [
        ("one file of two", 0, proof_of(*blocks, end="2 0"), [apart, touching]),
        ("not the file before", 1, proof_of(*blocks[::-1], end="2 0"), [apart, touching]),
        ("the second file", 0, proof_of(*blocks[::-1], end="2 0"), [touching, apart]),
        ("after the file line", 1, good.replace("separation max 0x1p-1\n", "").replace(
            "- f\n", "- f\nseparation max 0x1p-1\n"), [apart]),
        ("before the end", 1, good.replace("end", "separation max 1\nend"), [apart]),
        ("before the first line", 2, "separation max 1\n" + good, [apart]),
    ]
    return [("separation: " + name, *rest) for name, *rest in cases]


# A point falls on a triangle that is fixed, and an edge comes near to both. Vertex 6 is a point far off.
FALL = """touchstone-motion 1
vertices 7
face 0 1 2
point 3
edge 4 5
point 6
fixed 0
fixed 1
fixed 2
frame
0 0 0
4 0 0
0 4 0
1 1 2
-1 1 5
2 1 5
90 0 0
frame
0 0 0
4 0 0
0 4 0
1 1 1
-1 1 4
2 1 4
90 0 0
frame
0 0 0
4 0 0
0 4 0
1 1 -1
-1 1 0x14p-4
2 1 0x14p-4
90 0 0
"""

FALL_PROOF = """touchstone-proofs 1
separation euclidean 0x1p-1
file mesh - fall
step 0
step 1
0 contact 0x1p-2 0x1p-2
n
w 0 1
w 1 2
w 2 1
w 3 1
1 none
d 0 0 1
end 2 1
"""

PAIR = "1 none\nd 0 0 1\n"


def crowd(lines=""):
    """Two edges, four points and a face. They rest; all pairs that are near have boxes 1 apart along some axis.

    Point 0 is a corner of an edge, point 3 one of the face.
    """
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (0, 0, 2), (1, 0, 2), (0, 1, 2)]
    frame = "frame\n" + "".join(" ".join(map(str, point)) + "\n" for point in points)
    elements = "edge 3 2\npoint 2\npoint 5\nedge 0 1\npoint 4\nface 6 7 8\npoint 6\n"
    return "touchstone-motion 1\nvertices 9\n" + elements + lines + 2 * frame


# The proofs for D = 1 and the metric euclidean: elements at the distance 1 by their closest corners.
CROWD_PAIRS = [
    ["contact 0 0", "w 0 1", "w 3 1"],  # edges 0 and 1
    ["contact 0 0", "w 0 1", "w 2 1"],  # point 1 and the face
    ["contact 0 0", "w 0 1", "w 1 1"],  # point 2 and the face
    ["none", "d 0 1 -1"],  # point 1 and edge 0
    ["contact 0 0", "w 0 1", "w 2 1"],  # point 1 and edge 1
    ["none", "d 0 1 -1"],  # point 2 and edge 0
    ["contact 0 0", "w 0 1", "w 1 1"],  # point 2 and edge 1
    ["contact 0 0", *BOTH],  # points 1 and 2
    ["none", "d -1 0 1"],  # points 1 and 3
    ["contact 0 0", *BOTH],  # points 2 and 3
]


def crowd_proof(pairs, separation="euclidean 1"):
    lines = ["step 0"]
    for number, (answer, *rest) in enumerate(pairs):
        lines += [f"{number} {answer}"] + rest
    contacts = sum(pair[0] != "none" for pair in pairs)
    return proof_of((separation, "mesh", lines), end=f"{len(pairs)} {contacts}")



def falling(head="", poses=("1 0 0 0 0 0 1", "3 0 0 0 0 0 -1"), rest="0 -1 0\n0 1 0\n"):
    """Edge 0 is on body 0 and falls through edge 1."""
    frames = "".join(f"frame\n{pose}\n{rest}" for pose in poses)
    elements = "body 1 0 1 0 0\nedge 0 1\nedge 2 3\nbody 0 0 -1 0 0\n"
    return "touchstone-motion 1\nvertices 4\n" + elements + head + frames


def turning(point, end, other, start="1 0 0 0"):
    """Point 0 is on a body that turns, and point 1 rests."""
    frames = "".join(f"frame\n{q} 0 0 0\n{other}\n" for q in (start, end))
    return f"touchstone-motion 1\nvertices 2\npoint 0\npoint 1\nbody 0 0 {point}\n" + frames


def body_cases():
    middles = [f"w {corner} 1" for corner in range(4)]
    falls = proof_of(("", "mesh", ["step 0", "0 contact 0x1p-1 0x1p-1", "d 0 0 1", *middles]), end="1 1")
    denied = proof_of(("", "mesh", ["step 0", "0 none", "d 0 0 1"]), end="1 0")
    nothing = proof_of(("", "mesh", ["step 0"]), end="0 0")
    at_one, below = (proof_of((d, "mesh", ["step 0"]), end="0 0") for d in ("max 1", "max 0x1.fffffffffffffp-1"))
    on_body = "body 2 0 0 -1 0\nbody 3 0 0 1 0\n"
    still = "1 0 0 0 0 0 0", "1 0 0 0 0 0 0"
    cases = [
        ("falls", 0, falls, falling()),
        ("falls, denied", 1, denied, falling()),
        ("falls, no pair", 1, nothing, falling()),
        ("quaternions of opposite signs", 2, falls, falling(poses=("1 0 0 0 0 0 1", "-3 0 0 0 0 0 -1"))),
        ("no quaternion", 2, falls, falling(poses=("1 0 0 0 0 0 1", "0 0 0 0 0 0 -1"))),
        ("more than a half turn", 2, falls, falling(poses=("1 0 0 0 0 0 1", "-1 0 0 1 0 0 -1"))),
        ("a pose too short", 2, falls, falling(poses=("1 0 0 0 0 0 1", "1 0 0 0 0 0"))),
        ("a pose too few", 2, nothing, falling("body 2 1 0 0 0\n")),
        ("a vertex too many", 2, falls, falling("body 2 0 0 0 0\n")),
        ("two lines for a vertex", 2, falls, falling("body 1 0 1 0 0\n")),
        ("no such vertex", 2, falls, falling("body 4 0 1 0 0\n")),
        ("a coordinate too few", 2, falls, falling("body 2 0 1 0\n")),
        ("a body with a leading zero", 2, falls, falling("body 2 00 1 0 0\n")),
        ("a body beyond the limit", 2, falls, falling(f"body 2 {(1 << 30) - 1} 1 0 0\n")),
        ("all on one body", 2, nothing, falling(on_body, ("1 0 0 0 0 0 1", "1 0 0 0 0 0 -1"), "")),
        ("a fixed vertex of a body that moves", 2, falls, falling("fixed 0\n")),
        ("one vertex is not fixed", 1, nothing, falling("fixed 0\nfixed 2\nfixed 3\n", still)),
        ("all vertices are fixed", 2, nothing, falling("fixed 0\nfixed 1\nfixed 2\nfixed 3\n", still)),
    ]
    # The box of a quarter turn of (1, 0, 0) is [0, 1] x [0, 1] x [0, 0].
    for other in ("2 1 0", "-1 0x1p-1 0", "1 2 0", "0x1p-1 -1 0", "0 0 1", "1 1 -1"):
        cases.append((f"the box of a quarter turn, at ({other})", 1, at_one, turning("1 0 0", "1 0 0 1", other)))
        cases.append((f"beyond the box of a quarter turn, ({other})", 0, below, turning("1 0 0", "1 0 0 1", other)))
    # To (1, 0, 0, 1/2) the least x is 3/5, and the greatest y 4/5: both are no doubles.
    for other, status in (("0x1.3333333333333p-1 0 0", 1), ("0x1.3333333333332p-1 0 0", 0),
                          ("1 0x1.999999999999ap-1 0", 1), ("1 0x1.999999999999bp-1 0", 0)):
        cases.append((f"a rounded box, ({other})", status, nothing, turning("1 0 0", "1 0 0 0x1p-1", other)))
        opposite = " ".join(word if word == "0" else "-" + word for word in other.split())
        cases.append((f"a rounded box, ({opposite})", status, nothing,
                      turning("-1 0 0", "-4 0 0 -2", opposite, "-7 0 0 0")))
    return [("body: " + name, status, proof, [text]) for name, status, proof, text in cases]


def fan(elements):
    """Four vertices at rest in three frames, the last one far away."""
    return "touchstone-motion 1\nvertices 4\n" + elements + 3 * "frame\n0 0 0\n1 0 0\n0 1 0\n9 0 0\n"


def rod(end, head="", start="-1 1 0", points="point 2\npoint 0\npoint 1\n"):
    """Wires from (-2, 0, 0) to the origin, and from there to a moving end; and two vertices far away."""
    rest = "-2 0 0\n0 0 0\n"
    far = "90 0 0\n91 0 0\n"
    return (f"touchstone-motion 1\nvertices 5\n{points}edge 1 0\nedge 1 2\n{head}"
            f"frame\n{rest}{start}\n{far}frame\n{rest}{end}\n{far}")


def fold_cases():
    folds = ["contact 0x1p-1 0x1p-1", "d 0 1 0", *(f"w {corner} 1" for corner in range(3))]
    bends = ["none", "d 0 1 0"]
    face = "face 0 1 2\n"

    def proof(*pairs, separation=""):
        return crowd_proof(pairs, separation)

    swings, bent = "-1 -1 0", "-1 0x1p-1 0"
    back = ["contact 0 0", "w 0 1", "w 1 1", "w 2 1"]
    return [("fold: " + name, status, lines, [text]) for name, status, lines, text in [
        ("the end of a rod swings through the next wire", 0, proof(folds), rod(swings)),
        ("the end swings, denied", 1, proof(bends), rod(swings)),
        ("the end swings, left out", 1, proof(), rod(swings)),
        ("the end swings, with a separation", 0, proof(folds, ["none", "d 1 0 0"], separation="max 1"), rod(swings)),
        ("the end swings, with a separation, one of both", 1, proof(folds, separation="max 1"), rod(swings)),
        ("the end swings, left out with a separation", 1, proof(separation="max 1"), rod(swings)),
        ("a bend", 0, proof(), rod(bent)),
        ("a bend, with a pair that is none", 1, proof(bends), rod(bent)),
        ("a bend nearer than the separation", 0, proof(bends, separation="euclidean 0x1p-1"), rod(bent)),
        ("a bend nearer than the separation, left out", 1, proof(separation="euclidean 0x1p-1"), rod(bent)),
        ("a bend nearer than the separation, as a contact", 1,
         proof(["contact 0 0", "w 0 1", "w 1 1", "w 2 1"], separation="euclidean 1"), rod(bent, start=bent)),
        ("a bend just below the separation", 0, proof(separation="max 0x1.fffffffffffffp-2"), rod(bent)),
        ("a bend and both ends near", 0, proof(bends, ["none", "d 1 2 0"], separation="max 1"), rod(bent)),
        ("no line for the end", 0, proof(), rod(swings, points="point 1\npoint 0\n")),
        ("no line for the other end", 0, proof(folds), rod(swings, points="point 2\n")),
        ("a doubled wire", 0, proof(folds), rod(swings, "edge 2 1\n")),
        ("a doubled wire, the pair twice", 1, proof(folds, folds), rod(swings, "edge 2 1\n")),
        ("two wires alike to fold on", 0, proof(folds, folds), rod(swings, "edge 0 1\n")),
        ("a wire from the end to the far end too", 0, proof(folds), rod(swings, "edge 0 2\n")),
        ("a lone point in its place", 0, proof(folds), rod(swings).replace("edge 1 2\n", "")),
        ("the edges of a face", 2, proof(), rod(swings, face)),
        ("one edge is in a face", 2, proof(), rod(swings, "face 1 3 2\n", points="point 2\n")),
        ("the other edge is in a face", 2, proof(), rod(swings, "face 0 3 1\n", points="point 0\n")),
        ("an edge beside a face", 0, proof(folds), rod(swings, "face 0 3 2\n", points="point 2\n")),
        ("all is fixed", 2, proof(), rod("-1 1 0", "fixed 0\nfixed 1\nfixed 2\n")),
        ("the end is free", 1, proof(), rod(swings, "fixed 0\nfixed 1\n")),
        ("the end is free, proved", 0, proof(folds), rod(swings, "fixed 0\nfixed 1\n")),
        ("it lies on the next wire from the start", 0, proof(back), rod("1 1 0", start="-1 0 0")),
    ]]


def radius_cases():
    apart, touching = ["none", "d 1 1 0"], ["contact 0 0", "w 0 1", "w 1 1"]

    def points(first="radius 1\n", second="radius 0x1p-2\n", x="1 1", after=""):
        """A point that moves away from one at rest."""
        return ("touchstone-motion 1\nvertices 3\n" + first + "point 0\n" + second + "point 1\n" + after +
                f"frame\n0 0 0\n{x} 0\n90 0 0\nframe\n0 0 0\n{x} 1\n90 0 0\n")

    def proof(*pairs, separation=""):
        return crowd_proof(pairs, separation)

    near_one = "0x1.00000000000008p0 0"  # 1 + 2^-53
    return [("radius: " + name, status, lines, [text]) for name, status, lines, text in [
        ("farther apart than the sum", 0, proof(apart), points()),
        ("left out", 1, proof(), points()),
        ("a longer radius", 1, proof(apart), points("radius 2\n")),
        ("a longer radius, in contact", 0, proof(touching), points("radius 2\n")),
        ("in contact, denied", 1, proof(touching), points()),
        ("a radius for both", 1, proof(apart), points(second="")),
        ("a radius for the second one alone", 0, proof(), points("")),
        ("no radius", 0, proof(), points("", "")),
        ("a radius after both", 0, proof(), points("", "", after="radius 2\npoint 2\n")),
        ("a radius that ends", 0, proof(), points(after="radius 0\n").replace("radius 1\n", "radius 1\nradius 0\n")),
        ("at the sum", 0, proof(touching), points(x="0x1.4p0 0")),
        ("at the sum, left out", 1, proof(), points(x="0x1.4p0 0")),
        ("just beyond the sum", 0, proof(), points(x="0x1.4000000000001p0 0")),
        ("the sum is rounded up", 0, proof(touching), points(second="radius 0x1p-60\n", x=near_one)),
        ("the sum is rounded up, left out", 1, proof(), points(second="radius 0x1p-60\n", x=near_one)),
        ("a sum that is a double", 0, proof(), points(second="radius 0\n", x=near_one)),
        ("neighbours", 0, proof(), points(after="near 1 0\n")),
        ("neighbours, with their pair", 1, proof(apart), points(after="near 0 1\n")),
        ("neighbours of another one", 0, proof(apart), points(after="near 0 2\nnear 1 2\n")),
        ("neighbours that touch", 0, proof(touching), points(x="0 0", after="near 0 1\n")),
        ("neighbours that touch, denied", 1, proof(apart), points(x="0 0", after="near 0 1\n")),
        ("a separation of the file", 1, proof(apart, separation="euclidean 0x1.4p0"), points()),
        ("a negative radius", 2, proof(apart), points("radius -1\n")),
        ("no number", 2, proof(apart), points("radius one\n")),
        ("no radius in the line", 2, proof(apart), points("radius\n")),
        ("two radii in the line", 2, proof(apart), points("radius 1 1\n")),
        ("a vertex near itself", 2, proof(apart), points(after="near 1 1\n")),
        ("near no vertex", 2, proof(apart), points(after="near 1 3\n")),
        ("near alone", 2, proof(apart), points(after="near 1\n")),
        ("near twice", 2, proof(apart), points(after="near 0 1\nnear 1 0\n")),
    ]]


def group_cases():
    touching = ["contact 0 0", "w 0 1", "w 1 1"]
    two = "group 0 0\ngroup 1 1\n"

    def points(groups, elements="point 0\npoint 1\npoint 2\n"):
        """Points 1 and 2 are at the distance 1 from point 0 in the metric max, and at 2 from each other."""
        frame = "frame\n0 0 0\n1 1 0\n1 -1 0\n90 0 0\n"
        return "touchstone-motion 1\nvertices 4\n" + elements + groups + 2 * frame

    def wire(groups):
        return points(groups, "point 0\nedge 1 3\n")

    def proof(count):
        return crowd_proof(count * [touching], "max 1")

    return [("group: " + name, status, proof(count), [text]) for name, status, count, text in [
        ("none", 0, 2, points("")),
        ("two, and nothing ignored", 0, 2, points(two)),
        ("two that are ignored", 0, 1, points(two + "ignore 0 1\n")),
        ("two that are ignored, with their pair", 1, 2, points(two + "ignore 0 1\n")),
        ("in the other order", 0, 1, points(two + "ignore 1 0\n")),
        ("before the elements", 0, 1, points("", "ignore 1 0\n" + two + "point 0\npoint 1\npoint 2\n")),
        ("the line ignore is missing", 1, 1, points(two)),
        ("a line group is missing", 1, 1, points("group 0 0\nignore 0 1\n")),
        ("a vertex in another group", 1, 1, points(two.replace("1 1", "1 2") + "ignore 0 1\n")),
        ("two others are ignored", 0, 1, points(two + "group 2 2\nignore 2 0\n")),
        ("within a group", 0, 1, points("group 0 5\ngroup 1 5\nignore 5 5\n")),
        ("within another group", 0, 2, points("group 0 5\ngroup 1 5\nignore 4 4\n")),
        ("between the two, not within", 1, 1, points("group 0 5\ngroup 1 5\nignore 4 5\n")),
        ("all is ignored", 2, 0, points(two + "group 2 1\nignore 0 1\nignore 1 1\n")),
        ("all that is near is ignored", 0, 0, points(two + "group 2 1\nignore 0 1\n")),
        ("all that is near, with a proof", 1, 1, points(two + "group 2 1\nignore 0 1\n")),
        ("a group of no vertex", 0, 2, points("ignore 0 1\n")),
        ("the greatest number", 0, 1, points("group 0 1073741823\ngroup 1 1073741823\nignore 1073741823 1073741823\n")),
        ("an edge of two, one of them ignored", 0, 1, wire(two + "group 3 2\nignore 0 1\n")),
        ("an edge of two, one of them ignored, left out", 1, 0, wire(two + "group 3 2\nignore 0 1\n")),
        ("an edge of two, both ignored", 2, 0, wire(two + "group 3 2\nignore 0 1\nignore 0 2\n")),
        ("an edge with a vertex in none", 0, 1, wire(two + "ignore 0 1\n")),
        ("a fold that is ignored", 2, 0, rod("-1 -1 0", "".join(f"group {v} 0\n" for v in range(3)) + "ignore 0 0\n")),
        *[("the line " + line, 2, 2, points("group 1 1\nignore 0 1\n" + line + "\n")) for line in (
            "group 0", "group 0 0 0", "group 4 0", "group 0 -1", "group 0 00", "group 0 x", "group 0 1073741824",
            "group 1 1", "group x 0", "ignore 0", "ignore 0 1", "ignore 1 0", "ignore 0 0 0", "ignore 0 -1",
            "ignore 0 01", "ignore 1073741824 0", "ignore", "group")],
    ]]


def touching_cases():
    apart, near, both = ["none", "d 1 0 0"], ["contact 0 0", "w 0 1", "w 1 1"], "touching point-point 0 1\n"

    def points(lines, head=""):
        """Points 1 and 2 are at the distance 1 from point 0 in the metric max, and at 2 from each other."""
        frame = "frame\n0 0 0\n1 1 0\n1 -1 0\n90 0 0\n"
        return "touchstone-motion 1\nvertices 4\n" + head + "point 0\npoint 1\npoint 2\n" + lines + 2 * frame

    def proof(*pairs, separation="max 1"):
        return crowd_proof(pairs, separation)

    wire = points(both.replace("point-point 0 1", "point-edge 0 0")).replace("point 1\npoint 2\n", "edge 1 3\n")
    return [("touching: " + name, status, lines, [text]) for name, status, lines, text in [
        ("none", 0, proof(near, near), points("")),
        ("a pair", 0, proof(apart, near), points(both)),
        ("a pair, within the separation", 1, proof(near, near), points(both)),
        ("a pair, left out", 1, proof(near), points(both)),
        ("another pair", 0, proof(near, apart), points("touching point-point 0 2\n")),
        ("before the points", 0, proof(apart, near), points("", both)),
        ("no such pair", 0, proof(near, near), points("touching point-point 7 8\n")),
        ("another kind", 0, proof(near, near), points("touching point-edge 0 1\n")),
        ("without a separation", 0, proof(separation=""), points(both)),
        ("a point and an edge", 0, proof(apart), wire),
        ("a point and an edge, within the separation", 1, proof(near), wire),
        ("with radii, whose boxes are apart", 0, proof(separation=""), points(
            both, "radius 1\n").replace("1 -1 0", "9 -9 0")),
        *[("the line " + line, 2, proof(apart, near), points(both + line + "\n")) for line in (
            "touching", "touching point-point", "touching point-point 0", "touching point-point 0 1",
            "touching point-point 1 0", "touching point-point 1 1", "touching point-point 0 1 2",
            "touching edge-point 0 1", "touching mesh 0 1", "touching point-point 0 01", "touching point-point -1 0",
            "touching point-point 0 x", "touching edge-edge 3 2", "touching vertex-face 0 1073741824")],
        *[("the line " + line, 0, proof(apart, near), points(both + line + "\n")) for line in (
            "touching vertex-face 1 0", "touching point-edge 1 0", "touching edge-edge 2 3")],
    ]]


def motion_cases():
    def motion(name, text, proof=FALL_PROOF, status=2):
        return name, status, proof, [text]

    def edited(name, old, new, status=1):
        assert old in FALL_PROOF, old
        return name, status, FALL_PROOF.replace(old, new), [FALL]

    def broken(name, old, new, status=2):
        assert old in FALL, old
        return name, status, FALL_PROOF, [FALL.replace(old, new, 1)]

    first, _, second = FALL_PROOF.partition("step 1\n")[2].partition("1 none")
    other = "1" + first[1:]
    swapped = FALL_PROOF.replace(first + PAIR, "0" + PAIR[1:] + other)
    last_frame = FALL[FALL.rindex("frame"):]
    empty = "touchstone-motion 1\nvertices 0\nframe\nframe\n"
    bare = [line for line in FALL.splitlines(keepends=True) if line.split()[0] not in ("point", "edge", "face", "fixed")]
    steps = proof_of(("", "mesh", ["step 0", "step 1"]), end="0 0")
    nothing = proof_of(("", "mesh", ["step 0"]), end="0 0")
    less = "euclidean " + word(1 - TINY)
    faces_last = CROWD_PAIRS[:1] + CROWD_PAIRS[3:] + CROWD_PAIRS[1:3]
    by_edge = CROWD_PAIRS[:3] + [CROWD_PAIRS[i] for i in (3, 5, 4, 6)] + CROWD_PAIRS[7:]
    far = "touchstone-motion 1\nvertices 2\npoint 0\npoint 1\n" + 2 * "frame\n0 0 0\n5 0 0\n"
    query = rows([ORIGIN, (-2, 0, 0)], [ORIGIN, (1, 0, 0)])
    both = proof_of(("max 1", "point-point", ["0 none", WEST]), ("", "mesh", ["step 0"]), end="1 0")
    return [("motion: " + name, *rest) for name, *rest in [
        motion("accepted", FALL, status=0),
        motion("lines with carriage returns", FALL.replace("\n", "\r\n"), status=0),
        motion("comments and blank lines", FALL.replace("frame\n", " \t# a frame\n\n  frame  \n"), status=0),
        motion("no line feed at the end", FALL[:-1], status=0),
        edited("max", "euclidean", "max", 0),
        edited("no separation", "separation euclidean 0x1p-1\n", ""),
        edited("more separation, more pairs", "0x1p-1", "1"),
        edited("a piece of a pair dropped", "n\n", ""),
        edited("a pair dropped", PAIR, ""),
        edited("a pair dropped, and counted", PAIR + "end 2", "end 1"),
        edited("a pair in another step", "step 1\n", "0 none\nd 0 0 1\nstep 1\n"),
        edited("a pair doubled", "end 2", "2 none\nd 0 0 1\nend 3"),
        edited("pairs counted through", "step 0\n", "step 0\n0 none\nd 0 0 1\n"),
        ("pairs swapped", 1, swapped, [FALL]),
        edited("step 0 dropped", "step 0\n", ""),
        edited("step 1 dropped", "step 1\n", ""),
        edited("a step more", "end", "step 2\nend"),
        edited("step 0 doubled", "step 0\n", "step 0\nstep 0\n"),
        edited("steps swapped", "step 0\nstep 1\n", "step 1\nstep 0\n"),
        edited("steps from 1 on", "step 0\nstep 1\n", "step 1\nstep 2\n"),
        edited("a leading zero", "step 1", "step 01"),
        edited("a word too many", "step 1", "step 1 1"),
        edited("wrong count of queries", "end 2 1", "end 1 1"),
        edited("wrong count of contacts", "end 2 1", "end 2 0"),
        edited("a contact denied", first, "0 none\nn\n"),
        edited("another time", "0x1p-2 0x1p-2", "0x1p-1 0x1p-1"),
        edited("another kind", "file mesh", "file vertex-face", 2),
        broken("one frame", FALL[FALL.index("frame"):FALL.rindex("frame")], ""),
        motion("no frame", FALL[:FALL.index("frame")]),
        motion("a query file", query),
        motion("nothing", ""),
        broken("another version", "touchstone-motion 1", "touchstone-motion 2"),
        broken("no number of vertices", "vertices 7", "vertices"),
        broken("vertices with a leading zero", "vertices 7", "vertices 07"),
        broken("vertices with a sign", "vertices 7", "vertices +7"),
        broken("more vertices than lines", "vertices 7", "vertices 8"),
        broken("fewer vertices than lines", "vertices 7", "vertices 6"),
        broken("very many vertices", "vertices 7", "vertices 1" + 30 * "0"),
        broken("2^30 vertices", "vertices 7", f"vertices {1 << 30}"),
        broken("an edge without an end", "edge 4 5", "edge 4"),
        broken("an edge of three vertices", "edge 4 5", "edge 4 5 6"),
        broken("an edge of one vertex", "edge 4 5", "edge 4 4"),
        broken("a face of two vertices", "face 0 1 2", "face 0 1 0"),
        broken("no such vertex", "edge 4 5", "edge 4 7"),
        broken("two lines for a point", "point 3\n", "point 3\npoint 3\n"),
        broken("two lines for a fixed vertex", "fixed 1\n", "fixed 1\nfixed 1\n"),
        broken("a fixed vertex that moves", "fixed 2\n", "fixed 2\nfixed 3\n"),
        broken("another sort of element", "edge 4 5", "volume 4 5"),
        broken("an element after the frames", last_frame, last_frame + "point 0\n"),
        broken("a coordinate too few", "-1 1 4", "-1 1"),
        broken("a coordinate too many", "-1 1 4", "-1 1 4 0"),
        broken("a coordinate that is no number", "-1 1 4", "-1 1 four"),
        broken("a decimal point", "-1 1 4", "-1 1 4.0"),
        broken("a vertex too few", "-1 1 4\n", ""),
        broken("a frame too short at the end", "90 0 0\n" + FALL[-1:] * 0, ""),
        broken("a fixed vertex written in another way", "4 0 0", "0x1p2 0 0", 0),
        broken("a point of the face, which shares its vertex", "point 6", "point 6\npoint 0", 0),
        broken("two edges alike", "edge 4 5", "edge 4 5\nedge 5 4", 1),  # two pairs with the point
        broken("a fixed vertex that rests", "fixed 2\n", "fixed 2\nfixed 6\n", 0),
        motion("nothing moves, nothing is there", empty, nothing),
        motion("positions without elements", "".join(bare), steps),
        motion("one point of them", "".join(bare[:2] + ["point 6\n"] + bare[2:]), steps),
        motion("two points of them, far apart", "".join(bare[:2] + ["point 6\npoint 0\n"] + bare[2:]), steps, 0),
        motion("two points of them, and one a corner", "".join(bare[:2] + ["point 6\nedge 6 0\n"] + bare[2:]), steps),
        motion("edges and faces that share a vertex", fan("edge 0 1\nedge 0 2\npoint 0\nface 0 1 2\n"), steps),
        motion("edges and faces that share a vertex, and a point far away",
               fan("edge 0 1\nedge 0 2\npoint 0\nface 0 1 2\npoint 3\n"), steps, 0),
        motion("all kinds, boxes D apart", crowd(), crowd_proof(CROWD_PAIRS), 0),
        motion("all kinds, boxes more than D apart", crowd(), crowd_proof([], less), 0),
        motion("all kinds, pairs that are too far", crowd(), crowd_proof(CROWD_PAIRS, less), 1),
        motion("all kinds, no pairs", crowd(), crowd_proof([]), 1),
        motion("faces after edges", crowd(), crowd_proof(faces_last), 1),
        motion("sorted by the second element", crowd(), crowd_proof(by_edge), 1),
        motion("both edges are fixed", crowd("fixed 0\nfixed 1\nfixed 2\nfixed 3\n"), crowd_proof(CROWD_PAIRS[1:]), 0),
        motion("both edges are fixed, with their pair", crowd("fixed 0\nfixed 1\nfixed 2\nfixed 3\n"),
               crowd_proof(CROWD_PAIRS), 1),
        motion("one corner is not fixed", crowd("fixed 0\nfixed 1\nfixed 2\n"), crowd_proof(CROWD_PAIRS), 0),
        motion("a point that becomes a corner of an edge", crowd("edge 6 8\n"), crowd_proof(CROWD_PAIRS), 1),
        ("after a query file", 0, both, [still(ORIGIN, (-2, 0, 0)), far]),
        ("files in another order", 2, both, [far, still(ORIGIN, (-2, 0, 0))]),
        ("a query file without a query", 2, proof_of(("", "point-point", []), end="0 0"), [""]),
        ("a query file with a comment alone", 2, proof_of(("", "point-point", []), end="0 0"), ["# none\n"]),
        ("a query file without a query after another file", 2, both.replace("file mesh", "file point-edge").replace(
            "step 0\n", ""), [still(ORIGIN, (-2, 0, 0)), ""]),
        ("no query file of the two", 1, both, [still(ORIGIN, (-2, 0, 0))]),
    ]]


def row_cases():
    """The words of a row: what may stand around and in them."""
    row = "0,1,0,1,0,1,0\n"
    apart = "-7,3,0,1,0,1,0\n"
    text = row + apart + row + apart

    def case(name, status, old, new):
        assert old in text
        return one("row: " + name, status, "", "point-point", text.replace(old, new, 1), "0 none", WEST)

    return [
        case("as it is", 0, row, row),
        case("spaces and tabs around the numbers", 0, "-7,3,", " \t-7\t ,\t3 ,"),
        case("a tab before the truth", 0, "1,0\n", "1,\t0\n"),
        case("a tab after the truth", 0, "1,0\n", "1,0\t \n"),
        case("a tab and a carriage return after the truth", 0, "1,0\n", "1,0\t\r\n"),
        case("a carriage return and a tab after the truth", 2, "1,0\n", "1,0\r\t\n"),
        case("two carriage returns", 2, "1,0\n", "1,0\r\r\n"),
        case("a tab in a number", 2, "-7", "-\t7"),
        case("another blank", 2, "-7", "\v-7"),
        case("leading zeros of a coordinate", 0, "-7,3", "-007,03"),
        case("a comment after a tab", 0, apart, "\t# a\n" + apart),
        case("a line of a space and a tab", 0, apart, " \t\n" + apart),
        case("truth 00", 2, "1,0\n", "1,00\n"),
        case("truth 01 in all rows", 2, text, text.replace(",0\n", ",01\n")),
        case("truth 1 in all rows, which no proof is about", 0, text, text.replace(",0\n", ",1\n")),
        case("truth -0", 2, "1,0\n", "1,-0\n"),
        case("truth 2 in all rows", 2, text, text.replace(",0\n", ",2\n")),
        case("no truth", 2, "1,0\n", "1,\n"),
        case("six columns", 0, text, text.replace(",0\n", "\n")),
        case("six columns in one row", 2, "1,0\n", "1\n"),
        case("a truth in one row", 2, text, text.replace(",0\n", "\n", 3)),
        case("another truth", 2, "1,0\n", "1,1\n"),
        case("a plus", 2, "-7", "+7"),
        case("denominator -3", 2, "3", "-3"),
        case("denominator 00", 2, "3", "00"),
        case("a column more", 2, "1,0\n", "1,0,\n"),
    ]


# A point of a body makes half a turn about the z axis, along the unit circle from (1, 0) to (-1, 0), and meets the
# point (0, 1) at t = 1/2: W = 1 - 2 t + 2 t^2 and X = (1 - 2 t, 2 t - 2 t^2, 0).
TURN = ("touchstone-curved,1\nquery,1\nmotion,0,1,0,0,0,0,0,0,1,0,0,0,0,0,0\nbody,0,1,0,0\n"
        "curve,0,1,0\n")
TURN_PROOF = ["0 contact 0x1p-1 0x1p-1", WEST, "w 0 1", "w 1 1"]
# The middle of an edge rests at the origin. One corner is on a body whose quaternion has the length 2, so W = 4.
HALF_EDGE = ("touchstone-curved,1\nquery,1\nmotion,3,2,0,0,0,2,0,0,0,0,0,0,0,0,0\ncurve,0,0,0\nbody,3,-1,0,0\n"
             "curve,1,0,0\n")


def curved_cases():
    def case(name, status, old, new, proof=None, text=TURN):
        assert old in text
        return one("curved: " + name, status, "", "point-point", text.replace(old, new, 1), *(proof or TURN_PROOF))

    def number(text, status):
        return case("the number " + text[:60], status, "curve,0,1,", f"curve,0,{text},")

    def half(status, *weights):
        return one("curved: weights " + " ".join(weights), status, "", "point-edge", HALF_EDGE, "0 contact 0 0", "w 0 1",
                   *weights)

    tie = "1.00000000000000011102230246251565404236316680908203125"  # 1 + 2^-53
    numbers = [("1.", 0), ("01", 0), ("1e0", 0), ("1E+0", 0), ("10e-1", 0), (".1e1", 0), ("0x1", 0), ("0x.8p1", 0),
               ("0X1P+0", 0), ("0x1.p0", 0), ("1" + "0" * 400 + "e-400", 0), ("1.00000000000000005", 0), (tie, 0),
               (tie + "1", 1), ("0x1.00000000000008p0", 0), ("0x1.000000000000081p0", 1), ("0x1.00000000000018p0", 1),
               ("1.0000000000000002", 1), ("-1", 1), ("0", 1), ("+1", 2), ("", 2), (".", 2), ("-", 2), ("1e", 2),
               ("0x", 2), ("0xp1", 2), ("1e+-0", 2), ("1e-+0", 2), ("--1", 2), ("1.0.0", 2), ("1 0", 2), ("0x1p", 2),
               ("nan", 2), ("inf", 2), ("1e400", 2), ("1e-400", 2), ("0x1p1024", 2), ("0x1p-1075", 2), ("1p0", 2),
               ("0x1p-1074", 1), ("0x1.fffffffffffff8p1023", 2), ("0x1e0", 1), ("1" + "0" * 4096 + "e-4096", 2),
               ("1e20001", 2), ("1." + "0" * 4095, 0), ("1." + "0" * 4096, 2), ("0x1." + "0" * 4095, 0),
               ("0x1." + "0" * 4096, 2), ("1e" + "0" * 4096, 0), ("1e" + "0" * 4097, 2)]
    late = ["0 contact 1 1"] + TURN_PROOF[1:]
    motion = "motion,0,1,0,0,0,0,0,0,1,0,0,0,0,0,0\n"
    body = "body,0,1,0,0\n"
    return [number(*pair) for pair in numbers] + [
        case("as it is", 0, "query", "query"),
        case("a comment and blanks", 0, motion, "# a\n \t\n" + motion.replace(",", " ,\t")),
        case("truth 0", 0, "query,1", "query,0"),
        case("another time", 1, "query", "query", late),
        case("another answer", 1, "query", "query", ["0 none", WEST]),
        case("n for points", 1, "query", "query", [TURN_PROOF[0], "n"] + TURN_PROOF[2:]),
        case("a direction that is zero at the start", 1, "query", "query", [TURN_PROOF[0], "d 1 1 0"] + TURN_PROOF[2:]),
        case("a longer quaternion", 0, motion, "motion,0,3,0,0,0,0,0,0,3,0,0,0,0,0,0\n"),
        case("the other sign of both", 0, motion, "motion,0,-1,0,0,0,0,0,0,-1,0,0,0,0,0,0\n"),
        case("the other way round", 1, motion, "motion,0,1,0,0,0,0,0,0,-1,0,0,0,0,0,0\n"),
        case("a longer quaternion at the end", 1, motion, "motion,0,1,0,0,0,0,0,0,3,0,0,0,0,0,0\n"),
        case("no turn", 1, motion, "motion,0,1,0,0,0,1,0,0,0,0,0,0,0,0,0\n"),
        case("a quaternion that is zero at 1/2", 2, motion, "motion,0,1,0,0,0,-1,0,0,0,0,0,0,0,0,0\n"),
        case("a quaternion that is zero at 1/4", 2, motion, "motion,0,1,-2,3,1,-3,6,-9,-3,0,0,0,0,0,0\n"),
        case("a quaternion that is zero at 0", 2, motion, "motion,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0\n"),
        case("a quaternion that is zero at 1", 2, motion, "motion,0,1,0,0,0,0,0,-0,0.0,0,0,0,0,0,0\n"),
        case("blanks around the words of the first row", 0, "touchstone-curved,1", " touchstone-curved\t, 1 "),
        case("another version", 2, "curved,1", "curved,2"),
        case("no version", 2, "curved,1", "curved"),
        case("a word after the version", 2, "curved,1", "curved,1,"),
        case("no first row", 2, "touchstone-curved,1\n", ""),
        case("the first row twice", 2, "query", "touchstone-curved,1\nquery"),
        case("no end of line", 2, "curve,0,1,0\n", "curve,0,1,0"),
        case("carriage returns", 0, TURN, TURN.replace("\n", "\r\n")),
        case("no queries", 2, TURN, "touchstone-curved,1\n"),
        case("a query more", 1, TURN, TURN + TURN[TURN.index("query"):]),
        case("truth 2", 2, "query,1", "query,2"),
        case("no truth", 2, "query,1", "query"),
        case("no row of a query", 2, "query,1\n", ""),
        case("a motion without a corner", 2, motion, motion + motion.replace("n,0", "n,1")),
        case("a motion twice", 2, motion, motion + motion),
        case("no motion", 2, motion, ""),
        case("the motion after its corner", 2, motion + body, body + motion),
        case("another motion", 2, body, body.replace("y,0", "y,1")),
        case("motion 4", 2, motion + body, (motion + body).replace("y,0", "y,4").replace("n,0", "n,4")),
        case("motion 00", 2, body, body.replace("y,0", "y,00")),
        case("motion 3", 0, motion + body, (motion + body).replace("y,0", "y,3").replace("n,0", "n,3")),
        case("a motion between the corners", 0, motion + body + "curve,0,1,0\n", "curve,0,1,0\n" + motion + body),
        case("a number of a motion too few", 2, motion, motion.replace(",0\n", "\n")),
        case("a number of a motion too many", 2, motion, motion.replace(",0\n", ",0,0\n")),
        case("a coordinate of a body too few", 2, body, "body,0,1,0\n"),
        case("two points of a body", 2, body, "body,0,1,0,0,1,0,0\n"),
        case("a corner too few", 2, "curve,0,1,0\n", ""),
        case("a corner too many", 2, body, body + body),
        case("another word", 2, "curve,", "corner,"),
        case("two control points", 0, "curve,0,1,0", "curve,0,1,0,0,1,0"),
        case("four control points", 0, "curve,0,1,0", "curve" + ",0,1,0" * 4),
        case("five control points", 2, "curve,0,1,0", "curve" + ",0,1,0" * 5),
        case("no control point", 2, "curve,0,1,0", "curve"),
        case("a control point and a half", 2, "curve,0,1,0", "curve,0,1,0,0"),
        case("a parabola that is there at 1/2", 0, "curve,0,1,0", "curve,0,1,2,0,1,0,0,1,-2"),
        case("a parabola that is higher at 1/2", 1, "curve,0,1,0", "curve,0,1,0,0,1,1,0,1,0"),
        half(0, "w 1 1", "w 2 4"),
        half(0, "w 1 0x1p-2", "w 2 1"),
        half(1, "w 1 1", "w 2 1"),
        half(1, "w 1 4", "w 2 1"),
        half(1, "w 1 -1", "w 2 -4"),
    ]


def all_cases():
    return (point_point_cases() + corner_cases() + line_cases() + row_cases() + curved_cases() + motion_cases() +
            fold_cases() + radius_cases() + group_cases() + touching_cases() +
            body_cases())


def by_page(proof, files):
    """The exit status of check_proofs.py and its last line or its complaint."""
    named = [(io.BytesIO(text.encode()), f"file {i}") for i, text in enumerate(files)]
    try:
        counts = check_proofs.check(io.BytesIO(proof.encode()), "proof", named, allow_empty=True)
    except check_proofs.Rejected as reason:
        return 1, str(reason)
    except check_proofs.BadInput as reason:
        return 2, str(reason)
    return 0, check_proofs.verdict(*counts)


def by_program(program, proof, files, folder):
    paths = [os.path.join(folder, name) for name in ["proof"] + [f"file{i}" for i in range(len(files))]]
    for path, text in zip(paths, [proof] + files):
        with open(path, "w", newline="") as stream:
            stream.write(text)
    done = subprocess.run([program, "--allow-empty"] + paths, capture_output=True, text=True, timeout=60, check=False)
    return done.returncode, (done.stdout if done.returncode == 0 else done.stderr).strip().split("\n")[-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--checker", help="the other checker")
    arguments = parser.parse_args()
    failures = []
    cases = all_cases()
    with tempfile.TemporaryDirectory() as folder:
        for name, status, proof, files in cases:
            found, text = by_page(proof, files)
            if found != status:
                failures.append(f"{name}: check_proofs.py ends with {found}, and not with {status}: {text}\n{proof}")
            elif found == 0 and claims(proof) != truths(proof, files):
                failures.append(f"{name}: an answer is not true\n{proof}")
            if arguments.checker:
                other, other_text = by_program(arguments.checker, proof, files, folder)
                if other != status or other == 0 and other_text != text:
                    failures.append(f"{name}: {arguments.checker} ends with {other}, and not with {status}: "
                                    f"{other_text}\n{proof}")
    for failure in failures:
        print(failure, file=sys.stderr)
    counts = [sum(status == s for _, status, _, _ in cases) for s in (0, 1, 2)]
    print(f"{len(cases)} small cases: {counts[0]} proofs hold, {counts[1]} do not, {counts[2]} errors; "
          f"{len(failures)} wrong verdicts")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
