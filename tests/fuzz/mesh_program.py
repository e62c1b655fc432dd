"""`touchstone mesh`, through files, as a program that `touchstone fuzz-steps` asks about whole steps.
SPDX-License-Identifier: MIT"""
import json
import os
import subprocess
import sys
import tempfile


def write_frame(name, step, positions):
    of_faces = {tuple(sorted((face[i - 1], face[i]))) for face in step["faces"] for i in range(3)}
    elements = [("f", step["faces"]), ("l", [e for e in step["edges"] if tuple(sorted(e)) not in of_faces]),
                ("p", [[v] for v in step["points"]])]
    with open(name, "w") as file:
        file.writelines("v %r %r %r\n" % tuple(x) for x in positions)
        for word, rows in elements:
            file.writelines("%s %s\n" % (word, " ".join(str(v + 1) for v in row)) for row in rows)


def first_contact(program, folder, step):
    names = [os.path.join(folder, "frame-%d.obj" % i) for i in range(2)]
    for name, positions in zip(names, (step["x0"], step["x1"])):
        write_frame(name, step, positions)
    options = ["--separation", repr(step["separation"]), "--metric", step["metric"]] if step["separation"] else []
    run = subprocess.run([program, "mesh", "--json", "--threads", "1", *options, *names], stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, text=True)
    if run.returncode not in (0, 1):
        raise RuntimeError(run.stderr)
    found = [json.loads(line) for line in run.stdout.splitlines()][-1]
    return 0 if found.get("at_start") else found.get("toi")


with tempfile.TemporaryDirectory() as scratch:
    for line in sys.stdin:
        print(json.dumps({"first_contact": first_contact(sys.argv[1], scratch, json.loads(line))}), flush=True)
