"""Wrong arguments of public functions and methods: a line names the argument. SPDX-License-Identifier: MIT"""
import re
import types

import numpy as np
import pytest
import touchstone as ts

FACE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
X0, X1 = np.array(FACE + [[0.2, 0.2, 1]]), np.array(FACE + [[0.2, 0.2, -1]])
POSES = [[0, 0, 0, 1, 0, 0, 0], [9, 0, 0, 1, 0, 0, 0]]
QUERY = {"kind": "vertex-face", "start": [X0[[3, 0, 1, 2]]], "end": [X1[[3, 0, 1, 2]]]}
STEP = {"t_max": 1.0, "threads": 1}


def mesh():
    return ts.Mesh(X0, [[0, 1, 2]])


def bodies():
    return ts.Bodies([ts.Body(FACE, [[0, 1, 2]]), ts.Body(FACE, [[0, 1, 2]])])


def on_bodies():
    return ts.CurvedQueries("point-point", ts.OnBody([[1, 0, 0]], q1=[1, 0, 0, 1]), ts.OnBody([[0, 1, 0]]))


def of_bodies(**more):
    return {"start": POSES, "end": POSES, "quaternion": "wxyz", "turn": "shorter", "threads": 1, **more}


def calls():
    """(what is called, its arguments by name)."""
    positions, options = {"x0": X0, "x1": X1}, {"separation": 0.0, "metric": "euclidean", "threads": 1}
    bounds = {"late_ulps": 1, "late_fraction": 0.5}
    yield ts.solve, {**QUERY, **options, "t_max": 1.0, "method": "fast", "wanted": "all"}
    yield ts.contact_times, {**QUERY, **options, "t_max": 1.0}
    yield ts.distance, {**QUERY, "t": 0.5, "metric": "max", "threads": 1}
    for function in (ts.contact_normal, ts.toi_gradient):
        yield function, {**QUERY, "t_max": 1.0, "separation": 0.0, "threads": 1}
    yield ts.prove, {**QUERY, **options}
    yield ts.certify, {**QUERY, "contact": [True], "toi": [0.5], **options, "t_max": 1.0, **bounds}
    yield ts.show, {**QUERY, "start": QUERY["start"][0], "end": QUERY["end"][0], "t_max": 1.0, "separation": 0.0,
                    "metric": "max"}
    yield ts.fuzz, {"solver": lambda *query: None, "cases": 4, "seed": 1, "climb": 0,
                    "separation": 0.0, "metric": "max", "early_ulps": 1, "early_fraction": 0.5, **bounds, "near": 0.0,
                    "findings": 1}
    for function in (ts.first_contact, ts.all_contacts, ts.closest_approach, ts.show_mesh):
        yield function, {"mesh": mesh(), **positions, **STEP}
    yield ts.first_contact, {"mesh": mesh(), **positions, "check_start": False}
    yield ts.candidates, {"mesh": mesh(), **positions, "threads": 1}
    yield ts.free_step, {"mesh": mesh(), **positions, "kept_fraction": 0.0, "check_start": False, "float32": False}
    for function in (ts.intersections, ts.intersects):
        yield function, {"mesh": mesh(), "x": X0, "threads": 1}
    yield ts.as_mesh, {"thing": types.SimpleNamespace(vertices=FACE, faces=[[0, 1, 2]])}
    yield ts.Mesh, {"vertices": 4, "faces": [[0, 1, 2]], "edges": [[0, 1]], "points": [3], "separation": 0.0,
                    "metric": "max", "dimension": 3, "excluded_vertices": [[0, 1]], "groups": [0, 0, 0, 1],
                    "group_pairs": [[0, 1]], "only_listed_groups": True}
    yield ts.Mesh, {"vertices": 4, "faces": [[0, 1, 2]], "radii": [0.0] * 4}
    yield ts.Body, {"points": FACE, "faces": [[0, 1, 2]], "edges": [[0, 1]], "loose_points": [], "radii": [0.0] * 3}
    yield ts.Body, {"points": X0, "mesh": mesh()}
    yield ts.Bodies, {"bodies": bodies().bodies, "separation": 0.0, "metric": "max", "ignore": [], "groups": [0, 1],
                      "group_pairs": [[0, 1]], "only_listed_groups": True}
    yield ts.MeshSteps, {"mesh": mesh()}
    steps, together = ts.MeshSteps(mesh()), bodies()
    yield steps.first_contact, {**positions, **STEP, "check_start": False}
    yield steps.all_contacts, {**positions, **STEP}
    yield steps.free_step, {**positions, "kept_fraction": 0.0, "threads": 1, "check_start": False, "float32": False}
    yield together.first_contact, of_bodies(t_max=1.0, check_start=False)
    yield together.all_contacts, of_bodies(t_max=1.0)
    yield together.candidates, of_bodies()
    yield together.free_step, of_bodies(check_start=False)
    yield together.contact_normal, of_bodies(contacts=together.all_contacts(POSES, POSES, quaternion="wxyz"), t_max=1.0)
    yield together.intersections, {"poses": POSES, "quaternion": "wxyz", "threads": 1}
    yield ts.CurvedQueries, {"kind": "point-point", "first": ts.OnBody([[1, 0, 0]]), "second": ts.OnBody([[0, 1, 0]]),
                             "shorter_turn": False}
    curved = {"t_max": 1.0, "separation": 0.0, "metric": "max", "threads": 1}
    yield on_bodies().solve, {**curved, "method": "fast", "wanted": "all"}
    yield on_bodies().contact_times, curved
    yield on_bodies().distance, {"t": 0.5, "metric": "max", "threads": 1}
    yield on_bodies().prove, {"separation": 0.0, "metric": "max", "threads": 1}


WRONG = [object(), "many words", b"bytes", {"a": 1}, {1}, [[[[["x"]]]]], np.array(["1.5"] * 4), np.zeros((7, 5)), 1j,
         1.5, -1, 2**70, float("nan"), [None], mesh(),
         ts.as_mesh(types.SimpleNamespace(vertices=FACE, faces=[[0, 1, 2]])), np.datetime64("2026-01-01"),
         types.SimpleNamespace(points=FACE)]
# Where the message names what the argument is about, in place of the argument.
ABOUT = {"start": "corner|start|motion|body", "end": "corner|end|motion|body", "kept_fraction": "fraction",
         "poses": "pose|body", "excluded_vertices": "excluded|vertex", "groups": "group", "group_pairs": "group",
         "points": "point|vertex", "loose_points": "point|vertex", "radii": "radi", "ignore": "rules|ignore|pair",
         "edges": "edge", "faces": "face", "x0": "x0|vertex", "x1": "x1|vertex", "x": "x|vertex",
         "thing": "thing|point", "vertices": "vert"}


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("call, named", calls(), ids=lambda value: getattr(value, "__name__", ""))
def test_a_wrong_argument_is_named_in_a_line(call, named):
    call(**named)
    for name in named:
        refused = 0
        for wrong in WRONG:
            try:
                call(**{**named, name: wrong})
            except (TypeError, ValueError) as error:
                message = str(error)
                assert len(message) < 400 and "\n" not in message and "Invoked" not in message, (name, message)
                assert re.search(ABOUT.get(name, name), message), (name, wrong, message)
                assert "dtype" not in message and "<U" not in message, (name, message)
                refused += 1
        assert refused > 0, name


def test_arguments_in_a_wrong_place_or_number():
    steps, together = ts.MeshSteps(mesh()), bodies()
    for ask, words in [
            (lambda: together.first_contact(POSES, POSES, "wxyz"),
             r"first_contact\(\) takes no more arguments without their names than start, end; name the others, as in "
             "quaternion='wxyz'$"),
            (lambda: together.first_contact(POSES, quaternion="wxyz"), r"first_contact\(\) needs the argument 'end'$"),
            (lambda: together.first_contact(POSES, POSES, tmax=1), r"has no argument 'tmax'; here it is 't_max'$"),
            (lambda: together.first_contact(POSES, POSES, order="wxyz"), "has no argument 'order'$"),
            (lambda: together.contact_normal(None, POSES, POSES, quaternion="wxyz"),
             r"contact_normal\(\): contacts is None; it must be a touchstone.BodyPairs$"),
            (lambda: steps.first_contact(X0, X1, 1, 1, True), "than x0, x1, t_max, threads; name the others$"),
            (lambda: mesh().describe(1, 2), r"describe\(\) takes no more arguments without their names than pair$"),
            (lambda: steps.first_contact(X0, X1, check_start="no"), "check_start is 'no'; it must be a bool$"),
            (lambda: ts.first_contact(mesh(), X0, X1, check_start=[]), r"first_contact\(\): check_start is of type li"),
            (lambda: ts.first_contact(X0, X1, mesh()), "mesh is of type ndarray; it must be a touchstone.Mesh, what"),
            (lambda: ts.intersections("a.stl"), "mesh is 'a.stl'; .*; read_mesh reads a mesh from a file$"),
            (lambda: ts.intersections(mesh()), "x is not given, and a Mesh has no positions of its own$"),
            (lambda: ts.Body("arm.stl"), "points is 'arm.stl'; it must be real numbers; read_mesh reads a mesh from a"),
            (lambda: ts.Body(FACE, mesh=FACE), "mesh is of type list; it must be a touchstone.Mesh"),
            (lambda: ts.Bodies(3), r"Bodies\(\): bodies is 3; it must be a list$"),
            (lambda: ts.MeshSteps(), r"MeshSteps\(\) needs the argument 'mesh'$"),
            (lambda: ts.Mesh(), r"Mesh\(\) needs the argument 'vertices'$"),
            (lambda: mesh().describe(), r"describe\(\) needs the argument 'pair'$"),
            (lambda: ts.solve("vertex-face", X0.astype(str), X1), "start has strings, such as '0.0'; they must be")]:
        with pytest.raises(TypeError, match=words):
            ask()


def test_a_reply_that_is_none_is_told():
    for reply, words in [("yes", "'yes', of type str"), (np.array([1, 0.5]), r"array\(\[1. , 0.5\]\)"),
                         ((True, 0.5, 1), r"\(True, 0.5, 1\), of type tuple"), ((True, "a"), r"\(True, 'a'\)"),
                         (True + 0j, r"\(1\+0j\), of type complex")]:
        with pytest.raises(TypeError, match=f"the solver returned {words}.*its reply must be a bool, a time, None"):
            ts.fuzz(lambda *query: reply, 50)
