#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The option --frames says the same in touchstone-check and in the checker that is proved in Coq.

    compare_frames.py --program TOUCHSTONE --checker PROGRAM --proved PROGRAM [--mutants N]

A scene of a plate at rest and two sheets, whose frames are OBJ and binary PLY files, is proved. Both checkers accept
the frames of each part, and say the same of other numbers of files, parts in another order, patterns of all sorts, and
N files of which some bytes or lines have changed. The same arguments give the same mutants.
"""

import argparse
import collections
import hashlib
import os
import random
import struct
import subprocess
import sys
import tempfile

FRAMES = 11


def sheet(at, step):
    """Vertices and faces of two triangles and a polygon."""
    z = at + step / 8
    points = [(0, 0, z), (2, 0, z), (2, 2, z), (0, 2, z), (-0.5, 1, z), (0.1, 5, z), (1, 5, z), (0.3, 6.7, z)]
    return points, [(0, 1, 2, 3, 4), (5, 6, 7)]


def obj(points, faces, more=""):
    lines = ["# a frame"] + ["v " + " ".join(map(repr, point)) for point in points]
    return "\n".join(lines + ["f " + " ".join(f"{v + 1}" for v in face) for face in faces]) + "\n" + more


def ply(points, faces, order, real="double"):
    big = order == "big"
    header = (f"ply\nformat binary_{order}_endian 1.0\ncomment a frame\nelement vertex {len(points)}\n"
              f"property {real} x\nproperty uchar quality\nproperty {real} y\nproperty {real} z\n"
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nelement edge 1\n"
              "property short vertex2\nproperty uint vertex1\nend_header\n")
    mark, letter = ">" if big else "<", real[0]
    body = b"".join(struct.pack(f"{mark}{letter}B{2 * letter}", x, 7, y, z) for x, y, z in points)
    body += b"".join(struct.pack(f"{mark}B{len(face)}i", len(face), *face) for face in faces)
    return header.encode() + body + struct.pack(f"{mark}hI", faces[0][0], faces[0][1])


def write(path, content):
    with open(path, "wb") as stream:
        stream.write(content if isinstance(content, bytes) else content.encode())


class Both:
    def __init__(self, arguments, folder):
        self.programs = [os.path.abspath(arguments.checker), os.path.abspath(arguments.proved)]
        self.folder = folder
        self.counts = collections.Counter()
        self.failures = []

    def run(self, what, *words, expected=None):
        """The status of both, if they are the same."""
        runs = [subprocess.run([program, *words, "proved/proofs.txt", "proved/motion.txt"], capture_output=True,
                               cwd=self.folder, timeout=60, check=False) for program in self.programs]
        statuses = [run.returncode for run in runs]
        self.counts[what, statuses[0]] += 1
        if statuses[0] != statuses[1] or runs[0].stdout != runs[1].stdout or expected not in (None, statuses[0]):
            texts = "\n".join((run.stdout + run.stderr).decode(errors="replace") for run in runs)
            self.failures.append(f"{what} {words}: {statuses}, expected {expected}\n{texts}")
        return statuses[0]


def frames_option(*patterns):
    return [word for pattern in patterns for word in ("--frames", pattern)]


def compare(arguments, folder):
    os.mkdir(os.path.join(folder, "low"))
    os.mkdir(os.path.join(folder, "high.d"))
    plate = [(-9, -9, -1), (9, -9, -1), (0, 9, -1)]
    path = lambda name: os.path.join(folder, name)
    write(path("plate.obj"), obj(plate, [(0, 1, 2)]))
    for step in range(FRAMES):
        write(path(f"low/f-{step}.obj"), obj(*sheet(0, step)))
        write(path(f"high.d/{step}.ply"), ply(*sheet(3, step), "little"))
        write(path(f"high.d/b{step:02}.ply"), ply(*sheet(3, step), "big"))
    made = subprocess.run([os.path.abspath(arguments.program), "mesh", "--parts", "--triangulate", "--prove", "proved",
                           "plate.obj", "low/f-*.obj", "high.d/[0-9]*.ply"], cwd=folder, capture_output=True, check=False)
    if made.returncode != 0:
        raise SystemExit(made.stderr.decode())
    both = Both(arguments, folder)
    good = ["plate.obj", "low/f-*.obj", "high.d/[0-9]*.ply"]
    run = lambda status, *patterns: both.run("frames", "--allow-empty", *frames_option(*patterns), expected=status)
    run(0, *good)
    run(0, *good[:2], "high.d/b*.ply")
    run(0, "pl[!b]te.obj", "*/f-*.ob?", "high.?/[a-b][0-9]?.p\\ly")
    run(0, "./plate.obj", os.path.join(folder, "low", "f-*"), "high.d/b*")
    run(1, "plate.obj", "high.d/b*.ply", "low/f-*.obj")
    run(1, *good[:2])
    run(1, *good, "plate.obj")
    run(1, "plate.obj", "low/f-[0-9].obj", good[2])
    run(1, "plate.obj", "low/f-3.obj", good[2])
    run(1, *good[:2], "high.d/*.ply")
    run(1, "plate.obj")
    run(1, "low/f-*.obj")
    run(2, "plate.obj", "none-*.obj", good[2])
    run(2, "plate.obj", "low/*x", good[2])
    run(2, "plate.obj", "low*", good[2])
    run(2, "plate.obj", "lo[/f-*.obj", good[2])
    both.run("words", "--frames", "plate.obj", "--allow-empty", expected=1)
    both.run("words", "--frames", expected=2)
    # One other bit, and elements that the motion has not.
    for name, content in (("low/f-3.obj", obj(*sheet(0, 3), "l 2 4\n")), ("low/f-3.obj", obj(*sheet(0, 3), "f 1 2 7\n")),
                          ("low/f-3.obj", obj(*sheet(0, 3)).replace("0.1", "0.10000000000000002")),
                          ("high.d/3.ply", ply([(x, y, z + 2**-51) for x, y, z in sheet(3, 3)[0]], sheet(3, 3)[1], "little")),
                          ("high.d/3.ply", ply(*sheet(3, 3), "big", "float"))):
        with open(path(name), "rb") as stream:
            before = stream.read()
        write(path(name), content)
        run(1, *good)
        write(path(name), before)
    run(0, *good)
    extra_elements(both, path, good)
    run(0, *good)
    files = ["low/f-1.obj", "high.d/1.ply", "high.d/b02.ply", "plate.obj"]
    rng = random.Random(7)
    for _ in range(arguments.mutants):
        name = rng.choice(files)
        with open(path(name), "rb") as stream:
            before = stream.read()
        write(path(name), mutant(rng, before))
        both.run("mutant", "--allow-empty", *frames_option("plate.obj", "low/f-*.obj", rng.choice(
            ["high.d/[0-9]*.ply", "high.d/b*.ply"])))
        write(path(name), before)
    return both


def extra_elements(both, path, good):
    """Motions with an element that the files have not, or a line `touching` or groups more, with their own digests."""
    texts = {}
    for name in ("motion.txt", "proofs.txt"):
        with open(path("proved/" + name), "rb") as stream:
            texts[name] = stream.read()
    for lines, status in ((b"edge 0 9\n", 1), (b"face 0 1 9\nedge 0 9\nedge 1 9\n", 1), (b"edge 1 0\n", 0),
                          (b"touching vertex-face 0 1\ntouching vertex-face 3 1\n", 0),
                          (b"group 0 3\ngroup 1 3\ngroup 3 3\ngroup 7 4\nignore 4 3\nignore 3 5\n", 0)):
        motion = texts["motion.txt"].replace(b"frame\n", lines + b"frame\n", 1)
        old = hashlib.sha256(texts["motion.txt"]).hexdigest().encode()
        new = hashlib.sha256(motion).hexdigest().encode()
        assert old in texts["proofs.txt"]
        for digest in (new, b"-"):
            write(path("proved/motion.txt"), motion)
            write(path("proved/proofs.txt"), texts["proofs.txt"].replace(old, digest))
            both.run("extra", "--allow-empty", *frames_option(*good), expected=status)
    for name, text in texts.items():
        write(path("proved/" + name), text)


WORDS = [b"f 1 2 3\n", b"f -1 -2 -3\n", b"f 1/2/3 2//4 3\n", b"l 1 2\n", b"p 1\n", b"v 1 2 3 4\n", b"v 1 2\n", b"f 1 2\n",
         b"vn 0 0 1\n", b"fo 1\n", b"\t# x\n", b"\n", b"\r", b"\t", b"e0", b"0x1p1", b"-0", b".", b"\0", b"\\", b"l 1\n", b"p\n",
         b"comment y\n", b"property float w\n", b"property list int int x\n", b"element vertex 1\n", b"element box 0\n",
         b"obj_info\n", b"end_header\n", b"\xef\xbb\xbf", b"inf", b"nan", b"1" * 30, b"#", b"float", b"uint", b"int8"]


def mutant(rng, content):
    content = bytearray(content)
    head = content.find(b"end_header")  # most changes are before the numbers
    for _ in range(rng.choice([1, 1, 1, 2])):
        at = rng.randrange(len(content) if head < 0 or rng.random() < 0.4 else head)
        change = rng.randrange(6)
        if change == 0:
            content[at] ^= 1 << rng.randrange(8)
        elif change == 1:
            content[at:at + rng.choice([1, 1, 2, 8])] = b""
        elif change == 2:
            content[at:at] = rng.choice(WORDS)
        elif change == 3:
            content[at:at + rng.randrange(1, 5)] = rng.choice(WORDS)
        else:
            lines = bytes(content).split(b"\n")
            i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
            if change == 4:
                lines.insert(i, rng.choice([lines[j], rng.choice(WORDS).strip()]))
            else:
                del lines[i]
            content = bytearray(b"\n".join(lines))
    return bytes(content)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, help="touchstone")
    parser.add_argument("--checker", required=True, help="touchstone-check")
    parser.add_argument("--proved", required=True, help="touchstone-check-proved")
    parser.add_argument("--mutants", type=int, default=1000, help="how many (default: 1000)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        both = compare(arguments, folder)
    for (what, status), count in sorted(both.counts.items()):
        print(f"{what}, status {status}: {count}")
    both.failures += [f"no mutant with status {status}" for status in range(3) if not both.counts["mutant", status]]
    for failure in both.failures[:10]:
        print(failure, file=sys.stderr)
    print(f"{len(both.failures)} differences")
    return 1 if both.failures else 0


if __name__ == "__main__":
    sys.exit(main())
