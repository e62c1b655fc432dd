# SPDX-License-Identifier: MIT
"""What a file of proofs claims, and what is true: both as lists of answers, one for each file or step.

The truth comes from exact_judge.py, and all pairs of a motion's step are looked at. The parser here is lenient: it is
for proofs that a checker has accepted.
"""

import functools
import itertools
from fractions import Fraction

from exact_judge import Elements

CORNERS = {"edge-edge": (2, 4), "vertex-face": (1, 4), "point-edge": (1, 3), "point-point": (1, 2)}


def value(word):
    """A number of a proof."""
    sign = -1 if word.startswith("-") else 1
    word = word.lstrip("-")
    if not word.startswith("0x"):
        return sign * Fraction(int(word))
    digits, exponent = word[2:].split("p")
    whole, _, fraction = digits.partition(".")
    return sign * int(whole + fraction, 16) * Fraction(2) ** (int(exponent) - 4 * len(fraction))


def lines_of(text):
    """The words of each line that is neither blank nor a comment."""
    words = [line.split() for line in text.split("\n")]
    return [line for line in words if line and not line[0].startswith("#")]


def claims(proofs):
    """For each file, or step of a motion, the list of answers: None or the times (T, U)."""
    answers = []
    for words in lines_of(proofs):
        if words[0] == "step" or words[0] == "file" and words[1] != "mesh":
            answers.append([])
        elif words[0].isdigit():
            answers[-1].append(None if words[1] == "none" else (value(words[2]), value(words[3])))
    return answers


def truths(proofs, files):
    """The true answers to the queries of the files, in the order of claims(). None for a file with an error."""
    answers = []
    metric, separation = "euclidean", "0"
    files = iter(files)
    for words in lines_of(proofs):
        if words[0] == "separation":
            _, metric, separation = words
        elif words[0] == "file":
            found = truths_of_file(words[1], next(files), metric, value(separation))
            if found is None:
                return None
            answers += found
            metric, separation = "euclidean", "0"
    return answers


def truths_of_file(kind, text, metric, separation):
    if kind == "mesh":
        return truths_of_motion(text, metric, separation)
    split, count = CORNERS[kind]
    rows = [[int(x) for x in line.split(",")] for line in text.split("\n")
            if line.strip() and not line.strip().startswith("#")]
    points = [tuple(Fraction(row[c], row[c + 1]) for c in (0, 2, 4)) for row in rows]
    if len(points) % (2 * count):
        return None
    queries = [points[i:i + 2 * count] for i in range(0, len(points), 2 * count)]
    return [[first_contact(tuple(query[:count]), tuple(query[count:]), split, metric, separation) for query in queries]]


@functools.lru_cache(maxsize=100000)
def first_contact(starts, ends, split, metric, separation):
    return Elements(list(starts), list(ends), split, metric, separation).first_contact()


class BadMotion(Exception):
    """The motion file is not valid."""


def parse_motion(text):
    """The elements by their sort, and the frames as lists of points."""
    lines = lines_of(text)
    count = int(lines[1][1])
    elements = {"point": [], "edge": [], "face": [], "fixed": []}
    rest = 2
    while rest < len(lines) and lines[rest][0] in elements:
        elements[lines[rest][0]].append(tuple(int(word) for word in lines[rest][1:]))
        rest += 1
    frames = []
    while rest < len(lines):
        frame = lines[rest + 1:rest + 1 + count]
        if lines[rest] != ["frame"] or len(frame) != count or any(len(words) != 3 for words in frame):
            raise BadMotion
        frames.append([tuple(value(word) for word in words) for words in frame])
        rest += 1 + count
    if len(frames) < 2 or any(len({frame[v] for frame in frames}) > 1 for v, in elements["fixed"]):
        raise BadMotion
    for sort, size in (("point", 1), ("edge", 2), ("face", 3), ("fixed", 1)):
        if any(len(set(e)) != size or len(e) != size or not 0 <= min(e) <= max(e) < count for e in elements[sort]):
            raise BadMotion
        if size == 1 and len(set(elements[sort])) < len(elements[sort]):
            raise BadMotion
    return elements, frames


def pairs_of(elements):
    """All pairs of a motion, near or far, in the order of the proofs: the vertices of both elements."""
    fixed = {v for v, in elements["fixed"]}
    corners = {v for edge in elements["edge"] for v in edge}
    alone = [point for point in elements["point"] if point[0] not in corners]
    for pairs in (itertools.combinations(elements["edge"], 2), itertools.product(elements["point"], elements["face"]),
                  itertools.product(alone, elements["edge"]), itertools.combinations(alone, 2)):
        for first, second in pairs:
            if not set(first) & set(second) and not fixed.issuperset(first + second):
                yield first, second


def near(first, second, frames, separation):
    """Whether the boxes of two elements during a step are at most the separation apart along each axis."""
    for c in range(3):
        a = [frame[v][c] for frame in frames for v in first]
        b = [frame[v][c] for frame in frames for v in second]
        if min(b) - max(a) > separation or min(a) - max(b) > separation:
            return False
    return True


def truths_of_motion(text, metric, separation):
    try:
        elements, frames = parse_motion(text)
    except BadMotion:
        return None
    answers = []
    for start, end in zip(frames, frames[1:]):
        answers.append([])
        for first, second in pairs_of(elements):
            if near(first, second, (start, end), separation):
                points = [tuple(frame[v] for v in first + second) for frame in (start, end)]
                answers[-1].append(first_contact(*points, len(first), metric, separation))
    return answers
