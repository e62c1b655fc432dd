#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The three checkers say the same about small, forged, flipped and changed proofs.

    compare_checkers.py --checker PROGRAM [--many PROGRAM] --proved PROGRAM [--many-proved PROGRAM] [--mutants N]
      PROOFS FILE...

They are touchstone-check, the checker that is proved in Coq, and check_proofs.py. A process for each mutant costs more
than the checks, so --many names the program of ../proofs/checks.cpp, and --many-proved that of checks.ml: the first two
programs get one mutant of a hundred then. The exit statuses of all must be equal, but where several reasons apply,
check_proofs.py may decide by another one. An accepted mutant must be true, too: exact_truth.py decides it without a
proof. The given proofs must hold; of a motion, small parts are taken. The verdict of each one's first proof is flipped:
a contact becomes none, and none becomes a contact. No checker accepts a flipped verdict. Then the mutations of
mutate_proofs.py change about N of the given proofs. The same arguments give the same mutants.
"""

import argparse
import collections
import os
import random
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "proofs"))
import mutate_proofs  # noqa: E402
import small_cases  # noqa: E402


def flipped(file):
    """The case with the other verdict, in a few ways that have the right form."""
    group = next(k for k, proofs in enumerate(file.groups) if proofs)
    (number, *verdict), *rest = file.groups[group][0]
    pieces = [line for line in rest if line[0] in ("n", "d")]
    weights = [line for line in rest if line[0] == "w"]
    if verdict[0] == "contact":
        variants = [[[number, "none"]] + (pieces or [["d", "1", "0", "0"]])]
        variants += [[[number, "none"], ["d"] + [str(c) for c in n]] for n in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    else:
        corners = mutate_proofs.CORNERS[file.kind][1] if file.kind in mutate_proofs.CORNERS else 4
        weights = [["w", str(i), "1"] for i in range(corners)]
        pair = [weights[0], weights[-1]]
        half, after = "0x1p-1", "0x1.0000000000001p-1"
        line = ["root", "-0x1.00000000000008p-1", "1"]
        variants = [[[number, "contact", "0", "0"]] + weights, [[number, "contact", "0", "0"]] + pair,
                    [[number, "contact", "1", "1"]] + pieces + weights,
                    [[number, "contact", half, after]] + pieces + [line] + weights,
                    [[number, "contact", half, after]] + pieces + [line] + pair]
    for lines in variants:
        other = file.copy()
        other.groups[group][0] = [list(line) for line in lines]
        yield other


class Comparison:
    def __init__(self, arguments, folder):
        self.checkers = {"check_proofs.py": mutate_proofs.Checker(None, None, folder)}
        for name, programs in (("touchstone-check", (arguments.checker, arguments.many)),
                               ("the proved checker", (arguments.proved, arguments.many_proved))):
            place = os.path.join(folder, str(len(self.checkers)))
            os.mkdir(place)
            programs = [program and os.path.abspath(program) for program in programs]
            self.checkers[name] = mutate_proofs.Checker(*programs, place)
        self.counts = collections.Counter()
        self.failures = []

    def run(self, what, proof, contents):
        """The status of all, if they are the same."""
        statuses = {name: checker.status(proof, contents) for name, checker in self.checkers.items()}
        status = statuses["touchstone-check"]
        self.counts[what.split()[0], status] += 1
        page = statuses["check_proofs.py"]
        if statuses["the proved checker"] != status or (page != status and not {page, status} <= {1, 2}):
            text = ", ".join(f"{name} with {status}" for name, status in statuses.items())
            self.failures.append(f"{what}: they end: {text}\n{proof}" + "".join(contents))
        return status

    def case(self, what, file, must_fail=False):
        proof = mutate_proofs.text_of([file])
        status = self.run(what, proof, [file.content])
        if status == 0 and (must_fail or not mutate_proofs.is_true(proof, [file.content])):
            self.failures.append(f"{what}: FALSE ACCEPTANCE\n{proof}{file.content}")
        return status


def compare(arguments, folder):
    comparison = Comparison(arguments, folder)
    for name, _, proof, contents in small_cases.all_cases():
        comparison.run(f"small {name}", proof, contents)
    for name, kind, rows, lines in mutate_proofs.forgeries():
        proofs = [[[line.split() for line in lines]]]
        comparison.case(f"forged {name}", mutate_proofs.File([], kind, rows, proofs), True)
    cases = []
    contents = [mutate_proofs.read_text(path) for path in arguments.files]
    for file in mutate_proofs.read_files(mutate_proofs.read_text(arguments.proofs), contents):
        cases += mutate_proofs.cases_of(file, 40)
    rng = random.Random(len(cases))
    rng.shuffle(cases)
    mutate_proofs.Run.cases = cases
    for index, file in enumerate(cases[:arguments.mutants // 6]):
        if comparison.case(f"given {index}", file) != 0:
            comparison.failures.append(f"given {index}: not accepted")
        for other in flipped(file) if file.proofs() else ():
            comparison.case(f"flipped {index}", other, True)
    done = 0
    while done < arguments.mutants:
        index, mutation = rng.randrange(len(cases)), rng.choice(mutate_proofs.MUTATIONS)
        file = cases[index]
        files = mutate_proofs.mutant_of(mutation, rng, file, mutate_proofs.same_kind(rng, file))
        if files is None:
            continue
        done += 1
        mutant, texts = mutate_proofs.text_of(files), [changed.content for changed in files]
        name = f"mutant {mutation.__name__} of {index}"
        if comparison.run(name, mutant, texts) == 0 and not mutate_proofs.is_true(mutant, texts):
            comparison.failures.append(f"{name}: FALSE ACCEPTANCE\n{mutant}" + "".join(texts))
    return comparison


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--checker", required=True, help="touchstone-check")
    parser.add_argument("--many", help="the program of ../proofs/checks.cpp")
    parser.add_argument("--proved", required=True, help="touchstone-check-proved")
    parser.add_argument("--many-proved", help="the program of checks.ml")
    parser.add_argument("--mutants", type=int, default=1000, help="how many (default: 1000)")
    parser.add_argument("proofs")
    parser.add_argument("files", nargs="+")
    arguments = parser.parse_args()
    memory = "/dev/shm"
    with tempfile.TemporaryDirectory(dir=memory if os.access(memory, os.W_OK) else None) as folder:
        comparison = compare(arguments, folder)
    for sort in ("small", "forged", "given", "flipped", "mutant"):
        by_status = ", ".join(f"{name} {comparison.counts[sort, key]:,}" for name, key in (
            ("accepted", 0), ("rejected", 1), ("errors", 2)))
        print(f"{sort:8} {by_status}")
    # Each sort of outcome was met, so that no comparison is about nothing.
    met = [("small", 0), ("small", 1), ("small", 2), ("forged", 1), ("given", 0), ("flipped", 1), ("mutant", 0),
           ("mutant", 1), ("mutant", 2)]
    comparison.failures += [f"{sort}: no status {status}" for sort, status in met
                            if not comparison.counts[sort, status]]
    for failure in comparison.failures[:10]:
        print(failure, file=sys.stderr)
    print(f"{len(comparison.failures)} differences")
    return 1 if comparison.failures else 0


if __name__ == "__main__":
    sys.exit(main())
