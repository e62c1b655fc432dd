#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Changes proofs, separations and motions, and checks that no checker accepts a proof of a false answer.

    mutate_proofs.py [--checker PROGRAM [--many PROGRAM]] [--mutants N] [--jobs N] [--seconds N] [PROOFS FILE...]

The checker is check_proofs.py, or the PROGRAM. A process for each mutant costs more than the checks, so --many names
the program of checks.cpp, which does them in one process. One mutant of a hundred goes to the first program too, whose
exit status must be the same. Some forged proofs of false answers come first. Then the given proofs,
and those of small_cases.py, become *cases*: a query with its proof, or a small part of a motion with its proofs. Each
mutation below changes each case some times, N in total. An accepted mutant must be true: exact_truth.py says what it
claims, and what is true of its files and separations, which may have changed too. The same arguments give the same
mutants. The exit status is 0 without a false acceptance.
"""

import argparse
import collections
import io
import itertools
import multiprocessing
import os
import random
import re
import struct
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

import check_proofs
import small_cases
from exact_truth import CORNERS, as_double, claims, curved_queries, is_curved, lines_of, rows_of, truths, value

NUMBER = re.compile(r"-?([0-9]+|0x[0-9A-Fa-f.]+p[+-]?[0-9]+)")


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


# A mutation of a proof gets the random source, the proof, which it may change, and a proof of another query. It returns
# the lines, or None if it does not apply.


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
    different = [two for two in itertools.combinations(proof.weights, 2) if two[0][2:] != two[1][2:]]
    if not different:
        return None
    first, second = rng.choice(different)
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


PROOF_MUTATIONS = [flip_bit, scale_number, change_last_bit, drop_line, repeat_line, swap_lines, shuffle_lines, truncate,
                   swap_directions, widen_piece, move_end_of_piece, change_direction, deny, claim_contact, move_times,
                   use_other_proof, use_other_meeting, change_signs_of_weights, swap_weights, multiply_weights,
                   change_root, change_between]



class File:
    """A query file or a motion file, and its part of the proofs.

    `separation` is the words of its line, or empty. `groups` has the proofs of a query file, or those of each step of
    a motion, each proof as a list of lines. `labels` has the words `step K` for each group of a motion.
    """

    def __init__(self, separation, kind, content, groups):
        self.separation, self.kind, self.content, self.groups = separation, kind, content, groups
        self.labels = [["step", str(k)] for k in range(len(groups))] if kind == "mesh" else []

    def copy(self):
        groups = [[[list(line) for line in proof] for proof in group] for group in self.groups]
        result = File(list(self.separation), self.kind, self.content, groups)
        result.labels = [list(label) for label in self.labels]
        return result

    def lines(self):
        lines = [self.separation] if self.separation else []
        lines.append(["file", self.kind, "-", "f"])
        for k, group in enumerate(self.groups):
            lines += self.labels[k:k + 1] + [line for proof in group for line in proof]
        return lines

    def proofs(self):
        return [proof for group in self.groups for proof in group]

    def renumber(self):
        for group in self.groups:
            for number, proof in enumerate(group):
                proof[0][0] = str(number)

    def motion(self):
        """The lines of a motion file before its frames, and its frames, which have a line for each body, and one for
        each vertex on none."""
        lines = lines_of(self.content)
        starts = [i for i, words in enumerate(lines) if words == ["frame"]] + [len(lines)]
        return lines[:starts[0]], [lines[i + 1:j] for i, j in zip(starts, starts[1:])]

    def set_motion(self, head, frames):
        lines = head + [words for frame in frames for words in [["frame"]] + frame]
        self.content = "".join(" ".join(words) + "\n" for words in lines)


def rows_of_vertices(head):
    """Of each vertex of a motion: the number of its row in a frame, or of its body's."""
    bodies = {int(words[1]): int(words[2]) for words in head if words[0] == "body"}
    body_count = max(bodies.values(), default=-1) + 1
    free = [v for v in range(int(head[1][1])) if v not in bodies]
    return {**bodies, **{v: body_count + k for k, v in enumerate(free)}}


def text_of(files):
    """The file of proofs. Its last line always fits."""
    lines = [line for file in files for line in file.lines()]
    answers = [line[1] for line in lines if line[1:2] and line[1] in ("none", "contact")]
    lines = [["touchstone-proofs", "1"]] + lines + [["end", str(len(answers)), str(answers.count("contact"))]]
    return "".join(" ".join(line) + "\n" for line in lines)


# A mutation of a file gets the random source, the file, which it may change, and a file of another case. It returns the
# files of the mutant, or None if it does not apply.


def change_separation_by_ulps(rng, file, other):
    if not file.separation:
        return None
    d = value(file.separation[2])
    unit = max(abs(d), Fraction(1, 1 << 1000)) / (1 << 52)
    file.separation[2] = word_of(d + rng.choice([-1, 1]) * rng.choice([1, 2, 3, 1 << 10, 1 << 30]) * unit)
    return [file]


def scale_separation(rng, file, other):
    if not file.separation:
        return None
    factor = rng.choice([0, -1, 2, 3, 1024, Fraction(1, 2), Fraction(3, 4), Fraction(9, 8), Fraction(1, 1024)])
    file.separation[2] = word_of(value(file.separation[2]) * factor)
    return [file]


def change_metric(rng, file, other):
    if not file.separation:
        return None
    file.separation[1] = "max" if file.separation[1] == "euclidean" else "euclidean"
    return [file]


def drop_separation(rng, file, other):
    if not file.separation:
        return None
    file.separation = []
    return [file]


def add_separation(rng, file, other):
    if file.separation:
        return None
    d = other.separation[2] if other.separation and rng.random() < 0.5 else word_of(Fraction(1, 1 << rng.randrange(60)))
    file.separation = ["separation", rng.choice(["euclidean", "max"]), d]
    return [file]


def move_separation(rng, file, other):
    """To the file before, to the next one, or both files change theirs."""
    if file.separation == other.separation:
        return None
    files = [file, other] if rng.random() < 0.5 else [other, file]
    swapped = [files[1].separation, files[0].separation]
    if rng.random() < 0.5:  # both have the same one, or none
        swapped = [rng.choice(swapped)] * 2
    for changed, separation in zip(files, swapped):
        changed.separation = separation
    return files


def move_separation_line(rng, file, other):
    """After its file line, to the end, or twice."""
    if not file.separation:
        return None
    line, file.separation = file.separation, []
    place = rng.randrange(3)
    if place == 0 and not file.labels and file.groups[0]:
        file.groups[0][0].insert(0, line)
    elif place == 1 and file.proofs():
        file.proofs()[-1].append(line)
    else:
        file.separation = line + ["\nseparation"] + line[1:]
    return [file]


def use_other_file(rng, file, other):
    if file.kind != other.kind or file.content == other.content:
        return None
    file.content = other.content
    return [file]


def change_kind(rng, file, other):
    file.kind = rng.choice([kind for kind in list(CORNERS) + ["mesh"] if kind != file.kind])
    return [file]


def another_number(rng, x):
    step = Fraction(max(abs(x.numerator), 1), x.denominator << rng.choice([0, 1, 10, 52, 52, 60]))
    return rng.choice([x + step, x - step, -x, Fraction(0), x * 2])


def change_coordinate(rng, file, other):
    if file.kind == "mesh":
        head, frames = file.motion()
        points = [(words, range(3, 6)) for words in head if words[0] == "body"]
        rows = [(row, range(len(row))) for frame in frames for row in frame]
        if not rows:
            return None
        row, places = rng.choice(points if points and rng.random() < 0.3 else rows)
        c = rng.choice(places)
        row[c] = word_of(another_number(rng, value(row[c])))
        file.set_motion(head, frames)
        return [file]
    rows = rows_of(file.content)
    if is_curved(file.content):
        row = rng.choice([row for row in rows if row[0] in ("motion", "body", "curve")])
        c = rng.randrange(1 if row[0] == "curve" else 2, len(row))
        try:
            row[c] = float(another_number(rng, as_double(row[c]))).hex()
        except OverflowError:
            return None
        return with_rows(file, rows)
    row, c = rng.choice(rows), rng.choice([0, 2, 4])
    x = another_number(rng, Fraction(int(row[c]), int(row[c + 1])))
    row[c:c + 2] = str(x.numerator), str(x.denominator)
    return with_rows(file, rows)


def with_rows(file, rows):
    file.content = "".join(",".join(row) + "\n" for row in rows)
    return [file]


def change_curved_rows(rng, file, other):
    """A row is missing, twice or elsewhere; a corner has another motion, or another degree; a turn goes the other way
    round, or another body's quaternion is longer; the file loses the row that says that its motion is curved."""
    if not is_curved(file.content):
        return None
    rows = rows_of(file.content)
    places = range(2, len(rows))
    i, j = rng.choice(places), rng.choice(places)
    motions = [row for row in rows if row[0] == "motion"]
    corners = [row for row in rows if row[0] in ("body", "curve")]
    choice = rng.randrange(9)
    if choice == 0:
        del rows[i]
    elif choice == 1:
        rows.insert(j, list(rows[i]))
    elif choice == 2:
        rows[i], rows[j] = rows[j], rows[i]
    elif choice == 3:
        del rows[rng.randrange(2)]
    elif choice == 4:
        row = rng.choice(corners)
        row[1 if row[0] == "body" else slice(0, 1)] = rng.choice("0123") if row[0] == "body" else ["body", "0"]
    elif choice == 5:
        row = rng.choice(corners)
        row += row[-3:] if rng.random() < 0.7 else ["0"]
    elif choice == 6 and motions:
        row = rng.choice(motions)
        row[6:10] = [float(-as_double(word)).hex() for word in row[6:10]]
    elif choice == 7 and motions:
        row = rng.choice(motions)
        factor = rng.choice([2, 3, 0.5, -1])
        first = rng.choice([2, 6])
        try:
            row[first:first + 4] = [float(factor * as_double(word)).hex() for word in row[first:first + 4]]
        except OverflowError:
            return None
    else:
        row = rng.choice(motions or corners)
        row[-3:], row[-6:-3] = row[-6:-3], row[-3:]
    return with_rows(file, rows)


def renumbered(rng, file):
    """Most mutants have the numbers that the checker expects."""
    if rng.random() < 0.8:
        file.renumber()
        file.labels = [["step", str(k)] for k in range(len(file.labels))]
    return [file]


def drop_step(rng, file, other):
    if not file.labels:
        return None
    k = rng.randrange(len(file.labels))
    del file.labels[k], file.groups[k]
    return renumbered(rng, file)


def drop_step_line(rng, file, other):
    """The pairs of the step stay, after those of the step before."""
    if len(file.labels) < 2:
        return None
    k = rng.randrange(1, len(file.labels))
    file.groups[k - 1] += file.groups.pop(k)
    del file.labels[k]
    return renumbered(rng, file)


def double_step(rng, file, other):
    if not file.labels:
        return None
    k = rng.randrange(len(file.labels))
    file.labels.insert(k, list(file.labels[k]))
    file.groups.insert(k, [[list(line) for line in proof] for proof in file.groups[k]])
    return renumbered(rng, file)


def swap_steps(rng, file, other):
    if len(file.labels) < 2:
        return None
    i, j = rng.sample(range(len(file.labels)), 2)
    file.groups[i], file.groups[j] = file.groups[j], file.groups[i]
    file.labels[i], file.labels[j] = file.labels[j], file.labels[i]
    return renumbered(rng, file)


def drop_pair(rng, file, other):
    groups = [group for group in file.groups if group]
    if not groups:
        return None
    group = rng.choice(groups)
    del group[rng.randrange(len(group))]
    return renumbered(rng, file)


def double_pair(rng, file, other):
    groups = [group for group in file.groups if group]
    if not groups:
        return None
    group = rng.choice(groups)
    k = rng.randrange(len(group))
    group.insert(k, [list(line) for line in group[k]])
    return renumbered(rng, file)


def swap_pairs(rng, file, other):
    """Of one step or of two steps."""
    places = [(group, k) for group in file.groups for k in range(len(group))]
    if len(places) < 2:
        return None
    (first, i), (second, j) = rng.sample(places, 2)
    first[i], second[j] = second[j], first[i]
    return renumbered(rng, file)


def move_pair(rng, file, other):
    groups = [group for group in file.groups if group]
    if not groups or len(file.groups) < 2:
        return None
    source = rng.choice(groups)
    target = rng.choice([group for group in file.groups if group is not source])
    target.insert(rng.randrange(len(target) + 1), source.pop(rng.randrange(len(source))))
    return renumbered(rng, file)


def empty_step(rng, file, other):
    if not file.labels or not file.proofs():
        return None
    rng.choice([group for group in file.groups if group]).clear()
    return [file]


def add_fixed(rng, file, other):
    """One line `fixed`, or one for each vertex that rests."""
    if file.kind != "mesh":
        return None
    head, frames = file.motion()
    fixed = {words[1] for words in head if words[0] == "fixed"}
    rows = rows_of_vertices(head)
    vertices = [str(v) for v in rows if str(v) not in fixed]
    resting = [v for v in vertices if all(frame[rows[int(v)]] == frames[0][rows[int(v)]] for frame in frames)]
    chosen = resting if resting and rng.random() < 0.7 else vertices[:]
    if not chosen:
        return None
    if rng.random() < 0.5:
        chosen = [rng.choice(chosen)]
    file.set_motion(head + [["fixed", v] for v in chosen], frames)
    return [file]


def drop_fixed(rng, file, other):
    if file.kind != "mesh":
        return None
    head, frames = file.motion()
    lines = [words for words in head if words[0] == "fixed"]
    if not lines:
        return None
    dropped = lines if rng.random() < 0.3 else [rng.choice(lines)]
    file.set_motion([words for words in head if words not in dropped], frames)
    return [file]


def change_elements(rng, file, other):
    """A line drops, doubles or changes its place, or has another vertex."""
    if file.kind != "mesh":
        return None
    head, frames = file.motion()
    if len(head) < 4:
        return None
    i, j = rng.sample(range(2, len(head)), 2)
    change = rng.randrange(4)
    if change == 0:
        del head[i]
    elif change == 1:
        head.insert(j, list(head[i]))
    elif change == 2:
        head[i], head[j] = head[j], head[i]
    else:
        head[i][rng.randrange(1, len(head[i]))] = str(rng.randrange(len(frames[0])))
    file.set_motion(head, frames)
    return [file]


def change_radii(rng, file, other):
    """A radius changes or is new, or two vertices become neighbours or are none any more."""
    if file.kind != "mesh":
        return None
    head, frames = file.motion()
    radii, near = ([words for words in head if words[0] == sort] for sort in ("radius", "near"))
    change = rng.random()
    if radii and change < 0.6:
        words = rng.choice(radii)
        words[1] = word_of(another_number(rng, value(words[1])))
    elif near and change < 0.75:
        head.remove(rng.choice(near))
    else:
        vertices = [str(v) for v in rng.sample(range(int(head[1][1])), 2)] if int(head[1][1]) > 1 else ["0", "0"]
        new = ["radius", word_of(another_number(rng, Fraction(1, 64)))] if change < 0.85 else ["near"] + vertices
        head.insert(rng.randrange(2, len(head) + 1), new)
    file.set_motion(head, frames)
    return [file]


def change_groups(rng, file, other):
    """A vertex gets another group or loses its own, or two groups are ignored or not any more."""
    if file.kind != "mesh":
        return None
    head, frames = file.motion()
    groups, ignored = ([words for words in head if words[0] == sort] for sort in ("group", "ignore"))
    names = [words[2] for words in groups] + [name for words in ignored for name in words[1:]] + ["0", "1"]
    change = rng.random()
    if groups and change < 0.4:
        rng.choice(groups)[2] = rng.choice(names)
    elif groups and change < 0.5:
        head.remove(rng.choice(groups))
    elif ignored and change < 0.75:
        head.remove(rng.choice(ignored))
    else:
        known = {words[1] for words in groups}
        vertices = [str(v) for v in range(int(head[1][1])) if str(v) not in known]
        one = ["group", rng.choice(vertices), rng.choice(names)] if vertices and change < 0.9 else None
        head += [one or ["ignore", rng.choice(names), rng.choice(names)]]
        if not ignored and rng.random() < 0.5:
            head.append(["ignore", rng.choice(names), rng.choice(names)])
    file.set_motion(head, frames)
    return [file]


def change_touching(rng, file, other):
    """Two elements are asked about touching alone, or not any more."""
    if file.kind != "mesh":
        return None
    head, frames = file.motion()
    lines = [words for words in head if words[0] == "touching"]
    if lines and rng.random() < 0.5:
        head.remove(rng.choice(lines))
    else:
        kind = rng.choice(list(CORNERS))
        sorts = {1: "point", 2: "edge", 3: "face"}
        counts = [sum(words[0] == sorts[size] for words in head) for size in (CORNERS[kind][0],
                                                                             CORNERS[kind][1] - CORNERS[kind][0])]
        numbers = sorted(rng.randrange(count + 1) for count in counts)
        head.append(["touching", kind] + [str(number) for number in numbers])
    file.set_motion(head, frames)
    return [file]


def change_frames(rng, file, other):
    """A frame drops, doubles or changes its place."""
    if file.kind != "mesh":
        return None
    head, frames = file.motion()
    i, j = rng.sample(range(len(frames)), 2)
    change = rng.randrange(3)
    if change == 0:
        del frames[i]
    elif change == 1:
        frames.insert(i, frames[j])
    else:
        frames[i], frames[j] = frames[j], frames[i]
    file.set_motion(head, frames)
    return [file]


def truncate_proofs(rng, file, other):
    """The rest of the proofs is missing."""
    lines = file.lines()
    kept = lines[:rng.randrange(2, len(lines))] if len(lines) > 2 else None
    if kept is None:
        return None
    result = File([], file.kind, file.content, [])
    result.lines = lambda: kept
    return [result]


def reorder_proofs(rng, file, other):
    lines = file.lines()
    if len(lines) < 4:
        return None
    i, j = rng.sample(range(1, len(lines)), 2)
    lines.insert(i, lines.pop(j))
    result = File([], file.kind, file.content, [])
    result.lines = lambda: lines
    return [result]


FILE_MUTATIONS = [change_separation_by_ulps, scale_separation, change_metric, drop_separation, add_separation,
                  move_separation, move_separation_line, use_other_file, change_kind, change_coordinate,
                  change_curved_rows, drop_step, drop_step_line, double_step, swap_steps, drop_pair, double_pair, swap_pairs, move_pair, empty_step,
                  add_fixed, drop_fixed, change_elements, change_radii, change_groups, change_touching, change_frames, truncate_proofs, reorder_proofs]
MUTATIONS = PROOF_MUTATIONS + FILE_MUTATIONS


def mutant_of(mutation, rng, file, other):
    """The files of a mutant, or None."""
    file, other = file.copy(), other.copy()
    if mutation in FILE_MUTATIONS:
        return mutation(rng, file, other)
    if not file.proofs() or not other.proofs():
        return None
    group = rng.choice([group for group in file.groups if group])
    k = rng.randrange(len(group))
    # In a motion, the other proof is often one of the same part: it may be of the same kind.
    source = file.copy() if len(file.proofs()) > 1 and rng.random() < 0.5 else other
    group[k] = mutation(rng, Proof(group[k]), Proof(rng.choice(source.proofs())))
    return None if group[k] is None else [file]


def straight_rows(starts, ends):
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
        return "point-point", straight_rows([(0, 0, 0), (start, 0, 0)], [(0, 0, 0), (end, 0, 0)])

    passing = two_points(-2, 1)  # they meet at 2/3
    meeting = two_points(-1, 1)  # they meet at 1/2
    resting = two_points(0, 0)
    odd = 2**53 + 1
    return [
        ("negative weight", "point-edge", straight_rows(line, line), ["0 contact 0 0", "w 0 1", "w 1 -1", "w 2 2"]),
        ("zero weights", "point-edge", straight_rows(above, above), ["0 contact 0 0", "w 0 0", "w 1 0", "w 2 0"]),
        ("no weights", "point-edge", straight_rows(above, above), ["0 contact 0 0"]),
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
        ("two signs", "point-edge", straight_rows(around, around), ["0 none", east]),
        ("direction that turns", "edge-edge", straight_rows(*crossing), ["0 none", "d 0 0 1 0 0 -3"]),
        ("zero direction", "edge-edge", straight_rows(*crossing), ["0 none", "d 0 0 0"]),
        ("late", *resting, ["0 contact 1 1", east, *weights]),
        ("no piece", *resting, ["0 contact 1 1", *weights]),
        ("different points", *two_points(1, 1), ["0 contact 0 0", *weights]),
    ]


def read_files(proofs, contents):
    """The files of a file of proofs that holds."""
    files = []
    separation = []
    contents = iter(contents)
    for words in lines_of(proofs)[1:-1]:
        if words[0] == "separation":
            separation = words
        elif words[0] == "file":
            files.append(File(separation, words[1], next(contents), [[]] if words[1] != "mesh" else []))
            separation = []
        elif words[0] == "step":
            files[-1].groups.append([])
            files[-1].labels.append(words)
        elif words[0].isdigit():
            files[-1].groups[-1].append([words])
        else:
            files[-1].groups[-1][-1].append(words)
    return files


def cases_of(file, parts):
    """A case for each query of a query file; some small parts of a motion."""
    if file.kind == "mesh":
        return motion_cases_of(file, parts)
    if is_curved(file.content):
        queries = [[["touchstone-curved", "1"]] + rows for rows in curved_queries(file.content)]
        contents = ["".join(",".join(row) + "\n" for row in rows) for rows in queries]
        return [File(file.separation, file.kind, content, [[[["0"] + proof[0][1:]] + proof[1:]]])
                for content, proof in zip(contents, file.groups[0])]
    count = 2 * CORNERS[file.kind][1]
    rows = [row for row in file.content.split("\n") if row.strip() and not row.strip().startswith("#")]
    cases = []
    for k, proof in enumerate(file.groups[0]):
        content = "".join(re.sub(r"[ \t]", "", row).strip() + "\n" for row in rows[count * k:count * (k + 1)])
        cases.append(File(file.separation, file.kind, content, [[[["0"] + proof[0][1:]] + proof[1:]]]))
    return cases


def motion_cases_of(file, parts):
    """The motion itself if it is small, and parts of it: up to two steps, the elements of up to three of their pairs,
    and all pairs of these elements."""
    motion = check_proofs.Motion(check_proofs.Lines(io.BytesIO(file.content.encode()), "motion"))
    metric, d = (file.separation[1], file.separation[2].encode()) if file.separation else (None, b"0")
    lines = check_proofs.Lines(io.BytesIO(b""), "separation")
    reach = check_proofs.read_number(d, lines)
    steps = []
    for frames in motion.steps():
        steps.append([pair for _, *pair in motion.near_pairs(frames, metric, reach)])
    small = len(file.proofs()) <= 12 and motion.count <= 30 and len(steps) <= 4
    cases = [file] if small else []
    head, frames = file.motion()
    rows = rows_of_vertices(head)
    rng = random.Random(f"{len(file.content)} {len(file.proofs())}")
    for _ in range(parts if steps and any(steps) else 0):
        first = rng.randrange(len(steps))
        last = min(first + rng.randrange(1, 3), len(steps))
        near = [(k, pair) for k in range(first, last) for pair in steps[k]]
        if not near:
            continue
        chosen = set()
        for _, (kind, one, two) in rng.sample(near, min(len(near), rng.randrange(1, 4))):
            chosen |= {(SORTS[kind][0],) + one, (SORTS[kind][1],) + two}
        complete(chosen, motion)
        used = sorted({v for _, _, vertices in chosen for v in vertices})
        names = {v: str(k) for k, v in enumerate(used)}
        new_head = [["touchstone-motion", "1"], ["vertices", str(len(used))]]
        new_numbers = {}
        for sort, number, vertices in sorted(chosen):
            new_numbers[sort, number] = sum(one == sort for one, _ in new_numbers)
            if motion.has_radii:
                new_head.append(["radius", motion.words_of_radii[motion.radii[sort][number]].decode()])
            new_head.append([sort.decode()] + [names[v] for v in vertices])
        new_head += [["fixed", names[v]] for v in used if v in motion.fixed]
        new_head += [["near"] + [names[v] for v in pair] for pair in motion.near if pair <= set(used)]
        for kind, one, two in motion.touching:
            pair = (SORTS[kind][0], one), (SORTS[kind][1], two)
            if set(pair) <= set(new_numbers):
                new_head.append(["touching", list(motion.KINDS)[kind].decode()] + [str(new_numbers[element]) for element in pair])
        new_head += [["group", names[v], str(motion.groups[v])] for v in used if v in motion.groups]
        new_head += [["ignore"] + [str(group) for group in (min(pair), max(pair))] for pair in motion.ignored]
        bodies = sorted({motion.bodies[v][0] for v in used if v in motion.bodies})
        for words in head:
            if words[0] == "body" and int(words[1]) in names:
                new_head.append(["body", names[int(words[1])], str(bodies.index(int(words[2])))] + words[3:])
        kept_rows = bodies + [rows[v] for v in used if v not in motion.bodies]
        groups = []
        for k in range(first, last):
            kept = [proof for proof, (kind, one, two) in zip(file.groups[k], steps[k])
                    if {(SORTS[kind][0],) + one, (SORTS[kind][1],) + two} <= chosen]
            groups.append([[list(line) for line in proof] for proof in kept])
        part = File(file.separation, "mesh", "", groups)
        part.set_motion(new_head, [[frame[row] for row in kept_rows] for frame in frames[first:last + 1]])
        part.renumber()
        cases.append(part)
    return cases


def complete(chosen, motion):
    """Adds what makes the pairs of the chosen elements those of the whole motion: a point that is a corner of an edge
    stays one, an edge of a face has a face, and a point and a wire that another one joins have this one."""
    def add_first(sort, vertices):
        found = [(sort, k, element) for k, element in enumerate(motion.elements[sort]) if set(vertices) <= set(element)]
        chosen.update(found[:1])

    before = 0
    while len(chosen) > before:
        before = len(chosen)
        points = [vertices for sort, _, vertices in chosen if sort == b"point"]
        edges = [vertices for sort, _, vertices in chosen if sort == b"edge"]
        for point in points:
            add_first(b"edge", point)
        for edge in edges:
            add_first(b"face", edge)
        for (point,), edge in itertools.product(points, edges):
            for end in edge if motion.is_wire(edge) else ():
                if motion.is_wire((point, end)):
                    add_first(b"edge", (point, end))


# The sorts of both elements, for the kinds of pairs in their order.
SORTS = [(b"edge", b"edge"), (b"point", b"face"), (b"point", b"edge"), (b"point", b"point"), (b"point", b"edge")]


class Checker:
    """check_proofs.py or a program."""

    SAMPLE = 100  # one of so many mutants has a process of its own too

    def __init__(self, program, many, folder):
        self.program, self.many, self.folder = program, many, folder
        self.process, self.written, self.server, self.count = None, {}, None, 0
        self.environment = dict(os.environ)

    def status(self, proof, contents):
        """0 accepted, 1 or 2 not; anything else is a crash."""
        if not self.program:
            try:
                named = [(io.BytesIO(content.encode()), "file") for content in contents]
                check_proofs.check(io.BytesIO(proof.encode()), "proof", named, allow_empty=True)
                return 0
            except check_proofs.Rejected:
                return 1
            except check_proofs.BadInput:
                return 2
        if self.process != os.getpid():  # each process has its own files
            self.process, self.written, self.server = os.getpid(), {}, None
        paths = [os.path.join(self.folder, f"{self.process}-{i}") for i in range(len(contents) + 1)]
        for path, text in zip(paths, [proof] + contents):
            if self.written.get(path) != text:
                with open(path, "w", newline="") as stream:
                    stream.write(text)
                self.written[path] = text
        if not self.many:
            return self.status_of_process(paths)
        status = self.status_of_many(paths)
        self.count += 1
        if self.count % self.SAMPLE == 0:
            alone = self.status_of_process(paths)
            if alone != status:
                return f"{status}, but {alone} in a process of its own"
        return status

    def status_of_process(self, paths):
        """Of a process for one mutant: a program may stop at the first proof that does not hold."""
        silent = [(os.POSIX_SPAWN_OPEN, stream, os.devnull, os.O_WRONLY, 0) for stream in (1, 2)]
        process = os.posix_spawn(self.program, [self.program, "--allow-empty"] + paths, self.environment, file_actions=silent)
        status = os.waitpid(process, 0)[1]
        return os.WEXITSTATUS(status) if os.WIFEXITED(status) else -os.WTERMSIG(status)

    def status_of_many(self, paths):
        if not self.server:
            self.server = subprocess.Popen([self.many], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.server.stdin.write("\t".join(["--allow-empty"] + paths).encode() + b"\n")
        self.server.stdin.flush()
        answer = self.server.stdout.readline()
        if answer:
            return int(answer)
        server, self.server = self.server, None
        return -abs(server.wait()) or "none"


class Run:
    """What the processes share."""

    cases = []
    rounds = 1
    checker = None
    deadline = None  # of time.monotonic()


def same_kind(rng, file):
    """Another case, of the same kind if there is one."""
    choices = rng.choices(Run.cases, k=20)
    return rng.choice([case for case in choices if case.kind == file.kind] or choices)


def is_true(proofs, contents):
    """Whether all claims are true. Accepted proofs that cannot be read here are false."""
    try:
        return claims(proofs) == truths(proofs, contents)
    except (ValueError, IndexError, StopIteration):
        return False


def try_case(index):
    """The counts, the failures and the accepted mutants of one case."""
    file = Run.cases[index]
    counts = collections.Counter()
    failures, accepted = [], []
    if Run.deadline is not None and time.monotonic() > Run.deadline:
        return counts, failures, accepted
    counts["cases"] = 1
    text = text_of([file])
    if Run.checker.status(text, [file.content]) != 0:
        failures.append(f"case {index}: the original proof is not accepted\n{text}{file.content}")
    if not is_true(text, [file.content]):
        failures.append(f"case {index}: the original proof is accepted, but false\n{text}{file.content}")
    for mutation in MUTATIONS:
        for turn in range(Run.rounds):
            name = f"{index} {mutation.__name__} {turn}"
            rng = random.Random(name)
            files = mutant_of(mutation, rng, file, same_kind(rng, file))
            if files is None:
                continue
            mutant, contents = text_of(files), [changed.content for changed in files]
            if mutant == text and contents == [file.content]:
                continue
            status = Run.checker.status(mutant, contents)
            counts[mutation.__name__, "tried"] += 1
            if status == 0:
                true = is_true(mutant, contents)
                counts[mutation.__name__, "still true" if true else "false"] += 1
                accepted.append(name)
                if not true:
                    failures.append(f"{name}: FALSE ACCEPTANCE\n{mutant}" + "".join(contents))
            elif status in (1, 2):
                counts[mutation.__name__, "rejected"] += 1
            else:
                failures.append(f"{name}: the checker ended with status {status}\n{mutant}" + "".join(contents))
    return counts, failures, accepted


def read_text(path):
    with open(path, newline="") as stream:
        return stream.read()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--checker", help="the program that checks (default: check_proofs.py)")
    parser.add_argument("--many", help="the program of checks.cpp, which checks many mutants (needs --checker)")
    parser.add_argument("--mutants", type=int, default=0, help="about how many (default: one a case and mutation)")
    parser.add_argument("--cases", type=int, default=0, help="at most so many of the given cases (default: all)")
    parser.add_argument("--parts", type=int, default=20, help="parts of each motion (default: 20)")
    parser.add_argument("--jobs", type=int, default=1, help="processes (default: 1)")
    parser.add_argument("--seconds", type=float, default=0, help="begin no case after this time (default: no limit)")
    parser.add_argument("--accepted", help="a file for the names of the accepted mutants")
    parser.add_argument("proofs", nargs="?")
    parser.add_argument("files", nargs="*")
    arguments = parser.parse_args()
    memory = "/dev/shm"
    with tempfile.TemporaryDirectory(dir=memory if os.access(memory, os.W_OK) else None) as folder:
        programs = [program and os.path.abspath(program) for program in (arguments.checker, arguments.many)]
        if arguments.many and not arguments.checker:
            parser.error("--many goes with --checker")
        Run.checker = Checker(*programs, folder)
        return run(arguments)


def run(arguments):
    cases = []
    if arguments.proofs:
        contents = [read_text(path) for path in arguments.files]
        for file in read_files(read_text(arguments.proofs), contents):
            cases += cases_of(file, arguments.parts)
        if 0 < arguments.cases < len(cases):
            cases = random.Random(arguments.cases).sample(cases, arguments.cases)
    for _, status, proof, contents in small_cases.all_cases():
        if status == 0:
            cases += [case for file in read_files(proof, contents) for case in cases_of(file, 0)]
    random.Random(len(cases)).shuffle(cases)  # a run that ends early has seen all sorts
    Run.cases = cases
    # About 3 of 5 mutations apply to a case.
    Run.rounds = max(1, round(arguments.mutants / (len(cases) * len(MUTATIONS) * 0.6)))

    if arguments.seconds > 0:
        Run.deadline = time.monotonic() + arguments.seconds
    counts = collections.Counter()
    failures, accepted = [], []
    for name, kind, rows, lines in forgeries():
        file = File([], kind, rows, [[[line.split() for line in lines]]])
        status = Run.checker.status(text_of([file]), [rows])
        if status not in (1, 2):
            failures.append(f"forged proof, {name}: status {status}")
    if arguments.jobs > 1:
        with multiprocessing.get_context("fork").Pool(arguments.jobs) as pool:
            results = pool.map(try_case, range(len(cases)), chunksize=1)
    else:
        results = map(try_case, range(len(cases)))
    for some_counts, some_failures, some_accepted in results:
        counts += some_counts
        failures += some_failures
        accepted += some_accepted

    done = counts.pop("cases")
    columns = ("tried", "rejected", "still true", "false")
    print(f"{len(forgeries())} forged proofs, {done} of {len(cases)} cases changed")
    print(f"{'mutation':26}" + "".join(f"{column:>12}" for column in columns))
    for name in [mutation.__name__ for mutation in MUTATIONS]:
        print(f"{name:26}" + "".join(f"{counts[name, column]:12}" for column in columns))
    print(f"{'all':26}" + "".join(f"{sum(n for (_, c), n in counts.items() if c == column):12}" for column in columns))
    if arguments.accepted:
        with open(arguments.accepted, "w") as stream:
            stream.writelines(name + "\n" for name in accepted)
    # A mutation that applies to few cases may meet only those that it cannot falsify.
    failures += [f"{m.__name__}: no mutant was rejected" for m in MUTATIONS
                 if done == len(cases) and not counts[m.__name__, "rejected"]
                 and not 0 < counts[m.__name__, "tried"] < 20]
    for failure in failures[:20]:
        print(failure, file=sys.stderr)
    if failures:
        print(f"{len(failures)} failures", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
