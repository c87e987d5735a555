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
    """Every array that the XDMF file names exists and has the shape it says."""
    root = xml.etree.ElementTree.parse(path).getroot()
    items = [item for item in root.iter("DataItem") if item.get("Format") == "HDF"]
    assert len(items) == 2 + 11 * 3
    for item in items:
        name, dataset = item.text.split(":")
        with h5py.File(os.path.join(os.path.dirname(path), name), "r") as file:
            assert file[dataset].shape == tuple(map(int, item.get("Dimensions").split()))


check_index(sys.argv[1])
check_xdmf(sys.argv[1].replace(".h5", ".xdmf"))
