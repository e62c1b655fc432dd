#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Changes proofs, and checks that no checker accepts a changed proof of a false answer.

    mutate_proofs.py [--checker PROGRAM] [--rounds N] [--accepted FILE] PROOFS QUERY_FILE...

The checker is check_proofs.py, or the PROGRAM. Some forged proofs of false answers come first. Then each query
becomes a file of its own, with its proof, and each mutation below changes that proof N times. The answer in the
original proof counts as the truth, because the checker accepts it. A changed proof that is accepted is harmless if
its answer is the same, and a false acceptance otherwise. The same arguments give the same mutants. The exit status is
0 without a false acceptance.
"""

import argparse
import collections
import io
import os
import random
import re
import struct
import subprocess
import sys
import tempfile
from fractions import Fraction

import check_proofs

CORNERS = {"edge-edge": 4, "vertex-face": 4, "point-edge": 3, "point-point": 2}
NUMBER = re.compile(r"-?([0-9]+|0x[0-9a-f.]+p[+-]?[0-9]+)")


def value(word):
    sign = -1 if word.startswith("-") else 1
    word = word.lstrip("-")
    if not word.startswith("0x"):
        return sign * Fraction(int(word))
    digits, exponent = word[2:].split("p")
    whole, _, fraction = digits.partition(".")
    return sign * int(whole + fraction, 16) * Fraction(2) ** (int(exponent) - 4 * len(fraction))


def word_of(number):
    """A number with a power of two as its denominator, as a word of a proof."""
    number = Fraction(number)
    return f"{'-' if number < 0 else ''}0x{abs(number.numerator):x}p-{number.denominator.bit_length() - 1}"


def times(p, q):
    product = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, c in enumerate(p):
        for j, d in enumerate(q):
            product[i + j] += c * d
    return product


def ulp_after(x, steps):
    """The double that is some doubles after the double x >= 0; 0 if there is none."""
    bits = int.from_bytes(struct.pack(">d", float(x)), "big") + steps
    return Fraction(struct.unpack(">d", max(bits, 0).to_bytes(8, "big"))[0])


class Proof:
    """The lines of one proof, as lists of words."""

    def __init__(self, lines):
        self.verdict = lines[0]
        self.pieces = [line for line in lines if line[0] in ("n", "d")]
        self.root = [line for line in lines if line[0] == "root"]
        self.weights = [line for line in lines if line[0] == "w"]

    def lines(self):
        return [list(line) for line in [self.verdict] + self.pieces + self.root + self.weights]

    def answer(self):
        return self.verdict[1:2] + [value(word) for word in self.verdict[2:]]


# A mutation gets the random source, the proof, which it may change, and a proof of another query. It returns the lines,
# or None if it does not apply.


def change_number(rng, proof, other, change):
    lines = proof.lines()
    places = [(i, j) for i, line in enumerate(lines) for j, word in enumerate(line)
              if NUMBER.fullmatch(word) and not (i == 0 and j == 0) and not (line[0] == "w" and j == 1)]
    if not places:
        return None
    i, j = rng.choice(places)
    lines[i][j] = word_of(change(value(lines[i][j])))
    return lines


def flip_bit(rng, proof, other):
    def change(x):
        numerator = abs(x.numerator) ^ (1 << rng.randrange(max(x.numerator.bit_length(), 1) + 1))
        return Fraction(numerator if x >= 0 else -numerator, x.denominator)
    return change_number(rng, proof, other, change)


def scale_number(rng, proof, other):
    return change_number(rng, proof, other, lambda x: x * rng.choice([2, Fraction(1, 2), -1, 0, 3]))


def change_last_bit(rng, proof, other):
    return change_number(rng, proof, other, lambda x: x + rng.choice([-1, 1]) * Fraction(1, x.denominator))


def drop_line(rng, proof, other):
    lines = proof.lines()
    del lines[rng.randrange(1, len(lines)) if len(lines) > 1 else 0]
    return lines


def repeat_line(rng, proof, other):
    lines = proof.lines()
    i = rng.randrange(len(lines))
    return lines[:i] + [lines[i]] + lines[i:]


def swap_lines(rng, proof, other):
    lines = proof.lines()
    if len(lines) < 3:
        return None
    i, j = rng.sample(range(1, len(lines)), 2)
    lines[i], lines[j] = lines[j], lines[i]
    return lines


def shuffle_lines(rng, proof, other):
    lines = proof.lines()
    rng.shuffle(lines)
    return lines


def truncate(rng, proof, other):
    lines = proof.lines()
    return lines[:rng.randrange(1, len(lines))] if len(lines) > 1 else None


def swap_directions(rng, proof, other):
    if len(proof.pieces) < 2:
        return None
    i, j = rng.sample(range(len(proof.pieces)), 2)
    cut = [line.index("to") if "to" in line else len(line) for line in (proof.pieces[i], proof.pieces[j])]
    first, second = proof.pieces[i], proof.pieces[j]
    proof.pieces[i], proof.pieces[j] = second[:cut[1]] + first[cut[0]:], first[:cut[0]] + second[cut[1]:]
    return proof.lines()


def widen_piece(rng, proof, other):
    """A piece ends where the next one does, and the next one goes."""
    if len(proof.pieces) < 2:
        return None
    i = rng.randrange(len(proof.pieces) - 1)
    following = proof.pieces.pop(i + 1)
    line = proof.pieces[i]
    proof.pieces[i] = line[:line.index("to")] + (following[following.index("to"):] if "to" in following else [])
    return proof.lines()


def move_end_of_piece(rng, proof, other):
    ends = [line for line in proof.pieces if "to" in line]
    if not ends:
        return None
    line = rng.choice(ends)
    line[-1] = word_of(value(line[-1]) * Fraction(rng.choice([1, 3, 7, 9, 16, 31, 64]), 8))
    return proof.lines()


def change_direction(rng, proof, other):
    """A direction of few bits, a zero one, or one that changes its sign during the piece."""
    if not proof.pieces:
        return None
    line = rng.choice(proof.pieces)
    end = line[line.index("to"):] if "to" in line else []
    if line[0] == "d" and rng.random() < 0.5:
        words = line[1:len(line) - len(end)]
        rows = [times([value(word) for word in words[c::3]], [Fraction(-1, 2), Fraction(1)]) for c in range(3)]
        numbers = [row[j] for j in range(len(rows[0])) for row in rows]
    else:
        numbers = [rng.randrange(-2, 3) for _ in range(3 * rng.randrange(1, 4))]
    line[:] = ["d"] + [word_of(x) for x in numbers] + end
    return proof.lines()


def deny(rng, proof, other):
    """A contact becomes none. The meeting goes, or the proof of another query without contact is used."""
    if proof.verdict[1] == "none":
        return None
    proof.verdict = [proof.verdict[0], "none"]
    proof.pieces = proof.pieces or [["n"]]
    if rng.random() < 0.7:
        proof.root, proof.weights = [], []
    return proof.lines()


def claim_contact(rng, proof, other):
    """Another time of contact, with the meeting that fits it, constant weights, or the other proof's meeting."""
    start = rng.choice([Fraction(0), Fraction(1), Fraction(rng.randrange(1, 1 << 20), 1 << 20)])
    if len(proof.verdict) > 2 and rng.random() < 0.5:
        start = ulp_after(value(proof.verdict[2]), rng.choice([-2, -1, 1, 2]))
    end = start if start == 1 or rng.random() < 0.5 else ulp_after(start, 1)
    proof.verdict = [proof.verdict[0], "contact", word_of(start), word_of(end)]
    proof.pieces = proof.pieces if end != 0 else []
    proof.root = [] if start == end else [["root", word_of(-start - end), "2"]]
    if not proof.weights or rng.random() < 0.3:
        constant = [["w", str(i), rng.choice(["1", "0"])] for i in range(4)]
        proof.weights = constant if rng.random() < 0.5 else other.weights
    return proof.lines()


def move_times(rng, proof, other):
    """T or U, or both, by some doubles; g stays as it is, or is the line through the middle."""
    if len(proof.verdict) < 4:
        return None
    t, u = value(proof.verdict[2]), value(proof.verdict[3])
    choices = [(t, t), (u, u), (u, ulp_after(u, 1)), (ulp_after(t, -1), t), (t, ulp_after(u, 1)), (ulp_after(t, -1), u),
               (ulp_after(t, -1), ulp_after(t, -1)), (u, t), (t, ulp_after(t, 1))]
    t, u = rng.choice([pair for pair in choices if pair != (t, u)])
    proof.verdict[2:] = [word_of(t), word_of(u)]
    if t == u:
        proof.root = []
    elif not proof.root or rng.random() < 0.3:
        proof.root = [["root", word_of(-t - u), "2"]]
    return proof.lines()


def use_other_proof(rng, proof, other):
    other.verdict[0] = proof.verdict[0]
    return other.lines()


def use_other_meeting(rng, proof, other):
    if not other.weights:
        return None
    proof.root, proof.weights = (other.root if proof.root else []), other.weights
    return proof.lines() if proof.verdict[1] == "contact" else None


def change_signs_of_weights(rng, proof, other):
    if not proof.weights:
        return None
    chosen = rng.sample(proof.weights, rng.randrange(1, len(proof.weights) + 1))
    for line in chosen:
        line[2:] = [word_of(-value(word)) for word in line[2:]]
    return proof.lines()


def swap_weights(rng, proof, other):
    if len(proof.weights) < 2:
        return None
    first, second = rng.sample(proof.weights, 2)
    first[2:], second[2:] = second[2:], first[2:]
    return proof.lines()


def multiply_weights(rng, proof, other):
    """By g, which makes all of them zero at its root, or by another line. Alone, in an element, or all of them."""
    if not proof.weights:
        return None
    t, u = value(proof.verdict[2]), value(proof.verdict[3])
    between = proof.root[0].index("between") if proof.root and "between" in proof.root[0] else None
    g = [value(word) for word in proof.root[0][1:between]] if proof.root else [-t, Fraction(1)]
    factor = rng.choice([g, [-t, Fraction(1)], [-u, Fraction(1)], [-c for c in g], [Fraction(1), Fraction(-1)]])
    for line in rng.choice([proof.weights, [rng.choice(proof.weights)]]):
        line[2:] = [word_of(c) for c in times([value(word) for word in line[2:]], factor)]
    return proof.lines()


def change_root(rng, proof, other):
    """g times a line, its square, another scale, a constant, a higher coefficient, or the other proof's g."""
    if not proof.root:
        return None
    words = proof.root[0]
    end = words.index("between") if "between" in words else len(words)
    g = [value(word) for word in words[1:end]]
    t, u = value(proof.verdict[2]), value(proof.verdict[3])
    middle = [-(t + u) / 2, Fraction(1)]
    choices = [times(g, middle), times(g, g), times(times(g, g), g), times(g, [Fraction(-3)]), times(g, [Fraction(0)]),
               g[:1], g[:-1], g + [Fraction(1)], g + [Fraction(0)], g[::-1], middle, [-t, Fraction(1)],
               times(g, [-u - 1, Fraction(1)])]
    proof.root = [["root"] + [word_of(c) for c in rng.choice(choices)] + words[end:]]
    return proof.lines()


def change_between(rng, proof, other):
    if not proof.root:
        return None
    words = proof.root[0]
    words = words[:words.index("between")] if "between" in words else words
    t, u = value(proof.verdict[2]), value(proof.verdict[3])
    points = [t, u, (t + u) / 2, (3 * t + u) / 4, Fraction(0), Fraction(1), 2 * u - t, -u]
    proof.root = [words + ["between"] + [word_of(rng.choice(points)) for _ in range(2)]]
    return proof.lines()


MUTATIONS = [flip_bit, scale_number, change_last_bit, drop_line, repeat_line, swap_lines, shuffle_lines, truncate,
             swap_directions, widen_piece, move_end_of_piece, change_direction, deny, claim_contact, move_times,
             use_other_proof, use_other_meeting, change_signs_of_weights, swap_weights, multiply_weights, change_root,
             change_between]


def rows_of(starts, ends):
    return "".join(f"{x},1,{y},1,{z},1,0\n" for x, y, z in starts + ends)


def forgeries():
    """Proofs of false answers: name, kind, rows, lines. Each breaks one check of the page, and holds otherwise."""
    line = [(2, 0, 0), (0, 0, 0), (1, 0, 0)]  # a point beside an edge, on its line
    above = [(0, 0, 1), (0, 0, 0), (1, 0, 0)]  # a point above an edge
    around = [(0, 0, 0), (-1, 0, 0), (1, 0, 0)]
    crossing = ([(-1, 0, 0), (1, 0, 0), (0, -1, 1), (0, 1, 1)], [(-1, 0, 0), (1, 0, 0), (0, -1, -2), (0, 1, -2)])
    third = "0 contact 0x1.5555555555555p-2 0x1.5555555555556p-2"
    half = "0 contact 0x1p-1 0x1.0000000000001p-1"
    west, east, weights = "d -1 0 0", "d 1 0 0", ["w 0 1", "w 1 1"]

    def two_points(start, end):
        """The first point rests at 0, the second one moves on the x axis."""
        return "point-point", rows_of([(0, 0, 0), (start, 0, 0)], [(0, 0, 0), (end, 0, 0)])

    passing = two_points(-2, 1)  # they meet at 2/3
    meeting = two_points(-1, 1)  # they meet at 1/2
    resting = two_points(0, 0)
    odd = 2**53 + 1
    return [
        ("negative weight", "point-edge", rows_of(line, line), ["0 contact 0 0", "w 0 1", "w 1 -1", "w 2 2"]),
        ("zero weights", "point-edge", rows_of(above, above), ["0 contact 0 0", "w 0 0", "w 1 0", "w 2 0"]),
        ("no weights", "point-edge", rows_of(above, above), ["0 contact 0 0"]),
        ("weights that vanish at T", *passing, ["0 contact 0x1p-1 0x1p-1", west, "w 0 -1 2", "w 1 -1 2"]),
        ("weights that vanish at the root", *passing, [third, west, "root -1 3", "w 0 -1 3", "w 1 -1 3"]),
        ("root elsewhere", *passing, [third, west, "root -2 3 between 0x1p-1 0x1p0", *weights]),
        ("no root between", *passing, [third, west, "root -2 3", *weights]),
        ("constant g", *passing, [third, west, "root -1 0", *weights]),
        ("T is the contact", *meeting, [half, west, "root -1 2", *weights]),
        ("U is the contact", *meeting, ["0 contact 0x1.fffffffffffffp-2 0x1p-1", west, "root -1 2", *weights]),
        ("wide bracket", *passing, ["0 contact 0x1p-1 0x1p0", west, "root -2 3", *weights]),
        ("T of 54 bits", *two_points(-odd, 2**54 - odd), [f"0 contact 0x{odd:x}p-54 0x{odd:x}p-54", west, *weights]),
        ("T after 1", *two_points(-2, -1), ["0 contact 0x1p1 0x1p1", west, *weights]),
        ("T before 0", *two_points(1, 2), ["0 contact -1 -1", east, *weights]),
        ("piece after the end", *passing, ["0 none", f"{west} to 0x1p-1", f"{east} to 2", east]),
        ("piece without length", *passing, ["0 none", f"{west} to 0x1p-1", f"{west} to 0x1p-1", east]),
        ("last piece has an end", *passing, ["0 none", f"{west} to 0x1p-1"]),
        ("zero at the end", *two_points(-1, 0), ["0 none", west]),
        ("two signs", "point-edge", rows_of(around, around), ["0 none", east]),
        ("direction that turns", "edge-edge", rows_of(*crossing), ["0 none", "d 0 0 1 0 0 -3"]),
        ("zero direction", "edge-edge", rows_of(*crossing), ["0 none", "d 0 0 0"]),
        ("late", *resting, ["0 contact 1 1", east, *weights]),
        ("no piece", *resting, ["0 contact 1 1", *weights]),
        ("different points", *two_points(1, 1), ["0 contact 0 0", *weights]),
    ]


def read_cases(proofs, query_files):
    """For each query its kind, its rows and the lines of its proof."""
    cases = []
    with open(proofs) as stream:
        lines = [line.split() for line in stream]
    files = iter(query_files)
    for words in lines[1:-1]:
        if words[0] == "file":
            kind, rows = words[1], iter([r for r in open(next(files)) if r.strip() and not r.strip().startswith("#")])
        elif words[0].isdigit():
            cases.append((kind, "".join(next(rows) for _ in range(2 * CORNERS[kind])), [["0"] + words[1:]]))
        else:
            cases[-1][2].append(words)
    return cases


def text_of(kind, lines):
    contacts = int(lines[0][1:2] == ["contact"])
    body = "".join(" ".join(line) + "\n" for line in lines)
    return f"touchstone-proofs 1\nfile {kind} - query\n{body}end 1 {contacts}\n".encode()


def status_of(program, folder, proof, rows):
    """0 accepted, 1 or 2 not; anything else is a crash."""
    if not program:
        try:
            check_proofs.check(io.BytesIO(proof), "proof", [(io.BytesIO(rows.encode()), "query")])
            return 0
        except (check_proofs.Rejected, check_proofs.BadInput):
            return 1
    paths = [os.path.join(folder, "proof"), os.path.join(folder, "query")]
    for path, content in zip(paths, (proof, rows.encode())):
        with open(path, "wb") as stream:
            stream.write(content)
    return subprocess.run([program] + paths, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--checker", help="the program that checks (default: check_proofs.py)")
    parser.add_argument("--rounds", type=int, default=1, help="mutants for each query and mutation")
    parser.add_argument("--accepted", help="a file for the names of the accepted mutants")
    parser.add_argument("proofs")
    parser.add_argument("queries", nargs="+")
    arguments = parser.parse_args()
    cases = read_cases(arguments.proofs, arguments.queries)
    counts = collections.Counter()
    failures, accepted = [], []
    with tempfile.TemporaryDirectory() as folder:
        for name, kind, rows, lines in forgeries():
            status = status_of(arguments.checker, folder, text_of(kind, [line.split() for line in lines]), rows)
            if status not in (1, 2):
                failures.append(f"forged proof, {name}: status {status}")
        for index, (kind, rows, lines) in enumerate(cases):
            if status_of(arguments.checker, folder, text_of(kind, lines), rows) != 0:
                failures.append(f"query {index}: the original proof is not accepted")
            truth = Proof(lines).answer()
            for mutation in MUTATIONS:
                for turn in range(arguments.rounds):
                    name = f"{index} {mutation.__name__} {turn}"
                    rng = random.Random(name)
                    another = rng.choice([case for case in rng.choices(cases, k=20) if case[0] == kind] or cases)
                    copies = [Proof([list(line) for line in original]) for original in (lines, another[2])]
                    mutant = mutation(rng, *copies)
                    if mutant is None or mutant == lines:
                        continue
                    status = status_of(arguments.checker, folder, text_of(kind, mutant), rows)
                    counts[mutation.__name__, "tried"] += 1
                    if status == 0:
                        same = Proof(mutant).answer() == truth
                        counts[mutation.__name__, "harmless" if same else "false"] += 1
                        accepted.append(name)
                        if not same:
                            failures.append(f"{name}: FALSE ACCEPTANCE\n{rows}{text_of(kind, mutant).decode()}")
                    elif status in (1, 2):
                        counts[mutation.__name__, "rejected"] += 1
                    else:
                        failures.append(f"{name}: the checker ended with status {status}")
    columns = ("tried", "rejected", "harmless", "false")
    print(f"{len(forgeries())} forged proofs, {len(cases)} proofs changed")
    print(f"{'mutation':24}" + "".join(f"{column:>10}" for column in columns))
    for name in [mutation.__name__ for mutation in MUTATIONS]:
        print(f"{name:24}" + "".join(f"{counts[name, column]:10}" for column in columns))
    print(f"{'all':24}" + "".join(f"{sum(n for (_, c), n in counts.items() if c == column):10}" for column in columns))
    if arguments.accepted:
        with open(arguments.accepted, "w") as stream:
            stream.writelines(name + "\n" for name in accepted)
    failures += [f"{m.__name__}: no mutant was rejected" for m in MUTATIONS if not counts[m.__name__, "rejected"]]
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
