"""read_frames.py PROGRAM: VTK's own reader reads back what `simulate --out` writes, and finds what was simulated.

SPDX-License-Identifier: MIT
"""

import json
import math
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


def check_small(program):
    """A few frames, bit for bit: positions, velocities, cells."""
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


def winding_number(loop, at):
    """How often the loop of points, seen from above, goes around a point."""
    angle = 0
    for a, b in zip(loop, loop[1:] + loop[:1]):
        ax, ay, bx, by = a[0] - at[0], a[1] - at[1], b[0] - at[0], b[1] - at[1]
        angle += math.atan2(ax * by - ay * bx, ax * bx + ay * by)
    return round(angle / (2 * math.pi))


def check_ten_seconds(program):
    """All of the hoop: every frame is whole, and what is in them shows that the ball goes through the net."""
    with tempfile.TemporaryDirectory() as folder:
        out, scene_file = Path(folder) / "out", Path(folder) / "scene.json"
        run(program, "hoop", "--scene-out", str(scene_file))
        scene = json.loads(scene_file.read_text())
        told = run(program, "hoop", "--out", str(out))
        check(told.splitlines()[-1].startswith("600 steps, 0 crossings; left out: "), f"the last line is {told.splitlines()[-1]}")
        rim = [wire[0] for wire in scene["wires"]]
        cord = next(cable["particles"] for cable in scene["cables"] if cable.get("closed"))
        middle = next(i for i, p in enumerate(scene["particles"]) if p.get("collides") is False)
        frames = json.loads((out / "frames" / "frames.vtk.series").read_text())["files"]
        check(len(frames) == 301, f"{len(frames)} frames in the series")
        check(len(list((out / "frames").glob("*.vtk"))) == 301, "other files than the series names")
        before, passed, cells = None, {"rim": 0, "cord": 0}, set()
        for number, frame in enumerate(frames):
            check(abs(frame["time"] - number / 30) < 1e-9, f"{frame['name']}: time {frame['time']}")
            mesh = read(out / "frames" / frame["name"])
            check(mesh.GetNumberOfPoints() == len(scene["particles"]), f"{frame['name']}: the number of points")
            cells.add((mesh.GetNumberOfLines(), mesh.GetNumberOfPolys()))
            points = [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]
            velocity = mesh.GetPointData().GetArray("velocity")
            check(velocity.GetNumberOfTuples() == len(points), f"{frame['name']}: the number of velocities")
            check(all(math.isfinite(x) for point in points for x in point), f"{frame['name']}: a place is no number")
            check(all(math.isfinite(x) for i in range(len(points)) for x in velocity.GetTuple(i)),
                  f"{frame['name']}: a velocity is no number")
            now = {"ball": points[middle]}
            for name, loop in (("rim", rim), ("cord", cord)):
                now[name] = sum(points[i][2] for i in loop) / len(loop)
                if before and before["ball"][2] > before[name] and now["ball"][2] <= now[name]:
                    passed[name] += abs(winding_number([points[i] for i in loop], now["ball"]))
            before = now
        check(len(cells) == 1 and min(cells)[0] > 500, f"lines and polygons: {cells}")
        check(passed == {"rim": 1, "cord": 1}, f"the ball fell through: {passed}")
        check(before["ball"][2] < 0.13, f"in the end the ball's middle is at {before['ball']}")
    print(f"VTK read {len(frames)} frames of ten seconds, in which the ball goes through the net")


check_small(sys.argv[1])
check_ten_seconds(sys.argv[1])
