#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the proofs of `touchstone prove`. It is written from docs/proofs.md alone and uses no code of the library.

    check_proofs.py [--allow-empty] PROOFS FILE...

The files are query files and motion files. The exit status is 0 when every proof holds, 1 when some proof does not
hold, and 2 for a file that cannot be read.

All arithmetic is on integers. A polynomial is the list of its coefficients, the constant one first. The checks ask for
signs and divisibility only. So the coordinates and the separation of a query are multiplied by their common
denominator, and the numbers of a proof by a power of two.
"""

import collections
import functools
import hashlib
import itertools
import math
import re
import sys

MAX_LINE_BYTES = 1 << 20
MAX_DIGITS = 4096
MAX_HEX_DIGITS = 16384
MAX_EXPONENT = 20000
MAX_DEGREE = 32
MAX_QUERY_DIGITS = 4096
MAX_VERTICES = (1 << 30) - 1

# For each kind the number of corners of the first element, and of both.
KINDS = {b"edge-edge": (2, 4), b"vertex-face": (1, 4), b"point-edge": (1, 3), b"point-point": (1, 2)}

NUMBER = re.compile(rb"(-?)(?:([0-9]+)|0x(?=\.?[0-9A-Fa-f])([0-9A-Fa-f]*)(?:\.([0-9A-Fa-f]*))?p([+-]?[0-9]+))")
# The signs s_k of the polynomials for the metric `max`.
SIGNS = list(itertools.product((1, -1), repeat=3))

INTEGER = re.compile(rb"0|[1-9][0-9]*")
DIGEST = re.compile(rb"-|[0-9a-f]{64}")
QUERY_NUMBER = re.compile(rb"-?[0-9]{1,%d}" % MAX_QUERY_DIGITS)
# A number of a file of curved queries: its sign, and digits, fraction and exponent of a hexfloat or a decimal.
CURVED_NUMBER = re.compile(rb"(-?)(?:0[xX](?=\.?[0-9A-Fa-f])([0-9A-Fa-f]*)(?:\.([0-9A-Fa-f]*))?(?:[pP]([+-]?[0-9]+))?|"
                           rb"(?=\.?[0-9])([0-9]*)(?:\.([0-9]*))?(?:[eE]([+-]?[0-9]+))?)")

NONE_NEAR = "no two elements that are asked about come near enough to need a proof"
STARTS = "; not asked: whether a first frame intersects itself, and what lines above leave out"

# Newer versions of Python refuse decimal integers of more than 4,300 digits unless told otherwise.
if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(MAX_DIGITS + 20)


class Rejected(Exception):
    """A proof does not hold."""


class BadInput(Exception):
    """A file cannot be read."""


class Lines:
    """The lines of a binary stream, without blank lines and comments. `line` is the current one, None at the end."""

    def __init__(self, stream, name):
        self.stream = stream
        self.name = name
        self.number = 0
        self.has_end = False
        self.line = b""
        self.sha256 = hashlib.sha256()
        self.advance()

    def advance(self):
        for line in iter(lambda: self.stream.readline(MAX_LINE_BYTES + 3), b""):
            self.number += 1
            self.sha256.update(line)
            self.has_end = line.endswith(b"\n")
            line = re.sub(rb"\r?\n?\Z", b"", line, count=1)
            if self.number == 1 and line.startswith(b"\xef\xbb\xbf"):
                line = line[3:]
            if len(line) > MAX_LINE_BYTES:
                raise BadInput(f"{self.place()}: the line has more than {MAX_LINE_BYTES} bytes")
            text = line.lstrip(b" \t")
            if text and not text.startswith(b"#"):
                self.line = line
                return
        self.line = None

    def digest(self):
        """The digest of the whole file, of which the rest is read."""
        while self.line is not None:
            self.advance()
        return self.sha256.hexdigest().encode()

    def columns(self):
        """The columns of the current row; none at the end of the file."""
        return [] if self.line is None else [column.strip(b" \t") for column in self.line.split(b",")]

    def words(self):
        """The words of the current line; no words at the end of the file."""
        return [] if self.line is None else [word for word in self.line.split(b" ") if word]

    def place(self):
        return f"{self.name}:{self.number}"


def read_number(word, lines):
    """A number of a proof: a pair (m, e) with the value m 2^e. m is odd, or m = e = 0."""
    match = NUMBER.fullmatch(word) if len(word) <= MAX_HEX_DIGITS + MAX_DIGITS + 6 else None
    if not match:
        raise BadInput(f"{lines.place()}: not a number, or too long: {ascii(word[:40].decode('latin-1'))}")
    sign, decimal, whole, fraction, exponent = match.groups(default=b"")
    digits, power = decimal or whole + fraction, power_of(exponent)
    most = MAX_DIGITS if decimal else MAX_HEX_DIGITS
    if len(digits) > most or abs(power) > MAX_EXPONENT:
        raise BadInput(f"{lines.place()}: more than {most} digits, or an exponent beyond {MAX_EXPONENT}")
    value = int(digits, 10 if decimal else 16)
    if value == 0:
        return 0, 0
    zeros = (value & -value).bit_length() - 1
    return (-value if sign else value) >> zeros, power - 4 * len(fraction) + zeros


def power_of(exponent):
    """The exponent of a number, which may have none; beyond the limit if it has too many digits."""
    return int(exponent or 0) if len(exponent.lstrip(b"+-")) <= MAX_DIGITS else MAX_EXPONENT + 1


def read_time(word, lines):
    m, e = read_number(word, lines)
    if e < -MAX_EXPONENT:
        raise BadInput(f"{lines.place()}: a time that is no multiple of 2^-{MAX_EXPONENT}")
    return m, e


def to_integers(numbers):
    """Integers and e, so that number i is integer i times 2^e. e is not positive."""
    least = min([0] + [e for _, e in numbers])
    return [m << (e - least) for m, e in numbers], least


def less(x, y):
    (x, y), _ = to_integers([x, y])
    return x < y


def is_double(x):
    m, e = x
    return m == 0 or (0 < m < 1 << 53 and e >= -1074)


def next_double(x):
    m, e = x
    if m == 0:
        return 1, -1074
    unit = max(e + m.bit_length() - 53, -1074)
    m = (m << (e - unit)) + 1
    zeros = (m & -m).bit_length() - 1
    return m >> zeros, unit + zeros


def plus(p, q):
    if len(p) < len(q):
        p, q = q, p
    return [c + q[i] if i < len(q) else c for i, c in enumerate(p)]


def minus(p, q):
    return plus(p, [-c for c in q])


def times(p, q):
    product = [0] * (len(p) + len(q) - 1)
    for i, c in enumerate(p):
        for j, d in enumerate(q):
            product[i + j] += c * d
    return product


def is_multiple(p, g):
    """Whether g divides p, with rational coefficients. The degree of g is at least 1, and g[-1] is not zero."""
    rest = list(p)
    while len(rest) >= len(g):
        top = rest.pop()
        if top:
            shifted = [0] * (len(rest) + 1 - len(g)) + g[:-1]
            rest = [g[-1] * c - top * d for c, d in zip(rest, shifted)]
    return not any(rest)


@functools.lru_cache(maxsize=None)
def conversion(d):
    """Integers m_ij = f C(i, j) / C(d, j) with one factor f > 0."""
    binomials = [math.comb(d, j) for j in range(d + 1)]
    factor = math.lcm(*binomials)
    return [[math.comb(i, j) * (factor // binomials[j]) for j in range(i + 1)] for i in range(d + 1)]


def bernstein(p, low, high):
    """The Bernstein coefficients of p over [low, high], all times one positive number."""
    (a, b), e = to_integers([low, high])
    # With low = a / 2^k and high = b / 2^k, the steps compute 2^(k d) p((a + s (b - a)) / 2^k) by powers of s.
    k = -e
    width = b - a
    powers = [p[-1]]
    for count, c in enumerate(reversed(p[:-1]), 1):
        powers = [a * x + width * y for x, y in zip(powers + [0], [0] + powers)]
        powers[0] += c << (k * count)
    return [sum(m * c for m, c in zip(row, powers)) for row in conversion(len(p) - 1)]


def is_positive(p, low, high):
    return min(bernstein(p, low, high)) > 0


class Query:
    """Corner i is at corners[i] / weights[i], three polynomials and one that is positive.

    Corners of one motion have the same weight; `motions` has None for those of none, whose weight is 1. All coordinates
    and the separation are times one positive number. `split` is the number of corners of the first element. `metric` is
    None for the separation 0.
    """

    def __init__(self, corners, weights, motions, split, metric, separation):
        self.split = split
        self.size = len(corners)
        self.corners = corners
        self.weights = weights
        self.motions = motions
        self.metric = metric
        self.separation = separation

    @classmethod
    def straight(cls, starts, ends, split, metric, separation):
        corners = [[[s, e - s] for s, e in zip(start, end)] for start, end in zip(starts, ends)]
        return cls(corners, [[1]] * len(corners), [None] * len(corners), split, metric, separation)

    def has_one_weight(self, i, j):
        return self.motions[i] == self.motions[j]

    def difference(self, i, j):
        """D(i, j), a positive multiple of x_i - x_j."""
        if self.has_one_weight(i, j):
            return [minus(p, q) for p, q in zip(self.corners[i], self.corners[j])]
        return [minus(times(self.weights[j], p), times(self.weights[i], q))
                for p, q in zip(self.corners[i], self.corners[j])]

    def factor(self, i, j):
        """S(i, j): D(i, j) is S(i, j) (x_i - x_j)."""
        return self.weights[i] if self.has_one_weight(i, j) else times(self.weights[i], self.weights[j])

    def pairs(self):
        """The corners of the first element, each with each one of the second element."""
        return itertools.product(range(self.split), range(self.split, self.size))

    def normal(self):
        """u x w, for the kinds with 4 corners."""
        ends = ((1, 0), (3, 2)) if self.split == 2 else ((2, 1), (3, 1))
        u, w = (self.difference(i, j) for i, j in ends)
        return [minus(times(u[b], w[c]), times(u[c], w[b])) for b, c in ((1, 2), (2, 0), (0, 1))]


def query_of_rows(rows, split, metric, separation):
    """The query of the rows of a query file. The separation is a number of the proofs."""
    m, e = separation
    factor = 1 << max(-e, 0)
    for row in rows:
        for denominator in (row[1], row[3], row[5]):
            if factor % denominator:
                factor = math.lcm(factor, denominator)
    points = [[row[c] * (factor // row[c + 1]) for c in (0, 2, 4)] for row in rows]
    count = len(rows) // 2
    scaled = m * factor << e if e >= 0 else m * (factor >> -e)
    return Query.straight(points[:count], points[count:], split, metric, scaled)


def read_query(lines, kind, metric, separation):
    """The next query of a query file, or None at its end."""
    split, count = KINDS[kind]
    rows = []
    while lines.line is not None and len(rows) < 2 * count:
        fields = lines.columns()
        if len(fields) not in (6, 7) or not all(QUERY_NUMBER.fullmatch(field) for field in fields):
            raise BadInput(f"{lines.place()}: a row has six or seven integers of at most {MAX_QUERY_DIGITS} digits")
        row = [int(field) for field in fields]
        if min(row[1], row[3], row[5]) <= 0:
            raise BadInput(f"{lines.place()}: a denominator is not positive")
        rows.append(row)
        if fields[6:] not in ([], [b"0"], [b"1"]) or row[6:] != rows[0][6:]:
            raise BadInput(f"{lines.place()}: the truth is 0 or 1, the same in all rows of a query")
        lines.advance()
    if not rows:
        return None
    if len(rows) < 2 * count:
        raise BadInput(f"{lines.place()}: the last query has too few rows")
    return query_of_rows(rows, split, metric, separation)


def read_double(word, lines):
    """The double that is nearest to a number of a file of curved queries, as (m, e)."""
    match = CURVED_NUMBER.fullmatch(word) if len(word) <= MAX_QUERY_DIGITS + MAX_DIGITS + 6 else None
    if not match:
        raise BadInput(f"{lines.place()}: not a number, or too long: {ascii(word[:40].decode('latin-1'))}")
    sign, *groups = match.groups(default=b"")
    whole, fraction, exponent = groups[:3] if groups[0] or groups[1] else groups[3:]
    base, step, digit = (16, 2, 4) if groups[0] or groups[1] else (10, 10, 1)
    power = power_of(exponent)
    if len(whole + fraction) > MAX_QUERY_DIGITS or abs(power) > MAX_EXPONENT:
        raise BadInput(f"{lines.place()}: more than {MAX_QUERY_DIGITS} digits, or an exponent beyond {MAX_EXPONENT}")
    power -= digit * len(fraction)
    top, bottom = int(whole + fraction, base) * step ** max(power, 0), step ** max(-power, 0)
    # The greatest e of those for which top / (bottom 2^e) has 53 bits before the point, or -1074.
    e = max(top.bit_length() - bottom.bit_length() - 53, -1074)
    while True:
        number, unit = top << max(-e, 0), bottom << max(e, 0)
        m, rest = divmod(number, unit)
        if m.bit_length() <= 53:
            break
        e += 1
    m += 2 * rest > unit or (2 * rest == unit and m % 2)
    if (m == 0) != (top == 0) or m.bit_length() + e > 1024 and m:
        raise BadInput(f"{lines.place()}: beyond the doubles: {ascii(word[:40].decode('latin-1'))}")
    zeros = (m & -m).bit_length() - 1 if m else 0
    return ((-m if sign else m) >> zeros, e + zeros) if m else (0, 0)


def is_curved_file(lines):
    """Whether a query file has curved motion, which its first row says; that row is then the one before."""
    columns = lines.columns()
    if columns[:1] != [b"touchstone-curved"]:
        return False
    if columns != [b"touchstone-curved", b"1"]:
        raise BadInput(f"{lines.place()}: the version of a file of curved queries is 1")
    require_end(lines)
    lines.advance()
    return True


def require_end(lines):
    if lines.line is not None and not lines.has_end:
        raise BadInput(f"{lines.place()}: the last row has no end of line")


def read_curved_query(lines, kind, metric, separation):
    """The next query of a file of curved queries, or None at its end."""
    def require_row(holds, what):
        if not holds:
            raise BadInput(f"{lines.place()}: {what}")

    split, count = KINDS[kind]
    columns = lines.columns()
    if not columns:
        return None
    require_row(columns in ([b"query", b"0"], [b"query", b"1"]), "expected query,0 or query,1")
    motions, corners = {}, []
    while True:
        require_end(lines)
        lines.advance()
        word, *columns = lines.columns() or [None]
        if word in (None, b"query"):
            break
        if word in (b"motion", b"body"):
            require_row(columns and columns[0] in (b"0", b"1", b"2", b"3"), "the number of a motion is 0 to 3")
        if word == b"motion":
            number = columns.pop(0)
            require_row(len(columns) == 14 and number not in motions, "expected 14 numbers of a new motion")
            motions[number] = [read_double(column, lines) for column in columns]
            require_row(not vanishes(motions[number][:8]), "the quaternion is zero at some t")
            continue
        require_row(word in (b"body", b"curve") and len(corners) < count, "no row of a query, or a corner too many")
        motion = columns.pop(0) if word == b"body" else None
        require_row(motion is None or motion in motions, "the motion must come before its corners")
        sizes = (3,) if word == b"body" else (3, 6, 9, 12)
        require_row(len(columns) in sizes, "a corner has three coordinates for each of its points")
        corners.append((motion, [read_double(column, lines) for column in columns]))
    require_row(len(corners) == count, "the query has too few corners")
    require_row(set(motions) == {motion for motion, _ in corners} - {None}, "a motion has no corner")
    return curved_query(motions, corners, split, metric, separation)


def vanishes(q):
    """Whether (1 - t) q0 + t q1 = 0 at some t in [0, 1]."""
    integers, _ = to_integers(q)
    q0, q1 = integers[:4], integers[4:]
    product = sum(a * b for a, b in zip(q0, q1))
    return product <= 0 and product ** 2 == sum(a * a for a in q0) * sum(a * a for a in q1)


def curved_query(motions, corners, split, metric, separation):
    """The query of motions, lists of 14 numbers, and of corners, each with its motion or None and its numbers."""
    lengths = [x for motion in motions.values() for x in motion[8:]] + [x for _, points in corners for x in points]
    integers, _ = to_integers(lengths + [separation])
    distance = integers.pop()
    rest = iter(integers)
    turns, e = to_integers([x for motion in motions.values() for x in motion[:8]])
    square = 1 << -2 * e  # all X_i and W_i are multiplied by it
    poses = {number: Pose(turns[8 * k:8 * k + 8], [next(rest) for _ in range(6)]) for k, number in enumerate(motions)}
    polynomials, weights = [], []
    for motion, points in corners:
        points = [next(rest) for _ in points]
        if motion is None:
            polynomials.append([[square * x for x in power_basis(points[c::3])] for c in range(3)])
            weights.append([square])
        else:
            polynomials.append(poses[motion].corner(points))
            weights.append(poses[motion].weight)
    return Query(polynomials, weights, [motion for motion, _ in corners], split, metric, distance)


def power_basis(controls):
    """The polynomial whose Bernstein coefficients are these."""
    n = len(controls) - 1
    return [math.comb(n, k) * sum((-1) ** (k - i) * math.comb(k, i) * controls[i] for i in range(k + 1))
            for k in range(n + 1)]


class Pose:
    """A moving body, with q = (w, x, y, z) and p as polynomials."""

    def __init__(self, q, p):
        self.q = [[a, b - a] for a, b in zip(q[:4], q[4:])]
        self.p = [[a, b - a] for a, b in zip(p[:3], p[3:])]
        squares = [times(c, c) for c in self.q]
        self.weight = functools.reduce(plus, squares)
        w, x, y, z = self.q
        ww, xx, yy, zz = squares
        self.rotation = [
            [minus(plus(ww, xx), plus(yy, zz)), twice(minus(times(x, y), times(w, z))),
             twice(plus(times(x, z), times(w, y)))],
            [twice(plus(times(x, y), times(w, z))), minus(plus(ww, yy), plus(xx, zz)),
             twice(minus(times(y, z), times(w, x)))],
            [twice(minus(times(x, z), times(w, y))), twice(plus(times(y, z), times(w, x))),
             minus(plus(ww, zz), plus(xx, yy))]]

    def corner(self, point):
        return [functools.reduce(plus, [times(m, [y]) for m, y in zip(row, point)] + [times(self.weight, p)])
                for row, p in zip(self.rotation, self.p)]


def twice(p):
    return [2 * c for c in p]


def rounded_down(top, bottom):
    """The greatest m 2^e that is at most top / bottom, for integers |m| < 2^53 and e >= -1074, as (m, e)."""
    if top == 0:
        return 0, 0
    e = max(abs(top).bit_length() - bottom.bit_length() - 60, -1074)
    while True:
        m = (top << max(-e, 0)) // (bottom << max(e, 0))
        if abs(m) < 1 << 53:
            return m, e
        e += 1


def box_on_body(motion, point):
    """The least and the greatest coordinates of a point of a body in a step; None where a weight is not positive."""
    lengths, e = to_integers(motion[8:] + point)
    turns, _ = to_integers(motion[:8])
    pose = Pose(turns, lengths[:6])
    zero, one = (0, 0), (1, 0)
    weights = bernstein(pose.weight + [0], zero, one)
    if min(weights) <= 0:
        return None
    low, high = [], []
    for polynomial in pose.corner(lengths[6:]):
        controls = bernstein(polynomial, zero, one)
        bounds = [rounded_down(sign * c, w << -e) for sign in (1, -1) for c, w in zip(controls, weights)]
        integers, least = to_integers(bounds)
        low.append((min(integers[:4]), least))
        high.append((-min(integers[4:]), least))
    return low, high


def order(x, y):
    return less(y, x) - less(x, y)


def round_up(r, s):
    """The least m 2^e that is at least r + s, for integers |m| < 2^53 and e >= -1074."""
    integers, e = to_integers([r, s])
    m, e = rounded_down(-sum(integers), 1 << -e)
    return -m, e


def are_boxes_near(ends, first, second, distance):
    """Whether the boxes of two elements are at most the distance apart along each axis."""
    for c in range(3):
        one, other = ([end[vertex][c] for end in ends for vertex in vertices] for vertices in (first, second))
        integers, _ = to_integers(one + other + [distance])
        reach = integers.pop()
        one, other = integers[:len(one)], integers[len(one):]
        if min(one) - max(other) > reach or min(other) - max(one) > reach:
            return False
    return True


Box = collections.namedtuple("Box", "low high element")


class Motion:
    """A motion file. Its frames are read one after another, so that two of them are in memory."""

    SIZES = {b"point": 1, b"edge": 2, b"face": 3, b"fixed": 1, b"body": 1}
    KINDS = {b"edge-edge": 0, b"vertex-face": 1, b"point-edge": 2, b"point-point": 3}
    FOLD = 4  # the place of folds among the kinds of pairs
    PARTNERS = {b"point": (b"point", b"edge", b"face"), b"edge": (b"edge", b"point"), b"face": (b"point",)}

    def __init__(self, lines):
        self.lines = lines
        if lines.words() != [b"touchstone-motion", b"1"]:
            raise BadInput(f"{lines.place()}: the first line is not \"touchstone-motion 1\"")
        lines.advance()
        words = lines.words()
        if words[:1] != [b"vertices"] or len(words) != 2:
            raise BadInput(f"{lines.place()}: expected \"vertices N\"")
        self.count = self.read_integer(words[1])
        if self.count > MAX_VERTICES:
            raise BadInput(f"{lines.place()}: a motion has at most {MAX_VERTICES} vertices")
        lines.advance()
        self.elements = {sort: [] for sort in self.SIZES}
        self.radii = {sort: [] for sort in self.SIZES}  # of the elements
        self.words_of_radii = {}
        self.near = set()  # pairs of vertices
        self.has_radii = False
        self.groups = {}  # by vertex
        self.touching = set()  # pairs of elements: the place of their kind, and their numbers
        self.ignored = set()  # pairs of groups; of one that is ignored with itself, the one
        self.read_elements()
        self.fixed = {vertex for vertex, in self.elements.pop(b"fixed")}
        self.bodies = {}  # the body of a vertex, and its point there
        for (vertex,), words in zip(self.elements.pop(b"body"), self.on_bodies):
            self.bodies[vertex] = words
        self.body_count = max([body + 1 for body, _ in self.bodies.values()], default=0)
        edge_vertices = {vertex for edge in self.elements[b"edge"] for vertex in edge}
        sides = {frozenset(side) for face in self.elements[b"face"] for side in itertools.combinations(face, 2)}
        self.wires = {frozenset(edge) for edge in self.elements[b"edge"]} - sides
        self.lone = [vertex not in edge_vertices for vertex, in self.elements[b"point"]]

    def is_wire(self, ends):
        """Whether some edge has these two vertices, and no face."""
        return frozenset(ends) in self.wires

    def read_integer(self, word):
        if len(word) > MAX_DIGITS or not INTEGER.fullmatch(word):
            raise BadInput(f"{self.lines.place()}: not an integer without a sign and leading zeros, or too long")
        return int(word)

    def read_elements(self):
        seen = set()
        self.on_bodies = []
        radius, word = (0, 0), b"0"
        while True:
            sort, *words = self.lines.words() or [b""]
            if sort == b"radius":
                if len(words) != 1:
                    raise BadInput(f"{self.lines.place()}: expected radius R")
                word = words[0]
                radius = read_number(word, self.lines)
                if radius[0] < 0:
                    raise BadInput(f"{self.lines.place()}: a radius is negative")
                self.has_radii = True
                self.lines.advance()
                continue
            if sort == b"near":
                pair = frozenset(self.read_integer(word) for word in words)
                if len(words) != 2 or len(pair) != 2 or max(pair) >= self.count or pair in self.near:
                    raise BadInput(f"{self.lines.place()}: expected near V W, two vertices that are not near yet")
                self.near.add(pair)
                self.lines.advance()
                continue
            if sort == b"touching":
                kind = self.KINDS.get(b" ".join(words[:1]))
                numbers = [self.read_integer(word) for word in words[1:]]
                if kind is None or len(numbers) != 2 or max(numbers) > MAX_VERTICES:
                    raise BadInput(f"{self.lines.place()}: expected touching KIND I J")
                if (kind, *numbers) in self.touching or (kind in (0, 3) and numbers[0] >= numbers[1]):
                    raise BadInput(f"{self.lines.place()}: there is such a line already, or they are not in their order")
                self.touching.add((kind, *numbers))
                self.lines.advance()
                continue
            if sort in (b"group", b"ignore"):
                numbers = [self.read_integer(word) for word in words]
                if len(numbers) != 2 or max(numbers) > MAX_VERTICES:
                    raise BadInput(f"{self.lines.place()}: expected group V G or ignore G H")
                if sort == b"ignore":
                    known = frozenset(numbers) in self.ignored
                    self.ignored.add(frozenset(numbers))
                else:
                    known = numbers[0] >= self.count or numbers[0] in self.groups
                    self.groups[numbers[0]] = numbers[1]
                if known:
                    raise BadInput(f"{self.lines.place()}: there is such a line already, or no such vertex")
                self.lines.advance()
                continue
            if sort not in self.SIZES:
                return
            if sort == b"body":
                if len(words) != 5:
                    raise BadInput(f"{self.lines.place()}: expected body V B X Y Z")
                body = self.read_integer(words[1])
                if body >= MAX_VERTICES:
                    raise BadInput(f"{self.lines.place()}: the number of a body is below {MAX_VERTICES}")
                self.on_bodies.append((body, [read_number(word, self.lines) for word in words[2:]]))
                del words[1:]
            vertices = tuple(self.read_integer(word) for word in words)
            if len(vertices) != self.SIZES[sort] or len(set(vertices)) != len(vertices):
                raise BadInput(f"{self.lines.place()}: {sort.decode()} needs {self.SIZES[sort]} different vertices")
            if max(vertices) >= self.count:
                raise BadInput(f"{self.lines.place()}: there is no such vertex")
            if len(vertices) == 1:
                if (sort, vertices) in seen:
                    raise BadInput(f"{self.lines.place()}: this vertex has such a line already")
                seen.add((sort, vertices))
            self.elements[sort].append(vertices)
            self.radii[sort].append(radius)
            self.words_of_radii[radius] = self.words_of_radii.get(radius, word)
            self.lines.advance()

    def read_frame(self):
        """The poses of all bodies and the rows of all vertices as numbers, or None at the end of the file.

        The row of a vertex on a body is its point there.
        """
        if self.lines.line is None:
            return None
        if self.lines.words() != [b"frame"]:
            raise BadInput(f"{self.lines.place()}: expected an element, \"frame\" or the end of the file")
        self.lines.advance()
        poses, rows = [], []
        while len(poses) < self.body_count:
            poses.append(self.read_row(7, f"body {len(poses)}"))
        while len(rows) < self.count:
            on_body = self.bodies.get(len(rows))
            rows.append(on_body[1] if on_body else self.read_row(3, f"vertex {len(rows)}"))
        return poses, rows

    def read_row(self, size, name):
        words = self.lines.words()
        if len(words) != size:
            raise BadInput(f"{self.lines.place()}: expected the {size} numbers of {name}")
        row = [read_number(word, self.lines) for word in words]
        self.lines.advance()
        return row

    def steps(self):
        """Both frames of each step."""
        start, end = self.read_frame(), self.read_frame()
        if end is None:
            raise BadInput(f"{self.lines.place()}: a motion has at least two frames")
        while end is not None:
            for vertex in self.fixed:
                body, _ = self.bodies.get(vertex, (None, None))
                if start[1][vertex] != end[1][vertex] or (body is not None and start[0][body] != end[0][body]):
                    raise BadInput(f"{self.lines.place()}: vertex {vertex} is fixed, but moves")
            yield start, end
            start, end = end, self.read_frame()

    def queries(self, frames, metric, separation):
        """The queries of the pairs of a step, in the order of the page."""
        for about, _, first, second in self.near_pairs(frames, metric, separation):
            corners, motions = [], {}
            for vertex in first[1] + second[1]:
                if vertex in self.bodies:
                    body, point = self.bodies[vertex]
                    motions[body] = self.motion(frames, body)
                    corners.append((body, point))
                else:
                    corners.append((None, frames[0][1][vertex] + frames[1][1][vertex]))
            yield curved_query(motions, corners, len(first[1]), *about)

    def near_pairs(self, frames, metric, separation):
        """The metric and the separation, the kind and the elements of each pair of a step, in the order of the page."""
        if self.has_radii:
            radii = itertools.chain([(0, 0)], *self.radii.values())
            separation = round_up(*2 * [max(radii, key=functools.cmp_to_key(order))])
        ends = self.ends(frames)
        for kind, first, second in sorted(self.pairs(*self.boxes(ends, separation))):
            about = (None, (0, 0)) if self.only_touches(kind, first, second) else (metric, separation)
            if self.has_radii:
                about = self.separation(kind, first, second)
                if not are_boxes_near(ends, first[1], second[1], about[1]):
                    continue
            yield about, kind, first, second

    def only_touches(self, kind, first, second):
        return kind == self.FOLD or (kind, first[0], second[0]) in self.touching

    def separation(self, kind, first, second):
        """The metric and the separation of a pair of a motion with radii."""
        if self.only_touches(kind, first, second) or any(frozenset(pair) in self.near for pair in itertools.product(first[1], second[1])):
            return None, (0, 0)
        sorts = [(b"edge", b"edge"), (b"point", b"face"), (b"point", b"edge"), (b"point", b"point")][kind]
        distance = round_up(*(self.radii[sort][number] for sort, (number, _) in zip(sorts, (first, second))))
        return (b"euclidean" if distance[0] > 0 else None), distance

    def boxes(self, ends, separation):
        """The boxes of all vertices, two lists of points, and the separation, as integers of one scale."""
        integers, _ = to_integers([x for rows in ends for row in rows for x in row] + [separation])
        reach = integers.pop()
        points = [integers[i:i + 3] for i in range(0, len(integers), 3)]
        return points[:self.count], points[self.count:], reach

    def ends(self, frames):
        """The boxes of all vertices, two lists of points."""
        ends = [[list(row) for row in frame[1]] for frame in frames]
        for vertex, (body, point) in self.bodies.items():
            box = box_on_body(self.motion(frames, body), point)
            if box is None:
                raise BadInput(f"{self.lines.place()}: body {body} turns too far in the step before this line")
            ends[0][vertex], ends[1][vertex] = box
        return ends

    @staticmethod
    def motion(frames, body):
        """The quaternions and then the positions at both ends."""
        (start, _), (end, _) = frames
        return start[body][:4] + end[body][:4] + start[body][4:] + end[body][4:]

    def has_pair(self):
        """Whether the rules leave a pair, near or not."""
        every = [(sort, *element) for sort, elements in self.elements.items() for element in enumerate(elements)]
        return any(self.pair(*two) for two in itertools.combinations(every, 2) if two[1][0] in self.PARTNERS[two[0][0]])

    def contents(self, frames):
        counts = [counted(frames, "frame", "frames"), counted(self.count, "vertex", "vertices")]
        for sort in (b"point", b"edge", b"face"):
            counts.append(counted(len(self.elements[sort]), sort.decode(), sort.decode() + "s"))
        if self.has_radii:
            radii = [radius for sort in self.PARTNERS for radius in self.radii[sort] if radius[0] > 0]
            counts.append(counted(len(radii), "element", "elements") + " with radii")
            if radii:
                key = functools.cmp_to_key(order)
                ends = [self.words_of_radii[end].decode() for end in (min(radii, key=key), max(radii, key=key))]
                counts[-1] += " from " + " to ".join(ends)
            if self.near:
                counts.append(counted(len(self.near), "pair of neighbours", "pairs of neighbours"))
        if self.fixed:
            counts.append(counted(len(self.fixed), "fixed vertex", "fixed vertices"))
        if self.bodies:
            members = {}
            for vertex, (body, _) in self.bodies.items():
                members.setdefault(body, []).append(vertex)
            on_bodies = counted(len(self.bodies), "vertex", "vertices")
            counts.append(f"{on_bodies} on {counted(len(members), 'body', 'bodies')}")
            counts.append("where " + self.text_of_runs(members, sorted(members)))
        if self.touching:
            counts.append(counted(len(self.touching), "pair", "pairs") + " asked about touching alone")
            apart = self.touching_apart()
            if apart:
                counts.append(f"{apart} of them joined by no edges")
        if self.ignored:
            counts += self.ignored_groups()
        corners = {vertex for sort in (b"edge", b"face") for element in self.elements[sort] for vertex in element}
        corners -= {vertex for vertex, in self.elements[b"point"]}
        sides = {frozenset(side) for face in self.elements[b"face"] for side in itertools.combinations(face, 2)}
        sides -= {frozenset(edge) for edge in self.elements[b"edge"]}
        if corners:
            counts.append(counted(len(corners), "corner is no point", "corners are no points"))
        if sides:
            counts.append(counted(len(sides), "side is no edge", "sides are no edges"))
        every = itertools.chain(*(self.elements[sort] for sort in (b"point", b"edge", b"face")))
        unused = self.count - len(set(itertools.chain(*every)))
        if unused:
            counts.append(counted(unused, "vertex is in no element", "vertices are in no element"))
        return ", ".join(counts)

    def touching_apart(self):
        """How many pairs of the lines `touching` are not in one connected part of the edges."""
        part = {}  # the vertices that edges join to a vertex
        for v, w in self.elements[b"edge"]:
            less, more = sorted((part.get(v, [v]), part.get(w, [w])), key=len)
            if less is not more:
                more += less
                part.update((vertex, more) for vertex in more)
        sorts = [(b"edge", b"edge"), (b"point", b"face"), (b"point", b"edge"), (b"point", b"point")]
        apart = 0
        for kind, *numbers in self.touching:
            two = [self.elements[sort][number:number + 1] for sort, number in zip(sorts[kind], numbers)]
            parts = [min(part.get(element[0][0], element[0][:1])) if element else None for element in two]
            apart += parts[0] != parts[1]
        return apart

    def ignored_groups(self):
        members = {}
        for vertex, group in sorted(self.groups.items()):
            members.setdefault(group, []).append(vertex)
        pairs = sorted((min(pair), max(pair)) for pair in self.ignored)
        shown = "".join(f" {g}-{h}" for g, h in pairs)
        yield f"{counted(len(members), 'group', 'groups')} of vertices"
        yield f"{counted(len(pairs), 'pair', 'pairs')} of groups not asked about:{shown}"
        yield "where " + self.text_of_runs(members, sorted(set(itertools.chain(*pairs))))

    @staticmethod
    def text_of_runs(members, named):
        """The vertices of groups or bodies: "0 has vertices 0 to 7 and vertex 9"."""
        texts = []
        for number in named:
            vertices = set(members.get(number, []))
            starts = sorted(v for v in vertices if v - 1 not in vertices)
            ends = sorted(v for v in vertices if v + 1 not in vertices)
            runs = [f"vertex {v}" if v == w else f"vertices {v} to {w}" for v, w in zip(starts, ends)]
            texts.append(f"{number} has {' and '.join(runs) or 'no vertex'}")
        return ", ".join(texts)

    def pairs(self, start, end, reach):
        """A sweep along the x axis: at each box, the boxes before it whose end is not yet left behind."""
        boxes = []
        for sort, elements in self.elements.items():
            for number, vertices in enumerate(elements):
                axes = list(zip(*(frame[v] for frame in (start, end) for v in vertices)))
                boxes.append(Box([min(axis) for axis in axes], [max(axis) for axis in axes], (sort, number, vertices)))
        boxes.sort(key=lambda box: box.low[0])
        before = {sort: [] for sort in self.elements}
        for box in boxes:
            sort = box.element[0]
            for other_sort in self.PARTNERS[sort]:
                near = before[other_sort] = [b for b in before[other_sort] if b.high[0] + reach >= box.low[0]]
                for other in near:
                    if all(box.low[c] - other.high[c] <= reach >= other.low[c] - box.high[c] for c in (1, 2)):
                        pair = self.pair(box.element, other.element)
                        if pair:
                            yield pair
            before[sort].append(box)

    def pair(self, first, second):
        """The order of its kind, and number and vertices of both elements; None if the two are no pair."""
        order = {b"point": 0, b"edge": 1, b"face": 2}
        first, second = sorted((first, second), key=lambda element: (order[element[0]], element[1]))
        vertices = first[2] + second[2]
        if set(first[2]) & set(second[2]) or self.fixed.issuperset(vertices):
            return None
        groups = ([self.groups.get(vertex) for vertex in element[2]] for element in (first, second))
        if self.ignored.issuperset(frozenset(pair) for pair in itertools.product(*groups)):
            return None
        bodies = {self.bodies[vertex][0] if vertex in self.bodies else None for vertex in vertices}
        if len(bodies) == 1 and None not in bodies:
            return None
        sorts = first[0], second[0]
        kind = [(b"edge", b"edge"), (b"point", b"face"), (b"point", b"edge"), (b"point", b"point")].index(sorts)
        if kind >= 2 and not all(self.lone[number] for sort, number, _ in (first, second) if sort == b"point"):
            (point,), ends = first[2], second[2]
            if kind != 2 or not self.is_wire(ends) or not any(self.is_wire((point, end)) for end in ends):
                return None
            kind = self.FOLD
        return kind, first[1:], second[1:]


def require(holds, reason):
    if not holds:
        raise Rejected(reason)


def read_numbers(words, lines, polynomials=1):
    """The coefficients of a polynomial, or of several ones of the same degree in one list."""
    require(words and len(words) % polynomials == 0, "the number of coefficients is wrong")
    if len(words) > polynomials * (MAX_DEGREE + 1):
        raise BadInput(f"{lines.place()}: a polynomial has a degree above {MAX_DEGREE}")
    return [read_number(word, lines) for word in words]


def read_piece(query, lines):
    """The direction of a piece, as three polynomials, whether it is n, and the number after `to` or None."""
    words = lines.words()
    end = None
    if words[-2:-1] == [b"to"]:
        end = read_time(words[-1], lines)
        words = words[:-2]
    if words[:1] == [b"d"]:
        coefficients, _ = to_integers(read_numbers(words[1:], lines, 3))
        return [coefficients[c::3] for c in range(3)], False, end
    require(words == [b"n"] and query.size == 4, "expected a piece; only queries with 4 corners have n")
    return query.normal(), True, end


def dot(p, q):
    x, y, z = (times(a, b) for a, b in zip(p, q))
    return plus(plus(x, y), z)


def separates(query, direction, is_normal, low, high, may_touch_at_end):
    """Whether the direction separates the elements from low to high, by the signs of Bernstein coefficients."""
    # For n all pairs of corners have the same sign, and one is looked at.
    pairs = list(query.pairs())[:1] if is_normal else list(query.pairs())
    products = [dot(direction, query.difference(j, i)) for i, j in pairs]
    bounds = [times([query.separation], query.factor(i, j)) for i, j in pairs]
    signs = {1, -1}
    if query.metric == b"euclidean":
        at_low = [bernstein(p, low, low)[0] for p in products]
        if not (min(at_low) > 0 or max(at_low) < 0):
            return False
        signs = {1}
        square = dot(direction, direction)
        products = [minus(times(p, p), times(times(bound, bound), square)) for p, bound in zip(products, bounds)]
    elif query.metric == b"max":
        sums = [dot(direction, [[s] for s in triple]) for triple in SIGNS]
        products = [minus(p, times(bound, total)) for p, bound in zip(products, bounds) for total in sums]
    for p in products:
        b = bernstein(p, low, high)
        strict, rest = (b[:1], b[1:]) if may_touch_at_end else (b, [])
        signs = {s for s in signs if all(s * c > 0 for c in strict) and all(s * c >= 0 for c in rest)}
        if not signs:
            return False
    return True


def check_pieces(query, lines, end, touches_at_end):
    low = (0, 0)
    while low is not None:
        direction, is_normal, stop = read_piece(query, lines)
        last = stop is None
        require(last or (less(low, stop) and less(stop, end)), "the piece does not end in the rest of the interval")
        if not separates(query, direction, is_normal, low, end if last else stop, last and touches_at_end):
            raise Rejected("the direction does not separate the elements during the piece")
        low = stop
        lines.advance()


def check_meeting(query, lines, early, late):
    low, high = early, late
    (time, one), _ = to_integers([early, (1, 0)])
    g = [-time, one]
    if early != late:
        words = lines.words()
        if words[-3:-2] == [b"between"]:
            low, high = (read_time(word, lines) for word in words[-2:])
            words = words[:-3]
        require(words[:1] == [b"root"], "expected a root")
        inside = not less(low, early) and less(low, high) and not less(late, high)
        require(inside, "the interval of the root is not within the times")
        g, _ = to_integers(read_numbers(words[1:], lines))
        require(len(g) > 1 and g[-1] != 0, "the degree of g is 0, or its leading coefficient is 0")
        at_low, at_high = bernstein(g, low, low)[0], bernstein(g, high, high)[0]
        require(at_low < 0 < at_high or at_high < 0 < at_low, "g has no opposite signs at the ends of its interval")
        lines.advance()

    sums = [[0], [0]]
    points = [[[0], [0], [0]], [[0], [0], [0]]]
    for corner, weight in read_weights(query, lines).items():
        holds = is_positive(weight, low, high) or is_multiple(weight, g)
        require(holds, f"the weight of corner {corner} may be negative")
        element = 0 if corner < query.split else 1
        sums[element] = plus(sums[element], times(weight, query.weights[corner]))
        points[element] = [plus(p, times(weight, x)) for p, x in zip(points[element], query.corners[corner])]
    require(all(is_positive(total, low, high) for total in sums), "the weights of an element may all be zero")
    difference = [minus(times(sums[1], p), times(sums[0], q)) for p, q in zip(*points)]
    if query.metric is None:
        require(all(is_multiple(c, g) for c in difference), "the weighted points are not proved to be equal")
        return
    bound = times([query.separation], times(*sums))
    if query.metric == b"euclidean":
        room = [minus(times(bound, bound), dot(difference, difference))]
    else:
        room = [sign(bound, c) for c in difference for sign in (plus, minus)]
    near = all(is_multiple(p, g) or min(bernstein(p, low, high)) >= 0 for p in room)
    require(near, "the distance of the weighted points is not proved to be at most the separation")


def read_weights(query, lines):
    """The weights by corner, all times one positive number."""
    numbers = {}
    while lines.words()[:1] == [b"w"]:
        words = lines.words()
        require(words[1:2] and words[1] in [b"0", b"1", b"2", b"3"][: query.size], "there is no such corner")
        corner = int(words[1])
        require(corner not in numbers, f"corner {corner} has two weights")
        numbers[corner] = read_numbers(words[2:], lines)
        lines.advance()
    integers = iter(to_integers([number for polynomial in numbers.values() for number in polynomial])[0])
    return {corner: [next(integers) for _ in polynomial] for corner, polynomial in numbers.items()}


def check_query(query, number, lines):
    """Checks the proof of one query. Returns whether it has a contact."""
    words = lines.words()
    require(words[:1] == [str(number).encode()], "expected the proof of this query")
    if words[1:] == [b"none"]:
        lines.advance()
        check_pieces(query, lines, (1, 0), False)
        return False
    require(len(words) == 4 and words[1] == b"contact", "the answer is neither none nor contact T U")
    early, late = (read_time(word, lines) for word in words[2:])
    doubles = is_double(early) and is_double(late) and not less((1, 0), late)
    require(doubles and late in (early, next_double(early)), "the times are not one double or two neighbours in [0, 1]")
    lines.advance()
    if late != (0, 0):
        check_pieces(query, lines, early, early == late)
    check_meeting(query, lines, early, late)
    return True


def read_header(lines, name):
    """The metric or None, the separation as a word and as a number, the kind of the queries and the digest of the next
    file."""
    metric, word, separation = None, b"0", (0, 0)
    words = lines.words()
    if words[:1] == [b"separation"]:
        require(len(words) == 3 and words[1] in (b"euclidean", b"max"),
                f"{lines.place()}: expected separation METRIC D; METRIC is euclidean or max")
        _, metric, word = words
        separation = read_number(word, lines)
        require(separation[0] > 0, f"{lines.place()}: the separation is not above zero")
        lines.advance()
        words = lines.words()
    kinds = list(KINDS) + [b"mesh"]
    holds = words[:1] == [b"file"] and len(words) > 3 and words[1] in kinds and DIGEST.fullmatch(words[2])
    require(holds, f"{lines.place()}: expected the proofs of {name}: file KIND DIGEST NAME")
    lines.advance()
    return metric, word, separation, words[1], words[2]


def check_queries(queries, lines, name):
    """Checks the proofs of all queries. Returns the numbers of queries and of contacts."""
    number, contacts = -1, 0
    for number, query in enumerate(queries):
        try:
            contacts += check_query(query, number, lines)
        except Rejected as reason:
            raise Rejected(f"{name}: query {number}: {lines.place()}: {reason}") from None
    return number + 1, contacts


def check(proofs, proofs_name, files, report=lambda header: None, allow_empty=False):
    """Checks the proofs of a binary stream. `files` yields pairs of stream and name.

    Returns the numbers of queries, of contacts and of motions. Raises Rejected or BadInput.
    """
    lines = Lines(proofs, proofs_name)
    if lines.words() != [b"touchstone-proofs", b"1"]:
        raise BadInput(f"{lines.place()}: the first line is not \"touchstone-proofs 1\"")
    lines.advance()
    queries = contacts = motions = 0
    for stream, name in files:
        metric, separation_word, separation, kind, digest = read_header(lines, name)
        rows = Lines(stream, name)
        counts = []
        with_separation = f" with separation {metric.decode()} {separation_word.decode()}" if metric else ""
        if kind == b"mesh":
            motions += 1
            motion = Motion(rows)
            if motion.has_radii:
                require(metric is None, f"{lines.place()}: a motion with radii has the separations of its own")
                with_separation = " with separation euclidean, the sum of two radii"
            for step, frames in enumerate(motion.steps()):
                require(lines.words() == [b"step", str(step).encode()],
                        f"{lines.place()}: expected \"step {step}\" of {name}")
                lines.advance()
                pairs = motion.queries(frames, metric, separation)
                counts.append(check_queries(pairs, lines, f"{name}: step {step}"))
            contents = motion.contents(len(counts) + 1)
            about = f" in {counted(len(counts), 'step', 'steps')}{with_separation}: {contents}"
            if not any(count for count, _ in counts):
                if not motion.has_pair():
                    raise BadInput(f"{name}: no two elements could meet: {contents}")
                about += f"; {NONE_NEAR}"
        else:
            curved = is_curved_file(rows)
            about = (" with curved motion" if curved else "") + with_separation
            read = read_curved_query if curved else read_query
            rest = iter(functools.partial(read, rows, kind, metric, separation), None)
            counts.append(check_queries(rest, lines, name))
            if counts == [(0, 0)]:
                raise BadInput(f"{name}: there is no query")
        require(digest in (b"-", rows.digest()), f"{name}: the proofs name another digest, {digest.decode()}")
        count = sum(count for count, _ in counts)
        about += "; the proofs name no digest of the file" if digest == b"-" else ""
        report(f"{name}: {counted(count, f'{kind.decode()} query', f'{kind.decode()} queries')}{about}")
        queries += sum(count for count, _ in counts)
        contacts += sum(count for _, count in counts)
    holds = lines.words() == [b"end", str(queries).encode(), str(contacts).encode()]
    require(holds, f"{lines.place()}: expected \"end {queries} {contacts}\"")
    lines.advance()
    require(lines.line is None, f"{lines.place()}: something follows the end")
    require(queries > 0 or allow_empty, f"no query was checked: {NONE_NEAR}; --allow-empty accepts this")
    return queries, contacts, motions


def opened(names):
    for name in names:
        with open(name, "rb") as stream:
            yield stream, name


def counted(number, one, several):
    return f"{number} {one if number == 1 else several}"


def verdict(queries, contacts, motions):
    answers = f"{counted(contacts, 'contact', 'contacts')}, {queries - contacts} without contact"
    starts = STARTS if motions else ""
    return f"{counted(queries, 'query', 'queries')} checked: {answers if queries else NONE_NEAR}{starts}"


def main(arguments):
    allow_empty = arguments[:1] == ["--allow-empty"]
    arguments = arguments[allow_empty:]
    if len(arguments) < 2:
        print("usage: check_proofs.py [--allow-empty] PROOFS FILE...", file=sys.stderr)
        return 2
    reports = []
    try:
        with open(arguments[0], "rb") as proofs:
            counts = check(proofs, arguments[0], opened(arguments[1:]), reports.append, allow_empty)
    except Rejected as reason:
        print(f"rejected: {reason}", file=sys.stderr)
        return 1
    except (BadInput, OSError) as reason:
        print(f"check_proofs.py: {reason}", file=sys.stderr)
        return 2
    print("\n".join(reports + [verdict(*counts)]))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
