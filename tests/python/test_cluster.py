"""touchstone.cluster: over threads, processes and a Dask cluster whose workers die. SPDX-License-Identifier: MIT"""
import json
import multiprocessing
import os
import signal
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial

import numpy as np
import pytest
import queries
import touchstone as ts
from touchstone import cluster

KIND = "vertex-face"


def claims(n=4000):
    start, end = queries.both(KIND, n)
    truth = ts.solve(KIND, start, end)
    wrong = truth.contact.copy()
    wrong[::17] ^= True
    toi = np.where(truth.contact, truth.toi, 0.5)
    toi[::13] = 0.75
    return start, end, wrong, toi


def dying(part, marker):
    """The part; but the first worker that is asked for it is killed before it answers."""
    try:
        os.close(os.open(marker, os.O_CREAT | os.O_EXCL))
    except FileExistsError:
        return part
    os.kill(os.getpid(), signal.SIGKILL)


def frame(k):
    """Two points fly towards a third, which one of them hits in step 6."""
    return np.array([[k, 0, 0], [k, 1, 0], [6.5, 0, 0]], float)


def test_parts_put_together_are_the_whole():
    data = claims()
    whole = ts.certify(KIND, *data)
    with ThreadPoolExecutor(4) as pool:
        for rows in (1, 7, 1000, 10_000):
            n = 200 if rows < 100 else 4000
            parts = cluster.partition(*(x[:n] for x in data), rows=rows)
            found = cluster.certify(pool, KIND, parts)
            text = cluster.report(ts.certify(KIND, *(x[:n] for x in data)))
            assert cluster.report(found) == text == cluster.certify_report(pool, KIND, parts)
            answers = cluster.solve(pool, KIND, [part[:2] for part in parts])
            for name in ("contact", "toi", "toi_upper", "nature", "feature_a", "feature_b", "level"):
                assert np.array_equal(getattr(answers, name), getattr(whole.truth, name)[:n]), name
        assert len(cluster.solve(pool, KIND, [])) == 0 and not cluster.certify(pool, KIND, []).holds  # no claims
        late = cluster.certify(pool, KIND, parts, classes=["late"])
        text = cluster.report(late)
        assert text == cluster.certify_report(pool, KIND, parts, classes=["late"])
        assert json.loads(text)["not_counted"] == late.not_counted.sum() > 0
    assert not whole.holds
    text = json.loads(cluster.report(whole))
    assert text["claims"]["missed"] == whole.count(ts.Verdict.missed) > 0
    assert [c["query"] for c in text["refuted"]] == whole.refuted.tolist()


def test_processes_without_dask():
    data = claims(600)
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        found = cluster.certify(pool, KIND, cluster.partition(*data, rows=200))
        assert cluster.report(found) == cluster.report(ts.certify(KIND, *data))
        sequence = cluster.steps(pool, {"vertices": 3}, frame, 10, parts=3)
        assert [step["free"] for step in sequence] == [k != 6 for k in range(10)]
        assert sequence[6]["toi"] == (0.5).hex() and sequence[6]["first"] == ["vertex 0 and vertex 2"]
        assert cluster.steps(pool, {"vertices": 3}, frame, 10, parts=50) == sequence


def early_half(kind, start, end):
    """Misses every contact in the second half of the step."""
    return ts.solve(kind, start, end, t_max=0.5, wanted="contact").contact


def dying_solver(marker, kind, start, end):
    """The same; but the first worker that is asked is killed before it answers."""
    dying(None, marker)
    return early_half(kind, start, end)


def test_fuzzing_in_parts():
    options = {"kinds": ["point-edge", "point-point"], "findings": 100}
    with ThreadPoolExecutor(3) as pool:
        found = cluster.fuzz(pool, early_half, 600, parts=3, seed=5, **options)
        assert found == cluster.fuzz(pool, early_half, 600, parts=3, seed=5, **options)
        alone = [ts.fuzz(early_half, 200, seed=5 + i, **options) for i in range(3)]
        assert found["queries"] == 600 and found["failures"] == sum(one.failures for one in alone) > 0
        assert sum(f["count"] for f in found["findings"]) == sum(f.count for one in alone for f in one.findings)
        for f in found["findings"]:
            start, end = ([[float.fromhex(x) for x in corner] for corner in f[name]] for name in ("start", "end"))
            truth = ts.solve(f["kind"], start, end)
            assert f["failure"] == "missed" and truth.contact and truth.toi.hex() == f["exact"]["toi"]
            assert f["claim"] == {"contact": False, "toi": None} and not early_half(f["kind"], start, end)
        assert json.loads(json.dumps(found)) == found
        assert cluster.fuzz(pool, early_half, 2, parts=50)["queries"] == 2
        with pytest.raises(ValueError, match="part 0: .*none-such"):
            cluster.fuzz(pool, early_half, 10, families=["none-such"])
        with pytest.raises(ValueError, match="cases is 0"):
            cluster.fuzz(pool, early_half, 0)


def test_errors_name_the_part_and_the_row():
    start, end, *_ = claims(100)
    end[73, 1, 1] = np.nan
    pool = ThreadPoolExecutor(2)
    with pytest.raises(ValueError, match="part 7: row 3: .*f0"):
        cluster.solve(pool, KIND, cluster.partition(start, end, rows=10))
    with pytest.raises(ValueError, match="part 1: step 5: "):
        cluster.steps(pool, {"vertices": 3}, lambda k: frame(k)[:2 + (k != 6)], 10, parts=2)
    with pytest.raises(ValueError, match="rows is 0"):
        cluster.partition(start, rows=0)
    with pytest.raises(ValueError, match="must have the same"):
        cluster.partition(start, end[1:])
    with pytest.raises(ValueError):
        cluster.steps(pool, {"vertices": 3}, frame, -1)
    with pytest.raises(TypeError, match="part 0: contact"):
        cluster.certify(pool, KIND, [(start[:50], end[:50], [2] * 50)])


@pytest.fixture(scope="module")
def dask_client():
    distributed = pytest.importorskip("distributed", reason="Dask is missing (Debian: python3-distributed)")
    import dask
    # A cluster of Dask closes what restarts a worker that is not back in time: 15 s are too few on a busy machine.
    dask.config.set({"distributed.worker.memory.terminate": False, "distributed.deploy.lost-worker-timeout": "1 hour"})
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as workers:
        with distributed.Client(workers) as client:
            yield client


def test_a_worker_that_is_killed_loses_nothing_and_changes_no_byte(dask_client, tmp_path):
    data = claims()
    wanted = cluster.report(ts.certify(KIND, *data))
    parts = cluster.partition(*data, rows=250)
    assert cluster.report(cluster.certify(dask_client, KIND, parts)) == wanted
    first = {worker["pid"] if isinstance(worker, dict) else worker for worker in dask_client.run(os.getpid).values()}
    parts[3] = partial(dying, parts[3], str(tmp_path / "first"))
    parts[11] = partial(dying, parts[11], str(tmp_path / "second"))
    assert cluster.report(cluster.certify(dask_client, KIND, parts)) == wanted
    assert {path.name for path in tmp_path.iterdir()} == {"first", "second"}
    assert set(dask_client.run(os.getpid).values()) != first, "no worker died"
    parts[5] = partial(dying, parts[5], str(tmp_path / "again"))
    assert cluster.certify_report(dask_client, KIND, parts) == wanted and (tmp_path / "again").exists()
    whole = ts.solve(KIND, *data[:2])
    parts = [partial(dying, data[:2], str(tmp_path / "third"))]
    answers = cluster.solve(dask_client, KIND, parts)
    assert np.array_equal(answers.toi, whole.toi) and np.array_equal(answers.nature, whole.nature)


def test_sequences_on_dask(dask_client):
    with ThreadPoolExecutor(1) as pool:
        wanted = cluster.steps(pool, {"vertices": 3}, frame, 20, parts=1)
        assert cluster.steps(dask_client, {"vertices": 3}, frame, 20, parts=7) == wanted


def test_fuzzing_on_dask_loses_nothing_with_a_killed_worker(dask_client, tmp_path):
    marker = tmp_path / "fuzz"
    options = {"cases": 400, "parts": 4, "kinds": ["point-point"]}
    with ThreadPoolExecutor(1) as pool:
        wanted = json.dumps(cluster.fuzz(pool, early_half, **options))
    found = cluster.fuzz(dask_client, partial(dying_solver, str(marker)), **options)
    assert marker.exists() and json.dumps(found) == wanted
