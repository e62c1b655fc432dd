"""Bodies that turn and corners on curves. SPDX-License-Identifier: MIT"""
import csv
import os
import subprocess
import warnings
from pathlib import Path

import numpy as np
import pytest
import queries
import touchstone as ts
from touchstone import CurvedQueries, OnBody, OnCurves

QUERY_FILES = Path(__file__).parents[2] / "src/cli/queries"
FIRST = {"edge-edge": 2, "vertex-face": 1, "point-edge": 1, "point-point": 1}


@pytest.mark.parametrize("kind", queries.KINDS)
def test_straight_motion_as_curves_has_the_same_answers(kind):
    start, end = queries.both(kind, 400)
    points = np.stack([start, end], 2)
    cut = FIRST[kind]
    curved = CurvedQueries(kind, OnCurves(points[:, :cut]), OnCurves(points[:, cut:]))
    assert len(curved) == 400 and curved.kind == kind
    straight = ts.solve(kind, start, end)
    assert queries.same(curved.solve(), straight)
    assert queries.same(curved.solve(threads=3, t_max=0.5), ts.solve(kind, start, end, t_max=0.5))
    assert np.array_equal(curved.solve(wanted="contact").contact, straight.contact)
    near = ts.solve(kind, start, end, separation=0.25)
    assert queries.same(curved.solve(separation=np.full(400, 0.25)), near)
    some = slice(390, 400)
    few = CurvedQueries(kind, OnCurves(points[some, :cut]), OnCurves(points[some, cut:]))
    times = ts.contact_times(kind, start[some], end[some])
    assert [[(str(a), str(b)) for a, b in t] for t in few.contact_times(threads=2)] == \
        [[(str(a), str(b)) for a, b in t] for t in times]
    for metric in ("euclidean", "max"):
        distances = ts.distance(kind, start[some], end[some], 0.5, metric)
        assert np.array_equal(few.distance(0.5, metric).value, distances.value)
    for asked in ({}, {"separation": 0.25, "t_max": 0.75}):
        normals = ts.contact_normal(kind, start[some], end[some], **asked)
        assert np.allclose(few.contact_normal(**asked), normals, atol=2**-48, rtol=0, equal_nan=True)
        assert np.array_equal(few.contact_normal(threads=3, **asked), few.contact_normal(**asked), equal_nan=True)
    one = CurvedQueries(kind, OnCurves(points[0, :cut]), OnCurves(points[0, cut:]))
    assert one.distance(1).value == ts.distance(kind, start[0], end[0], 1).value
    assert one.solve().contact == straight.contact[0] == one.solve(wanted="contact").contact


def test_single_rows_count_for_all():
    tips = np.array([[[1., 0, 0]], [[2, 0, 0]], [[.5, 0, 0]]])
    wall = OnBody([[0, -4, 0], [0, 4, 0]], p0=[.25, 0, 0])
    many = CurvedQueries("point-edge", OnBody(tips, q1=[1, 0, 0, 1]), wall)
    answers = many.solve()
    for i, tip in enumerate(tips):
        one = CurvedQueries("point-edge", OnBody(tip, q1=[1, 0, 0, 1]), wall).solve()
        assert (one.contact, one.toi) == (answers.contact[i], answers.toi[i])
    assert answers.contact.tolist() == [True, True, True]
    # The longer the rod is, the farther it turns until its tip is at x = 1/4.
    assert answers.toi[1] > answers.toi[0] > answers.toi[2]


def rows_of(path):
    """The queries of a file: each a list of rows of words."""
    found = []
    for row in csv.reader(line for line in path.read_text().splitlines() if line and not line.startswith("#")):
        if row[0] == "query":
            found.append([])
        if found:
            found[-1].append(row)
    return found


def number(text):
    return float.fromhex(text) if "x" in text else float(text)


def element(corners, motions):
    """An element of a file, or None for one that the module does not have: corners that move in different ways."""
    if all(row[0] == "body" and row[1] == corners[0][1] for row in corners):
        motion = motions[corners[0][1]]
        return OnBody([[number(x) for x in row[2:]] for row in corners], motion[:4], motion[4:8], motion[8:11],
                      motion[11:])
    if all(row[0] == "curve" and len(row) == len(corners[0]) for row in corners):
        return OnCurves([np.array([number(x) for x in row[1:]]).reshape(-1, 3) for row in corners])
    return None


def test_the_answers_of_the_program(tmp_path):
    program = os.environ["TOUCHSTONE_PROGRAM"]
    if not program:
        pytest.skip("the program is not built")
    compared = 0
    for kind in queries.KINDS:
        for path in sorted((QUERY_FILES / kind).glob("curved_*.csv")):
            out = tmp_path / "answers.csv"
            subprocess.run([program, "solve", "--numbers", "hex", "--kind", kind, "--out", out, path], check=True,
                           capture_output=True)
            lines = list(csv.DictReader(out.open()))
            found = rows_of(path)
            assert len(found) == len(lines)
            for rows, line in zip(found, lines):
                motions = {row[1]: [number(x) for x in row[2:]] for row in rows if row[0] == "motion"}
                corners = [row for row in rows if row[0] in ("body", "curve")]
                both = element(corners[:FIRST[kind]], motions), element(corners[FIRST[kind]:], motions)
                if None in both:
                    continue
                answer = CurvedQueries(kind, *both).solve()
                assert answer.contact == (line["contact"] == "1") and str(answer.level) == line["level"], path
                if answer.contact:
                    assert (answer.toi, answer.toi_upper) == (number(line["toi"]), number(line["toi_upper"]))
                    assert (str(answer.nature), str(answer.feature_a), str(answer.feature_b)) == \
                        (line["nature"], line["feature_a"], line["feature_b"])
                compared += 1
    assert compared > 100


def test_what_is_wrong_is_named():
    point, edge = OnBody([[0, 0, 0]]), OnBody([[1, 0, 0], [2, 0, 0]])
    for kind, first, second, error, words in (
        ("point-edge", point, [[0, 0, 0]], TypeError, "second is of type list"),
        ("point-edges", point, edge, ValueError, "kind is"),
        ("point-edge", edge, point, ValueError, "first.corners has the shape"),
        ("point-edge", OnBody([[0, 0, 0]], q0=[1, 0, 0]), edge, ValueError, "first.q0 has the shape"),
        ("point-edge", OnBody([[0, 0, 0]], p1=["a", 0, 0]), edge, TypeError, "first.p1"),
        ("point-edge", OnCurves([[0, 0, 0]]), edge, ValueError, "first.control_points has the shape"),
        ("point-edge", OnCurves(np.zeros((1, 5, 3))), edge, ValueError, "1 to 4 control points"),
        ("point-edge", OnBody(np.zeros((3, 1, 3))), OnBody(np.zeros((2, 2, 3))), ValueError,
         "first.corners has 3 rows and second.corners has 2"),
    ):
        with pytest.raises(error, match=words):
            CurvedQueries(kind, first, second)
    opposite = np.array([[1., 0, 0, 0], [-2, 0, 0, 0]])
    with pytest.warns(UserWarning), pytest.raises(ValueError, match="row 1: .*q1"):
        CurvedQueries("point-edge", OnBody([[0, 0, 0]], q1=opposite), edge).solve()
    with pytest.raises(ValueError, match="row 0"):
        CurvedQueries("point-point", OnBody([[[np.nan, 0, 0]]]), point).solve(wanted="contact").contact
    with pytest.raises(ValueError, match="t_max"):
        CurvedQueries("point-point", point, point).solve(t_max=2)


WALL = OnBody([[-2, -.5, -1], [2, -.5, -1], [0, -.5, 2]])
TURN = np.array([np.cos(.05), 0, 0, np.sin(.05)])


def test_a_longer_turn_is_told_once_and_shortened_on_demand():
    signs = np.array([1., -1, 1, -1, -1])
    tips = OnBody([[1, 0, 0]], q1=signs[:, None] * TURN)
    with pytest.warns(UserWarning, match=r"3 of 5 queries have .* first in row 1: q0 . q1 < 0") as told:
        longer = CurvedQueries("vertex-face", tips, WALL)
    assert len(told) == 1 and told[0].filename == __file__
    assert longer.solve(wanted="contact").contact.tolist() == (signs < 0).tolist()
    with pytest.warns(UserWarning, match="1 of 1 queries has a body .* shorter_turn=True"):
        CurvedQueries("vertex-face", OnBody([[1, 0, 0]], q1=-TURN), WALL)
    with pytest.warns(UserWarning, match="2 of 2 queries"):  # of either element
        CurvedQueries("point-point", OnBody([[1, 0, 0]]), OnBody(np.ones((2, 1, 3)), q1=-TURN))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        shorter = CurvedQueries("vertex-face", tips, WALL, shorter_turn=True)
        assert not shorter.solve(wanted="contact").contact.any()
        assert not CurvedQueries("vertex-face", OnBody([[1, 0, 0]], q1=TURN), WALL).solve(wanted="contact").contact
        # As it is given, a turn to the opposite quaternion has no meaning.
        still = CurvedQueries("vertex-face", OnBody([[1, 0, 0]], q1=[-1, 0, 0, 0]), WALL, shorter_turn=True)
        assert not still.solve(wanted="contact").contact
    with pytest.raises(TypeError, match="shorter_turn is of type int"):
        CurvedQueries("vertex-face", tips, WALL, shorter_turn=1)
