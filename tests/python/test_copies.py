"""Copies, pickles, slices and tables of objects, and hints. SPDX-License-Identifier: MIT"""
import copy
import importlib.util
import pickle
import types

import numpy as np
import pytest
import touchstone as ts

START = np.zeros((5, 2, 3))
START[:, 1, 0] = [1, 2, 5, 3, 4]
END = START.copy()
END[:, 0, 0] = 4
EDGES = [[[0, 0, 0], [1, 0, 0]]]


def objects():
    mesh = ts.Mesh(7, [[0, 1, 2], [3, 4, 5]], [[4, 3]], separation=0.125, metric="max", excluded_vertices=[[6, 0]],
                   excluded_pairs=[("vertex-face", 3, 0)], groups=[0, 0, 0, 1, 1, 1, 2], group_pairs=[[2, 1]],
                   pair_separations={("vertex-face", 5, 0): 0.5})
    x0 = np.array([[-9, -9, 0], [9, -9, 0], [0, 9, 0], [0, 0, 1], [1, 0, 1.5], [0, 1, 1.5], [2, 2, 1]], float)
    x1 = x0 + np.array([[0, 0, 0]] * 3 + [[0, 0, -1.25]] * 3 + [[0, 0, 0]])
    plain = ts.Mesh(7, [[0, 1, 2], [3, 4, 5]])
    contact = ts.first_contact(plain, x0, x1, check_start=True)
    return [mesh, ts.Mesh(3, radii=[0.5, 0, 1], dimension=2), ts.solve("point-point", START, END),
            ts.solve("point-point", START[0], END[0]), ts.distance("point-point", START),
            ts.distance("point-point", START[0]), contact, contact.earliest, ts.all_contacts(plain, x0, x1),
            ts.candidates(plain, x0, x1), ts.free_step(plain, x0, x1), ts.intersections(plain, x1),
            ts.closest_approach(plain, x0, x1), ts.fuzz(lambda *_: False, 300),
            ts.fuzz(lambda *_: False, 300).findings[0], ts.Nature.crossing]


def same(a, b):
    """By all attributes."""
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and np.array_equal(a, b, equal_nan=a.dtype == float)
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    if type(a).__module__.startswith("touchstone") and type(a).__module__ != "touchstone._names":
        names = [n for n in dir(a) if not n.startswith("_") and not callable(getattr(a, n))]
        return repr(a) == repr(b) and all(same(getattr(a, n), getattr(b, n)) for n in names)
    return type(a) is type(b) and (a == b or a != a and b != b)


@pytest.mark.parametrize("i", range(16))
def test_a_pickle_is_the_same_object(i):
    thing = objects()[i]
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(thing, protocol))
        assert type(again) is type(thing) and same(thing, again)
    assert copy.copy(thing) is thing and copy.deepcopy([thing])[0] is thing


def test_a_mesh_keeps_its_rules():
    mesh = objects()[0]
    again = pickle.loads(pickle.dumps(mesh))
    for kind, first, second in [("vertex-face", a, b) for a in range(7) for b in range(2)]:
        pair = (kind, first, second)
        assert mesh.may_collide(pair) == again.may_collide(pair)
        assert mesh.separation_of(pair) == again.separation_of(pair)
    assert again.separation_of(("vertex-face", 5, 0)) == 0.5 and again.metric == "max"
    assert not again.may_collide(("vertex-face", 3, 0)) and again.may_collide(("vertex-face", 4, 0))
    steps = copy.deepcopy(ts.MeshSteps(mesh))
    assert same(steps.mesh, mesh) and steps.searches == 0


def test_curved_queries():
    fan = ts.OnBody(np.array([[[0, 0, 0], [1, 0, 0]], [[0, 0, 0], [2, 0, 0]]], float), q1=[-1, 0, 0, 1])
    with pytest.warns(UserWarning, match="longer"):
        queries = ts.CurvedQueries("point-edge", ts.OnCurves([[[0, 1.5, 0]]]), fan)
    fan.corners[:] = 9
    again = pickle.loads(pickle.dumps(queries))
    assert repr(again) == repr(queries) and same(again.solve(), queries.solve())
    assert same(copy.deepcopy(queries).solve(), queries.solve())


def test_times_are_copied():
    (first, last), = ts.contact_times("point-edge", [[-1, 0, 0]] + EDGES[0], [[2, 0, 0]] + EDGES[0])
    assert copy.deepcopy(first) is first and copy.copy(last) is last


def test_a_damaged_pickle_is_refused():
    answers = ts.solve("point-point", START, END)
    version, data = answers.__getstate__()
    for bad in [(version, data[:-1]), (version, data + b"x"), ("0.0.1", data), (version, b""), (version,),
                (version, b"\xff" * len(data)), (1, data), (version, 5)]:
        with pytest.raises(ValueError, match="pickle is"):
            ts.Answers.__new__(ts.Answers).__setstate__(bad)
    for thing in objects()[:-1]:
        version, data = thing.__getstate__()
        for size in range(0, len(data), 1 + len(data) // 40):
            with pytest.raises(ValueError, match="pickle is"):
                type(thing).__new__(type(thing)).__setstate__((version, data[:size]))


def test_slices():
    answers = ts.solve("point-point", START, END)
    assert len(answers[1:4]) == 3 and answers[1:4].toi.tolist() == answers.toi[1:4].tolist()
    assert answers[::-1].toi.tolist() == answers.toi[::-1].tolist() and len(answers[9:]) == 0
    assert [a.toi for a in answers] == answers.toi.tolist()
    distances = ts.distance("point-point", START)
    assert [d.value for d in distances[::2]] == [1, 5, 4] and distances[-1].value == 4
    with pytest.raises(IndexError, match="no distance 5; there are 5"):
        distances[5]
    x = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, -1], [1, 1, 1]]
    found = ts.intersections(ts.Mesh(5, [[0, 1, 2]], [[3, 4]]), x)
    assert list(found) == [("edge", 0, "face", 0, "pierces")] and len(found[1:]) == 0
    pairs = ts.candidates(ts.Mesh(3), np.zeros((3, 3)), np.zeros((3, 3)))
    assert list(pairs[1:]) == [pairs[1], pairs[2]] and len(pairs[1:].separation) == 0
    assert list(pairs[[2, 0]]) == [pairs[2], pairs[0]] and len(pairs[[2, 0]].separation) == 0
    assert len(found[[False]]) == 0 and list(found[np.array([0, 0])]) == [found[0], found[0]]


def test_masks_and_several_numbers():
    answers, distances = ts.solve("point-point", START, END), ts.distance("point-point", START)
    for several in (answers.contact, ~answers.contact, answers.contact.tolist(), np.array([3, -1, 3]), [4, 0], [],
                    np.array([1], np.uint8), np.array([2**40 % 5], np.uint64), np.zeros(5, bool), range(2)):
        for all_, column in ((answers, "toi"), (distances, "value")):
            some = all_[several]
            wanted = getattr(all_, column)[list(several)] if len(several) else []
            assert type(some) is type(all_) and getattr(some, column).tolist() == list(wanted), several
    for wrong, words in ((5, "no answer 5; there are 5"), ([0, 5], "no answer 5; there are 5"),
                         ([-6], "no answer -6"), ([True], "the mask has 1 bools; there must be one for each answer, 5"),
                         (np.array([2**63], np.uint64), "no answer 9223372036854775808")):
        with pytest.raises(IndexError, match=words):
            answers[wrong]
    for wrong in ("a", 1.5, (0, 1), None, [0.5], [[0, 1]], np.float64(1), np.zeros(0), {}):
        with pytest.raises(TypeError, match="the index is"):
            answers[wrong]
    for wrong in (True, False, np.True_, np.array(True)):  # a bool is no number of an answer, and no mask
        with pytest.raises(TypeError, match="the index is (numpy.)?(bool|ndarray)"):
            answers[wrong]
    with pytest.raises(ValueError, match=r"index\[1\] is masked"):
        answers[np.ma.array([0, 1], mask=[False, True])]


def test_tables():
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    table = ts.solve("point-point", START, END).to_pandas()
    assert isinstance(table, pandas.DataFrame) and table.shape == (5, 15)
    assert table.nature[0] == "isolated" and table.toi[1] == 0.5 and table.a0[0] == 1
    assert ts.distance("point-point", START).to_pandas().value.tolist() == [1, 2, 5, 3, 4]
    for thing in objects():
        if hasattr(thing, "to_pandas"):
            assert len(thing.to_pandas()) == len(thing.findings if isinstance(thing, ts.FuzzReport) else thing)
    rod = ts.Body([[0, 0, 0], [2, 0, 0]], edges=[[0, 1]])
    poses = [[0, 0, 0, 1, 0, 0, 0], [1, -1, 0, 1, 0, 0, 1]]  # the second one is along y
    pairs = ts.Bodies([rod, rod]).all_contacts(poses, poses, quaternion="wxyz").to_pandas()
    assert pairs.kind.tolist() == ["edge-edge"] and pairs.toi.tolist() == [0]
    crossing = ts.Bodies([rod, rod]).intersections(poses, quaternion="wxyz").to_pandas()
    for table in (pairs, crossing):
        assert sorted([*table.first_body, *table.second_body]) == [0, 1] and table["first"].tolist() == [0]


def test_claims_and_findings_as_tables():
    pytest.importorskip("pandas", reason="pandas is not installed")
    found = ts.certify("point-point", START, END, [True] * 5, [0, 1, 0, 0, 0], classes=["phantom"])
    table = found.to_pandas()
    assert table.verdict.tolist() == ["holds", "late", "phantom", "holds", "holds"]
    assert table.refuted.tolist() == [False, False, True, False, False] and table.early[0] == 0.25
    assert table.toi.tolist() == found.truth.toi.tolist()
    report = ts.fuzz(lambda *_: False, 300, findings=100)
    table = report.to_pandas()
    assert table.failure.tolist() == [one.failure for one in report.findings] and table.exact_contact.all()
    assert table["count"].sum() == report.failures and table.start[0].tolist() == report.findings[0].start.tolist()


def test_names_of_other_programs_are_told():
    for call, here in [(lambda: ts.solve("point-point", START, END, min_distance=1), "here it is 'separation'"),
                       (lambda: ts.free_step(ts.Mesh(2), START[0], END[0], num_threads=2), "here it is 'threads'"),
                       (lambda: ts.solve("point-point", START, END, tmax=1), "here it is 't_max'")]:
        with pytest.raises(TypeError, match=here):
            call()
    with pytest.raises(TypeError, match="unexpected keyword argument 'colour'"):
        ts.solve("point-point", START, END, colour=1)


def test_polygons_of_other_packages_are_cut_where_that_is_asked():
    x = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0]]
    thing = types.SimpleNamespace
    quads, triangles = [[0, 1, 2, 3], [1, 4, 5, 2]], [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]]
    blocks = [thing(type="quad", data=quads[:1]), thing(type="polygon4", data=quads[1:])]
    for made in (thing(points=x, cells=blocks), thing(vertices=x, faces=quads),
                 thing(vertices=x, faces=np.array(quads)),
                 thing(points=x, faces=np.array([4, *quads[0], 4, *quads[1]]))):
        with pytest.raises(ValueError, match=r"a face of 4 corners; .*as_mesh\(..., triangulate=True\) cuts it"):
            ts.as_mesh(made)
        assert ts.as_mesh(made, triangulate=True).mesh.faces.tolist() == triangles
    mixed = thing(points=x, faces=np.array([3, 1, 4, 2, 5, 0, 1, 4, 5, 3]))
    assert ts.as_mesh(mixed, triangulate=True).mesh.faces.tolist() == [[1, 4, 2], [0, 1, 4], [0, 4, 5], [0, 5, 3]]


def test_meshes_of_other_packages():
    x, face = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5]], [[0, 1, 2]]
    thing = types.SimpleNamespace
    cells = [thing(type="triangle", data=np.array(face)), thing(type="line", data=np.array([[2, 3]]))]
    for made, edges, points in [
            (thing(points=np.array(x, np.float32), cells=cells), 4, 0),
            (thing(vertices=x, faces=face), 3, 0), (thing(vertices=x, triangles=face), 3, 0),
            (thing(points=x, faces=np.array([3, 0, 1, 2]), lines=np.array([3, 1, 2, 3]), verts=np.array([])), 4, 0),
            (thing(points=x, faces=np.array([3, 0, 1, 2]), lines=[], verts=np.array([1, 3])), 3, 1),
            (thing(points=x, faces=np.array([3, 0, 1, 2]), verts=np.array([1, 3])), 3, 1),
            (thing(points=x, lines=[[0, 3], [3, 1]]), 2, 0)]:
        mesh, positions, parts, face_parts = ts.as_mesh(made)
        assert (len(mesh.edges), len(mesh.points), positions.tolist(), parts) == (edges, points, x, [])
    for made, words in [(thing(points=x, cells=[thing(type="tetra", data=[[0, 1, 2, 3]])]), "cells of type 'tetra'"),
                        (thing(points=x, faces=np.array([2, 0, 1])), "a face of 2 corners; a face has three$"),
                        (thing(points=x, faces=np.array([]), strips=np.array([4, 0, 1, 2, 3])), "strips"),
                        (thing(points=x, faces=np.array([]), lines=np.array([5, 0, 1, 2])), "says that 5 corners"),
                        (thing(points=x, faces=np.array([]), lines=np.array([-1, 0, 1, 2])), "says that -1 corners"),
                        (thing(points=x, faces=np.array([])), "neither faces nor lines")]:
        with pytest.raises(ValueError, match=words):
            ts.as_mesh(made)
    for wrong, words in [({}, "thing is of type dict; it must be a mesh of meshio"),
                         (ts.Mesh(2), "thing is a touchstone.Mesh, which has no positions"),
                         ("a.stl", "thing is 'a.stl'; .*; read_mesh reads a mesh from a file")]:
        with pytest.raises(TypeError, match=words):
            ts.as_mesh(wrong)
    assert ts.as_mesh(ts.as_mesh(thing(vertices=x, faces=face))).positions.tolist() == x
    meshio = pytest.importorskip("meshio", reason="meshio is not installed")
    mesh = ts.as_mesh(meshio.Mesh(x, [("triangle", face), ("vertex", [[3]])])).mesh
    assert (len(mesh.faces), mesh.points.tolist()) == (1, [3])


def test_what_has_a_mesh_is_a_mesh(tmp_path):
    x, face = np.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, 1], [1, 2, 1], [1, 1, 2.]]), [[0, 1, 2], [3, 4, 5]]
    mesh, x1 = ts.Mesh(x, face), x * [1, 1, -1]
    path = tmp_path / "a.obj"
    path.write_text("".join(f"v {p[0]} {p[1]} {p[2]}\n" for p in x) + "f 1 2 3\nf 4 5 6\n")
    thing = types.SimpleNamespace(vertices=x, faces=face)
    with_positions = [ts.read_mesh(path), ts.as_mesh(thing), thing]
    if importlib.util.find_spec("meshio"):
        with_positions.append(importlib.import_module("meshio").Mesh(x, [("triangle", face)]))
    frames = ts.read_frames([path, path])

    def answers(given, *own):
        steps = ts.MeshSteps(given)
        return repr([ts.first_contact(given, x, x1), ts.all_contacts(given, x, x1), ts.candidates(given, x, x1),
                     ts.free_step(given, x, x1).length, ts.show_mesh(given, x, x1), steps.first_contact(x, x1),
                     steps.mesh, ts.Body(x, mesh=given), ts.intersections(given, *own), ts.intersects(given, *own),
                     ts.closest_approach(given, *own)])

    for given in [mesh, frames, *with_positions]:
        assert answers(given, x) == answers(mesh, x)
    for given in with_positions:
        assert answers(given) == answers(mesh, x)
        assert repr(ts.closest_approach(given, x1=x1)) == repr(ts.closest_approach(mesh, x, x1))
    for ask in (ts.intersections, ts.intersects, ts.closest_approach):
        with pytest.raises(TypeError, match="is not given, and a Mesh has no positions"):
            ask(mesh)
        with pytest.raises(TypeError, match=r"is not given, and Frames have many positions: frames.positions\[0\]"):
            ask(frames)
    for wrong, words in [(with_positions[0], "x0 is of type MeshFile; .* such as its .positions"),
                         (thing, "x0 is of type SimpleNamespace; .* such as its .vertices")]:
        with pytest.raises(TypeError, match=words):
            ts.first_contact(mesh, wrong, x1)
