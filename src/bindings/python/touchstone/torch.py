"""First contacts and distances for PyTorch, with their gradients. It needs torch; tensors are of float64, on the CPU.
SPDX-License-Identifier: MIT"""
from __future__ import annotations

from typing import Any, Tuple

import numpy as np
import torch as _torch  # type: ignore[import]

from . import _core, _queries
from ._hints import hinting
from ._queries import Kind

once_differentiable = _torch.autograd.function.once_differentiable
_CORNERS_OF_FIRST = {"edge-edge": 2, "vertex-face": 1, "point-edge": 1, "point-point": 1}


def _array(tensor: Any, name: str) -> Any:
    if not isinstance(tensor, _torch.Tensor):
        raise TypeError(f"{name} is of type {type(tensor).__name__}; it must be a tensor")
    if tensor.dtype != _torch.float64 or tensor.device.type != "cpu":
        raise ValueError(f"{name} is of {tensor.dtype} on {tensor.device}; it must be of torch.float64 on the CPU: "
                         f"{name}.double().cpu()")
    return tensor.detach().numpy()


def _times(derivatives: Any, grad: Any) -> Any:
    """Their products, which are 0 where the loss does not depend on a query, also one without a derivative."""
    return _torch.where(grad == 0, _torch.zeros_like(derivatives), derivatives * grad)


class _Toi(_torch.autograd.Function):  # type: ignore[misc]
    @staticmethod
    def forward(ctx: Any, *given: Any) -> Any:  # type: ignore[override]
        kind, start, end, t_max, separation, threads = given
        x0, x1 = _array(start, "start"), _array(end, "end")
        answers = _queries.solve(kind, x0, x1, t_max, separation, threads=threads, wanted="time")
        ctx.save_for_backward(start, end)
        ctx.asked = (t_max, separation, threads)
        ctx.kind, ctx.contact = kind, np.asarray(answers.contact)
        return _torch.from_numpy(np.array(answers.toi, dtype=np.float64))

    @staticmethod
    @once_differentiable  # type: ignore[misc]
    def backward(ctx: Any, grad: Any) -> Tuple[Any, ...]:  # type: ignore[override]
        x0, x1 = (tensor.detach().numpy() for tensor in ctx.saved_tensors)
        derivatives = _queries.toi_gradient(ctx.kind, x0, x1, *ctx.asked)
        contact = ctx.contact[..., np.newaxis, np.newaxis, np.newaxis]
        by_time: Any = _torch.from_numpy(np.where(contact, derivatives, 0.0))
        by_start, by_end = _times(by_time, grad[..., None, None, None]).unbind(-3)
        return None, by_start[..., :x0.shape[-1]], by_end[..., :x0.shape[-1]], None, None, None


@hinting
def toi(kind: Kind, start: Any, end: Any, t_max: float = 1.0, separation: float = 0.0, threads: int = 1) -> Any:
    """The largest double <= the exact time of each query's first contact, as a tensor; inf without one.

    start, end  tensors of shape (n, corners, 3) or (corners, 3); the other arguments are those of `touchstone.solve`

    The gradient is that of the exact time, by `touchstone.toi_gradient`: 0 without a contact, and NaN for a contact
    whose time has no derivative, if the loss depends on it: in contact at the start, only touching, or at a corner or
    border. There is no second derivative. Raises TypeError and ValueError for tensors of another type or on another
    device, and what `touchstone.solve` raises.

    >>> import torch, touchstone.torch
    >>> start = torch.tensor([[0., 0, 4], [0, 0, 0]], dtype=torch.float64, requires_grad=True)
    >>> end = torch.tensor([[0., 0, -4], [0, 0, 0]], dtype=torch.float64)
    >>> time = touchstone.torch.toi('point-point', start, end, separation=2.)
    >>> time.backward()
    >>> time.item(), start.grad[0].tolist()
    (0.25, [0.0, 0.0, 0.09375])
    """
    return _Toi.apply(kind, start, end, t_max, separation, threads)


class _Distance(_torch.autograd.Function):  # type: ignore[misc]
    @staticmethod
    def forward(ctx: Any, *given: Any) -> Any:  # type: ignore[override]
        kind, corners, threads = given
        x = _array(corners, "corners")
        found = _queries.distance(kind, x, threads=threads)
        first = _CORNERS_OF_FIRST[_core.kind_name(kind)]
        weights = np.concatenate([-np.asarray(found.weights_a)[..., :first],
                                  np.asarray(found.weights_b)[..., :x.shape[-2] - first]], axis=-1)
        value = np.array(found.value, dtype=np.float64)
        # Of elements that are within the next double at rest; it is exact but for the last bits.
        normal = _queries.contact_normal(kind, x, x, 1.0, np.nextafter(value, np.inf), threads)
        normal = np.where((value > 0)[..., np.newaxis], normal, np.nan)[..., :x.shape[-1]]
        ctx.derivatives = weights[..., np.newaxis] * normal[..., np.newaxis, :]
        return _torch.from_numpy(value)

    @staticmethod
    @once_differentiable  # type: ignore[misc]
    def backward(ctx: Any, grad: Any) -> Tuple[Any, ...]:  # type: ignore[override]
        return None, _times(_torch.from_numpy(ctx.derivatives), grad[..., None, None]), None


@hinting
def distance(kind: Kind, corners: Any, threads: int = 1) -> Any:
    """The Euclidean distance of each query's elements at rest, as a tensor: the double nearest to the exact one.

    corners  a tensor of shape (n, corners, 3) or (corners, 3); the other arguments are those of `touchstone.distance`

    The gradient is that for the closest points, each derivative within some 2^-48: NaN where the elements touch. Where
    several pairs of points are closest it is the one of those that `touchstone.distance` names. Raises what `toi` raises.

    >>> import torch, touchstone.torch
    >>> corners = torch.tensor([[0., 3, 0], [-1, 0, 0], [1, 0, 0]], dtype=torch.float64, requires_grad=True)
    >>> apart = touchstone.torch.distance('point-edge', corners)
    >>> apart.backward()
    >>> apart.item(), (corners.grad + 0).tolist()
    (3.0, [[0.0, 1.0, 0.0], [0.0, -0.5, 0.0], [0.0, -0.5, 0.0]])
    """
    return _Distance.apply(kind, corners, threads)
