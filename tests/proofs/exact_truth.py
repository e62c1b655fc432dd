# SPDX-License-Identifier: MIT
"""What a file of proofs claims, and what is true: both as lists of answers, one for each file or step.

The truth comes from exact_judge.py, and all pairs of a motion's step are looked at. The parser here is lenient: it is
for proofs that a checker has accepted.
"""

import collections
import functools
import itertools
import math
from fractions import Fraction

from exact_judge import Elements, add, mul

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
    if is_curved(text):
        try:
            queries = curved_queries(text)
            answers = [first_contact_of(tuple(query), kind, metric, separation) for query in queries]
            return [answers] if answers else None
        except (BadQuery, ValueError, IndexError, OverflowError):
            return None
    rows = [[int(x) for x in line.split(",")] for line in text.split("\n")
            if line.strip() and not line.strip().startswith("#")]
    points = [tuple(Fraction(row[c], row[c + 1]) for c in (0, 2, 4)) for row in rows]
    if not points or len(points) % (2 * count):
        return None
    queries = [points[i:i + 2 * count] for i in range(0, len(points), 2 * count)]
    return [[first_contact(tuple(query[:count]), tuple(query[count:]), split, metric, separation) for query in queries]]


@functools.lru_cache(maxsize=100000)
def first_contact(starts, ends, split, metric, separation):
    corners = [[[Fraction(s), Fraction(e) - s] for s, e in zip(start, end)] for start, end in zip(starts, ends)]
    return Elements(corners, split, metric, [Fraction(separation)]).first_contact()


class BadQuery(Exception):
    """A query with curved motion is not valid."""


def rows_of(text):
    """The columns of each row of a query file."""
    rows = [[word.strip() for word in line.split(",")] for line in text.split("\n")]
    return [row for row in rows if row != [""] and not row[0].startswith("#")]


def is_curved(text):
    return rows_of(text)[:1] == [["touchstone-curved", "1"]]


def curved_queries(text):
    """The rows of each query of a file with curved motion."""
    queries = []
    for row in rows_of(text)[1:]:
        if row[0] == "query":
            queries.append([])
        queries[-1].append(tuple(row))
    return queries


def as_double(word):
    """The double nearest to a number, as a fraction."""
    x = float.fromhex(word) if "x" in word.lower() else float(word)
    return Fraction(x)


def line(start, end):
    return [start, end - start]


def quaternion_product(a, b):
    s, x, y, z = range(4)
    terms = [[(s, s, 1), (x, x, -1), (y, y, -1), (z, z, -1)], [(s, x, 1), (x, s, 1), (y, z, 1), (z, y, -1)],
             [(s, y, 1), (y, s, 1), (z, x, 1), (x, z, -1)], [(s, z, 1), (z, s, 1), (x, y, 1), (y, x, -1)]]
    return [functools.reduce(lambda total, t: add(total, mul(a[t[0]], b[t[1]]), t[2]), row, [0]) for row in terms]


class RigidMotion:
    """Of the 14 numbers of a row `motion`."""

    def __init__(self, numbers):
        self.q = [line(a, b) for a, b in zip(numbers[:4], numbers[4:8])]
        self.conjugate = [self.q[0]] + [[-c for c in p] for p in self.q[1:]]
        self.origin = [line(a, b) for a, b in zip(numbers[8:11], numbers[11:14])]
        self.weight = quaternion_product(self.q, self.conjugate)[0]

    def corner(self, point):
        """The coordinates of a point of the body, times the weight."""
        pure = [[Fraction(0)]] + [[Fraction(x)] for x in point]
        turned = quaternion_product(quaternion_product(self.q, pure), self.conjugate)[1:]
        return [add(x, mul(self.weight, p)) for x, p in zip(turned, self.origin)]

    def box(self, point):
        """The least and the greatest quotients of Bernstein coefficients, rounded to doubles outwards."""
        weights = bernstein_of_cubic(self.weight)
        if min(weights) <= 0:
            raise BadMotion
        quotients = [[x / w for x, w in zip(bernstein_of_cubic(p), weights)] for p in self.corner(point)]
        return [rounded_down(min(axis)) for axis in quotients], [-rounded_down(-max(axis)) for axis in quotients]


def bernstein_of_cubic(p):
    c = list(p) + [Fraction(0)] * (4 - len(p))
    return [c[0], c[0] + c[1] / 3, c[0] + 2 * c[1] / 3 + c[2] / 3, sum(c)]


def rounded_down(x):
    nearest = Fraction(float(x))
    return nearest if nearest <= x else Fraction(math.nextafter(float(x), -math.inf))


@functools.lru_cache(maxsize=100000)
def first_contact_of(rows, kind, metric, separation):
    """Of a query with curved motion. All corners are multiplied by all |q|^2."""
    split, count = CORNERS[kind]
    motions, corners = {}, []
    for row in rows[1:]:
        if row[0] == "motion":
            if len(row) != 16 or row[1] in motions or row[1] not in ("0", "1", "2", "3"):
                raise BadQuery
            numbers = [as_double(word) for word in row[2:]]
            q0, q1 = numbers[:4], numbers[4:8]
            # q(t) = 0 where all components vanish at one t in [0, 1].
            for t in [a / (a - b) for a, b in zip(q0, q1) if a != b] + [Fraction(0)]:
                if 0 <= t <= 1 and not any((1 - t) * a + t * b for a, b in zip(q0, q1)):
                    raise BadQuery
            motions[row[1]] = RigidMotion(numbers)
        elif row[0] == "body" and row[1] in motions and len(row) == 5:
            corners.append((row[1], motions[row[1]].corner([as_double(word) for word in row[2:]])))
        elif row[0] == "curve" and len(row) in (4, 7, 10, 13):
            numbers = [as_double(word) for word in row[1:]]
            controls = [numbers[i:i + 3] for i in range(0, len(numbers), 3)]
            while len(controls) > 1:  # de Casteljau's scheme, with polynomials in place of points
                controls = [[add(mul([1, -1], p if isinstance(p, list) else [p]),
                                 mul([0, 1], q if isinstance(q, list) else [q])) for p, q in zip(a, b)]
                            for a, b in zip(controls, controls[1:])]
            corners.append((None, [p if isinstance(p, list) else [p] for p in controls[0]]))
        else:
            raise BadQuery
    if rows[0][0] != "query" or len(rows[0]) != 2 or rows[0][1] not in ("0", "1") or len(corners) != count:
        raise BadQuery
    if {motion for motion, _ in corners} - {None} != set(motions):
        raise BadQuery

    return first_contact_on(motions, corners, split, metric, separation)


def first_contact_on(motions, corners, split, metric, separation):
    """Of corners as polynomials, each with the name of its motion or None."""
    def completed(p, motion):
        for other, rigid in motions.items():
            p = mul(p, rigid.weight) if other != motion else p
        return p
    polynomials = [[completed(p, motion) for p in corner] for motion, corner in corners]
    return Elements(polynomials, split, metric, completed([Fraction(separation)], None)).first_contact()


class BadMotion(Exception):
    """The motion file is not valid."""


class Element(tuple):
    """The vertices of an element, which has a radius."""


class Motion:
    """The elements by their sort, the body and the point of each vertex on a body, and the frames: the rows of bodies
    and those of vertices."""

    SIZES = {"point": 1, "edge": 2, "face": 3, "fixed": 1}

    def __init__(self, text):
        lines = lines_of(text)
        count = int(lines[1][1])
        self.elements = {sort: [] for sort in self.SIZES}
        self.bodies = {}
        self.near = set()
        self.has_radii = False
        self.groups, self.ignored, self.touching = {}, [], set()
        radius = 0
        rest = 2
        while rest < len(lines) and lines[rest][0] in list(self.SIZES) + ["body", "radius", "near", "group", "ignore", "touching"]:
            sort, *words = lines[rest]
            if sort == "radius":
                radius, = (value(word) for word in words)
                self.has_radii = True
                if radius < 0:
                    raise BadMotion
            elif sort == "near":
                pair = frozenset(int(word) for word in words)
                if len(words) != 2 or len(pair) != 2 or pair in self.near or not 0 <= min(pair) <= max(pair) < count:
                    raise BadMotion
                self.near.add(pair)
            elif sort == "touching":
                split, size = CORNERS[words[0]]
                pair = split, size - split, int(words[1]), int(words[2])
                if len(words) != 3 or pair in self.touching or min(pair[2:]) < 0 or pair[:2] in ((1, 1), (2, 2)) and (
                        pair[2] >= pair[3]):
                    raise BadMotion
                self.touching.add(pair)
            elif sort in ("group", "ignore"):
                a, b = (int(word) for word in words)
                known = a in self.groups or a >= count if sort == "group" else [a, b] in self.ignored
                if known or min(a, b) < 0:
                    raise BadMotion
                if sort == "group":
                    self.groups[a] = b
                else:
                    self.ignored += [[a, b], [b, a]]
            elif sort == "body":
                if int(words[0]) in self.bodies or not 0 <= int(words[0]) < count:
                    raise BadMotion
                self.bodies[int(words[0])] = int(words[1]), tuple(value(word) for word in words[2:])
            else:
                self.elements[sort].append(Element(int(word) for word in words))
                self.elements[sort][-1].radius = radius
                self.elements[sort][-1].number = len(self.elements[sort]) - 1
            rest += 1
        body_count = max([body + 1 for body, _ in self.bodies.values()], default=0)
        self.frames = []
        while rest < len(lines):
            rows = lines[rest + 1:rest + 1 + body_count + count - len(self.bodies)]
            sizes = [7] * body_count + [3] * (count - len(self.bodies))
            if lines[rest] != ["frame"] or [len(words) for words in rows] != sizes:
                raise BadMotion
            numbers = [tuple(value(word) for word in words) for words in rows]
            free = iter(numbers[body_count:])
            self.frames.append((numbers[:body_count], [None if v in self.bodies else next(free) for v in range(count)]))
            rest += 1 + len(rows)
        self.check(count)

    def check(self, count):
        if len(self.frames) < 2:
            raise BadMotion
        for vertex, in self.elements["fixed"]:
            if len({self.place(vertex, frame) for frame in self.frames}) > 1:
                raise BadMotion
        for sort, size in self.SIZES.items():
            elements = self.elements[sort]
            if any(len(set(e)) != size or len(e) != size or not 0 <= min(e) <= max(e) < count for e in elements):
                raise BadMotion
            if size == 1 and len(set(elements)) < len(elements):
                raise BadMotion

    def place(self, vertex, frame):
        return frame[0][self.bodies[vertex][0]] if vertex in self.bodies else frame[1][vertex]

    def motion(self, body, start, end):
        """As in a row `motion`."""
        a, b = start[0][body], end[0][body]
        return a[:4] + b[:4] + a[4:] + b[4:]

    def only_touches(self, first, second):
        return (len(first), len(second), first.number, second.number) in self.touching

    def separation(self, first, second, is_fold):
        """Of a pair of a motion with radii."""
        if is_fold or any(frozenset(pair) in self.near for pair in itertools.product(first, second)):
            return 0
        return round_up(first.radius + second.radius)

    def boxes(self, start, end):
        """Of each vertex, its least and its greatest coordinates."""
        boxes = [(a, b) if a else None for a, b in zip(start[1], end[1])]
        for vertex, (body, point) in self.bodies.items():
            boxes[vertex] = RigidMotion(self.motion(body, start, end)).box(point)
        return boxes

    def first_contact(self, vertices, split, start, end, metric, separation):
        if not any(v in self.bodies for v in vertices):
            return first_contact(*(tuple(frame[1][v] for v in vertices) for frame in (start, end)), split, metric,
                                 separation)
        motions = tuple((b, self.motion(b, start, end)) for b in {self.bodies[v][0] for v in vertices
                                                                 if v in self.bodies})
        corners = tuple(self.bodies[v] if v in self.bodies else (None, start[1][v] + end[1][v]) for v in vertices)
        return first_contact_of_bodies(motions, corners, split, metric, separation)


@functools.lru_cache(maxsize=100000)
def first_contact_of_bodies(motions, corners, split, metric, separation):
    rigid = {body: RigidMotion(numbers) for body, numbers in motions}
    polynomials = [(body, [line(a, b) for a, b in zip(numbers[:3], numbers[3:])] if body is None else
                    rigid[body].corner(numbers)) for body, numbers in corners]
    return first_contact_on(rigid, polynomials, split, metric, separation)


def pairs_of(elements, bodies, groups, ignored):
    """All pairs of a motion, near or far, in the order of the proofs: the vertices of both elements, and whether the
    pair is a fold, for which a separation does not count."""
    fixed = {v for v, in elements["fixed"]}
    corners = {v for edge in elements["edge"] for v in edge}
    alone = [point for point in elements["point"] if point[0] not in corners]
    wires = [edge for edge in elements["edge"] if not any(set(edge) <= set(face) for face in elements["face"])]
    neighbours = collections.defaultdict(set)
    for v, w in wires:
        neighbours[v].add(w)
        neighbours[w].add(v)
    folds = (((w,), wire) for w, in elements["point"] for wire in wires if neighbours[w] & set(wire))
    kinds = [itertools.combinations(elements["edge"], 2), itertools.product(elements["point"], elements["face"]),
             itertools.product(alone, elements["edge"]), itertools.combinations(alone, 2), folds]
    for pairs in kinds:
        for first, second in pairs:
            on = {bodies[v][0] if v in bodies else None for v in first + second}
            on_one_body = len(on) == 1 and None not in on
            is_asked = any([groups.get(v), groups.get(w)] not in ignored for v in first for w in second)
            if not set(first) & set(second) and not fixed.issuperset(first + second) and not on_one_body and is_asked:
                yield first, second, pairs is folds


def round_up(x):
    """The least multiple of a power of two from 2^-1074 on, by an integer below 2^53, that is at least x >= 0."""
    unit = Fraction(1, 1 << 1074)
    while -(-x // unit) >= 1 << 53:
        unit *= 2
    return -(-x // unit) * unit


def near(first, second, boxes, separation):
    """Whether the boxes of two elements during a step are at most the separation apart along each axis."""
    for c in range(3):
        a = [end[c] for v in first for end in boxes[v]]
        b = [end[c] for v in second for end in boxes[v]]
        if min(b) - max(a) > separation or min(a) - max(b) > separation:
            return False
    return True


def truths_of_motion(text, metric, separation):
    try:
        motion = Motion(text)
        answers = []
        pairs = list(pairs_of(motion.elements, motion.bodies, motion.groups, motion.ignored))
        if not pairs or (motion.has_radii and separation > 0):
            raise BadMotion
        for start, end in zip(motion.frames, motion.frames[1:]):
            boxes = motion.boxes(start, end)
            answers.append([])
            for first, second, is_fold in pairs:
                is_fold = is_fold or motion.only_touches(first, second)
                d = 0 if is_fold else separation
                if motion.has_radii:
                    d = motion.separation(first, second, is_fold)
                if near(first, second, boxes, d if motion.has_radii else separation):
                    answers[-1].append(motion.first_contact(first + second, len(first), start, end, metric, d))
        return answers
    except (BadMotion, OverflowError):
        return None
