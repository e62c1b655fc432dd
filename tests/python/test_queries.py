"""solve, contact_times, distance and contact_normal. SPDX-License-Identifier: MIT"""
import math
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
import pytest
import queries
import touchstone as ts

TRIANGLE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


@pytest.mark.parametrize("kind", queries.KINDS)
def test_a_batch_is_its_queries_one_by_one(kind):
    start, end = queries.both(kind, 400)
    answers = ts.solve(kind, start, end)
    assert len(answers) == 400 and 0 < answers.contact.sum() < 400
    any_touch = ts.solve(kind, start, end, wanted="contact").contact
    times = ts.contact_times(kind, start, end)
    for q in range(400):
        one = ts.solve(kind, start[q], end[q])
        for name in queries.COLUMNS:
            wanted = getattr(answers, name)[q]
            got = getattr(one, name)
            assert np.array_equal(got, wanted), (q, name)
            assert np.array_equal(getattr(answers[q], name), wanted)
        assert any_touch[q] == one.contact == ts.solve(kind, start[q], end[q], wanted="contact").contact
        assert bool(times[q]) == one.contact
        if one.contact:
            first = times[q][0][0]
            assert (first.lower, first.upper) == (one.toi, one.toi_upper)
            assert one.toi <= first <= one.toi_upper


@pytest.mark.parametrize("kind", queries.KINDS)
def test_memory_layouts_types_and_threads_change_nothing(kind):
    start, end = queries.lattice(kind, 3000)
    start[::7] += 0.5
    wanted = ts.solve(kind, start, end, threads=1)
    wide = np.zeros((6000, start.shape[1] + 1, 7))
    wide[::2, 1:, 1::2] = start
    unaligned = np.frombuffer(b"x" + start.tobytes(), np.uint8)[1:].view(np.float64).reshape(start.shape)
    assert not unaligned.flags.aligned
    backwards = np.ascontiguousarray(start[::-1])[::-1]
    layouts = [
        np.asfortranarray(start), wide[::2, 1:, 1::2], unaligned, backwards,
        np.ascontiguousarray(start.transpose(1, 0, 2)).transpose(1, 0, 2),
        np.ascontiguousarray(start.transpose(2, 1, 0)).transpose(2, 1, 0)
    ]
    for x in layouts:
        assert np.array_equal(x, start)
        assert queries.same(ts.solve(kind, x, end, threads=1), wanted)
        assert queries.same(ts.solve(kind, x, np.asfortranarray(end), threads=2), wanted)
    for dtype in (np.float32, np.float16, ">f8", np.longdouble):
        assert queries.same(ts.solve(kind, start.astype(dtype), end), wanted)
    whole = ts.solve(kind, np.floor(start), end)
    for dtype in (np.int8, np.int64, object):
        assert queries.same(ts.solve(kind, np.floor(start).astype(dtype), end), whole)
    assert queries.same(ts.solve(kind, start.tolist(), end.tolist()), wanted)
    for threads in (0, 2, 7, 1024):
        assert queries.same(ts.solve(kind, start, end, threads=threads), wanted)
        assert np.array_equal(ts.solve(kind, start, end, threads=threads, wanted="contact").contact, wanted.contact)


def test_float32_is_taken_exactly():
    x = np.float32(0.1)  # not the double 0.1
    answer = ts.solve("point-point", np.array([[0, 0, 0], [x, 0, 0]], np.float32), np.float32([[1, 0, 0], [x, 0, 0]]))
    assert answer.toi == answer.toi_upper == float(x) != 0.1


def test_the_plane_is_z_0():
    start, end = queries.lattice("point-edge", 500)
    start[:, :, 2] = end[:, :, 2] = 0
    wanted = ts.solve("point-edge", start, end)
    for order in "CF":
        flat = [np.array(x[:, :, :2], order=order) for x in (start, end)]
        assert queries.same(ts.solve("point-edge", *flat), wanted)
    assert 0 < wanted.contact.sum() < 500


def test_methods_agree():
    for kind in queries.KINDS:
        start, end = queries.both(kind, 60)
        fast = ts.solve(kind, start, end)
        for method in ("exact", "oracle", "fast-cgal"):
            other = ts.solve(kind, start, end, method=method)
            for name in ("contact", "toi", "toi_upper", "nature", "feature_a", "feature_b"):
                assert np.array_equal(getattr(fast, name), getattr(other, name)), (kind, method, name)


def test_what_is_not_wanted_is_left_out():
    times, features = ["toi", "toi_upper", "starts_within"], ["nature", "feature_a", "feature_b", "trend"]
    for kind in queries.KINDS:
        start, end = queries.both(kind, 200)
        whole = ts.solve(kind, start, end)
        for wanted, kept in (("features", times + features), ("time", times), ("contact", [])):
            some = ts.solve(kind, start, end, wanted=wanted)
            assert np.array_equal(some.contact, whole.contact)
            for name in kept:
                assert np.array_equal(getattr(some, name), getattr(whole, name)), (kind, wanted, name)
            for name in set(features) - set(kept):
                assert not getattr(some, name).any()
            assert not some.weights_a[some.contact].any() and not some.weights_b[some.contact].any()
            one = ts.solve(kind, start[0], end[0], wanted=wanted)
            assert one.contact == some.contact[0] and np.array_equal(one.toi, some.toi[0], equal_nan=True)
        assert np.isnan(some.toi[some.contact]).all() and np.isinf(some.toi[~some.contact]).all()


def test_separations():
    start, end = queries.both("vertex-face", 300)
    distances = np.abs(np.random.default_rng(5).standard_normal(300)).astype(np.float32)
    distances[::5] = 0
    for metric in ("euclidean", "max"):
        answers = ts.solve("vertex-face", start, end, separation=distances, metric=metric)
        near = ts.solve("vertex-face", start, end, separation=distances, metric=metric, wanted="contact").contact
        times = ts.contact_times("vertex-face", start, end, separation=distances, metric=metric)
        assert np.array_equal(answers.contact, near)
        for q in range(0, 300, 7):
            one = ts.solve("vertex-face", start[q], end[q], separation=float(distances[q]), metric=metric)
            assert repr(one) == repr(answers[q])
            assert (one.toi, one.trend, one.starts_within) == (answers.toi[q], answers.trend[q],
                                                              answers.starts_within[q])
            assert len(times[q]) > 0 if one else times[q] == []
        at = ts.distance("vertex-face", start, end, metric=metric).value
        assert np.array_equal(answers.starts_within[distances > 0], (at <= distances)[distances > 0])


def test_distances_and_normals():
    drop = [[.25, .25, 2]] + TRIANGLE, [[.25, .25, -1]] + TRIANGLE
    for t in (0, 0.25, 1):
        assert ts.distance("vertex-face", *drop, t=t).value == abs(2 - 3 * t)
    found = ts.distance("vertex-face", [drop[0], drop[1]])
    assert found.value.tolist() == [2, 1]
    assert [str(ts.Feature(f)) for f in found.feature_b] == ["f", "f"]
    assert found.weights_b[0] == pytest.approx([.5, .25, .25])
    one = ts.distance("vertex-face", drop[0])
    assert (float(one), str(one.feature_a), one.weights_a) == (2, "v", (1, 0, 0))
    normals = ts.contact_normal("vertex-face", [drop[0], drop[1]], [drop[1], drop[1]])
    assert normals[0].tolist() == [0, 0, -1] and np.isnan(normals[1]).all()
    assert ts.contact_normal("vertex-face", *drop, separation=.5).tolist() == [0, 0, -1]


def test_times_compare_exactly():
    edge = [[0, 0, 0], [1, 0, 0]]
    (first, last), = ts.contact_times("point-edge", [[-1, 0, 0]] + edge, [[2, 0, 0]] + edge)
    assert first == Fraction(1, 3) and last == Fraction(2, 3) and first != last and first != 1 / 3
    assert first < last and last > first and first <= first and not first < first
    assert 0 < first < 1 and first > 1 / 3 and first < math.inf and first > -math.inf
    assert float(first) == first.lower == 1 / 3 < first.upper
    assert first != "1/3" and first != math.nan
    with pytest.raises(TypeError):
        first < "1/3"
    with pytest.raises(TypeError):
        hash(first)
    root = ts.contact_times("point-point", [[0, 0, 0], [1, 0, 0]], [[1, 1, 0], [1, 0, 0]], separation=.75)
    assert "root of" in str(root[0][0]) and root[0][0].lower < root[0][0].upper


def test_attributes_are_read_only_views_that_keep_the_answers_alive():
    start, end = queries.lattice("edge-edge", 100)
    column = ts.solve("edge-edge", start, end).toi
    copy = column.copy()
    ts.solve("edge-edge", end, start)
    assert np.array_equal(column, copy)
    with pytest.raises(ValueError):
        column[0] = 0
    answers = ts.solve("edge-edge", start, end)
    assert answers.toi.base is not None and answers.contact.dtype == bool and answers.weights_a.shape == (100, 3)
    assert [a.contact for a in answers] == answers.contact.tolist()
    assert repr(answers[-1]) == repr(answers[99])
    with pytest.raises(IndexError):
        answers[100]


def test_no_queries():
    nothing = np.empty((0, 4, 3))
    answers = ts.solve("edge-edge", nothing, nothing)
    assert len(answers) == 0 and answers.toi.shape == (0,) and answers.weights_a.shape == (0, 3)
    assert ts.solve("edge-edge", nothing, nothing, wanted="contact").contact.shape == (0,)
    assert ts.contact_times("edge-edge", nothing, nothing) == []
    assert ts.distance("edge-edge", nothing).value.shape == (0,)
    with pytest.raises(ValueError, match="t_max"):
        ts.solve("edge-edge", nothing, nothing, t_max=2)


FUNCTIONS = [ts.solve, ts.contact_times, ts.distance, ts.contact_normal, ts.toi_gradient]


@pytest.mark.parametrize("ask", FUNCTIONS)
def test_wrong_input_is_refused(ask):
    start, end = queries.random("edge-edge", 5000)
    for bad in (math.nan, math.inf, -math.inf):
        for order in "CF":
            wrong = np.array(end, order=order)
            wrong[4321, 2, 1] = bad
            with pytest.raises(ValueError, match=r"row 4321: .*b0"):
                ask("edge-edge", start, wrong)
        with pytest.raises(ValueError, match="b0"):
            ask("edge-edge", start[0], wrong[4321])
    for kind, error in (("edges", ValueError), ("", ValueError), ("edge-edg", ValueError), (3, TypeError),
                        (None, TypeError), ("\udc80", UnicodeError)):
        with pytest.raises(error):
            ask(kind, start, end)
    for x in (start[:, :3], start[:, :, :1], start[0, 0], 0.5, [], [[]], start[None], np.zeros((4, 0, 3))):
        with pytest.raises(ValueError, match="start has the shape"):
            ask("edge-edge", x, end)
    with pytest.raises(ValueError, match="start has 5000 queries and end has 4999"):
        ask("edge-edge", start, end[1:])
    with pytest.raises(ValueError, match="coordinates a corner"):
        ask("edge-edge", start[:, :, :2], end)
    with pytest.raises(ValueError, match="start"):
        ask("edge-edge", [[[1, 2], [3]]], end)
    for x in ([["a"] * 3] * 4, start + 1j, start > 0, None, {}, [[None] * 3] * 4):
        with pytest.raises(TypeError, match="start (has|is)"):
            ask("edge-edge", x, end)
    for threads, error in ((-1, ValueError), (1025, ValueError), (10**30, ValueError), (1.5, TypeError),
                           ("2", TypeError)):
        with pytest.raises(error):
            ask("edge-edge", start, end, threads=threads)


def test_numbers_that_are_no_double_are_refused():
    start, end = [[0, 0], [2**53 + 1, 0]], [[0, 0], [0, 0]]
    with pytest.raises(ValueError, match=r"start\[1, 0\] is 9007199254740993, which no double equals"):
        ts.solve("point-point", start, end)
    with pytest.raises(ValueError, match=r"end\[1, 1\] is 1/3"):
        ts.solve("point-point", end, [[0, 0], [0, Fraction(1, 3)]])
    with pytest.raises(ValueError, match="no double"):
        ts.solve("point-point", np.array(end, np.longdouble) + np.longdouble(1) / 3, end)
    with pytest.raises(ValueError, match="no double"):
        ts.solve("point-point", [[0, 0], [10**400, 0]], end)
    assert ts.solve("point-point", [[0, 0], [2**62, 0]], end).toi == 1
    with pytest.raises(ValueError, match="no double"):
        ts.solve("point-point", end, end, separation=2**53 + 1)


def test_options_without_meaning_are_refused():
    start, end = queries.random("edge-edge", 10)
    for ask in (ts.solve, ts.contact_times, ts.contact_normal):
        for x in ((start, end), (start[0], end[0])):
            for t_max in (-0.1, 1.1, math.nan, math.inf):
                with pytest.raises(ValueError, match="t_max"):
                    ask("edge-edge", *x, t_max=t_max)
            with pytest.raises(TypeError, match="t_max"):
                ask("edge-edge", *x, t_max="1")
            for separation in (-1, math.nan, math.inf):
                with pytest.raises(ValueError):
                    ask("edge-edge", *x, separation=separation)
        with pytest.raises(ValueError, match="separation has the shape"):
            ask("edge-edge", start, end, separation=[1, 2])
        with pytest.raises(ValueError, match="row 3"):
            ask("edge-edge", start, end, separation=[1, 2, 3, -4, 5, 6, 7, 8, 9, 10])
    with pytest.raises(ValueError, match="metric"):
        ts.solve("edge-edge", start, end, metric="l2")
    with pytest.raises(ValueError, match="'fast', 'exact'"):
        ts.solve("edge-edge", start, end, method="quick")
    with pytest.raises(ValueError, match="wanted is 'toi'.*'time'"):
        ts.solve("edge-edge", start, end, wanted="toi")
    with pytest.raises(TypeError):
        ts.solve("edge-edge", start)
    for t in (-1, 2, math.nan):
        with pytest.raises(ValueError, match="t is|t_max|time"):
            ts.distance("edge-edge", start, end, t=t)


def test_a_thousand_threads_worth_of_calls():
    tasks = []
    for seed in range(100):
        for kind in queries.KINDS:
            tasks.append((kind, *queries.lattice(kind, 50, seed)))
    wanted = [ts.solve(*task, threads=1) for task in tasks]
    with ThreadPoolExecutor(64) as pool:
        for _ in range(3):
            got = list(pool.map(lambda task: ts.solve(*task, threads=2), tasks))
            assert all(queries.same(a, b) for a, b in zip(got, wanted))


def test_names():
    assert ts.Nature.names(np.array([[1, 2], [5, 0]], np.uint8)).tolist() == [["crossing", "grazing"],
                                                                              ["entering", "none"]]
    assert str(ts.Feature.f01) == "f01" and ts.Level(2) == ts.Level.exact


def test_masked_elements_are_refused():
    start, end = (x[:6] for x in queries.both("edge-edge", 6))
    wanted = ts.solve("edge-edge", start, end)
    whole = np.ma.array(start, mask=False)
    for unmasked in (whole, np.ma.array(start), np.ma.array(start.astype(np.float32).astype(float)), list(whole)):
        assert len(ts.solve("edge-edge", unmasked, end)) == 6
    assert queries.same(ts.solve("edge-edge", whole, np.ma.array(end)), wanted)
    masked = whole.copy()
    masked[4, 1, 2] = np.ma.masked
    for call in (ts.solve, ts.contact_times):
        with pytest.raises(ValueError, match=r"start\[4, 1, 2\] is masked"):
            call("edge-edge", masked, end)
        with pytest.raises(ValueError, match=r"end\[4, 1, 2\] is masked"):
            call("edge-edge", start, list(masked))
    with pytest.raises(ValueError, match=r"end\[4, 1, 2\] is masked"):
        ts.solve("edge-edge", start, masked.astype(np.float32))
    with pytest.raises(ValueError, match=r"start\[0, 0, 0\] is masked"):
        ts.solve("point-point", [[[np.ma.masked, 0, 0], [1, 0, 0]]], np.zeros((1, 2, 3)))
    with pytest.raises(ValueError, match=r"separation\[1\] is masked"):
        ts.solve("edge-edge", start, end, separation=np.ma.array(np.ones(6), mask=[0, 1, 0, 0, 0, 0]))
    hidden = np.ma.array(np.zeros(6, bool), mask=[0, 0, 1, 0, 0, 0])
    with pytest.raises(ValueError, match=r"contact\[2\] is masked"):
        ts.certify("edge-edge", start, end, hidden)
    with pytest.raises(ValueError, match=r"toi\[2\] is masked"):
        ts.certify("edge-edge", start, end, np.ones(6, bool), np.ma.array(np.zeros(6), mask=hidden.mask))
    mapped = start.view(type("Mapped", (np.ndarray,), {}))  # another subclass, such as np.memmap
    assert queries.same(ts.solve("edge-edge", mapped, end), wanted)


class Exported:
    """An array that has the methods of DLPack and no others."""

    def __init__(self, array, device=1):
        self.array, self.device = array, device

    def __dlpack__(self, stream=None):
        return self.array.__dlpack__()

    def __dlpack_device__(self):
        return (self.device, 0)


def test_arrays_of_other_packages_are_read():
    start, end = queries.both("edge-edge", 5)
    assert queries.same(ts.solve("edge-edge", Exported(start), Exported(end)), ts.solve("edge-edge", start, end))
    with pytest.raises(TypeError, match=r"end is on another device \(number 2 of DLPack\); it must be on the CPU"):
        ts.solve("edge-edge", start, Exported(end, 2))


def test_gradients():
    face = [[0, 0, 0], [4, 0, 0], [0, 4, 0]]
    fall = ([[1, 1, 3]] + face, [[1, 1, -1]] + face)
    gradient = ts.toi_gradient("vertex-face", [fall[0], fall[1]], [fall[1], fall[1]])
    assert gradient.shape == (2, 2, 4, 3) and np.isnan(gradient[1]).all()
    assert gradient[0, :, 0, 2].tolist() == [0.0625, 0.1875] and gradient[0].sum() == 0
    kept = ts.toi_gradient("vertex-face", *fall, separation=.5)
    assert kept[0, 0].tolist() == [0, 0, 0.09375]
    assert ts.toi_gradient("point-point", [[0, 0, 0], [1, 0, 0]], [[2, 0, 0], [1, 0, 0]], 1, .5).shape == (2, 2, 3)
