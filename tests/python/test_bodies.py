"""Whole bodies that turn. SPDX-License-Identifier: MIT"""
import copy
import itertools
import pickle
import types

import numpy as np
import pytest
import touchstone as ts
from test_copies import same
from test_module import interrupted

AT_REST = [0, 0, 0, 1, 0, 0, 0]
FACES = [t for a, b, c, d in [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
         for t in ((a, b, c), (a, c, d))]


def box(x, y, z):
    return ts.Body(list(itertools.product((-x, x), (-y, y), (-z, z))), FACES)


def poses(*rows):
    return np.array(rows, float)


def every_answer(a, b, start, end):
    """{pair: answer} of all pairs of elements of two boxes, by `solve` for curved queries."""
    def element(body, corners, number):
        return ts.OnBody(body.points[corners], start[number, 3:], end[number, 3:], start[number, :3], end[number, :3])

    found = {}
    vertices = np.arange(8)[:, np.newaxis]

    def ask(kind, first, i, x, second, j, y):
        rows = np.array(list(itertools.product(range(len(x)), range(len(y)))))
        elements = element(first, x[rows[:, 0]], i), element(second, y[rows[:, 1]], j)
        answers = ts.CurvedQueries(kind, *elements, shorter_turn=True).solve()
        for (e, f), answer in zip(rows.tolist(), answers):
            if answer:
                found[kind, (i, e), (j, f)] = answer

    ask("edge-edge", a, 0, a.mesh.edges, b, 1, b.mesh.edges)
    ask("vertex-face", a, 0, vertices, b, 1, b.mesh.faces)
    ask("vertex-face", b, 1, vertices, a, 0, a.mesh.faces)
    return found


def test_every_pair_of_two_boxes_has_the_answer_of_solve():
    rng = np.random.default_rng(11)
    a, b = box(1, .5, .25), box(.5, .5, .75)
    bodies = ts.Bodies([a, b])
    hits = 0
    for case in range(24):
        start, end = rng.standard_normal((2, 2, 7))
        if case % 2:  # degenerate: quarter turns, and numbers of few bits
            start, end = np.round(2 * start) / 2, np.round(2 * end) / 2
            start[:, 3:], end[:, 3:] = [1, 0, 0, 0], [[1, 0, 0, 1], [1, 1, 0, 0]]
        start[1, 0] += 2
        expected = every_answer(a, b, start, end)
        found = bodies.all_contacts(start, end, quaternion="wxyz")
        assert set(found) == set(expected)
        assert all(same(answer, expected[pair]) for pair, answer in zip(found, found.answers))
        first = bodies.first_contact(start, end, quaternion="wxyz")
        at_start = {pair for pair, answer in expected.items() if answer.starts_within}
        later = {pair: answer for pair, answer in expected.items() if pair not in at_start}
        assert set(first.at_start) == at_start and first.contact == bool(later)
        if later:
            assert first.toi == min(answer.toi for answer in later.values())
            assert set(first.earliest) <= {pair for pair, answer in later.items() if answer.toi == first.toi}
            assert all(same(x, later[pair]) for pair, x in zip(first.earliest, first.earliest.answers))
        assert set(expected) <= set(bodies.candidates(start, end, quaternion="wxyz"))
        hits += bool(later)
    assert 6 < hits < 24


def test_a_quarter_turn_meets_what_it_reaches():
    rod, ball = ts.Body([[0, 0, 0], [1, 0, 0]], edges=[[0, 1]]), ts.Body([[0, 0, 0]])
    bodies = ts.Bodies([rod, ball])
    end = poses([0, 0, 0, 3, 0, 0, 3], AT_REST)
    start = poses(AT_REST, AT_REST)
    start[1, :3] = end[1, :3] = [0, 1, 0]
    found = bodies.first_contact(start, end, quaternion="wxyz")
    assert (found.contact, found.toi, found.free, len(found.at_start)) == (True, 1, False, 0)
    pair, = found.earliest
    assert pair == ("point-edge", (1, 0), (0, 0)) and not found.start_intersections
    assert bodies.describe(pair) == "vertex 0 of body 1 and edge 0 (0-1) of body 0"
    assert found.earliest.first_body.tolist() == [1] and found.earliest.second.tolist() == [0]
    assert found.earliest.answers.weights_b[0].tolist() == [0, 1, 0]
    assert str(found.earliest.answers[0].feature_b) == "e1"
    assert repr(found) == "<FirstBodyContact: toi 1.0, 1 earliest, 0 at the start>"
    short = bodies.first_contact(start, end, quaternion="wxyz", t_max=0.5, check_start=False)
    assert short.free and not short.start_checked and short.t_max == 0.5
    assert repr(short) == "<FirstBodyContact: free; only up to 0.5; start not checked>"
    normal = bodies.contact_normal(found.earliest, start, end, quaternion="wxyz")
    assert normal.shape == (1, 3) and np.isnan(normal).all(), "a point and an edge that touch have none"
    near = ts.Bodies([rod, ts.Body([[0, 0, 0]], radii=[0.25])], separation=0.125)
    assert near.separation_of(pair) == 0.375 and near.first_contact(start, end, quaternion="wxyz").toi < 1


def test_the_sign_of_a_quaternion_and_the_order_of_its_components():
    """Poses from an engine: a turn by 5.7 degrees, the second quaternion with either sign."""
    tip, wall = ts.Body([[1, 0, 0]]), ts.Body([[-2, -.5, -1], [2, -.5, -1], [0, -.5, 2]], [[0, 1, 2]])
    bodies = ts.Bodies([tip, wall])
    start = poses(AT_REST, AT_REST)
    end = start.copy()
    end[0, 3:] = [np.cos(.05), 0, 0, np.sin(.05)]
    found = bodies.first_contact(start, end, quaternion="wxyz")
    assert found.free and found.turned.tolist() == [] and repr(found) == "<FirstBodyContact: free>"
    end[0, 3:] *= -1
    short = bodies.first_contact(start, end, quaternion="wxyz")
    assert short.free and short.turned.tolist() == [0]
    for pairs in (bodies.all_contacts(start, end, quaternion="wxyz"), bodies.candidates(start, end, quaternion="wxyz"),
                  short.earliest, short.at_start):
        assert pairs.turned.tolist() == [0] and repr(pairs).endswith("; 1 body takes the shorter turn>")
        assert pairs[:0].turned.tolist() == [0] and pickle.loads(pickle.dumps(pairs)).turned.tolist() == [0]
    assert bodies.all_contacts(start, end, quaternion="wxyz", turn="as_given").turned.tolist() == []
    assert repr(short) == "<FirstBodyContact: free; 1 body takes the shorter turn>"
    long = bodies.first_contact(start, end, quaternion="wxyz", turn="as_given")
    assert long.contact and long.turned.tolist() == [] and 0 < long.toi < 1

    def xyzw(rows):
        return rows[:, [0, 1, 2, 4, 5, 6, 3]]

    for turn in ("shorter", "as-given"):
        for method in (bodies.first_contact, bodies.all_contacts, bodies.candidates):
            assert same(method(start, end, quaternion="wxyz", turn=turn),
                        method(xyzw(start), xyzw(end), quaternion="xyzw", turn=turn))
        step = bodies.free_step(start, end, quaternion="wxyz", turn=turn)
        other = bodies.free_step(xyzw(start), xyzw(end), quaternion="xyzw", turn=turn)
        assert step.outcome == other.outcome and np.array_equal(xyzw(step.poses), other.poses)
    wrong = bodies.first_contact(xyzw(start), xyzw(end), quaternion="wxyz", turn="as-given")
    assert not same(wrong, long), "the order counts"
    assert len(bodies.intersections(xyzw(start), quaternion="xyzw")) == 0


def test_normals_are_those_of_the_pairs_queries():
    bodies = ts.Bodies([box(1, 1, 1), box(.5, .5, .5)])
    start, end = poses(AT_REST, [4, 0, 0, 1, 0, 0, 0]), poses(AT_REST, [0, 0, 0, 1, 0, 0, 1])
    contacts = bodies.first_contact(start, end, quaternion="wxyz").earliest
    assert len(contacts) > 0
    for pair, normal in zip(contacts, bodies.contact_normal(contacts, start, end, quaternion="wxyz")):
        towards_second = 1 if pair[1][0] == 0 else -1
        assert np.isnan(normal).all() or normal @ [towards_second, 0, 0] == 1
    near = ts.Bodies(bodies.bodies, separation=.25)
    contacts = near.first_contact(start, end, quaternion="wxyz").earliest
    assert np.allclose(np.abs(near.contact_normal(contacts, start, end, quaternion="wxyz")), [1, 0, 0])
    with pytest.raises(ValueError, match="metric is 'max'"):
        ts.Bodies(bodies.bodies, separation=.25, metric="max").contact_normal(contacts, start, end, quaternion="wxyz")
    with pytest.raises(ValueError, match="many motions"):
        near.contact_normal(contacts, start, end[np.newaxis], quaternion="wxyz")


def test_a_free_step_ends_before_the_contact_and_is_free():
    bodies = ts.Bodies([box(1, 1, 1), box(.5, .5, .5)])
    start = poses(AT_REST, [4, 0, 0, 1, 0, 0, 0])
    end = poses([0, 0, 0, 1, 0, 0, .25], [-4, 0, 0, 1, .5, 0, 0])
    step = bodies.free_step(start, end, quaternion="wxyz")
    toi = step.first_contact.toi
    assert step.outcome == "shortened" and 0.99 * toi < step.length <= toi and step.proofs > 1
    assert bodies.first_contact(start, step.poses, quaternion="wxyz").free
    assert repr(step) == f"<FreeBodyStep: shortened, length {step.length}>"
    whole = bodies.free_step(start, start, quaternion="wxyz")
    assert whole.outcome == "whole" and np.array_equal(whole.poses, start)
    assert not whole.poses.flags.writeable


def test_bodies_that_intersect_at_the_start_are_told():
    bodies = ts.Bodies([box(1, 1, 1), box(.25, .25, .25), box(2, .125, .125)])
    start = poses(AT_REST, AT_REST, [9, 0, 0, 1, 0, 0, 0])
    found = bodies.first_contact(start, start, quaternion="wxyz")
    assert not found.free and not found.contact and found.start_checked
    (first_element, (body, _), second_element, (other, _), sort), = found.start_intersections
    assert (first_element, body, second_element, other, sort) == ("vertex", 1, "face", 0, "inside")
    assert repr(found) == "<FirstBodyContact: 1 intersections at the start>"
    assert bodies.free_step(start, start, quaternion="wxyz").outcome == "intersects_at_start"
    assert bodies.first_contact(start, start, quaternion="wxyz", check_start=False).free
    start[2, 0] = 0
    pierced = bodies.intersections(start, quaternion="wxyz", threads=2)
    assert "pierces" in pierced.sort and set(pierced.first_body) | set(pierced.second_body) == {0, 1, 2}
    assert list(pierced)[0] == pierced[0] and len(pierced[1:]) == len(pierced) - 1
    assert (pierced.in_open, pierced.cancelled, pierced.excluded) == (0, 0, 0)


def test_intersections_say_what_lies_in_open_surfaces():
    large = box(4, 4, 4)
    corners = np.array(large.points)[np.array(FACES)].reshape(-1, 3)
    soup = ts.Body(corners, np.arange(len(corners)).reshape(-1, 3))
    bodies = ts.Bodies([soup, box(1, 1, 1)])
    found = bodies.intersections(poses(AT_REST, AT_REST), quaternion="wxyz")
    assert (len(found), found.in_open) == (0, 1)
    assert repr(found) == "<BodyIntersections: 0; 1 piece in the box of open surfaces>"
    assert repr(found[:0]) == repr(found) == repr(pickle.loads(pickle.dumps(found)))


def test_rules_leave_pairs_of_bodies_out():
    row = [box(.5, .5, .5)] * 3
    start = poses(AT_REST, [1, 0, 0, 1, 0, 0, 0], [2, 0, 0, 1, 0, 0, 0])

    def touching(**rules):
        bodies = ts.Bodies(row, **rules)
        found = bodies.first_contact(start, start, quaternion="wxyz", check_start=False)
        pairs = found.at_start
        all_ = bodies.all_contacts(start, start, quaternion="wxyz")
        near = bodies.candidates(start, start, quaternion="wxyz")
        assert pairs.excluded == all_.excluded == near.excluded == near[:1].excluded == found.excluded
        assert ("left out" in repr(all_)) == (found.excluded > 0)
        return found.excluded, {tuple(sorted(ab)) for ab in zip(pairs.first_body.tolist(), pairs.second_body.tolist())}

    assert touching() == (0, {(0, 1), (1, 2)})
    assert touching(ignore=[(1, 0)]) == (1, {(1, 2)})
    assert touching(groups=[5, 5, 7], group_pairs=[[7, 5]]) == (2, {(0, 1)})
    assert touching(groups=[5, 5, 7], group_pairs=[[7, 5]], only_listed_groups=True) == (1, {(1, 2)})
    found = ts.Bodies(row, ignore=[(0, 1), (1, 2)]).first_contact(start, start, quaternion="wxyz")
    assert repr(found) == "<FirstBodyContact: free; 2 pairs of bodies left out>"
    for nothing in (dict(bodies=row, ignore=[(0, 1), (0, 2), (1, 2)]), dict(bodies=row[:1]), dict(bodies=[])):
        with pytest.warns(UserWarning, match="no two of these bodies may collide"):
            ts.Bodies(**nothing)


def test_many_motions_have_the_results_of_each():
    bodies = ts.Bodies([box(1, .5, .25), box(.5, .5, .5)])
    rng = np.random.default_rng(5)
    start = poses(AT_REST, [4, 0, 0, 1, 0, 0, 0])
    ends = rng.standard_normal((40, 2, 7))
    starts = np.stack([start] * len(ends))
    for name in ("first_contact", "all_contacts", "candidates", "free_step"):
        ask = getattr(bodies, name)
        alone = [ask(start, end, quaternion="wxyz") for end in ends]
        for threads in (1, 2):
            assert same(ask(starts, ends, quaternion="wxyz", threads=threads), alone)
        assert same(ask(start, ends, quaternion="wxyz"), alone)
        assert same(ask(ends, start, quaternion="wxyz")[3], ask(ends[3], start, quaternion="wxyz"))
        assert ask(starts[:0], ends[:0], quaternion="wxyz") == []
    assert {found.contact for found in bodies.first_contact(start, ends, quaternion="wxyz")} == {True, False}
    assert [len(x) for x in bodies.intersections(starts, quaternion="wxyz")] == [0] * len(ends)


def test_what_has_no_meaning_is_refused_with_its_place():
    bodies = ts.Bodies([box(1, 1, 1), box(1, 1, 1)])
    start = poses(AT_REST, [4, 0, 0, 1, 0, 0, 0])

    def refused(words, *given, kind=ValueError, quaternion="wxyz", **more):
        with pytest.raises(kind, match=words):
            bodies.first_contact(*given, quaternion=quaternion, **more)

    with pytest.raises(TypeError, match="quaternion is not given; it must be 'wxyz'.*or 'xyzw'"):
        bodies.first_contact(start, start)
    refused("quaternion is 'wzyx'; it must be 'wxyz' or 'xyzw'", start, start, quaternion="wzyx")
    refused("quaternion is of type int", start, start, kind=TypeError, quaternion=4)
    refused("turn is 'long'; it must be 'shorter' or 'as-given'", start, start, turn="long")
    refused(r"start has the shape \(2, 6\); it must be \(n, 2, 7\) or \(2, 7\)", start[:, :6], start)
    refused(r"end has the shape \(1, 7\); it must be \(n, 2, 7\) or \(2, 7\)", start, start[:1])
    refused("start has 3 motions and end has 4; they must have the same", np.stack([start] * 3), np.stack([start] * 4))
    refused("end is 'x'; it must be real numbers", start, "x", kind=TypeError)
    refused("t_max is 1.5", start, start, t_max=1.5)
    refused("threads is -1", start, start, threads=-1)
    for place, words in [((1, 3), "body 1: the quaternion q1"), ((0, 1), "body 0: the position p1 has y = nan")]:
        end = start.copy()
        end[place] = np.nan
        refused(words, start, end)
        refused("motion 1: " + words, start, np.stack([start, end]))
    end = start.copy()
    end[1, 3:] = 0
    refused("body 1: the quaternion q1 is zero", start, end)
    refused("motion 2: body 1: the quaternion q1 is zero", start, np.stack([start, start, end]))
    end[1, 3:] = [-2, 0, 0, 0]
    refused("body 1: q1 is q0 times a negative number", start, end, turn="as-given")
    assert bodies.first_contact(start, end, quaternion="wxyz").turned.tolist() == [1]
    with pytest.raises(TypeError, match=r"bodies\[1\] is of type .*Mesh; it must be a touchstone.Body"):
        ts.Bodies([bodies.bodies[0], ts.Mesh(2)])
    for words, rules in [("the rules name body 2, and there are 2 bodies", dict(ignore=[(0, 2)])),
                         ("the pair of body 1 with itself", dict(ignore=[(1, 1)])),
                         ("the groups of 1 bodies", dict(groups=[1])), ("-1", dict(separation=-1)),
                         ("metric is 'l1'", dict(metric="l1"))]:
        with pytest.raises(ValueError, match=words):
            ts.Bodies(bodies.bodies, **rules)
    for pair in (("edge-edge", 0, 1), (), ("edge-edge", (0, -1), (1, 0)), None):
        with pytest.raises(ValueError, match="a pair is a tuple"):
            bodies.describe(pair)
    with pytest.raises(ValueError, match="edge 99 of body 0, which has 18 of them"):
        bodies.describe(("edge-edge", (0, 99), (1, 0)))


def test_bodies_are_made_of_meshes_and_files():
    x, faces = box(1, 1, 1).points, np.array(FACES)
    mesh = ts.Mesh(8, faces, separation=3, excluded_vertices=[[0, 5]])
    thing = types.SimpleNamespace(vertices=x, faces=faces)
    made = [ts.Body(x, faces), ts.Body(x, mesh=mesh), ts.Body(thing), ts.Body(ts.as_mesh(thing)),
            ts.Body(x.tolist(), FACES, loose_points=[])]
    for body in made:
        assert repr(body) == "<Body: 8 vertices, 12 faces, 18 edges, 0 loose points>"
        assert np.array_equal(body.points, x) and np.array_equal(body.mesh.faces, faces)
        assert not body.points.flags.writeable
    with pytest.raises(AttributeError):
        made[0].points = x
    two = poses(AT_REST, [2.25, 0, 0, 1, 0, 0, 0])
    for radii, free in [([.125] * 8, False), ([.1] * 8, True)]:
        for body in (ts.Body(x, faces, radii=radii), ts.Body(x, mesh=mesh, radii=radii), ts.Body(thing, radii=radii)):
            assert ts.Bodies([body, body]).first_contact(two, two, quaternion="wxyz").free == free
    for words, kind, given, named in [
            ("points is a Mesh, which has no positions", TypeError, (mesh,), {}),
            ("mesh is 3; it must be a touchstone.Mesh", TypeError, (x,), dict(mesh=3)),
            ("mesh has the elements already", TypeError, (x, faces), dict(mesh=mesh)),
            ("points has the elements already", TypeError, (thing, faces), {}),
            (r"points has the shape \(8, 2\); it must be \(n, 3\)", ValueError, (x[:, :2],), {}),
            (r"points has the shape \(7, 3\); for this mesh it must be \(8, 3\)", ValueError, (x[:7],),
             dict(mesh=mesh)),
            ("in the plane", ValueError, (x[:, :2],), dict(mesh=ts.Mesh(8, edges=[[0, 1]], dimension=2))),
            ("face 0", ValueError, (x[:2], [[0, 1, 2]]), {}), ("vertex 0", ValueError, (x + [np.nan, 0, 0],), {}),
            ("radi", ValueError, (x, faces), dict(radii=[1, 2]))]:
        with pytest.raises(kind, match=words):
            ts.Body(*given, **named)


@pytest.mark.parametrize("bodies, motions", [("[ts.Body(x0, faces), ts.Body(x0 + 0.1, faces)]", 1),
                                             ("[ts.Body([[0, 0, 0]]), ts.Body([[1, 0, 0]])]", 300_000)])
def test_ctrl_c_is_heard(bodies, motions):
    pose = f"np.tile([0, 0, 0, 1, 0, 0, 0], ({motions}, 2, 1))"
    interrupted(f"ts.Bodies({bodies}).all_contacts({pose}, {pose}, quaternion='wxyz', threads=2)")


def test_pickles_and_copies():
    a, b = box(1, .5, .25), ts.Body([[0, 0, 0], [1, 0, 0]], edges=[[0, 1]], radii=[.5, 0])
    bodies = ts.Bodies([a, b, a], separation=.125, metric="max", ignore=[(2, 0)], groups=[0, 1, 2],
                       group_pairs=[[0, 1], [1, 2]], only_listed_groups=True)
    start = poses(AT_REST, [4, 0, 0, 1, 0, 0, 0], [0, 0, 9, 1, 0, 0, 0])
    end = poses([0, 0, 0, 1, 0, 0, 1], [0, 0, 0, -1, 0, 0, 0], [0, 0, 9, 1, 0, 0, 0])
    step = bodies.free_step(start, end, quaternion="wxyz")
    met = bodies.intersections(poses(AT_REST, AT_REST, AT_REST), quaternion="wxyz")
    screw = bodies.solve_screw(start, end, quaternion="wxyz")
    things = [a, b, bodies, step, step.first_contact, step.first_contact.earliest, met, screw]
    assert len(met) and len(step.first_contact.earliest) and step.first_contact.turned.tolist() == [1]
    for thing in things:
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            again = pickle.loads(pickle.dumps(thing, protocol))
            assert type(again) is type(thing) and same(thing, again)
        assert copy.copy(thing) is thing and copy.deepcopy([thing])[0] is thing
        version, data = thing.__getstate__()
        for size in range(0, len(data), 1 + len(data) // 40):
            with pytest.raises(ValueError, match="pickle is"):
                type(thing).__new__(type(thing)).__setstate__((version, data[:size]))
    again = pickle.loads(pickle.dumps(bodies))
    assert same(again.free_step(start, end, quaternion="wxyz"), step)
    assert len(pickle.dumps(ts.Bodies([a] * 100))) < 2 * len(pickle.dumps(a)), "a body is written once"


def test_turns_at_a_constant_rate_have_three_verdicts():
    rod = ts.Body([[0, 0, 0], [2, 0, 0]], edges=[[0, 1]])
    post = ts.Body([[0, 0, -1], [0, 0, 1]], edges=[[0, 1]])
    bodies = ts.Bodies([rod, post])

    def screw(degrees, **named):
        """The rod turns by 160 degrees about z; the post is where it is after so many of them."""
        angle = np.radians(degrees)
        beside = [np.cos(angle), np.sin(angle), 0, 1, 0, 0, 0]
        end = [0, 0, 0, np.cos(np.radians(80)), 0, 0, np.sin(np.radians(80))]
        return bodies.solve_screw(poses(AT_REST, beside), poses(end, beside), quaternion="wxyz", **named)

    found = screw(40)  # a quarter of the turn, and of the time: by the rational arc it is at t = 0.266
    assert found.verdict == "contact" and not found.free and found.start_checked and found.t_max == 1
    assert found.free_until <= .25 <= found.contact_by < .251 and found.free_until > .249
    assert found.pairs[0] == ("edge-edge", (0, 0), (1, 0)) and found.pair_verdict == ["contact"]
    assert found.pair_free_until == found.free_until and found.pair_contact_by == found.contact_by
    assert 0 < found.pair_deviation < 1e-3
    assert repr(found) == (f"<BodyScrewAnswer: contact, free until {found.free_until!r}, contact by "
                           f"{found.contact_by!r}, 1 pairs>")
    missed = screw(170, threads=2, check_start=False)
    assert missed.free and missed.verdict == "free" and missed.free_until == 1 and len(missed.pairs) == 0
    assert repr(missed) == "<BodyScrewAnswer: free; start not checked>"
    early = screw(40, t_max=.125)
    assert early.free and repr(early) == "<BodyScrewAnswer: free; only up to 0.125>"
    grazing = ts.Bodies([rod, ts.Body([[0, 0, 0]])])
    end = poses([0, 0, 0, 1, 0, 0, 1], [0, 2, 0, 1, 0, 0, 0])
    step = poses(AT_REST, [0, 2, 0, 1, 0, 0, 0]), end + [[0, 0, 0, 0, 0, 0, .5], [0] * 7]
    tip = grazing.solve_screw(*step, quaternion="wxyz", most_arcs=16)
    assert tip.verdict == "within the bound" and tip.contact_by == 1 and .7 < tip.free_until < 1
    assert "intersections at the start" in repr(bodies.solve_screw(
        poses(AT_REST, [1, 0, 0, 1, 0, 0, 0]), poses(AT_REST, [1, 0, 0, 1, 0, 0, 0]), quaternion="wxyz"))
    # On a parabola the ball comes down to the other one, which a straight way passes.
    ball = ts.Body([[0, 0, 0]], radii=[.5])
    balls, ends = ts.Bodies([ball, ball]), ([-4, 2, 0, 1, 0, 0, 0], [4, 2, 0, 1, 0, 0, 0])
    ways = poses(ends[0], AT_REST), poses(ends[1], AT_REST)
    assert balls.solve_screw(*ways, quaternion="wxyz").free
    curve = [[[0, -1, 0]], [[0, 0, 0]]]  # at t = 1/2 it is at y = 1/2
    met = balls.solve_screw(*ways, quaternion="wxyz", inner=curve)
    assert met.verdict == "contact" and met.contact_by < .5
    cubic = [[[-4 / 3, 0, 0], [4 / 3, 0, 0]], [[0, 0, 0]] * 2]  # the same parabola
    again = balls.solve_screw(*ways, quaternion="wxyz", inner=cubic)
    assert again.verdict == "contact" and abs(again.contact_by - met.contact_by) < 1e-3
    up = [[[0, 9, 0]], [[0, 0, 0]]]
    both = balls.solve_screw(np.array([ways[0]] * 2), ways[1], quaternion="wxyz", inner=[curve, up], threads=0)
    assert [one.free for one in both] == [False, True]
    for wrong, words in [([0, 0, 0], r"inner has the shape \(3,\); it must be \(k, m, 3\)"),
                         (np.zeros((2, 3, 3)), r"inner has the shape \(2, 3, 3\)"),
                         (np.zeros((1, 2, 3)), r"inner has the shape \(1, 2, 3\); it must be \(n, 2, 2, 3\)"),
                         ([curve, up], "inner is for many motions|inner has 2 motions and the poses have 1"),
                         ([[[0, np.nan, 0]], [[0, 0, 0]]], "body 0")]:
        with pytest.raises(ValueError, match=words):
            balls.solve_screw(*ways, quaternion="wxyz", inner=wrong)
    with pytest.raises(ValueError, match="most_arcs is 100; the number of arcs must be a power of two"):
        screw(40, most_arcs=100)
    with pytest.raises(TypeError, match="arcs is 'many'; it must be a whole number, a power of two"):
        screw(40, arcs="many")


def test_the_distance_of_bodies_at_rest():
    bodies = ts.Bodies([box(1, 1, 1), box(.5, .5, .5)])
    apart = poses(AT_REST, [3, 0, 0, 1, 0, 0, 0])
    found = bodies.distance(apart, quaternion="wxyz")
    assert found.distance == 1.5 and len(found.pairs) > 0 and len(found.intersections) == 0
    assert set(found.pairs.separation) == {1.5} and all(found.pairs.answers.contact)
    assert repr(found) == f"<BodyDistance: 1.5, {len(found.pairs)} pairs, 0 intersections>"
    assert pickle.loads(pickle.dumps(found)).distance == 1.5
    many = bodies.distance(np.stack([apart, apart + [[0] * 7, [1] + [0] * 6]]), quaternion="wxyz", threads=0)
    assert [one.distance for one in many] == [1.5, 2.5]
    inside = bodies.distance(poses(AT_REST, AT_REST), quaternion="wxyz")
    assert inside.distance == 0 and len(inside.pairs) == 0 and inside.intersections.sort == ["inside"]
    assert ts.Bodies([box(1, 1, 1), box(1, 1, 1)], metric="max").distance(
        poses(AT_REST, [5, 4, 0, 1, 0, 0, 0]), quaternion="wxyz").distance == 3
    with pytest.raises(ValueError):
        bodies.distance(apart, quaternion="wyxz")
