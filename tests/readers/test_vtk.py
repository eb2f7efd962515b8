"""VTU, VTK, PLY and STL files as VTK reads them."""
import numpy as np
import pytest
import vtk
from agreement import ordered, same_cells, same_points, signed_volume
from mesh_cases import NAMES, case
from vtk.util.numpy_support import vtk_to_numpy

from advlayers.formats import obj, ply, vtu
from advlayers.formats import vtk as legacy

KINDS = {3: "line2", 21: "line3", 5: "tri3", 22: "tri6", 9: "quad4", 23: "quad8", 10: "tet4",
         24: "tet10", 14: "pyramid5", 13: "prism6", 12: "hex8", 28: "quad9", 27: "pyramid13",
         26: "prism15", 25: "hex20"}
WEDGES = {"prism6": (0, 2, 1, 3, 5, 4),
          "prism15": (0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13)}
WRITERS = {"vtu": (vtu.write, vtk.vtkXMLUnstructuredGridReader),
           "vtk": (legacy.write, vtk.vtkUnstructuredGridReader)}


def read(path, reader):
    reader = reader()
    reader.SetFileName(path)
    if hasattr(reader, "ReadAllScalarsOn"):
        reader.ReadAllScalarsOn()
    reader.Update()
    return reader.GetOutput()


def cells_of(grid):
    """By kind: nodes, and numbers of the cells."""
    found = {}
    ids = vtk.vtkIdList()
    for number in range(grid.GetNumberOfCells()):
        grid.GetCellPoints(number, ids)
        kind = KINDS[grid.GetCellType(number)]
        nodes = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        if kind in WEDGES:  # VTK's begin with a side that is counter-clockwise from outside
            nodes = [nodes[i] for i in WEDGES[kind]]
        found.setdefault(kind, ([], []))
        found[kind][0].append(nodes)
        found[kind][1].append(number)
    return found


@pytest.mark.parametrize("ending", WRITERS)
@pytest.mark.parametrize("name", NAMES)
def test_grids(tmp_path, name, ending):
    parts = case(name)
    writer, reader = WRITERS[ending]
    path = str(tmp_path / f"mesh.{ending}")
    writer(path, parts)
    grid = read(path, reader)
    same_points(parts, vtk_to_numpy(grid.GetPoints().GetData()))
    cells = cells_of(grid)
    same_cells(vtu.drawn(parts), {kind: rows for kind, (rows, _) in cells.items()}, [1, 2, 3])
    arrays = {grid.GetCellData().GetArrayName(i): vtk_to_numpy(grid.GetCellData().GetArray(i))
              for i in range(grid.GetCellData().GetNumberOfArrays())}
    numbers = {(2, "face"), (1, "edge"), (3, "solid")}
    for dimension, array in numbers:
        for block in vtu.drawn(parts).of(dimension):
            rows, places = cells[block.kind]
            seen = np.column_stack([rows, arrays[array][places]])
            wanted = [np.column_stack([other.cells, other.part])
                      for other in vtu.drawn(parts).of(dimension) if other.kind == block.kind]
            assert np.array_equal(ordered(seen), ordered(np.concatenate(wanted)))
    check_groups(parts, grid, ending, arrays, cells)
    if name == "solid":
        points = grid.GetPointData()
        for array, values in (("layer", parts.node_layer), ("parent", parts.node_parent)):
            assert np.array_equal(vtk_to_numpy(points.GetArray(array)), values)


def check_groups(parts, grid, ending, arrays, cells):
    if ending == "vtu":
        fields = grid.GetFieldData()
        kept = {fields.GetArrayName(i): int(fields.GetArray(i).GetValue(0))
                for i in range(fields.GetNumberOfArrays())}
        names = sorted(kept, key=kept.get)
        assert sorted(kept.values()) == list(range(1, len(kept) + 1))
    else:
        names = list(vtu.group_numbers(parts))
    assert {entry.name for entry in parts.groups} <= set(names)
    for dimension in (1, 2, 3):
        owners = parts.owners(dimension)
        for block in vtu.drawn(parts).of(dimension):
            rows, places = cells[block.kind]
            groups = arrays["group"][places]
            wanted = {tuple(cell): owners[part] for other in parts.of(dimension)
                      for cell, part in zip(other.cells.tolist(), other.part.tolist())}
            for cell, number in zip(rows, groups.tolist()):
                owner = wanted[tuple(cell)]
                assert owner == names[number - 1] if number else owner not in names


@pytest.mark.parametrize("name", ["extruded", "extruded second", "turned second", "filled"])
def test_sides_of_volume_cells_face_outward(tmp_path, name):
    """As VTK itself lists the sides of its cells."""
    parts = case(name)
    path = str(tmp_path / "mesh.vtu")
    vtu.write(path, parts)
    grid = read(path, vtk.vtkXMLUnstructuredGridReader)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    seen = 0
    for number in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(number)
        if cell.GetCellDimension() < 3:
            continue
        volume = 0.0
        for i in range(cell.GetNumberOfFaces()):
            face = cell.GetFace(i)  # mid nodes come after its corners
            x = points[[face.GetPointId(k) for k in range(face.GetNumberOfEdges())]]
            for k in range(1, len(x) - 1):
                volume += np.dot(x[0], np.cross(x[k], x[k + 1])) / 6.0
        assert volume > 0.0
        seen += 1
    assert seen == sum(len(block) for block in parts.of(3))
    for block in parts.of(3):
        assert (signed_volume(parts.nodes, block.kind, block.cells) > 0.0).all()


@pytest.mark.parametrize("name", ["solid", "plane", "facets"])
@pytest.mark.parametrize("ending", ["ply", "obj"])
def test_polygons(tmp_path, name, ending):
    parts = case(name)
    path = str(tmp_path / f"mesh.{ending}")
    {"ply": ply, "obj": obj}[ending].write(path, parts)
    surface = read(path, {"ply": vtk.vtkPLYReader, "obj": vtk.vtkOBJReader}[ending])
    # VTK reads both in single precision.
    points = vtk_to_numpy(surface.GetPoints().GetData())
    assert np.allclose(points, parts.nodes, rtol=1e-6, atol=1e-6)
    cells = {}
    for kind, rows in ((kind, rows) for kind, rows in polygons(surface).items() if kind != 2):
        cells[{3: "tri3", 4: "quad4"}[kind]] = rows
    same_cells(parts, cells, [2])


def polygons(surface):
    found = {}
    ids = vtk.vtkIdList()
    for number in range(surface.GetNumberOfCells()):
        surface.GetCellPoints(number, ids)
        found.setdefault(ids.GetNumberOfIds(), []).append(
            [ids.GetId(i) for i in range(ids.GetNumberOfIds())])
    return found


def test_names_that_xml_does_not_like(tmp_path):
    from dataclasses import replace

    from advlayers.formats.mesh_parts import Group

    parts = replace(case("facets"), groups=(Group('a < "b" & c', 2, (1,)),))
    path = str(tmp_path / "mesh.vtu")
    vtu.write(path, parts)
    fields = read(path, vtk.vtkXMLUnstructuredGridReader).GetFieldData()
    assert [fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())] == ['a < "b" & c']
