"""Meshes from files. SPDX-License-Identifier: MIT"""
from __future__ import annotations

import os
from typing import Any, Iterable, List, NamedTuple, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import is_file_name
from ._core import Mesh
from ._hints import shown


class _FileFields(NamedTuple):
    mesh: Mesh
    positions: npt.NDArray[np.float64]
    parts: List[str]
    face_parts: npt.NDArray[np.uint32]


class _FramesFields(NamedTuple):
    mesh: Mesh
    positions: npt.NDArray[np.float64]


class _Mended:
    welded_vertices = 0
    dropped_elements = 0


class MeshFile(_FileFields, _Mended):
    """A mesh of a file: `mesh`, `positions` (n, 3), the names of its objects or groups as `parts`, and `face_parts`,
    the index into them of each face, empty without names. The attributes `welded_vertices` and `dropped_elements` count
    what `weld` and `drop_degenerate` changed."""


class Frames(_FramesFields, _Mended):
    """The frames of an animation: the `mesh` that all have, and `positions` of shape (frames, n, 3). The attributes
    `welded_vertices` and `dropped_elements` count what `weld` and `drop_degenerate` changed."""


AnyMesh = Union[Mesh, MeshFile, Frames, Any]  # Any: what as_mesh takes
_Path = Union[str, os.PathLike[str]]
_Arrays = Tuple[Any, Any, Any, Any, List[str], Any, int, int]


def _counted(result: Any, arrays: _Arrays) -> Any:
    result.welded_vertices, result.dropped_elements = arrays[6:]
    return result


def _mesh_of(reader: Any, arrays: _Arrays, path: Any, between_parts: bool) -> Mesh:
    try:
        return _mesh_of_arrays(arrays, path, between_parts)
    except ValueError:
        reader.check_elements(os.fsdecode(path))  # names the file and the remedy
        raise


def _mesh_of_arrays(arrays: _Arrays, path: Any, between_parts: bool) -> Mesh:
    positions, faces, edges, points, parts, face_parts = arrays[:6]
    # Vertices in no element of the file do not collide, and corners are no loose points.
    loose = np.setdiff1d(points, np.concatenate([faces.ravel(), edges.ravel()]))
    if not between_parts:
        return Mesh(len(positions), faces, edges, loose)
    if not parts:
        raise ValueError(f"{path}: names no parts, objects or groups, and between_parts is True")
    groups = np.full(len(positions), len(parts), np.uint32)
    groups[faces] = face_parts[:, np.newaxis]
    shared = np.flatnonzero((groups[faces] != face_parts[:, np.newaxis]).any(axis=1))
    if len(shared):
        raise ValueError(f"{path}: face {shared[0]} shares a vertex with another part, and between_parts is True")
    numbers = np.arange(len(parts), dtype=np.uint32)
    return Mesh(len(positions), faces, edges, loose, groups=groups, group_pairs=np.stack([numbers, numbers], axis=1))


def _triangles(polygons: Any, triangulate: bool, name: str) -> npt.NDArray[np.int64]:
    """The triangles of polygons, an array or a list, in their order; those of one share its first corner."""
    equal = isinstance(polygons, np.ndarray) and polygons.ndim == 2
    groups = [polygons] if equal else [np.asarray(polygon)[np.newaxis] for polygon in polygons]
    for group in groups:
        corners = group.shape[1]
        if corners < 3 or corners > 3 and not triangulate:
            raise ValueError(f"{name} has a face of {corners} corners; a face has three" +
                             ("; as_mesh(..., triangulate=True) cuts it into triangles" if corners > 3 else ""))
    return np.concatenate([np.empty((0, 3), int)] + [
        np.stack([group[:, [0, i, i + 1]] for i in range(1, group.shape[1] - 1)], axis=1).reshape(-1, 3)
        for group in groups])


def _padded(flat: Any, name: str) -> List[npt.NDArray[np.int64]]:
    """PyVista's cells: the number of corners before each one's corners."""
    values, cells, i = np.asarray(flat).ravel(), [], 0
    while i < len(values):
        count = int(values[i])
        if not 0 < count < len(values) - i:
            raise ValueError(f"{name}[{i}] says that {count} corners follow, and there are {len(values) - i - 1}")
        cells.append(values[i + 1:i + 1 + count])
        i += 1 + count
    return cells


def _padded_faces(flat: Any) -> Any:
    values = np.asarray(flat).ravel()
    if len(values) % 4 == 0 and (values[::4] == 3).all():
        return values.reshape(-1, 4)[:, 1:]
    return _padded(values, "thing.faces")


def _padded_edges(flat: Any) -> npt.NDArray[np.int64]:
    """A line of more corners than two is several edges."""
    lines = _padded(flat, "thing.lines")
    if any(len(line) < 2 for line in lines):
        raise ValueError("thing.lines has a line of one corner; a line has two or more")
    return np.concatenate([np.stack([line[:-1], line[1:]], axis=1) for line in lines])


def _meshio_cells(thing: Any, triangulate: bool) -> Any:
    cells = {"triangle": [np.empty((0, 3), int)], "line": [np.empty((0, 2), int)], "vertex": [np.empty((0, 1), int)]}
    for block in thing.cells:
        if block.type == "quad" or block.type.startswith("polygon"):
            cells["triangle"].append(_triangles(np.asarray(block.data), triangulate, "the mesh"))
        elif block.type in cells:
            cells[block.type].append(np.asarray(block.data))
        else:
            raise ValueError(f"the mesh has cells of type '{block.type}'; right are triangle, line and vertex, and "
                             "quad and polygon by as_mesh(..., triangulate=True). thing.write('a.vtk') and read_mesh "
                             "take the surface of tetrahedra")
    return [np.concatenate(cells[name]) for name in ("triangle", "line", "vertex")]


def _file_of(thing: Any, triangulate: bool = False) -> Optional[MeshFile]:
    """The mesh and positions of a thing that has both; None for other things."""
    if isinstance(thing, (Mesh, MeshFile)):
        return thing if isinstance(thing, MeshFile) else None
    none = np.empty((0, 2), int)
    faces, edges, points = np.empty((0, 3), int), none, np.empty((0, 1), int)
    if hasattr(thing, "points") and isinstance(getattr(thing, "cells", None), list):
        positions, (faces, edges, points) = thing.points, _meshio_cells(thing, triangulate)
    elif hasattr(thing, "vertices") and hasattr(thing, "triangles"):
        positions, faces = thing.vertices, thing.triangles
    elif hasattr(thing, "vertices") and hasattr(thing, "faces"):
        positions, faces = thing.vertices, _triangles(np.asarray(thing.faces), triangulate, "thing.faces")
    elif hasattr(thing, "points") and hasattr(thing, "faces"):
        positions, faces = thing.points, _triangles(_padded_faces(thing.faces), triangulate, "thing.faces")
        edges = _padded_edges(thing.lines) if len(getattr(thing, "lines", ())) else edges
        points = np.concatenate(_padded(thing.verts, "thing.verts")) if len(getattr(thing, "verts", ())) else points
        if len(getattr(thing, "strips", ())):
            raise ValueError("the PolyData has strips of triangles; triangulate() makes faces of them")
        if not len(faces) and not len(edges):
            raise ValueError("the PolyData has neither faces nor lines; Mesh(len(points)) makes loose points")
    elif hasattr(thing, "points") and hasattr(thing, "lines"):
        positions, edges = thing.points, thing.lines
    else:
        return None
    at = np.ascontiguousarray(np.asarray(positions), dtype=np.float64)
    mesh = Mesh(at, np.asarray(faces), np.asarray(edges), np.unique(np.asarray(points).ravel()))
    return MeshFile(mesh, at, [], np.empty(0, np.uint32))


def _no_mesh(thing: Any, name: str, right: str) -> TypeError:
    return TypeError(f"{name} {shown(thing)}; it must be {right}a mesh of meshio, trimesh, PyVista or Open3D, with "
                     "points and cells, vertices and faces, vertices and triangles, or points and lines" +
                     ("; read_mesh reads a mesh from a file" if is_file_name(thing) else ""))


def as_mesh(thing: Any, *, triangulate: bool = False) -> MeshFile:
    """The mesh of an object of meshio, trimesh, PyVista (PolyData) or Open3D (TriangleMesh, LineSet).

    thing  the object. It is known by its attributes, points and cells, vertices and faces, points and faces, vertices
           and triangles, or points and lines, so that no package need be there. A MeshFile is returned as it is
    triangulate  whether faces of more than three corners are cut into triangles that share the first corner; without it
           they are errors

    Returns a MeshFile with mesh and positions, in the object's numbering. Vertices in no element do not collide. Raises
    TypeError for other objects, and ValueError for cells that are neither triangles, edges nor points. Functions that
    take a Mesh take such an object, too, and what `read_mesh` and `read_frames` return.

    >>> import types, touchstone
    >>> thing = types.SimpleNamespace(vertices=[[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces=[[0, 1, 2]])
    >>> touchstone.as_mesh(thing).mesh
    <Mesh: 3 vertices, 1 faces, 3 edges, 0 loose points>
    """
    file = _file_of(thing, triangulate)
    if isinstance(thing, Mesh):
        raise TypeError("thing is a touchstone.Mesh, which has no positions")
    if file is None:
        raise _no_mesh(thing, "thing", "")
    return file


def as_argument(mesh: Any) -> Mesh:
    """The Mesh of an argument `mesh`. Raises TypeError for what has none."""
    if isinstance(mesh, Mesh):
        return mesh
    file = mesh if isinstance(mesh, Frames) else _file_of(mesh)
    if file is None:
        raise _no_mesh(mesh, "mesh", "a touchstone.Mesh, what read_mesh or read_frames returned, or ")
    return file.mesh


def with_positions(mesh: Any, x: Any, name: str) -> Tuple[Mesh, Any]:
    """The Mesh of an argument, and positions x, which are the mesh's own where x is None."""
    if x is None:
        mesh = _file_of(mesh) or mesh
        if isinstance(mesh, MeshFile):
            x = mesh.positions
        elif isinstance(mesh, Frames):
            raise TypeError(f"{name} is not given, and Frames have many positions: frames.positions[0] are the first")
        elif isinstance(mesh, Mesh):
            raise TypeError(f"{name} is not given, and a Mesh has no positions of its own")
    return as_argument(mesh), x


def read_mesh(path: _Path, *, triangulate: bool = False, between_parts: bool = False, weld: bool = False,
              drop_degenerate: bool = False) -> MeshFile:
    """The mesh of a file in one of the program's formats: .obj, .ply, .stl, .vtk, .vtu, .vtp, .off, .msh, .gltf or
    .glb.

    path           the file; its ending says the format. Coordinates are read without loss, decimals as the nearest
                   doubles
    triangulate    whether polygons of more than three corners are cut into triangles that share the first corner;
                   without it they are errors
    between_parts  whether pairs within one object or group of the file never collide
    weld           whether elements name the first of the vertices of one object or group at exactly one position in
                   place of the others: for files with a vertex for each face. The others stay, and are in no element
    drop_degenerate  whether faces and edges that name a vertex twice, or the vertices of one before them, are left out;
                   without it they are errors

    Returns a MeshFile with mesh, positions, parts and face_parts; its attributes welded_vertices and dropped_elements
    count what was mended. Vertices are numbered from 0. Raises ValueError for
    what the reader does not understand completely: the message names the file and the line, and what would be right.

    >>> import pathlib, tempfile, touchstone
    >>> path = pathlib.Path(tempfile.mkdtemp(), 'a.off')
    >>> _ = path.write_text('OFF 4 2 0\\n0 0 0\\n1 0 0\\n0 .1 0\\n0 0 3\\n3 0 1 2\\n1 3\\n')
    >>> file = touchstone.read_mesh(path)
    >>> file.mesh, file.positions[2].tolist()
    (<Mesh: 4 vertices, 1 faces, 3 edges, 1 loose points>, [0.0, 0.1, 0.0])
    """
    reader = _core.MeshReader(triangulate, weld, drop_degenerate)
    arrays = reader.read(_decoded(path, "path is", "a file's name"))
    return _counted(MeshFile(_mesh_of(reader, arrays, path, between_parts), arrays[0], arrays[4], arrays[5]), arrays)


def _decoded(path: Any, what: str, right: str) -> str:
    if not isinstance(path, (str, bytes, os.PathLike)):
        raise TypeError(f"{what} of type {type(path).__name__}; it must be {right}")
    return os.fsdecode(path)


def _frame_files(paths: Union[_Path, Iterable[_Path]], in_order: Optional[bool]) -> List[str]:
    if isinstance(paths, (str, bytes, os.PathLike)):
        if os.path.isfile(paths):
            raise TypeError("paths must be several files, a folder or a pattern; read_mesh reads one")
        names = [os.fsdecode(paths)] if paths else []
    elif isinstance(paths, Iterable):
        names = [_decoded(path, "paths has an element", "the name of a file or a folder, or a pattern")
                 for path in paths]
    else:
        raise TypeError(f"paths is of type {type(paths).__name__}; it must be a folder, a pattern such as "
                        "'cloth-*.obj', or a list of files")
    if not names:
        raise ValueError("paths is empty; it must be the files of the frames")
    one = isinstance(paths, (str, bytes, os.PathLike))
    return _core.frame_files(names, bool(in_order) if one else in_order is None or in_order)


def read_frames(paths: Union[_Path, Iterable[_Path]], *, in_order: Optional[bool] = None, triangulate: bool = False,
                between_parts: bool = False, weld: bool = False, drop_degenerate: bool = False) -> Frames:
    """The frames of an animation: the mesh that all files have, and their positions, of shape (frames, n, 3).

    paths     the files, or a folder, or a pattern such as 'cloth-*.obj', which stand for their files
    in_order  True: the frames have the order of `paths`, whatever the files are called, and the files of a pattern have
              the order of their numbers. False: all are in the order of their numbers, cloth-2.obj before cloth-10.obj,
              and a number that is missing is an error, as in `touchstone mesh`. None, the default, is True for a list,
              and False for one folder or pattern
    weld      as in `read_mesh`; the first frame says which vertices, and a frame where they are apart is an error
    The other arguments are those of `read_mesh`

    Returns Frames, a tuple (mesh, positions) with the attributes welded_vertices and dropped_elements. Raises
    ValueError for what `read_mesh` raises it, for no file, and for a file with other elements than the first.

    >>> import pathlib, tempfile, touchstone
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> for z in range(2):
    ...     text = f'OFF 4 2 0\\n0 0 {z}\\n1 0 0\\n0 1 0\\n9 9 9\\n3 0 1 2\\n1 3\\n'
    ...     _ = (folder / f'{z}.off').write_text(text)
    >>> mesh, x = touchstone.read_frames(folder / '*.off')
    >>> x.shape, touchstone.first_contact(mesh, x[0], x[1]).free
    ((2, 4, 3), True)
    """
    names = _frame_files(paths, in_order)
    reader = _core.MeshReader(triangulate, weld, drop_degenerate)
    first = reader.read(names[0])
    mesh = _mesh_of(reader, first, names[0], between_parts)
    positions = [first[0]]
    for name in names[1:]:
        arrays = reader.read(name)
        for what, one, other in zip(("vertices", "faces", "edges", "points"), first, arrays):
            same = one.shape == other.shape and (what == "vertices" or np.array_equal(one, other))
            if not same:
                raise ValueError(f"{name} has other {what} than {names[0]}; all frames must have the same elements")
        if between_parts and (arrays[4] != first[4] or not np.array_equal(arrays[5], first[5])):
            raise ValueError(f"{name} has other parts than {names[0]}, and between_parts is True")
        positions.append(arrays[0])
    return _counted(Frames(mesh, np.stack(positions)), first)
