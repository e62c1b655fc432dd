"""Meshes from files, and how near their elements come. SPDX-License-Identifier: MIT"""
import math

import numpy as np
import pytest
import touchstone as ts

OBJ = "o base\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\no lid\nv 1 1 {z}\nv 4 4 2\nv 1 4 2\nf 4 5 6\nv 9 9 9\nl 1 2\np 2\n"


def write(folder, name, text):
    path = folder / name
    path.write_text(text)
    return path


def test_a_mesh_is_read_with_its_parts(tmp_path):
    path = write(tmp_path, "a.obj", OBJ.format(z=0.1))
    mesh, positions, parts, face_parts = ts.read_mesh(path)
    assert (mesh.faces.tolist(), mesh.edges[0].tolist(), len(mesh.points)) == ([[0, 1, 2], [3, 4, 5]], [0, 1], 0)
    assert (positions.shape, positions[3].tolist()) == ((7, 3), [1, 1, 0.1])
    assert (parts, face_parts.tolist()) == (["base", "lid"], [0, 1])
    assert ts.read_mesh(str(path)).mesh.vertex_count == 7
    points = ts.read_mesh(write(tmp_path, "p.off", "OFF 2 0 0\n0 0 0\n1 0 0\n"))
    assert (points.mesh.points.tolist(), points.parts) == ([0, 1], [])


def test_frames_are_read_in_their_order(tmp_path):
    paths = [write(tmp_path, f"{z}.obj", OBJ.format(z=z)) for z in (2, 1, 0.25)]
    mesh, x = ts.read_frames(paths, between_parts=True)
    assert x[:, 3, 2].tolist() == [2, 1, 0.25]
    near = ts.closest_approach(mesh, x[1], x[2])
    assert near.distance == 0.25 and mesh.describe(near.first_contact.earliest[0]) == "vertex 3 and face 0 (0-1-2)"
    assert near.first_contact.toi == 1 and repr(near) == "<ClosestApproach: distance 0.25>"
    assert ts.closest_approach(mesh, x[1], x[2], t_max=0.5).distance == 0.625
    assert ts.closest_approach(mesh, x[1]).distance == 1
    with pytest.warns(UserWarning, match="no two elements"):
        assert ts.closest_approach(ts.Mesh(1), [[0, 0, 0]]).distance == math.inf
    with pytest.raises(ValueError, match="other vertices"):
        ts.read_frames(paths + [write(tmp_path, "x.obj", OBJ.format(z=1) + "v 0 0 0\n")])
    with pytest.raises(ValueError, match="other faces"):
        ts.read_frames(paths + [write(tmp_path, "y.obj", OBJ.format(z=1).replace("f 4 5 6", "f 4 6 5"))])
    with pytest.raises(ValueError, match="paths is empty"):
        ts.read_frames([])
    with pytest.raises(TypeError, match="read_mesh reads one"):
        ts.read_frames(paths[0])


def test_patterns_and_folders_stand_for_their_frames(tmp_path):
    for z in (1, 2, 10):
        write(tmp_path, f"f-{z}.obj", OBJ.format(z=z))

    def heights(paths, **options):
        return ts.read_frames(paths, **options)[1][:, 3, 2].tolist()

    pattern = str(tmp_path / "f-*.obj")
    assert heights(pattern, in_order=True) == heights(tmp_path, in_order=True) == heights([pattern]) == [1, 2, 10]
    assert heights([tmp_path / "f-10.obj", tmp_path / "f-2.obj"]) == [10, 2]
    assert heights([tmp_path / "f-10.obj", tmp_path / "f-2.obj"], in_order=False) == [2, 10]
    assert heights([tmp_path / "f-10.obj", pattern]) == [10, 1, 2, 10]
    with pytest.raises(ValueError, match="frame 3 is missing .* in_order=True takes the files in the order given"):
        ts.read_frames(pattern)
    write(tmp_path, "rest.obj", OBJ.format(z=0))
    with pytest.raises(ValueError) as refused:
        ts.read_frames(tmp_path)
    assert "in more than numbers" in str(refused.value) and "in_order=True takes" in str(refused.value)
    assert "--" not in str(refused.value)
    with pytest.raises(ValueError, match="no file matches this pattern"):
        ts.read_frames(tmp_path / "g*.obj")


def test_a_message_about_elements_names_the_file_and_the_remedy(tmp_path):
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    remedy = r" \(drop_degenerate=True leaves "
    for name, text, words in [("a.obj", corners + "f 1 1 2\n", "face 2 names vertex 1 twice"),
                              ("b.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n", "face 0 names vertex 1 twice"),
                              ("c.obj", corners + "f 2 3 1\n", "face 2 has the same corners as face 1"),
                              ("d.obj", corners + "l 1 1\n", "edge 1 1 names vertex 1 twice")]:
        path = write(tmp_path, name, text)
        for read in (lambda: ts.read_mesh(path), lambda: ts.read_frames([path, path])):
            with pytest.raises(ValueError, match=f"{name}: {words}.*{remedy}"):
                read()
        ts.read_mesh(path, drop_degenerate=True)


def test_what_names_no_frames_is_refused(tmp_path):
    for wrong, words in [(3, "paths is of type int; it must be a folder, a pattern"),
                         (None, "paths is of type NoneType"),
                         ([3], "paths has an element of type int"), (iter([None]), "an element of type NoneType")]:
        with pytest.raises(TypeError, match=words):
            ts.read_frames(wrong)
    for wrong, words in [("", "paths is empty"), ({}, "paths is empty"), (tmp_path / "none", "none: is no file, no"),
                         (str(tmp_path / "none-*.obj"), "no file matches this pattern"),
                         (tmp_path / "none.obj", "none.obj: cannot be opened")]:
        with pytest.raises(ValueError, match=words):
            ts.read_frames(wrong)
    with pytest.raises(TypeError, match="path is of type NoneType; it must be a file's name"):
        ts.read_mesh(None)
    with pytest.raises(ValueError, match="is a folder; read_frames reads the frames in it"):
        ts.read_mesh(tmp_path)


SPLIT = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 {z}\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\nf 2 3 1\nf 1 1 2\n"


def test_meshes_are_mended_on_request(tmp_path):
    path = write(tmp_path, "s-1.obj", SPLIT.format(z=0))
    with pytest.raises(ValueError, match="twice"):
        ts.read_mesh(path)
    dropped = ts.read_mesh(path, drop_degenerate=True)
    assert (dropped.welded_vertices, dropped.dropped_elements, len(dropped.mesh.faces)) == (0, 2, 2)
    assert len(ts.intersections(dropped.mesh, dropped.positions)) > 0
    mended = ts.read_mesh(path, weld=True, drop_degenerate=True)
    assert (mended.welded_vertices, mended.dropped_elements) == (2, 2)
    assert mended.mesh.faces.tolist() == [[0, 1, 2], [1, 4, 2]] and len(mended.mesh.points) == 0
    assert len(mended) == 4 and len(ts.intersections(mended.mesh, mended.positions)) == 0
    frames = ts.read_frames([path, path], weld=True, drop_degenerate=True)
    assert (len(frames), frames.welded_vertices, frames.dropped_elements) == (2, 2, 2)
    assert np.array_equal(frames.mesh.faces, mended.mesh.faces) and frames.positions.shape == (2, 6, 3)
    apart = write(tmp_path, "s-2.obj", SPLIT.format(z=1))
    with pytest.raises(ValueError, match="vertices 2 and 4 are apart in s-2.obj, .*without weld=True they stay two"):
        ts.read_frames([path, apart], weld=True, drop_degenerate=True)


def test_elements_in_no_part_collide_between_parts(tmp_path):
    text = OBJ.format(z=1) + "v 0 0 7\nv 2 2 7\nl 8 9\nv 2 0 7\nv 0 2 7\nl 10 11\n"
    read = ts.read_mesh(write(tmp_path, "w.obj", text), between_parts=True)
    assert len(ts.intersections(read.mesh, read.positions)) == 1


def test_frames_of_other_parts_are_refused_between_parts(tmp_path):
    one = write(tmp_path, "1.obj", OBJ.format(z=1))
    two = write(tmp_path, "2.obj", OBJ.format(z=2).replace("o lid", "o cap"))
    assert len(ts.read_frames([one, two])[1]) == 2
    with pytest.raises(ValueError, match="has other parts"):
        ts.read_frames([one, two], between_parts=True)


def test_what_is_no_mesh_is_refused(tmp_path):
    for name, text, words in [("a.obj", "f 1 2 3\n", "vertex 3 does not exist"), ("a.npy", "", "NumPy and h5py read"),
                              ("a.xyz", "", "meshio convert"), ("a.off", "OFF 1 0 0\n0 0 nan\n", "no finite number"),
                              ("q.off", "OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "triangulate=True cuts"),
                              ("d.off", "OFF 3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 1\n", "twice")]:
        with pytest.raises(ValueError, match=words):
            ts.read_mesh(write(tmp_path, name, text))
    assert len(ts.read_mesh(tmp_path / "q.off", triangulate=True).mesh.faces) == 2
    with pytest.raises(ValueError, match="cannot be opened"):
        ts.read_mesh(tmp_path / "none.obj")
    with pytest.raises(ValueError, match="names no parts"):
        ts.read_mesh(tmp_path / "q.off", triangulate=True, between_parts=True)
    shared = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\no b\nf 2 4 3\n"
    with pytest.raises(ValueError, match="shares a vertex with another part"):
        ts.read_mesh(write(tmp_path, "s.obj", shared), between_parts=True)
    with pytest.raises(TypeError):
        ts.read_mesh(3)


@pytest.mark.parametrize("style", [{"binary": False}, {"compression": None}, {"compression": "zlib"}])
@pytest.mark.parametrize("real", ["float64", "float32"])
def test_a_vtu_file_of_meshio_has_the_same_mesh(tmp_path, style, real):
    meshio = pytest.importorskip("meshio", reason="meshio is not there (Debian: python3-meshio)")
    random = np.random.default_rng(5)
    points = (random.standard_normal((4000, 3)) * 2.0 ** random.integers(-30, 30, (4000, 1))).astype(real)
    corners = [random.permutation(3990)[:3 * n].reshape(-1, 3) for n in (1200, 1)]
    edges = random.permutation(3990)[:600].reshape(-1, 2)
    cells = [("triangle", corners[0]), ("line", edges), ("triangle", corners[1]), ("vertex", np.array([[3990], [3999]]))]
    path = tmp_path / "a.vtu"
    meshio.vtu.write(path, meshio.Mesh(points, cells), **style)
    mesh, positions, _, _ = ts.read_mesh(path)
    # meshio writes 12 digits of text; what they say is the nearest double.
    written = points if style.get("binary", True) else [[float(f"{x:.11e}") for x in row] for row in points]
    assert np.array_equal(positions, np.asarray(written, dtype=np.float64))
    assert np.array_equal(mesh.faces, np.concatenate(corners)) and mesh.points.tolist() == [3990, 3999]
    assert {tuple(sorted(edge)) for edge in edges.tolist()} <= {tuple(sorted(edge)) for edge in mesh.edges.tolist()}


def vtk_files(folder, data, writer, suffix):
    """What VTK writes in each style, but for compressors that are not read."""
    for mode in ("Ascii", "Binary", "Appended"):
        for zlib in (False, True):
            for big in (False, True):
                for wide in (False, True):
                    for base64 in (False, True):
                        write = writer()
                        write.SetInputData(data)
                        getattr(write, f"SetDataModeTo{mode}")()
                        getattr(write, f"SetCompressorTypeTo{'ZLib' if zlib else 'None'}")()
                        getattr(write, f"SetByteOrderTo{'Big' if big else 'Little'}Endian")()
                        getattr(write, f"SetHeaderTypeToUInt{64 if wide else 32}")()
                        write.SetEncodeAppendedData(base64)
                        write.SetBlockSize(4096)
                        path = folder / f"{mode}-{zlib}-{big}-{wide}-{base64}{suffix}"
                        write.SetFileName(str(path))
                        assert write.Write() == 1
                        yield mode, path


@pytest.mark.parametrize("suffix", [".vtu", ".vtp"])
def test_every_style_of_vtk_has_the_same_mesh(tmp_path, suffix):
    reason = "VTK is not there (Debian: python3-vtk9)"
    core = pytest.importorskip("vtkmodules.vtkCommonCore", reason=reason)
    model = pytest.importorskip("vtkmodules.vtkCommonDataModel", reason=reason)
    output = pytest.importorskip("vtkmodules.vtkIOXML", reason=reason)
    random = np.random.default_rng(6)
    x = random.standard_normal((3000, 3)) * 2.0 ** random.integers(-30, 30, (3000, 1))
    points = core.vtkPoints()
    points.SetDataTypeToDouble()
    for row in x:
        points.InsertNextPoint(row)
    faces = random.permutation(2900)[:2700].reshape(-1, 3)
    edges = random.permutation(2900)[:600].reshape(-1, 2)
    data = model.vtkPolyData() if suffix == ".vtp" else model.vtkUnstructuredGrid()
    data.SetPoints(points)
    data.Allocate(2000)
    for kind, cells in ((1, [[2990], [2999]]), (3, edges.tolist()), (5, faces.tolist())):
        for cell in cells:
            data.InsertNextCell(kind, len(cell), cell)
    writer = output.vtkXMLPolyDataWriter if suffix == ".vtp" else output.vtkXMLUnstructuredGridWriter
    for mode, path in vtk_files(tmp_path, data, writer, suffix):
        mesh, positions, _, _ = ts.read_mesh(path)
        assert np.array_equal(positions, x), path.name
        assert np.array_equal(mesh.faces, faces) and mesh.points.tolist() == [2990, 2999], path.name
        assert {tuple(sorted(edge)) for edge in edges.tolist()} <= {tuple(sorted(edge)) for edge in mesh.edges.tolist()}
