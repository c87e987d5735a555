"""Mesh files: by asperity-mesh, or written here, vertex by vertex."""

import subprocess

import asperity_run
import h5py
import numpy
import time_limits

MESH_TOOL = asperity_run.PROGRAM.with_name("asperity-mesh")  # there only where Gmsh is


def mesh_tool(*arguments, timeout=60):
    """Runs asperity-mesh, which must succeed; what it prints."""
    return subprocess.run([MESH_TOOL, *map(str, arguments)], check=True, capture_output=True,
                          text=True, timeout=time_limits.seconds(timeout)).stdout


def write(name, vertices, cells, boundaries, region_of_cells=None, regions=(b"body",),
          period=None):
    """The file of a mesh: vertices (num_vertices, dimension) [m], cells (num_cells, dimension + 1),
    {name of a boundary or fault: facets (num_facets, dimension)}, of each cell its region, and
    where it is periodic its period (dimension) [m], 0 along other axes."""
    with h5py.File(name, "w") as file:
        file.attrs.update({"format": "asperity-mesh", "version": 1,
                           "dimension": numpy.shape(vertices)[1]})
        if period is not None:
            file.attrs["period"] = numpy.array(period, dtype=float)
        file["vertices"] = vertices
        file["cells"] = cells
        file["cell_regions"] = (numpy.zeros(len(cells), dtype=int) if region_of_cells is None
                                else region_of_cells)
        file["region_names"] = list(regions)
        for boundary, facets in boundaries.items():
            file[f"boundaries/{boundary}/facets"] = facets
