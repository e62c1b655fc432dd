"""Gradients for PyTorch, against differences. SPDX-License-Identifier: MIT"""
import math

import numpy as np
import pytest
import touchstone as ts

torch = pytest.importorskip("torch", reason="torch is not installed")
from touchstone import torch as tt  # noqa: E402


def queries(seed, kind, corners, count=40):
    """Elements that come near each other."""
    rng = np.random.default_rng(seed)
    start = rng.uniform(-1, 1, (count, corners, 3))
    end = start + rng.uniform(-3, 3, (count, corners, 3))
    return kind, torch.tensor(start), torch.tensor(end)


@pytest.mark.parametrize("separation", [0.0, 0.05])
@pytest.mark.parametrize("kind, corners", [("edge-edge", 4), ("vertex-face", 4), ("point-edge", 3), ("point-point", 2)])
def test_the_gradient_of_a_time_is_that_of_differences(kind, corners, separation):
    kind, start, end = queries(3, kind, corners, 150)
    if kind in ("point-edge", "point-point"):
        separation *= 10
    start.requires_grad_()
    end.requires_grad_()
    times = tt.toi(kind, start, end, separation=separation)
    assert np.array_equal(times.detach().numpy(), ts.solve(kind, start.detach().numpy(), end.detach().numpy(),
                                                           separation=separation).toi)
    finite = torch.isfinite(times)
    torch.where(finite, times, torch.zeros_like(times)).sum().backward()
    compared = 0
    for tensor, which in ((start, 0), (end, 1)):
        grad, h = tensor.grad.numpy(), 1e-6
        for q in np.flatnonzero(finite.numpy())[:30]:
            if not np.isfinite(grad[q]).all() or abs(grad[q]).max() > 100:
                continue
            for c in range(corners):
                moved = []
                for sign in (-1, 1):
                    pair = [start.detach().numpy()[q].copy(), end.detach().numpy()[q].copy()]
                    pair[which][c, 1] += sign * h
                    moved.append(ts.solve(kind, *pair, separation=separation).toi)
                if not np.isfinite(moved).all():
                    continue
                assert math.isclose((moved[1] - moved[0]) / (2 * h), grad[q, c, 1], rel_tol=1e-3, abs_tol=1e-3)
                compared += 1
    assert compared > 20 or (kind in ("point-edge", "point-point") and separation == 0)  # these two hardly ever touch


@pytest.mark.parametrize("kind, corners", [("edge-edge", 4), ("vertex-face", 4), ("point-edge", 3), ("point-point", 2)])
def test_the_gradient_of_a_distance_is_that_of_differences(kind, corners):
    kind, x, _ = queries(4, kind, corners)
    x.requires_grad_()
    tt.distance(kind, x).sum().backward()
    h, at, compared = 1e-7, x.detach().numpy(), 0
    for q in range(20):
        if not np.isfinite(x.grad[q].numpy()).all():
            continue
        for c in range(corners):
            for k in range(3):
                moved = [at[q].copy(), at[q].copy()]
                moved[0][c, k] -= h
                moved[1][c, k] += h
                low, high = (ts.distance(kind, one).value for one in moved)
                assert math.isclose((high - low) / (2 * h), x.grad[q, c, k], rel_tol=1e-4, abs_tol=1e-4)
                compared += 1
    assert compared > 15 * corners * 3


def test_without_a_gradient():
    start = torch.tensor([[[0., 0, 1], [5, 5, 5]], [[0, 0, 1], [0, 0, 0]]], dtype=torch.float64, requires_grad=True)
    end = start.detach() * torch.tensor([1., 1, -1], dtype=torch.float64)
    end[0, 1] = 5
    times = tt.toi("point-point", start, end)
    assert times.tolist() == [math.inf, 0.5]
    times[1].backward()
    assert start.grad[0].abs().max() == 0 and start.grad[1].isnan().all()
    flat = torch.tensor([[0., 1], [0, 0]], dtype=torch.float64, requires_grad=True)
    tt.toi("point-point", flat, torch.tensor([[0., -1], [0, 0]], dtype=torch.float64), separation=0.5).backward()
    assert flat.grad.shape == (2, 2)


def test_distances_of_all_sizes():
    for scale in (1e200, 1e-200):
        x = torch.tensor([[scale, 0, 0], [0, 0, 0]], dtype=torch.float64, requires_grad=True)
        tt.distance("point-point", x).backward()
        assert x.grad.tolist() == [[1, 0, 0], [-1, 0, 0]]
    x = torch.tensor([[1 / 3, 1 / 3 + 2**-54, 0], [0, 0, 0], [1, 1, 0]], dtype=torch.float64, requires_grad=True)
    tt.distance("point-edge", x).backward()
    assert np.allclose(x.grad[0], [-math.sqrt(0.5), math.sqrt(0.5), 0], atol=1e-14)


def test_what_a_gradient_needs_is_kept():
    start = torch.tensor([[0., 0, 4], [0, 0, 0]], dtype=torch.float64, requires_grad=True)
    end = torch.tensor([[0., 0, -4], [0, 0, 0]], dtype=torch.float64)
    time = tt.toi("PP", start, end, separation=2.0)
    assert tt.distance("EE", torch.rand(3, 4, 3, dtype=torch.float64)).shape == (3,)
    with pytest.raises(RuntimeError, match="once_differentiable"):
        slope, = torch.autograd.grad(time**2, start, create_graph=True)
        slope.sum().backward()
    end[0, 2] = -7
    with pytest.raises(RuntimeError, match="modified by an inplace operation"):
        tt_time = time.sum()
        tt_time.backward()
    many = torch.tensor([[[0., 0, 1], [0, 0, 0]], [[0, 0, 0], [0, 0, 0]]], dtype=torch.float64, requires_grad=True)
    tt.toi("point-point", many, many.detach() * -1, separation=0.5)[0].backward()
    assert many.grad.isfinite().all()
    with pytest.raises(TypeError, match="here it is 'separation'"):
        tt.toi("point-point", start, end, min_distance=1.0)


def test_other_tensors_are_refused():
    with pytest.raises(ValueError, match="must be of torch.float64 on the CPU"):
        tt.toi("point-point", torch.zeros(2, 3), torch.zeros(2, 3))
    with pytest.raises(TypeError, match="it must be a tensor"):
        tt.distance("point-point", np.zeros((2, 3)))
