"""Reads files of XDMF with each reader of ParaView, for paraview_test.py:
    pvpython --no-mpi paraview_reader.py RESULT FILE...

RESULT holds a pickled {file: {reader: [(time, dataset), ...]}}; a dataset has `points`, `cells`,
`nodes` and `elements`, the last two {name of the field: array}.
"""

import os
import pickle
import sys

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

READERS = {
    "XDMFReader": lambda file: simple.XDMFReader(FileNames=[file]),
    "Xdmf3ReaderS": lambda file: simple.Xdmf3ReaderS(FileName=[file]),
    "Xdmf3ReaderT": lambda file: simple.Xdmf3ReaderT(FileName=[file]),
    "OpenDataFile": simple.OpenDataFile,
}


def arrays(attributes):
    return {attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i)).copy()
            for i in range(attributes.GetNumberOfArrays())}


def dataset(data):
    while hasattr(data, "GetNumberOfBlocks"):
        if data.GetNumberOfBlocks() != 1:
            raise RuntimeError(f"{data.GetNumberOfBlocks()} blocks, not 1")
        data = data.GetBlock(0)
    cells = [[data.GetCell(i).GetPointId(k) for k in range(data.GetCell(i).GetNumberOfPoints())]
             for i in range(data.GetNumberOfCells())]
    return {"points": vtk_to_numpy(data.GetPoints().GetData()).copy(), "cells": cells,
            "nodes": arrays(data.GetPointData()), "elements": arrays(data.GetCellData())}


def read(reader):
    reader.UpdatePipeline()
    result = []
    for time in list(reader.TimestepValues):
        reader.UpdatePipeline(time)
        result.append((time, dataset(servermanager.Fetch(reader))))
    simple.Delete(reader)
    return result


found = {}
for path in sys.argv[2:]:
    for name, opened in READERS.items():
        print("reading", path, "with", name, flush=True)
        found.setdefault(path, {})[name] = read(opened(os.path.abspath(path)))
with open(sys.argv[1], "wb") as file:
    pickle.dump(found, file)
