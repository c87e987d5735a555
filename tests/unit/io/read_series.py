"""Reads the history that SegmentedSeriesTest.cpp has written: 11 rows in two segments."""
import os
import sys
import xml.etree.ElementTree

import h5py
import numpy


def check_index(path):
    with h5py.File(path, "r") as file:
        assert file.attrs["format"] == "asperity series"
        assert file["fields/slip"].attrs["unit"] == "m"
        assert file["fields/alpha"].is_virtual
        row = numpy.arange(11.0)
        node = numpy.arange(6.0)
        assert numpy.array_equal(file["time"][:], row / 8)
        assert numpy.array_equal(file["step"][:], 10 * row)
        assert numpy.array_equal(file["fields/alpha"][:], row[:, None] + node / 16)
        assert numpy.array_equal(file["fields/alpha"][4:8, 2], row[4:8] + 2 / 16)
        slip = file["fields/slip"][:]
        assert slip.shape == (11, 6, 2)
        assert numpy.array_equal(slip[:, :, 1], numpy.broadcast_to(-node, (11, 6)))
        assert numpy.allclose(file["geometry/positions"][:], (node / 5) ** 2, atol=1e-15)


def check_xdmf(path):
    """Every array that the XDMF file names exists, with the shape it says and the row's numbers."""
    root = xml.etree.ElementTree.parse(path).getroot()
    grids = root.findall("Domain/Grid/Grid")
    assert len(grids) == 11
    for row, grid in enumerate(grids):
        arrays = [read(path, item) for item in grid.iter("DataItem")]
        node = numpy.arange(6.0)
        assert len(arrays) == 4  # elements, coordinates, alpha, slip
        assert numpy.array_equal(arrays[2], row + node / 16)
        assert arrays[3].shape == (6, 3)
        assert numpy.array_equal(arrays[3][:, 1], -node)
        assert not arrays[3][:, 2].any()


def read(path, item):
    name, dataset = item.text.split(":")
    with h5py.File(os.path.join(os.path.dirname(path), name), "r") as file:
        values = file[dataset][()]
    assert values.shape == tuple(map(int, item.get("Dimensions").split()))
    return values


check_index(sys.argv[1])
check_xdmf(sys.argv[1].replace(".h5", ".xdmf"))
