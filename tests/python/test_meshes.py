"""Mesh and the functions about meshes. SPDX-License-Identifier: MIT"""
import concurrent.futures
import math

import numpy as np
import pytest
import touchstone as ts

FACES = [[0, 1, 2], [3, 4, 5]]
X0 = np.array([[-9., -9, 0], [9, -9, 0], [0, 9, 0], [0, 0, 1], [1, 0, 1.5], [0, 1, 1.5], [2, 2, 1]])
X1 = X0 - [[0, 0, 1.25 * (3 <= v < 6)] for v in range(7)]


def cloud(n, seed=3):
    """Random triangles that move a little, and loose points."""
    rng = np.random.default_rng(seed)
    corners = rng.random((n, 1, 3)) + rng.standard_normal((n, 3, 3)) * n**(-1 / 3) / 4
    x0 = np.concatenate([corners.reshape(-1, 3), rng.random((n, 3))])
    return np.arange(3 * n).reshape(n, 3), x0, x0 + rng.standard_normal(x0.shape) * n**(-1 / 3) / 4


def test_first_contact_and_free_step():
    mesh = ts.Mesh(7, FACES)
    found = ts.first_contact(mesh, X0, X1)
    assert (found.contact, found.free, found.toi) == (True, False, 0.79999999999999993)
    assert [mesh.describe(pair) for pair in found.earliest] == ["vertex 3 and face 0 (0-1-2)"]
    assert len(found.at_start) == 0 and str(found.earliest.answers[0].nature) == "crossing"
    step = ts.free_step(mesh, X0, X1)
    assert step.outcome == "shortened" and step.length <= 0.8 and step.positions.shape == (7, 3)
    assert ts.first_contact(mesh, X0, step.positions).free
    assert ts.free_step(mesh, X0, X0).outcome == "whole"
    assert ts.free_step(mesh, X1, X1, 0.5).length <= 1
    pierced = ts.intersections(mesh, X1)
    assert ts.intersects(mesh, X1) is True and ts.intersects(mesh, X0) is False
    assert pierced.first.tolist() == [3, 4] and pierced.second.tolist() == [0, 0] and pierced.pierces.all()
    assert pierced.first_element == ["edge", "edge"] and pierced.second_element == ["face", "face"]
    assert pierced.weights_second.sum(axis=1) == pytest.approx(1)


def test_folds_surfaces_inside_and_the_start():
    mesh = ts.Mesh(4, [[0, 1, 2], [0, 1, 3]])
    folded = np.array([[0., 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, 0]])
    found = ts.intersections(mesh, folded)
    assert found.sort == ["folds", "folds"] and not found.pierces.any()
    open_ = folded.copy()
    open_[3, 1] = -1
    assert len(ts.intersections(mesh, open_)) == 0
    assert ts.first_contact(mesh, open_, folded).toi == .5

    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    box = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                    [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
    boxes, x = ts.Mesh(16, np.vstack([box, box + 8])), np.vstack([3 * corners, corners])
    inside = ts.intersections(boxes, x)
    assert inside.sort == ["inside"] and (inside.first[0], inside.second[0]) == (8, 0)
    step = ts.first_contact(boxes, x, x)
    assert step.free and not step.start_checked and "start not checked" in repr(step)
    step = ts.first_contact(boxes, x, x, check_start=True)
    assert not step.free and step.start_checked and step.start_intersections.sort == ["inside"]
    assert "intersections at the start" in repr(step)
    assert ts.free_step(boxes, x, x).outcome == "whole"
    assert ts.free_step(boxes, x, x, check_start=True).outcome == "intersects_at_start"
    for ask in (ts.all_contacts, ts.candidates):
        with pytest.raises(TypeError, match="check_start"):
            ask(boxes, x, x, check_start=True)


def test_against_solve_of_all_candidates():
    faces, x0, x1 = cloud(120)
    mesh = ts.Mesh(x0, faces)
    assert mesh.vertex_count == len(x0) and mesh.faces.tolist() == faces.tolist() and len(mesh.points) == 120
    contacts = ts.all_contacts(mesh, x0, x1)
    assert len(contacts) > 20
    assert (np.diff(contacts.answers.toi) >= 0).all()
    found = set()
    for pair in ts.candidates(mesh, x0, x1):
        corners = mesh.corners(pair)
        if ts.solve(pair[0], x0[corners], x1[corners], wanted="contact").contact:
            found.add(pair)
    assert found == set(contacts)
    for i, pair in enumerate(contacts):
        corners = mesh.corners(pair)
        assert repr(ts.solve(pair[0], x0[corners], x1[corners])) == repr(contacts.answers[i])
    assert contacts.kind == [pair[0] for pair in contacts] and contacts.first.tolist() == [p[1] for p in contacts]
    assert contacts.second.tolist() == [p[2] for p in contacts]


def test_threads_layouts_and_types_change_nothing():
    faces, x0, x1 = cloud(2000)  # many vertices: the call has a thread of its own
    x0, x1 = x0.astype(np.float32), x1.astype(np.float32)
    wanted = ts.all_contacts(ts.Mesh(8000, faces), x0.astype(float), x1.astype(float), threads=1)
    for index_type in (np.uint16, np.int32, np.uint64):
        mesh = ts.Mesh(len(x0), np.asfortranarray(faces.astype(index_type)))
        for x in (x0, np.asfortranarray(x0), np.asfortranarray(x0.astype(float)), x0.astype(float)[::-1].copy()[::-1]):
            got = ts.all_contacts(mesh, x, x1, threads=2)
            assert list(got) == list(wanted) and np.array_equal(got.answers.toi, wanted.answers.toi)


def test_steps_that_keep_what_they_found():
    faces, x0, x1 = cloud(400)
    mesh = ts.Mesh(x0, faces)
    steps = ts.MeshSteps(mesh)
    assert steps.mesh.faces.tolist() == mesh.faces.tolist() and steps.searches == 0
    tries = [x0 + s * (x1 - x0) for s in (0.1, 0.1, 0.09, 0.08, 0.07, 0.06)]
    assert list(steps.all_contacts(x0, tries[0])) == list(ts.all_contacts(mesh, x0, tries[0]))
    with concurrent.futures.ThreadPoolExecutor(3) as pool:  # one object for all: each call is answered by itself
        for x, found in zip(tries, pool.map(lambda x: steps.all_contacts(x0, x), tries)):
            expected = ts.all_contacts(mesh, x0, x)
            assert list(found) == list(expected) and found.answers.toi.tolist() == expected.answers.toi.tolist()
    assert steps.searches == 1 and repr(steps) == "<MeshSteps: searches=1>"
    found, expected = steps.first_contact(x0, tries[4], threads=2), ts.first_contact(mesh, x0, tries[4])
    assert found.toi == expected.toi and list(found.earliest) == list(expected.earliest)
    step, expected = steps.free_step(x0, tries[4], 0.25), ts.free_step(mesh, x0, tries[4], 0.25)
    assert step.length == expected.length and (step.positions == expected.positions).all()
    steps.release()
    with pytest.raises(ValueError, match="x1 has the shape"):
        steps.first_contact(x0, x1[:2])


def test_separations_rules_and_the_plane():
    mesh = ts.Mesh(2, separation=.25)
    assert ts.first_contact(mesh, [[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 0, 0]]).toi == .75
    mesh = ts.Mesh(2, radii=[.25, .125])
    assert mesh.separation_of(("point-point", 0, 1)) == .375
    mesh = ts.Mesh(2, pair_separations={("point-point", 0, 1): .5}, metric="max")
    assert mesh.metric == "max" and mesh.separation_of(("point-point", 0, 1)) == .5
    for rules in (dict(excluded_vertices=[[0, 1]]), dict(excluded_pairs=[("point-point", 0, 1)]),
                  dict(groups=[0, 1], group_pairs=[[0, 1]]), dict(groups=[0, 1], only_listed_groups=True)):
        if "groups" in rules:
            with pytest.warns(UserWarning, match="no two elements of this mesh may collide"):
                mesh = ts.Mesh(2, **rules)
            assert not mesh.has_pairs()
        else:
            mesh = ts.Mesh(2, **rules)
        assert not mesh.may_collide(("point-point", 0, 1))
        assert ts.first_contact(mesh, [[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0, 0, 0]]).free
    flat = ts.Mesh(np.zeros((3, 2)), edges=[[0, 1]])
    assert flat.dimension == ts.Mesh(3, edges=[[0, 1]], dimension=2).dimension == 2
    found = ts.first_contact(flat, [[0, 0], [2, 0], [1, 1]], [[0, 0], [2, 0], [1, -1]])
    assert found.toi == .5 and found.earliest[0] == ("point-edge", 2, 0)
    assert ts.free_step(flat, [[0, 0], [2, 0], [1, 1]], [[0, 0], [2, 0], [1, -1]]).positions.shape == (3, 2)


def test_wrong_input_is_refused():
    for arguments, message in (((3, [[0, 1, 3]]), "face 0"), ((3, [[0, 1, 1]]), "face 0"),
                               ((3, [[0, -1, 2]]), r"faces\[0\]"),
                               ((4, [[0, 1, 2], [2, 1, 0]]), "face"), ((3, [0, 1, 2]), "faces has the shape"),
                               ((3, [[0, 1]]), "faces has the shape"), ((3, None, [[0, 7]]), "edge 0"),
                               ((2, None, None, None, -1), "separation"), ((2, None, None, None, 0, "l2"), "metric"),
                               ((2, None, None, None, 0, "max", [1]), "radi"), ((-1,), "vertices"),
                               ((3, [[0, 1, 2**32]]), r"2\^32"), ((np.zeros(3),), "vertices has the shape")):
        with pytest.raises(ValueError, match=message):
            ts.Mesh(*arguments)
    for arguments in ((3, [[0, 1, 1.5]]), ("3",), (3, "faces"), (2, None, None, None, "1")):
        with pytest.raises(TypeError):
            ts.Mesh(*arguments)
    with pytest.raises(ValueError, match="dimension"):
        ts.Mesh(3, dimension=4)
    mesh = ts.Mesh(7, FACES)
    for ask in (ts.first_contact, ts.all_contacts, ts.candidates, ts.free_step):
        for x in (X0[:6], X0[:, :2], X0.ravel(), 1):
            with pytest.raises(ValueError, match=r"x1 has the shape .*; for this mesh it must be \(7, 3\)"):
                ask(mesh, X0, x)
        wrong = X1.copy()
        wrong[5, 1] = math.nan
        with pytest.raises(ValueError, match="vertex 5"):
            ask(mesh, X0, wrong)
        with pytest.raises(TypeError):
            ask("mesh", X0, X1)
    for pair, error in ((("edge-edge", 0, 99), ValueError), (("edge-edge", -1, 0), ValueError),
                        (("x", 0, 0), ValueError),
                        ((0, 0), ValueError), (("edge-edge", 0, 1.5), TypeError),
                        (("edge", 99, "face", 0, "pierces"), ValueError), (("edge", 0, "face", 99, "x"), ValueError),
                        (("edge", 0, "face", -1, "folds"), ValueError), (("body", 0, "face", 0, "folds"), ValueError),
                        (("edge", 0, "face", 0, "meets"), ValueError), (("edge", 0, 1, 0, "folds"), TypeError)):
        with pytest.raises(error):
            mesh.describe(pair)
    with pytest.raises(ValueError, match="t_max"):
        ts.first_contact(mesh, X0, X1, t_max=2)
    with pytest.raises(ValueError, match="fraction"):
        ts.free_step(mesh, X0, X1, 1)
    with pytest.raises(IndexError):
        ts.candidates(mesh, X0, X1)[10**6]


def test_an_intersection_is_described():
    mesh = ts.Mesh(7, faces=[[0, 1, 2]], edges=[[3, 4]], points=[5])
    found = ts.intersections(mesh, [[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, -1], [1, 1, 1], [2, 1, 0], [9, 9, 9]])
    assert sorted(map(mesh.describe, found)) == ["edge 0 (3-4) pierces face 0 (0-1-2)",
                                                 "vertex 5 touches face 0 (0-1-2)"]
    assert mesh.describe(("edge", 1, "face", 0, "folds")) == "edge 1 (0-1) folds onto face 0 (0-1-2)"
    with pytest.raises(ValueError, match="the mesh has no face 99; it has 1"):
        mesh.describe(("edge", 0, "face", 99, "folds"))


def test_an_empty_mesh():
    mesh = ts.Mesh(0)
    nothing = np.empty((0, 3))
    assert ts.first_contact(mesh, nothing, nothing).free and len(ts.candidates(mesh, nothing, nothing)) == 0
    assert ts.free_step(mesh, nothing, nothing).positions.shape == (0, 3)
    assert len(ts.intersections(mesh, nothing)) == 0 and mesh.faces.shape == (0, 3)


def test_masked_positions_and_indices_are_refused():
    mesh = ts.Mesh(7, np.ma.array(FACES))
    masked = np.ma.array(X1)
    masked[3, 0] = np.ma.masked
    with pytest.raises(ValueError, match=r"x1\[3, 0\] is masked"):
        ts.first_contact(mesh, X0, masked)
    assert ts.first_contact(mesh, np.ma.array(X0), np.ma.array(X1)).contact
    with pytest.raises(ValueError, match=r"faces\[1, 2\] is masked"):
        ts.Mesh(7, np.ma.array(FACES, mask=[[0, 0, 0], [0, 0, 1]]))
    with pytest.raises(ValueError, match=r"radii\[0\] is masked"):
        ts.Mesh(7, FACES, radii=np.ma.array(np.ones(7), mask=[1, 0, 0, 0, 0, 0, 0]))


BOUND = [bound for bound in vars(ts._core).values() if isinstance(bound, type)]


@pytest.mark.parametrize("bound", BOUND, ids=[bound.__name__ for bound in BOUND])
def test_an_object_without_a_value_is_refused(bound):
    made = bound.__new__(bound)
    tried = 0
    for name, member in vars(bound).items():
        if isinstance(member, property):
            calls = [lambda: getattr(made, name)]
        elif name in ("__repr__", "__str__", "__len__", "__float__", "__iter__", "__bool__", "page"):
            calls = [lambda: getattr(made, name)()]
        elif name in ("__getitem__", "__eq__", "__lt__"):
            calls = [lambda: getattr(made, name)(0)]
        elif name == "read":
            calls = [lambda: made.read("a.obj")]
        else:
            continue
        for call in calls:
            tried += 1
            with pytest.raises(TypeError, match="no value"):
                call()
    assert tried > 0


def test_a_mesh_without_a_value_is_refused_by_the_functions():
    class Mine(ts.Mesh):
        pass

    for mesh in (ts.Mesh.__new__(ts.Mesh), Mine.__new__(Mine)):
        for call in (ts.first_contact, ts.all_contacts, ts.candidates, ts.free_step):
            with pytest.raises(TypeError, match="no value"):
                call(mesh, X0, X1)
        with pytest.raises(TypeError, match="no value"):
            ts.intersections(mesh, X0)
        with pytest.raises(TypeError, match="no value"):
            ts.intersects(mesh, X0)
        mesh.__init__(7, FACES)
        assert ts.first_contact(mesh, X0, X1).contact
    assert len(BOUND) >= 13


def test_a_step_that_ends_at_floats():
    mesh = ts.Mesh(2)
    x0, x1 = np.float32([[0, 0, 0], [1, 0, 0]]), np.float32([[4.1, 0, 0], [1, 0, 0]])
    step = ts.free_step(mesh, x0, x1, float32=True)
    assert step.outcome == "shortened" and (step.positions.astype(np.float32) == step.positions).all()
    assert step.positions[0, 0] == np.nextafter(np.float32(1), np.float32(0))
    assert (ts.MeshSteps(mesh).free_step(x0, x1, float32=True).positions == step.positions).all()
    with pytest.raises(ValueError, match="vertex 0 has x = 0.1.* at t = 0, which is no float32 number"):
        ts.free_step(mesh, [[0.1, 0, 0], [1, 0, 0]], x1, float32=True)
