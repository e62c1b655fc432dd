#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the proofs of `touchstone prove`. It is written from docs/proofs.md alone and uses no code of the library.

    check_proofs.py PROOFS QUERY_FILE...

The exit status is 0 when every proof holds, 1 when some proof does not hold, and 2 for a file that cannot be read.

All arithmetic is on integers. A polynomial is the list of its coefficients, the constant one first. The checks ask for
signs and divisibility only. So the coordinates of a query are multiplied by their common denominator, and the numbers
of a proof by a power of two.
"""

import functools
import itertools
import math
import re
import sys

MAX_LINE_BYTES = 1 << 20
MAX_DIGITS = 20000
MAX_EXPONENT = 100000
MAX_DEGREE = 16
MAX_QUERY_DIGITS = 4096

# For each kind the number of corners of the first element, and of both.
KINDS = {b"edge-edge": (2, 4), b"vertex-face": (1, 4), b"point-edge": (1, 3), b"point-point": (1, 2)}

NUMBER = re.compile(rb"(-?)(?:([0-9]+)|0x(?=\.?[0-9A-Fa-f])([0-9A-Fa-f]*)(?:\.([0-9A-Fa-f]*))?p([+-]?[0-9]+))")
DIGEST = re.compile(rb"-|[0-9a-f]{64}")
QUERY_NUMBER = re.compile(rb"-?[0-9]{1,%d}" % MAX_QUERY_DIGITS)

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
        self.line = b""
        self.advance()

    def advance(self):
        for line in iter(lambda: self.stream.readline(MAX_LINE_BYTES + 3), b""):
            self.number += 1
            line = re.sub(rb"\r?\n?\Z", b"", line, count=1)
            if len(line) > MAX_LINE_BYTES:
                raise BadInput(f"{self.place()}: the line has more than {MAX_LINE_BYTES} bytes")
            text = line.lstrip(b" \t")
            if text and not text.startswith(b"#"):
                self.line = line
                return
        self.line = None

    def words(self):
        """The words of the current line; no words at the end of the file."""
        return [] if self.line is None else [word for word in self.line.split(b" ") if word]

    def place(self):
        return f"{self.name}:{self.number}"


def read_number(word, lines):
    """A number of a proof: a pair (m, e) with the value m 2^e. m is odd, or m = e = 0."""
    match = NUMBER.fullmatch(word) if len(word) <= MAX_DIGITS + 20 else None
    if not match:
        raise BadInput(f"{lines.place()}: not a number, or too long: {ascii(word[:40].decode('latin-1'))}")
    sign, decimal, whole, fraction, exponent = match.groups(default=b"")
    digits, power = decimal or whole + fraction, int(exponent or 0)
    if len(digits) > MAX_DIGITS or abs(power) > MAX_EXPONENT:
        raise BadInput(f"{lines.place()}: more than {MAX_DIGITS} digits, or an exponent beyond {MAX_EXPONENT}")
    value = int(digits, 10 if decimal else 16)
    if value == 0:
        return 0, 0
    zeros = (value & -value).bit_length() - 1
    return (-value if sign else value) >> zeros, power - 4 * len(fraction) + zeros


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
    """A query: corner i is at starts[i] + t steps[i], all times one positive integer."""

    def __init__(self, rows, split):
        self.split = split  # the number of corners of the first element
        self.size = count = len(rows) // 2
        factor = 1
        for row in rows:
            for denominator in (row[1], row[3], row[5]):
                if factor % denominator:
                    factor = math.lcm(factor, denominator)
        points = [[row[c] * (factor // row[c + 1]) for c in (0, 2, 4)] for row in rows]
        self.starts = points[:count]
        self.steps = [[e - s for s, e in zip(start, end)] for start, end in zip(points, points[count:])]

    def corner(self, i):
        """The three coordinates of a corner, as polynomials."""
        return [[s, d] for s, d in zip(self.starts[i], self.steps[i])]

    def normal(self):
        """u x w, for the kinds with 4 corners."""
        x = [self.corner(i) for i in range(4)]
        u_from, w_from, u_to, w_to = (0, 2, 1, 3) if self.split == 2 else (1, 1, 2, 3)
        u = [minus(p, q) for p, q in zip(x[u_to], x[u_from])]
        w = [minus(p, q) for p, q in zip(x[w_to], x[w_from])]
        return [minus(times(u[b], w[c]), times(u[c], w[b])) for b, c in ((1, 2), (2, 0), (0, 1))]


def read_query(lines, kind):
    """The next query of a query file, or None at its end."""
    split, count = KINDS[kind]
    rows = []
    while lines.line is not None and len(rows) < 2 * count:
        fields = [field.strip(b" ") for field in lines.line.split(b",")]
        if len(fields) != 7 or not all(QUERY_NUMBER.fullmatch(field) for field in fields):
            raise BadInput(f"{lines.place()}: a row has seven integers of at most {MAX_QUERY_DIGITS} digits")
        row = [int(field) for field in fields]
        if min(row[1], row[3], row[5]) <= 0:
            raise BadInput(f"{lines.place()}: a denominator is not positive")
        rows.append(row)
        if row[6] not in (0, 1) or row[6] != rows[0][6]:
            raise BadInput(f"{lines.place()}: the truth is 0 or 1, the same in all rows of a query")
        lines.advance()
    if not rows:
        return None
    if len(rows) < 2 * count:
        raise BadInput(f"{lines.place()}: the last query has too few rows")
    return Query(rows, split)


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
    """The direction of a piece, as three polynomials, and the number after `to` or None."""
    words = lines.words()
    end = None
    if words[-2:-1] == [b"to"]:
        end = read_number(words[-1], lines)
        words = words[:-2]
    if words[:1] == [b"d"]:
        coefficients, _ = to_integers(read_numbers(words[1:], lines, 3))
        return [coefficients[c::3] for c in range(3)], end
    require(words == [b"n"] and query.size == 4, "expected a piece; only queries with 4 corners have n")
    return query.normal(), end


def separates(query, direction, low, high, may_touch_at_end):
    """Whether the Bernstein coefficients of all p_ij have one sign."""
    heights = []
    for i in range(query.size):
        x, y, z = (times(n, p) for n, p in zip(direction, query.corner(i)))
        heights.append(plus(plus(x, y), z))
    signs = {1, -1}
    for i in range(query.split):
        for j in range(query.split, query.size):
            b = bernstein(minus(heights[j], heights[i]), low, high)
            strict, rest = (b[:1], b[1:]) if may_touch_at_end else (b, [])
            signs = {s for s in signs if all(s * c > 0 for c in strict) and all(s * c >= 0 for c in rest)}
            if not signs:
                return False
    return True


def check_pieces(query, lines, end, touches_at_end):
    low = (0, 0)
    while low is not None:
        direction, stop = read_piece(query, lines)
        last = stop is None
        require(last or (less(low, stop) and less(stop, end)), "the piece does not end in the rest of the interval")
        if not separates(query, direction, low, end if last else stop, last and touches_at_end):
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
            low, high = (read_number(word, lines) for word in words[-2:])
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
        sums[element] = plus(sums[element], weight)
        points[element] = [plus(p, times(weight, x)) for p, x in zip(points[element], query.corner(corner))]
    require(all(is_positive(total, low, high) for total in sums), "the weights of an element may all be zero")
    equal = all(is_multiple(minus(times(sums[1], p), times(sums[0], q)), g) for p, q in zip(*points))
    require(equal, "the weighted points are not proved to be equal")


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
    early, late = (read_number(word, lines) for word in words[2:])
    doubles = is_double(early) and is_double(late) and not less((1, 0), late)
    require(doubles and late in (early, next_double(early)), "the times are not one double or two neighbours in [0, 1]")
    lines.advance()
    if late != (0, 0):
        check_pieces(query, lines, early, early == late)
    check_meeting(query, lines, early, late)
    return True


def check(proofs, proofs_name, query_files):
    """Checks the proofs of a binary stream. query_files yields pairs of stream and name.

    Returns the numbers of queries and of contacts. Raises Rejected or BadInput.
    """
    lines = Lines(proofs, proofs_name)
    if lines.words() != [b"touchstone-proofs", b"1"]:
        raise BadInput(f"{lines.place()}: the first line is not \"touchstone-proofs 1\"")
    lines.advance()
    queries = contacts = 0
    for stream, name in query_files:
        words = lines.words()
        holds = words[:1] == [b"file"] and len(words) > 3 and words[1] in KINDS and DIGEST.fullmatch(words[2])
        require(holds, f"{lines.place()}: expected the proofs of {name}: file KIND DIGEST NAME")
        lines.advance()
        rows = Lines(stream, name)
        for number in itertools.count():
            query = read_query(rows, words[1])
            if query is None:
                break
            try:
                contacts += check_query(query, number, lines)
            except Rejected as reason:
                raise Rejected(f"{name}: query {number}: {lines.place()}: {reason}") from None
            queries += 1
    holds = lines.words() == [b"end", str(queries).encode(), str(contacts).encode()]
    require(holds, f"{lines.place()}: expected \"end {queries} {contacts}\"")
    lines.advance()
    require(lines.line is None, f"{lines.place()}: something follows the end")
    return queries, contacts


def opened(names):
    for name in names:
        with open(name, "rb") as stream:
            yield stream, name


def main(arguments):
    if len(arguments) < 2:
        print("usage: check_proofs.py PROOFS QUERY_FILE...", file=sys.stderr)
        return 2
    try:
        with open(arguments[0], "rb") as proofs:
            queries, contacts = check(proofs, arguments[0], opened(arguments[1:]))
    except Rejected as reason:
        print(f"rejected: {reason}", file=sys.stderr)
        return 1
    except (BadInput, OSError) as reason:
        print(f"check_proofs.py: {reason}", file=sys.stderr)
        return 2
    print(f"{queries} queries checked: {contacts} contacts, {queries - contacts} without contact")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
