"""Writes small meshes in the formats of other programs, for the tests of asperity-mesh.

A mesh is a dictionary: points (n, 3); blocks {name: (kind, cells from 0)}, of kind "tetra",
"hexahedron", "wedge", "pyramid", "triangle", "quad" or "line"; sides {name: [(cell from
0, side from 1)]}, with
the numbers of sides of the format; nodes {name: [node from 0]}; ghosts: for each
cell of VTU, whether it is a copy.

    python3 other_formats.py FOLDER     writes two tetrahedra and their fault in each format
"""

import base64
import pathlib
import struct
import sys
import zlib

import h5py
import numpy

DIMENSION = {"line": 1, "triangle": 2, "quad": 2, "tetra": 3, "pyramid": 3, "wedge": 3,
             "hexahedron": 3}
EXODUS = {"line": b"BAR2", "triangle": b"TRI3", "quad": b"QUAD4", "tetra": b"TETRA",
          "pyramid": b"PYRAMID", "wedge": b"WEDGE", "hexahedron": b"HEX8"}
ABAQUS = {"line": "T3D2", "triangle": "S3", "quad": "S4R", "tetra": "C3D4", "pyramid": "C3D5",
          "wedge": "C3D6", "hexahedron": "C3D8R"}
VTK = {"line": 3, "triangle": 5, "quad": 9, "tetra": 10, "hexahedron": 12, "wedge": 13,
       "pyramid": 14}


def _exodus_variables(mesh):
    """Of Exodus: {name: (dimensions, values, elem_type)}; text is a list of bytes."""
    variables = {}
    points = numpy.asarray(mesh["points"], dtype=">f8")
    flat = mesh.get("flat", False)
    for axis, name in enumerate("xy" if flat else "xyz"):
        variables[f"coord{name}"] = (("num_nodes",), points[:, axis], None)
    for number, (kind, cells) in enumerate(mesh["blocks"].values(), start=1):
        variables[f"connect{number}"] = ((f"num_el_in_blk{number}", f"num_nod_per_el{number}"),
                                         numpy.asarray(cells, dtype=">i4") + 1, EXODUS[kind])
    for letter, groups, dimension in (("e", mesh["blocks"], "num_el_blk"),
                                      ("s", mesh["sides"], "num_side_sets"),
                                      ("n", mesh["nodes"], "num_node_sets")):
        if groups:
            start = {"e": 1, "s": 10, "n": 20}[letter]
            kind = "eb" if letter == "e" else letter + "s"
            variables[f"{kind}_prop1"] = ((dimension,), numpy.arange(start, start + len(groups),
                                                                     dtype=">i4"), None)
            if mesh.get("named", True):
                variables[f"{kind}_names"] = ((dimension, "len_name"),
                                              [name.encode() for name in groups], None)
    for number, sides in enumerate(mesh["sides"].values(), start=1):
        for column, name in enumerate(("elem_ss", "side_ss")):
            variables[f"{name}{number}"] = (
                (f"num_side_ss{number}",),
                numpy.array([side[column] + (column == 0) for side in sides], dtype=">i4"), None)
    for number, nodes in enumerate(mesh["nodes"].values(), start=1):
        variables[f"node_ns{number}"] = ((f"num_nod_ns{number}",),
                                         numpy.asarray(nodes, dtype=">i4") + 1, None)
    return variables


def exodus(mesh, version=2):
    """Bytes of a classic netCDF file of version 1 or 2."""
    variables = _exodus_variables(mesh)
    sizes = {"len_name": 33}
    for dimensions, values, _ in variables.values():
        for axis, name in enumerate(dimensions):
            if name not in sizes:
                sizes[name] = numpy.shape(values)[axis]

    def text(name):
        return struct.pack(">i", len(name)) + name + b"\0" * (-len(name) % 4)

    def entry(name, begin):
        dimensions, values, elem_type = variables[name]
        kind = 2 if isinstance(values, list) else {"f": 6, "i": 4}[values.dtype.kind]
        attributes = (struct.pack(">ii", 0, 0) if elem_type is None else
                      struct.pack(">ii", 12, 1) + text(b"elem_type") + struct.pack(">i", 2)
                      + text(elem_type))
        return (text(name.encode()) + struct.pack(">i", len(dimensions))
                + b"".join(struct.pack(">i", list(sizes).index(d)) for d in dimensions)
                + attributes + struct.pack(">ii", kind, len(data[name]))
                + struct.pack(">i" if version == 1 else ">q", begin))

    data = {}
    for name, (_, values, _) in variables.items():
        raw = (b"".join(value.ljust(33, b"\0") for value in values)
               if isinstance(values, list)
               else values.astype(values.dtype.newbyteorder(">")).tobytes())
        data[name] = raw + b"\0" * (-len(raw) % 4)
    head = b"CDF" + bytes([version]) + struct.pack(">i", 0)
    head += struct.pack(">ii", 10, len(sizes)) + b"".join(
        text(name.encode()) + struct.pack(">i", size) for name, size in sizes.items())
    head += struct.pack(">ii", 0, 0) + struct.pack(">ii", 11, len(variables))
    begin = len(head) + sum(len(entry(name, 0)) for name in variables)
    for name in variables:
        head += entry(name, begin)
        begin += len(data[name])
    return head + b"".join(data.values())


def exodus_netcdf4(mesh, name):
    with h5py.File(name, "w") as file:
        for key, (_, values, elem_type) in _exodus_variables(mesh).items():
            if isinstance(values, list):
                file[key] = numpy.array([list(value.ljust(33, b"\0")) for value in values],
                                        dtype="u1").view("S1")
            else:
                file[key] = values.astype(values.dtype.newbyteorder("<"))
            if elem_type is not None:
                file[key].attrs["elem_type"] = numpy.bytes_(elem_type)


def abaqus(mesh, numbers=None, sections=False):
    """Text; numbers: of the nodes."""
    numbers = numbers or list(range(1, len(mesh["points"]) + 1))
    lines = ["*HEADING", "a small mesh", "** a comment", "*Node, nset=all"]
    lines += [f"{numbers[i]}, " + ", ".join(f"{x:.17g}" for x in point)
              for i, point in enumerate(mesh["points"])]
    element = 0
    for name, (kind, cells) in mesh["blocks"].items():
        lines.append(f"*Element, type={ABAQUS[kind]}" + ("" if sections else f", elset={name}"))
        first = element + 1
        for cell in cells:
            element += 1
            nodes = [str(numbers[node]) for node in cell]
            half = len(nodes) // 2
            lines += [f"{element}, " + ", ".join(nodes[:half]) + ",",
                      "  " + ", ".join(nodes[half:])]
        if sections:
            lines += [f"*Elset, elset={name}, generate", f"{first}, {element}, 1",
                      f'*Solid Section, elset="{name.upper()}", material=any', ","]
    for name, nodes in mesh["nodes"].items():
        lines += [f"*Nset, nset={name}"] + [f"{numbers[node]}," for node in nodes]
    for name, sides in mesh["sides"].items():
        lines += [f"*Elset, elset=_{name}_S{side}, internal\n {cell + 1}" for cell, side in sides]
        lines += [f"*Surface, type=ELEMENT, name={name}"]
        lines += [f"_{name}_S{side}, S{side}" for side in sorted({side for _, side in sides})]
    return "\n".join(lines) + "\n"


def _cells(mesh):
    return [(VTK[kind], cell, number)
            for number, (kind, cells) in enumerate(mesh["blocks"].values(), start=1)
            for cell in cells]


def vtk(mesh, binary=False, version="3.0"):
    cells = _cells(mesh)

    def values(array, kind):
        array = numpy.asarray(array)
        if binary:
            return array.astype({"double": ">f8", "int": ">i4", "vtktypeint64": ">i8"}[kind]
                                ).tobytes() + b"\n"
        return (" ".join(repr(x) for x in array.ravel().tolist()) + "\n").encode()

    text = (f"# vtk DataFile Version {version}\na small mesh\n{'BINARY' if binary else 'ASCII'}\n"
            f"DATASET UNSTRUCTURED_GRID\nPOINTS {len(mesh['points'])} double\n").encode()
    text += values(mesh["points"], "double")
    flat = [node for _, cell, _ in cells for node in cell]
    if version.startswith("5"):
        offsets = numpy.cumsum([0] + [len(cell) for _, cell, _ in cells])
        text += f"CELLS {len(offsets)} {len(flat)}\nOFFSETS vtktypeint64\n".encode()
        text += values(offsets, "vtktypeint64") + b"CONNECTIVITY vtktypeint64\n"
        text += values(flat, "vtktypeint64")
    else:
        all_of = [x for _, cell, _ in cells for x in (len(cell), *cell)]
        text += f"CELLS {len(cells)} {len(all_of)}\n".encode() + values(all_of, "int")
    text += f"CELL_TYPES {len(cells)}\n".encode() + values([kind for kind, _, _ in cells], "int")
    text += f"POINT_DATA {len(mesh['points'])}\nVECTORS u double\n".encode()
    text += values(numpy.zeros((len(mesh["points"]), 3)), "double")
    text += f"CELL_DATA {len(cells)}\nSCALARS CellEntityIds int 1\nLOOKUP_TABLE default\n".encode()
    text += values([number for _, _, number in cells], "int")
    text += f"FIELD more 2\nquality 1 {len(cells)} double\n".encode()
    text += values(numpy.full(len(cells), 0.5), "double")
    text += f"rank 1 {len(cells)} int\n".encode() + values(numpy.zeros(len(cells)), "int")
    return text


def vtu(mesh, form="ascii", header="UInt32", compressed=False, order="LittleEndian",
        together=True):
    """form: "ascii", "binary", "appended raw" or "appended base64"; together: header and data of
    what is not compressed are encoded in one piece."""
    end = {"LittleEndian": "<", "BigEndian": ">"}[order]
    count = end + {"UInt32": "u4", "UInt64": "u8"}[header]
    cells = _cells(mesh)
    appended = b""

    def pieces(raw):
        if not compressed:
            head = numpy.array([len(raw)], dtype=count).tobytes()
            return [head + raw] if together else [head, raw]
        size = 64  # several blocks
        blocks = [raw[i:i + size] for i in range(0, len(raw), size)]
        packed = [zlib.compress(block) for block in blocks]
        last = len(blocks[-1]) if len(blocks[-1]) < size else 0
        return [numpy.array([len(blocks), size, last, *map(len, packed)], dtype=count).tobytes(),
                b"".join(packed)]

    def array(name, values, kind, components=1):
        nonlocal appended
        tag = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}"'
        if form == "ascii":
            body = " ".join(repr(x) for x in numpy.ravel(values).tolist())
            return f'{tag} format="ascii">\n{body}\n</DataArray>\n'
        raw = numpy.asarray(values).astype(end + {"Float64": "f8", "Int64": "i8", "UInt8": "u1",
                                                  "Int32": "i4"}[kind]).tobytes()
        if form == "binary":
            body = "".join(base64.b64encode(piece).decode() for piece in pieces(raw))
            return f'{tag} format="binary">\n   {body}\n</DataArray>\n'
        offset = len(appended)
        appended += b"".join(piece if form.endswith("raw") else base64.b64encode(piece)
                             for piece in pieces(raw))
        return f'{tag} format="appended" offset="{offset}"/>\n'

    text = ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" '
            f'byte_order="{order}" header_type="{header}"'
            + (' compressor="vtkZLibDataCompressor"' if compressed else "")
            + ">\n<UnstructuredGrid>"
            f'<Piece NumberOfPoints="{len(mesh["points"])}" NumberOfCells="{len(cells)}">\n'
            + "<PointData>\n" + array("u", numpy.zeros(len(mesh["points"])), "Float64")
            + "</PointData>\n<CellData>\n"
            + array("quality", numpy.full(len(cells), 0.5), "Float64")
            + array("group", [number for _, _, number in cells], "Int32")
            + (array("vtkGhostType", mesh["ghosts"], "UInt8") if any(mesh.get("ghosts", []))
               else "")
            + "</CellData>\n<Points>\n" + array("Points", mesh["points"], "Float64", 3)
            + "</Points>\n<Cells>\n"
            + array("connectivity", [n for _, cell, _ in cells for n in cell], "Int64")
            + array("offsets", numpy.cumsum([len(cell) for _, cell, _ in cells]), "Int64")
            + array("types", [kind for kind, _, _ in cells], "UInt8")
            + "</Cells>\n</Piece>\n</UnstructuredGrid>\n")
    result = text.encode()
    if form.startswith("appended"):
        result += (f'<AppendedData encoding="{form.split()[1]}">\n_'.encode() + appended
                   + b"\n</AppendedData>\n")
    return result + b"</VTKFile>\n"


def write_small(folder):
    """Two tetrahedra, one above the other, with a fault between them."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, -1)]
    cells = {"above": ("tetra", [[0, 1, 2, 3]]), "below": ("tetra", [[0, 2, 1, 4]])}
    sides = {"blocks": {**cells, "fault": ("triangle", [[0, 1, 2]])}, "sides": {}}
    mesh = {"points": points, "nodes": {"front": [0, 1, 3]}, "blocks": cells}
    exodus_sides = {**mesh, "sides": {"fault": [(0, 4), (1, 4)]}}
    abaqus_sides = {**mesh, "sides": {"fault": [(0, 1), (1, 1)]}}
    for name, content in (("small.exo", exodus(exodus_sides)),
                          ("small.inp", abaqus(abaqus_sides).encode()),
                          ("text.vtk", vtk({**mesh, **sides})),
                          ("binary.vtk", vtk({**mesh, **sides}, True, "5.1")),
                          ("text.vtu", vtu({**mesh, **sides})),
                          ("appended.vtu", vtu({**mesh, **sides}, "appended raw")),
                          ("packed.vtu", vtu({**mesh, **sides}, "binary", compressed=True))):
        pathlib.Path(folder, name).write_bytes(content)


if __name__ == "__main__":
    write_small(sys.argv[1])
