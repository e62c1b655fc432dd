"""Questions about whole meshes. SPDX-License-Identifier: MIT"""
from __future__ import annotations

from typing import Optional

from numpy.typing import ArrayLike

from . import _core
from ._core import ClosestApproach, FirstContact, FreeStep, Intersections, Pairs
from ._hints import hinting
from ._mesh_files import AnyMesh, with_positions


@hinting
def first_contact(mesh: AnyMesh, x0: ArrayLike, x1: ArrayLike, t_max: float = 1.0, threads: int = 1, *,
                  check_start: bool = False) -> FirstContact:
    """The first contact while each vertex moves on a straight line from its position in x0 to that in x1.

    mesh     a Mesh of n vertices, what `read_mesh` or `read_frames` returned, or what `as_mesh` takes
    x0, x1   the positions at t = 0 and at t = 1, of shape (n, 3), or (n, 2) in the plane
    t_max    the end of the time range, 0 <= t_max <= 1
    threads  1 (default) to 1024, or 0 for as many as the machine has; it changes nothing in the result
    check_start  whether to ask also where the mesh intersects itself at x0. A step is about a start that is free: where
                 one element passes through another there, and no pair touches, no contact need follow

    Returns a FirstContact with the attributes contact, toi, toi_upper, first, at_start, free, start_checked and
    start_intersections. `first` has every pair whose contact begins at exactly that time, and `at_start` those in
    contact at t = 0, as Pairs with their answers. Raises ValueError for positions that do not fit the mesh or are not
    finite, naming the vertex.

    >>> import numpy as np, touchstone
    >>> mesh = touchstone.Mesh(4, faces=[[0, 1, 2]])  # vertex 3 is a loose point
    >>> x0 = np.array([[-9., -9, 0], [9, -9, 0], [0, 9, 0], [0, 0, 1]])
    >>> x1 = x0.copy()
    >>> x1[3, 2] = -1
    >>> found = touchstone.first_contact(mesh, x0, x1)
    >>> found.toi, mesh.describe(found.earliest[0])
    (0.5, 'vertex 3 and face 0 (0-1-2)')
    """
    return _core.first_contact(mesh, x0, x1, t_max, threads, check_start)


@hinting
def all_contacts(mesh: AnyMesh, x0: ArrayLike, x1: ArrayLike, t_max: float = 1.0, threads: int = 1) -> Pairs:
    """Every pair that comes into contact in [0, t_max], those in contact at the start too, by time and then by pair.

    Arguments and errors are those of `first_contact`. Returns Pairs with their answers.

    >>> import touchstone
    >>> mesh = touchstone.Mesh(2)                    # two loose points
    >>> contacts = touchstone.all_contacts(mesh, [[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [0, 0, 0]])
    >>> contacts[0], contacts.answers.toi.tolist()
    (('point-point', 0, 1), [0.5])
    """
    return _core.all_contacts(mesh, x0, x1, t_max, threads, False)


@hinting
def closest_approach(mesh: AnyMesh, x0: Optional[ArrayLike] = None, x1: Optional[ArrayLike] = None,
                     t_max: float = 1.0, threads: int = 1) -> ClosestApproach:
    """The least distance of two elements that may collide, in a step from x0 to x1, or at rest at x0 without x1.

    Arguments and errors are those of `first_contact`. Without x0 the start is the mesh's own positions, which a Mesh
    does not have. The mesh's metric measures, and its separations and radii do not count. Returns a ClosestApproach:
    `distance` is the least distance, rounded up to a double, 0 where the mesh intersects itself at the start;
    `first_contact` is the answer with it as the separation: when the elements are so near first, and which. Groups of a
    Mesh ask between parts only.

    >>> import touchstone
    >>> near = touchstone.closest_approach(touchstone.Mesh(2), [[0, 0, 0], [1, 0, 0]], [[.75, 0, 0], [1, 0, 0]])
    >>> near.distance, near.first_contact.toi
    (0.25, 1.0)
    """
    own, start = with_positions(mesh, x0, "x0")
    return _core.closest_approach(own, start, start if x1 is None else x1, t_max, threads, False)


@hinting
def candidates(mesh: AnyMesh, x0: ArrayLike, x1: ArrayLike, threads: int = 1) -> Pairs:
    """The pairs whose boxes meet during the step: every pair in contact is among them.

    Arguments and errors are those of `first_contact`. Returns Pairs without answers.

    >>> import touchstone
    >>> len(touchstone.candidates(touchstone.Mesh(2), [[0, 0, 0], [1, 0, 0]], [[0, 0, 0], [5, 0, 0]]))
    0
    """
    return _core.candidates(mesh, x0, x1, 1.0, threads, False)


@hinting
def intersections(mesh: AnyMesh, x: Optional[ArrayLike] = None, threads: int = 1) -> Intersections:
    """Where the mesh intersects itself at the positions x, exactly; separations do not count.

    Without x they are the mesh's own, as of a MeshFile or a mesh of another package. A Mesh has none.

    Returns Intersections, whose attributes are first_element, first, second_element, second, sort, pierces,
    weights_first and weights_second. A sort is 'touches', 'pierces', 'folds' (the elements share a vertex, and a point
    that is no shared vertex) or 'inside' (a closed surface, of which the vertex is one, lies wholly inside
    another one of the same orientation). Raises what `first_contact` raises.

    >>> import touchstone
    >>> mesh = touchstone.Mesh(5, faces=[[0, 1, 2]], edges=[[3, 4]])
    >>> found = touchstone.intersections(mesh, [[0, 0, 0], [1, 0, 0], [0, 1, 0], [.25, .25, -1], [.25, .25, 1]])
    >>> found.first_element[0], found.first.tolist(), found.second_element[0], found.pierces.tolist()
    ('edge', [0], 'face', [True])
    """
    return _core.intersections(*with_positions(mesh, x, "x"), threads)


@hinting
def intersects(mesh: AnyMesh, x: Optional[ArrayLike] = None, threads: int = 1) -> bool:
    """Whether `intersections` finds any. It ends at the first one that it meets. Raises what `first_contact` raises.

    >>> import touchstone
    >>> touchstone.intersects(touchstone.Mesh(2), [[0, 0, 0], [0, 0, 0]])
    True
    """
    return _core.intersects(*with_positions(mesh, x, "x"), threads)


@hinting
def free_step(mesh: AnyMesh, x0: ArrayLike, x1: ArrayLike, kept_fraction: float = 0.0, threads: int = 1, *,
              check_start: bool = False, float32: bool = False) -> FreeStep:
    """The longest step from x0 towards x1 that is proved free of contact, to positions rounded as they are returned.

    mesh, x0, x1, threads, check_start  as in `first_contact`
    kept_fraction  in [0, 1): each pair keeps more than this fraction of its distance at the start
    float32        whether the positions at the end are float32 numbers, as those at the start must be then; x1 is
                   rounded to such numbers first

    Returns a FreeStep with the attributes outcome, length, positions, first_contact and proofs. Raises what
    `first_contact` raises.

    >>> import touchstone
    >>> step = touchstone.free_step(touchstone.Mesh(2), [[0, 0, 0], [1, 0, 0]], [[4, 0, 0], [1, 0, 0]])
    >>> step.outcome, 0.249 < step.length < 0.25
    ('shortened', True)
    """
    return _core.free_step(mesh, x0, x1, kept_fraction, threads, check_start, float32)
