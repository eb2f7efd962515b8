"""Draws a mesh file: mesh_picture.py mesh.vtu picture.png [width]

The whole mesh, layers in blue, darkest at the walls; beside it a view along the z axis, and a
corner from near. A flat mesh is seen along z throughout. Needs python3-vtk9 and a display (xvfb-run
will do).
"""
import sys

import vtk

WIDTH, SHAPE = 1600, 1.6  # of the picture [pixels], and its width over its height
CORE = (0.93, 0.93, 0.90)
FIRST, LAST = (0.16, 0.38, 0.63), (0.80, 0.89, 0.95)  # colours of the first and the last layer


def read(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def layer_colours(layers):
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(layers + 1)
    table.SetTableValue(0, *CORE, 1.0)
    for layer in range(1, layers + 1):
        t = (layer - 1) / max(layers - 1, 1)
        table.SetTableValue(layer, *(a + t * (b - a) for a, b in zip(FIRST, LAST)), 1.0)
    table.SetRange(-0.5, layers + 0.5)
    table.Build()
    return table


def actor(grid, width):
    grid.GetCellData().SetActiveScalars("layer")
    layers = int(grid.GetCellData().GetArray("layer").GetRange()[1])
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputData(grid)
    mapper.SetLookupTable(layer_colours(layers))
    mapper.SetScalarModeToUseCellData()
    mapper.UseLookupTableScalarRangeOn()
    drawn = vtk.vtkActor()
    drawn.SetMapper(mapper)
    look = drawn.GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.10, 0.12, 0.15)
    look.SetLineWidth(width / 1200.0)
    look.SetAmbient(0.55)
    look.SetDiffuse(0.5)
    return drawn


def half_height(grid, camera, box):
    """Of a view, so that the whole mesh is in it."""
    to_view, bounds = camera.GetViewTransformMatrix(), grid.GetBounds()
    corners = [to_view.MultiplyPoint((x, y, z, 1.0)) for x in bounds[:2] for y in bounds[2:4]
               for z in bounds[4:]]
    aspect = (box[2] - box[0]) * SHAPE / (box[3] - box[1])
    return 1.03 * max(max(abs(y), abs(x) / aspect) for x, y, _z, _w in corners)


def view(grid, width, box, direction, focus=None):
    """A renderer for one part of the picture: the whole mesh, or a tenth of it about `focus`; `box`
    is (left, bottom, right, top) in [0, 1]."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetViewport(*box)
    renderer.AddActor(actor(grid, width))
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    bounds = grid.GetBounds()
    centre = focus or [0.5 * (bounds[i] + bounds[i + 1]) for i in (0, 2, 4)]
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(c + d * grid.GetLength() for c, d in zip(centre, direction)))
    camera.SetViewUp(0, 1, 0)
    camera.SetParallelScale(0.083 * grid.GetLength() if focus else half_height(grid, camera, box))
    renderer.ResetCameraClippingRange()
    return renderer


def save(window, path):
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


def views(grid, width):
    """The three parts of the picture."""
    bounds = grid.GetBounds()
    aslant, near = (-0.5, 0.8, 0.5), (0.4, 0.8, 0.45)
    corner = [bounds[1], 0.5 * (bounds[2] + bounds[3]), bounds[5]]
    if bounds[5] - bounds[4] < 1e-9 * grid.GetLength():
        aslant = near = (0, 0, 1)
        points = (grid.GetPoint(i) for i in range(grid.GetNumberOfPoints()))
        corner = list(min(points))
        corner[0] += 0.06 * (bounds[1] - bounds[0])
    return (view(grid, width, (0, 0, 0.6, 1), aslant),
            view(grid, width, (0.6, 0.55, 1, 1), (0, 0, 1)),
            view(grid, width, (0.6, 0, 1, 0.55), near, corner))


def main(mesh_path, picture_path, width=WIDTH):
    grid, width = read(mesh_path), int(width)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(width, round(width / SHAPE))
    for part in views(grid, width):
        window.AddRenderer(part)
    window.Render()
    save(window, picture_path)


main(*sys.argv[1:])
