"""Opens the XDMF files that SurfaceSeriesTest.cpp has written with VTK's own reader.

Exit status 77 if there is neither VTK nor ParaView with a reader of XDMF.
"""
import importlib
import sys

import numpy

MODULES = (("vtkmodules.vtkIOXdmf2", "vtkXdmfReader"), ("vtkmodules.vtkIOXdmf3", "vtkXdmf3Reader"),
           ("paraview.modules.vtkIOXdmf2", "vtkXdmfReader"))
TRIANGLE, TETRAHEDRON = 5, 10  # VTK's numbers


def find_reader():
    for module, name in MODULES:
        try:
            return getattr(importlib.import_module(module), name)
        except (ImportError, AttributeError):
            continue
    print("skipped: this Python has no VTK with a reader of XDMF (Debian: python3-paraview)")
    sys.exit(77)


def grids(path, reader_class):
    """The times, and the grid of each; VTK fills the same one again."""
    reader = reader_class()
    reader.SetFileName(path)
    reader.UpdateInformation()
    executive = reader.GetExecutive()
    times = executive.GetOutputInformation(0).Get(executive.TIME_STEPS())
    for time in times:
        reader.UpdateTimeStep(time)
        yield time, leaf(reader.GetOutputDataObject(0))


def leaf(data):
    while hasattr(data, "GetNumberOfBlocks"):
        assert data.GetNumberOfBlocks() == 1
        data = data.GetBlock(0)
    return data


def check(path, reader_class, cell_type, num_cells, num_nodes):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    times = []
    for time, grid in grids(path, reader_class):
        times.append(time)
        assert grid.GetNumberOfCells() == num_cells, (path, grid.GetNumberOfCells())
        assert grid.GetNumberOfPoints() == num_nodes, (path, grid.GetNumberOfPoints())
        assert all(grid.GetCellType(i) == cell_type for i in range(num_cells)), path
        x = vtk_to_numpy(grid.GetPoints().GetData())
        expected = time + x @ [1.0, 10.0, 100.0]
        scalar = vtk_to_numpy(grid.GetPointData().GetArray("T"))
        vector = vtk_to_numpy(grid.GetPointData().GetArray("u"))
        assert numpy.array_equal(scalar, expected), path
        assert numpy.array_equal(vector, expected[:, None] * [1.0, 2.0, 3.0]), path
        for i in range(num_cells):  # none of them reaches across
            low, high = numpy.array(grid.GetCell(i).GetBounds()).reshape(3, 2).T
            assert numpy.all(high - low <= 1.0), path
    assert times == [0.0, 0.5, 1.0, 1.5, 2.0], path


folder, reader = sys.argv[1], find_reader()
check(folder + "/fault.xdmf", reader, TRIANGLE, 24, 20)
check(folder + "/volume.xdmf", reader, TETRAHEDRON, 72, 40)
check(folder + "/periodic/volume.xdmf", reader, TETRAHEDRON, 48, 30)
print("read with", reader.__name__)
