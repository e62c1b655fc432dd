# SPDX-License-Identifier: MIT
"""Decides queries exactly, slowly and without a proof: the judge of changed proofs whose queries changed too.

It shares nothing with the checkers. The first contact is at t = 0, or it is a boundary point of the set of contact
times. Just before it the distance is more than D, and it is the distance of two features, or in the metric `max` along
the normal of a facet. This gives a polynomial that is zero at the first contact and not identically zero: a *critical*
polynomial. Bisection isolates the roots of all of them in (0, 1). A time, rational or the root of a polynomial, is a
contact if some signs of polynomials there say so.

All numbers are integers. A polynomial is the list of its coefficients, the constant one first.
"""

import functools
import itertools
import math
import struct
import sys
from fractions import Fraction

# Two roots whose distance is about the least double need more than a thousand halvings.
sys.setrecursionlimit(200_000)


def add(p, q, factor=1):
    n = max(len(p), len(q))
    return [(p[i] if i < len(p) else 0) + factor * (q[i] if i < len(q) else 0) for i in range(n)]


def mul(p, q):
    product = [0] * (len(p) + len(q) - 1)
    for i, c in enumerate(p):
        for j, d in enumerate(q):
            product[i + j] += c * d
    return product


def difference(p, q):
    return [add(a, b, -1) for a, b in zip(p, q)]


def dot(p, q):
    return functools.reduce(add, (mul(a, b) for a, b in zip(p, q)))


def cross(p, q):
    return [add(mul(p[b], q[c]), mul(p[c], q[b]), -1) for b, c in ((1, 2), (2, 0), (0, 1))]


def trim(p):
    """Without leading zeros and common factors; the sign stays."""
    while p and p[-1] == 0:
        p = p[:-1]
    content = math.gcd(*p)
    return [c // content for c in p]


def remainder(p, q):
    """A multiple of the remainder of p by q. Its sign is not kept."""
    p = trim(p)
    while len(p) >= len(q):
        scaled = [q[-1] * c for c in p]
        shift = len(p) - len(q)
        p = trim(add(scaled, [0] * shift + [p[-1] * c for c in q], -1))
    return p


def gcd(p, q):
    p, q = trim(p), trim(q)
    while q:
        p, q = q, remainder(p, q)
    return p


def quotient(p, q):
    """A multiple of p / q, for q that divides p."""
    p = [Fraction(c) for c in p]
    result = []
    while len(p) >= len(q):
        result.append(p[-1] / q[-1])
        for i, c in enumerate(reversed(q)):
            p[-1 - i] -= result[-1] * c
        p.pop()
    scale = math.lcm(*(c.denominator for c in result))
    return trim([int(c * scale) for c in reversed(result)])


def square_free(p):
    p = trim(p)
    common = gcd(p, [i * c for i, c in enumerate(p)][1:])
    return p if len(common) < 2 else quotient(p, common)


def shift(p):
    """p(s + 1)."""
    p = list(p)
    for i in range(len(p)):
        for j in range(len(p) - 2, i - 1, -1):
            p[j] += p[j + 1]
    return p


def variations(p):
    """An upper bound of the number of roots of p in (0, 1), exact if it is 0 or 1 (Descartes)."""
    signs = [c > 0 for c in shift(p[::-1]) if c]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def left_half(p):
    d = len(p) - 1
    return [c << (d - i) for i, c in enumerate(p)]


def at(p, a, b):
    """A positive multiple of p(a / b), b > 0."""
    value, power = 0, 1
    for c in reversed(p):
        value = value * a + c * power
        power *= b
    return value


def sign(x):
    return (x > 0) - (x < 0)


def localized(p, a, k):
    """A positive multiple of p((a + s) / 2^k)."""
    d = len(p) - 1
    p = [c << (k * (d - i)) for i, c in enumerate(p)]  # 2^(k d) p(x / 2^k)
    result = []
    for i in range(d + 1):  # Taylor expansion at x = a
        for j in range(d - 1, i - 1, -1):
            p[j] += a * p[j + 1]
        result.append(p[i])
    return result


class Root:
    """The only root in (a / 2^k, (a + 1) / 2^k) of a polynomial without multiple roots. It may be rational."""

    def __init__(self, p, a, k):
        self.p, self.a, self.k = p, a, k
        self.exact = None  # a Fraction, if bisection meets the root

    def refine(self):
        middle = 2 * self.a + 1
        value, low = at(self.p, middle, 2 << self.k), self.sign_after_low()
        if value == 0:
            self.exact = Fraction(middle, 2 << self.k)
        else:
            self.a, self.k = (middle if sign(value) == low else middle - 1), self.k + 1

    def sign_after_low(self):
        low = sign(at(self.p, self.a, 1 << self.k))
        return low or -sign(at(self.p, self.a + 1, 1 << self.k)) or sign(localized(self.p, self.a, self.k)[1])

    def sign_of(self, q):
        q = trim(q)
        common = None
        while q:
            if self.exact is not None:
                return sign(at(q, self.exact.numerator, self.exact.denominator))
            if variations(localized(q, self.a, self.k)) == 0:
                return sign(at(q, 2 * self.a + 1, 2 << self.k))
            if common is None:
                common = gcd(self.p, q)
            if len(common) > 1 and variations(localized(common, self.a, self.k)) == 1:
                return 0
            self.refine()
        return 0

    def bracket(self):
        """The root twice if it is a double, and its neighbouring doubles otherwise."""
        while self.exact is None:
            low = double_below(Fraction(self.a, 1 << self.k))
            high = double_after(low)
            if high >= Fraction(self.a + 1, 1 << self.k):
                return low, high
            if at(self.p, high.numerator, high.denominator) == 0:
                return high, high
            self.refine()
        low = double_below(self.exact)
        return (low, low) if low == self.exact else (low, double_after(low))


def double_below(x):
    """The largest double that is not above x >= 0."""
    result = Fraction(float(x))
    if result > x:
        bits = struct.unpack(">Q", struct.pack(">d", float(result)))[0]
        result = Fraction(struct.unpack(">d", struct.pack(">Q", bits - 1))[0])
    return result


def double_after(x):
    bits = struct.unpack(">Q", struct.pack(">d", float(x)))[0]
    return Fraction(struct.unpack(">d", struct.pack(">Q", bits + 1))[0])


class Elements:
    """The corners of both elements as polynomial vectors, and what decides a contact. All corners and the separation may
    be multiplied by one polynomial that is positive on [0, 1]."""

    def __init__(self, corners, split, metric, separation):
        """The coefficients of the corners and of the separation, a polynomial, are rational. The metric does not matter
        for the separation 0."""
        scale = math.lcm(*(Fraction(c).denominator for p in sum(corners, [separation]) for c in p))
        self.d, *rest = [[int(c * scale) for c in p] for p in sum(corners, [separation])]
        self.x = [rest[i:i + 3] for i in range(0, len(rest), 3)]
        self.first, self.second = range(split), range(split, len(corners))
        self.features = self.normals = None
        if metric == "max" and any(self.d):
            self.find_normals()
        else:
            self.find_features()

    def edges(self, corners):
        return list(itertools.combinations(corners, 2))

    def find_features(self):
        """For each pair of features: excess <= 0 if their lines or planes are at most D apart, and what is not negative
        and what is positive if the closest points are inside."""
        square = mul(self.d, self.d)
        self.features = []
        for i, j in itertools.product(self.first, self.second):
            r = difference(self.x[j], self.x[i])
            self.features.append((add(dot(r, r), square, -1), [], []))
        for corners, others in ((self.first, self.second), (self.second, self.first)):
            for corner, (i, j) in itertools.product(corners, self.edges(others)):
                e, r = difference(self.x[j], self.x[i]), difference(self.x[corner], self.x[i])
                c, ee, re = cross(r, e), dot(e, e), dot(r, e)
                self.features.append((add(dot(c, c), mul(square, ee), -1), [re, add(ee, re, -1)], [ee]))
        if len(self.x) < 4:
            return
        if len(self.first) == 2:
            u, w = difference(self.x[1], self.x[0]), difference(self.x[3], self.x[2])
            r = difference(self.x[2], self.x[0])
            n = cross(u, w)
            nn, s, q = dot(n, n), dot(cross(r, w), n), dot(cross(r, u), n)
            inside = [s, q, add(nn, s, -1), add(nn, q, -1)]
        else:
            u, w = difference(self.x[2], self.x[1]), difference(self.x[3], self.x[1])
            r = difference(self.x[0], self.x[1])
            n = cross(u, w)
            nn, s, q = dot(n, n), dot(cross(r, w), n), dot(cross(u, r), n)
            inside = [s, q, add(add(nn, s, -1), q, -1)]
        v = dot(n, r)
        self.features.append((add(mul(v, v), mul(square, nn), -1), inside, [nn]))

    def find_normals(self):
        """For each normal of a facet of the differences, widened by D: the polynomials that are all positive if it
        separates the elements."""
        axes = [[[int(c == k)] for c in range(3)] for k in range(3)]
        edges = self.edges(self.first) + self.edges(self.second)
        directions = [difference(self.x[j], self.x[i]) for i, j in edges]
        normals = axes + [cross(e, axis) for e in directions for axis in axes]
        normals += [cross(e, f) for e, f in itertools.combinations(directions, 2)]
        self.normals = []
        for m in normals:
            products = [dot(m, difference(self.x[j], self.x[i])) for i, j in itertools.product(self.first, self.second)]
            reaches = [mul(self.d, dot(m, [[s] for s in signs])) for signs in itertools.product((1, -1), repeat=3)]
            for s in (1, -1):
                self.normals.append([add(mul([s], p), reach, -1) for p in products for reach in reaches])

    def critical(self):
        """Polynomials, one of which is zero at the first contact unless that is at t = 0."""
        if self.features is not None:
            polynomials = [excess for excess, _, _ in self.features]
        else:
            polynomials = [p for normal in self.normals for p in normal]
        unique = set()
        for p in polynomials:
            p = trim(p)
            if len(p) > 1:
                unique.add(tuple(p if p[-1] > 0 else [-c for c in p]))
        return [square_free(list(p)) for p in sorted(unique)]

    def contact(self, sign_of):
        if self.features is not None:
            return any(
                sign_of(excess) <= 0 and all(sign_of(p) >= 0 for p in inside) and all(sign_of(p) > 0 for p in squares)
                for excess, inside, squares in self.features)
        return not any(all(sign_of(p) > 0 for p in normal) for normal in self.normals)

    def contact_at(self, a, b):
        return self.contact(lambda p: at(p, a, b))

    def first_contact(self):
        """None, or T and U as a proof gives them."""
        if self.contact_at(0, 1):
            return Fraction(0), Fraction(0)
        return self.search([(p, p) for p in self.critical()], 0, 0)

    def search(self, polynomials, a, k):
        """The first contact in (a / 2^k, (a + 1) / 2^k], where a / 2^k is none. Each polynomial comes with its local
        form, which has the interval as [0, 1]."""
        polynomials = [(p, local) for p, local in polynomials if variations(local)]
        root = self.common_root(polynomials, a, k) if k > 3 else None
        if root:
            if self.contact(root.sign_of):
                return root.bracket()
        elif polynomials:
            left = [(p, left_half(local)) for p, local in polynomials]
            found = self.search(left, 2 * a, k + 1)
            return found or self.search([(p, shift(local)) for p, local in left], 2 * a + 1, k + 1)
        if not self.contact_at(a + 1, 1 << k):
            return None
        end = Fraction(a + 1, 1 << k)
        below = double_below(end)
        return below, (below if below == end else double_after(below))

    @staticmethod
    def common_root(polynomials, a, k):
        """The root of all polynomials in the interval, if they have only one."""
        if not polynomials or any(variations(local) != 1 for _, local in polynomials):
            return None
        common = polynomials[0][0]
        for p, _ in polynomials[1:]:
            common = gcd(common, p)
        return Root(common, a, k) if len(common) > 1 and variations(localized(common, a, k)) == 1 else None
