"""read_frames.py PROGRAM: VTK's own reader reads back what `simulate --out` writes, and finds what was simulated.

SPDX-License-Identifier: MIT
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOLegacy import vtkPolyDataReader

STEPS = 40  # the ball is in the net by then
EVERY = 8


def check(condition, message):
    if not condition:
        sys.exit(f"wrong: {message}")


def run(program, *arguments):
    done = subprocess.run([program, "simulate", *arguments], capture_output=True, text=True)
    check(done.returncode == 0, f"simulate {arguments} ended with {done.returncode}: {done.stderr}")
    return done.stdout


def read(path):
    reader = vtkPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    check(reader.GetErrorCode() == 0, f"{path.name}: error {reader.GetErrorCode()}")
    return reader.GetOutput()


def main(program):
    explained = run(program, "hoop", "--size", "200", "--explain")
    edges = int(re.search(r"(\d+) edges", explained).group(1))
    faces = int(re.search(r"(\d+) faces", explained).group(1))
    with tempfile.TemporaryDirectory() as folder:
        out, checkpoint = Path(folder) / "out", Path(folder) / "checkpoint.json"
        run(program, "hoop", "--size", "200", "--steps", str(STEPS), "--frame-every", str(EVERY), "--out", str(out),
            "--checkpoint", str(checkpoint))
        state = json.loads(checkpoint.read_text())
        scene = json.loads(state["scene"])
        particles = len(scene["particles"])

        series = json.loads((out / "frames" / "frames.vtk.series").read_text())
        check(series["file-series-version"] == "1.0", "the version of the series")
        frames = series["files"]
        check(len(frames) == 1 + STEPS // EVERY, f"{len(frames)} frames in the series")
        written = sorted(path.name for path in (out / "frames").glob("*.vtk"))
        check([frame["name"] for frame in frames] == written, "the series names other files than were written")
        for number, frame in enumerate(frames):
            check(abs(frame["time"] - number * EVERY / 60) < 1e-12, f"{frame['name']}: time {frame['time']}")
            mesh = read(out / "frames" / frame["name"])
            check(mesh.GetNumberOfPoints() == particles, f"{frame['name']}: {mesh.GetNumberOfPoints()} points")
            check(mesh.GetNumberOfLines() == edges, f"{frame['name']}: {mesh.GetNumberOfLines()} lines")
            check(mesh.GetNumberOfPolys() == faces, f"{frame['name']}: {mesh.GetNumberOfPolys()} polygons")
            check(mesh.GetNumberOfCells() == edges + faces, f"{frame['name']}: {mesh.GetNumberOfCells()} cells")
            velocity = mesh.GetPointData().GetArray("velocity")
            check(velocity is not None and velocity.GetNumberOfComponents() == 3, f"{frame['name']}: no velocities")
            check(velocity.GetNumberOfTuples() == particles, f"{frame['name']}: {velocity.GetNumberOfTuples()} of them")

        # Positions: the first frame is the scene, the last one the checkpoint, to the last bit.
        first, last = read(out / "frames" / frames[0]["name"]), read(out / "frames" / frames[-1]["name"])
        place = [float.fromhex(x) for x in state["q"]]
        speed = [float.fromhex(x) for x in state["v"]]
        moved = 0
        for i in range(particles):
            check(list(first.GetPoint(i)) == scene["particles"][i]["position"], f"particle {i} at the start")
            check(list(last.GetPoint(i)) == place[3 * i:3 * i + 3], f"particle {i} at the end")
            check(list(last.GetPointData().GetArray("velocity").GetTuple(i)) == speed[3 * i:3 * i + 3],
                  f"the velocity of particle {i} at the end")
            moved += first.GetPoint(i) != last.GetPoint(i)
        check(moved > particles // 2, f"only {moved} of {particles} particles have moved")
        # Cells join the particles that the scene joins.
        springs = {frozenset(spring["particles"]) for spring in scene["springs"] if spring.get("collides", True)}
        lines = {frozenset(last.GetCell(i).GetPointId(k) for k in range(2)) for i in range(edges)}
        check(springs <= lines, "springs that are no lines")
        polygons = {frozenset(last.GetCell(edges + i).GetPointId(k) for k in range(3)) for i in range(faces)}
        check(polygons == {frozenset(face) for face in scene["faces"]}, "other polygons than the scene's faces")
    print(f"VTK {vtkVersion.GetVTKVersion()} read {len(frames)} frames of {particles} points, {edges} lines and {faces} "
          "polygons")


main(sys.argv[1])
