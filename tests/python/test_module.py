"""The module as a whole: examples, Ctrl-C, memory, and the program's answers. SPDX-License-Identifier: MIT"""
import csv
import doctest
import importlib
import importlib.util
import inspect
import os
import pkgutil
import re
import signal
import subprocess
import sys
import time
import typing
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import queries
import touchstone as ts

QUERY_FILES = Path(__file__).parents[2] / "src/cli/queries"


def test_every_example_in_a_docstring():
    attempted = 0
    names = [f"touchstone.{m.name}" for m in pkgutil.iter_modules(ts.__path__)]
    if importlib.util.find_spec("torch") is None:
        names.remove("touchstone.torch")
    for module in [ts] + [importlib.import_module(name) for name in names]:
        result = doctest.testmod(module)
        assert result.failed == 0
        attempted += result.attempted
    assert attempted > 40


def test_every_function_has_help_with_an_example():
    for name in ts.__all__:
        thing = getattr(ts, name)
        assert inspect.getdoc(thing), name
        if inspect.isfunction(thing):
            assert ">>>" in thing.__doc__ and "aises" in thing.__doc__ or "errors are those of" in thing.__doc__, name
            assert thing.__annotations__["return"], name


def test_the_stub_names_what_the_module_has():
    stub = (Path(ts.__file__).parent / "_core.pyi").read_text()
    module = importlib.import_module("touchstone._core")
    for name in dir(module):
        if not name.startswith("_"):
            assert re.search(rf"^(class|def) {name}\b", stub, re.M), name
    for name in re.findall(r"^(?:class|def) (\w+)", stub, re.M):
        assert hasattr(module, name), name
    for cls, body in re.findall(r"^class (\w+):\n((?:    .*\n)+)", stub, re.M):
        named = set(re.findall(r"^    (?:def )?(\w+)", body, re.M))
        there = {a for a in dir(getattr(module, cls)) if not a.startswith("_")}
        assert there == {a for a in named if not a.startswith("_")}, cls


def test_the_types_are_right():
    mypy = pytest.importorskip("mypy.api", reason="mypy is not installed")
    package = Path(ts.__file__).parent
    words, errors, status = mypy.run(["--cache-dir", os.devnull, str(package)])
    assert status == 0, words + errors


def test_types_tell_one_answer_from_many(tmp_path):
    mypy = pytest.importorskip("mypy.api", reason="mypy is not installed")
    (tmp_path / "user.py").write_text(
        "import numpy as np\nimport touchstone\n"
        "point = [[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]\n"
        "reveal_type(touchstone.solve('point-point', point, point))\n"
        "reveal_type(touchstone.solve('point-point', [point], [point], threads=2))\n"
        "reveal_type(touchstone.solve('point-point', np.array(point), np.array(point)))\n")
    files = [str(Path(ts.__file__).parent), str(tmp_path / "user.py")]
    words, errors, status = mypy.run(["--cache-dir", os.devnull, *files])
    assert status == 0, words + errors
    assert re.findall(r'Revealed type is "(.*)"', words) == [
        "touchstone._core.Answer", "touchstone._core.Answers",
        "Union[touchstone._core.Answers, touchstone._core.Answer]"]


def test_names_are_those_of_the_library():
    header = (Path(__file__).parents[2] / "include/touchstone/answer.hpp").read_text()
    for enumeration in (ts.Nature, ts.Feature, ts.Level, ts.Trend):
        body = re.search(rf"enum class {enumeration.__name__} : std::uint8_t {{(.*?)}};", header, re.S).group(1)
        assert re.findall(r"^  (\w+)", body, re.M) == [member.name for member in enumeration]


def hexfloat(x):
    """As C's %a writes it."""
    mantissa, exponent = float(x).hex().split("p")
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return f"{'0x0' if x == 0 else mantissa}p{exponent}"


def rows_of(path, kind):
    """The corners of the queries of a file, as fractions."""
    lines = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    numbers = [[Fraction(int(row[2 * k]), int(row[2 * k + 1])) for k in range(3)] for row in csv.reader(lines)]
    size = 2 * queries.KINDS[kind]
    return [(numbers[i:i + size // 2], numbers[i + size // 2:i + size]) for i in range(0, len(numbers), size)]


@pytest.mark.parametrize("kind, names", [("edge-edge", ["EE", "edge_edge"]), ("vertex-face", ["PT", "point-triangle"])])
def test_kinds_have_the_names_of_others(kind, names):
    start, end = np.zeros((1, 4, 3)), np.zeros((1, 4, 3))
    for name in names:
        assert [repr(a) for a in ts.solve(name, start, end)] == [repr(a) for a in ts.solve(kind, start, end)]
    with pytest.raises(ValueError, match="kind is 'edge-face'; it must be one of 'edge-edge'"):
        ts.solve("edge-face", start, end)
    with pytest.raises(ValueError, match="face-vertex is called vertex-face, and its corners come in the order v f0"):
        ts.solve("face_vertex", start, end)


def test_the_answers_of_the_program(tmp_path):
    program = os.environ["TOUCHSTONE_PROGRAM"]
    if not program:
        pytest.skip("the program is not built")
    compared = 0
    for kind in queries.KINDS:
        for path in sorted((QUERY_FILES / kind).glob("*.csv")):
            if path.name.startswith("curved_"):
                continue  # test_curved.py has these
            out = tmp_path / "answers.csv"
            subprocess.run([program, "solve", "--numbers", "hex", "--kind", kind, "--out", out, path], check=True,
                           capture_output=True)
            header, *lines = out.read_bytes().decode().splitlines(keepends=True)
            assert header == "file,query,contact,toi,toi_upper,nature,feature_a,feature_b,level\n"
            rows = rows_of(path, kind)
            assert len(rows) == len(lines)
            doubles = [i for i, row in enumerate(rows) if all(float(x) == x for end in row for c in end for x in c)]
            start, end = (np.array([[[float(x) for x in c] for c in rows[i][k]] for i in doubles]) for k in (0, 1))
            if not doubles:
                continue
            answers = ts.solve(kind, start, end)
            for i, a in zip(doubles, answers):
                text = "0,,,,,"
                if a.contact:
                    text = f"1,{hexfloat(a.toi)},{hexfloat(a.toi_upper)},{a.nature},{a.feature_a},{a.feature_b}"
                text += f",{a.level}\n"
                assert lines[i] == f"{lines[i].split(',')[0]},{i},{text}"
                compared += 1
    assert compared > 500


def interrupted(statement):
    """Runs a statement in a Python of its own, and interrupts it."""
    script = f"""
import numpy as np, sys, touchstone as ts
sys.path.insert(0, {str(Path(__file__).parent)!r})
import queries, test_meshes
start, end = queries.lattice("edge-edge", 400000)
faces, x0, x1 = test_meshes.cloud(40000)
mesh = ts.Mesh(len(x0), faces)
print("ready", flush=True)
try:
    while True:
        {statement}
except KeyboardInterrupt:
    print("heard", flush=True)
"""
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout.readline() == "ready\n"
        time.sleep(0.2)
        child.send_signal(signal.SIGINT)
        assert child.stdout.readline() == "heard\n"
        assert child.wait(60) == 0


@pytest.mark.parametrize("statement", [
    "ts.solve('edge-edge', start, end, method='oracle', threads=2)",
    "ts.contact_times('edge-edge', start, end, threads=1)", "ts.contact_times('edge-edge', start, end, threads=2)",
    "ts.all_contacts(mesh, x0, x0 + 1e3 * (x1 - x0), threads=2)", "ts.intersections(mesh, x0, threads=2)",
    "ts.prove('edge-edge', start, end, threads=2)", "ts.fuzz(lambda *query: False, 10**9)"
])
def test_ctrl_c_is_heard(statement):
    interrupted(statement)


def resident():
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="there is no /proc/self/statm")
def test_a_million_calls_leave_no_memory_behind():
    start, end = queries.lattice("vertex-face", 40)
    mesh = ts.Mesh(4, [[0, 1, 2]])
    wrong = np.full((4, 3), np.nan)
    curved = ts.CurvedQueries("vertex-face", ts.OnBody(start[:, :1], q1=[1, 0, 0, 1]), ts.OnBody(start[:, 1:]))

    def calls(count):
        for i in range(count):
            ts.solve("vertex-face", start[i % 40], end[i % 40])
        for _ in range(count // 50_000):
            ts.fuzz(lambda *query: True, 50).findings[0].start
        for _ in range(count // 1000):
            answers = ts.solve("vertex-face", start, end, separation=0.25)
            answers.toi, answers.weights_a, answers[3].nature
            ts.solve("vertex-face", start, end, wanted="contact").contact
            ts.distance("vertex-face", start).value
            ts.first_contact(mesh, start[0], end[0]).earliest.answers.toi
            ts.free_step(mesh, start[0], end[0]).positions
            ts.contact_times("vertex-face", start[1], end[1])
            curved.solve().toi, curved.prove().answers.toi
            for argument in (wrong, [[1]], "x"):
                try:
                    ts.solve("vertex-face", argument, wrong)
                except (ValueError, TypeError):
                    pass

    calls(100_000)
    before = resident()
    calls(1_000_000)
    assert resident() - before < 2**20, "bytes are left behind"


def test_names_are_those_of_the_library():
    kinds = (ts._queries.Kind, ts._queries.Metric, ts._queries.Method, ts._queries.Wanted)
    for literal, name in zip(kinds, ("Kind", "Metric", "Method", "Wanted")):
        assert typing.get_args(literal) == ts._core._names[name]
    for enumeration in (ts.Nature, ts.Trend, ts.Feature, ts.Level):
        names = tuple("" if member.name == "none" else member.name for member in enumeration)
        assert names == ts._core._names[enumeration.__name__]
        assert [int(member) for member in enumeration] == list(range(len(names)))
