#!/usr/bin/env python3
"""Writes the surfaces of this folder: faults and a ground that somebody else might give you.

main.ts      GOCAD TSurf, m: a wavy vertical fault 'main' and a fault 'splay' that leaves it
trace.txt    x y dip, m: the trace of a thrust whose dip varies from 60 to 40 degrees
contours.txt longitude latitude depth, degrees and km: a slab, its contours in no order
dem.asc      ESRI ascii, m: hills around the faults
"""

import math
import pathlib

FOLDER = pathlib.Path(__file__).parent
DEEP, HIGH = -15e3, 1500.0  # of the faults; the ground is below HIGH


def main_x(y, z):
    """The fault main, x [m] at y and z, which strikes north."""
    return 600 * math.sin(2 * math.pi * y / 20e3) + 0.05 * z


def ground(x, y):
    """Height [m]."""
    return 500 + 400 * math.sin(x / 9e3) * math.cos(y / 7e3)


def rows(y0, y1, x_at):
    """Points of a surface [(x, y, z)], 21 along strike and 12 down dip."""
    return [[(x_at(y, z), y, z) for y in (y0 + (y1 - y0) * i / 20 for i in range(21))]
            for z in (HIGH + (DEEP - HIGH) * j / 11 for j in range(12))]


def tsurf(name, points):
    """A GOCAD TSurf of rows of points."""
    width = len(points[0])
    lines = ["GOCAD TSurf 1", "HEADER {", f"name:{name}", "}", "GOCAD_ORIGINAL_COORDINATE_SYSTEM",
             "NAME Default", 'AXIS_NAME "X" "Y" "Z"', 'AXIS_UNIT "m" "m" "m"',
             "ZPOSITIVE Elevation", "END_ORIGINAL_COORDINATE_SYSTEM", "TFACE"]
    flat = [point for row in points for point in row]
    lines += [f"VRTX {i} {x:.1f} {y:.1f} {z:.1f}" for i, (x, y, z) in enumerate(flat, 1)]
    for j in range(len(points) - 1):
        for i in range(1, width):
            a = j * width + i
            lines += [f"TRGL {a} {a + 1} {a + width + 1}", f"TRGL {a} {a + width + 1} {a + width}"]
    return "\n".join(lines + ["END", ""])


def splay_x(y, z):
    """The fault splay leaves main at y = 5 km to the north east; it goes 500 m beyond main."""
    return main_x(5e3, z) - 500 + 0.6 * (y - 5e3)


def contours():
    """The plane z = -(lon - 143) * 25 km, bent along strike; blocks in no order or direction."""
    text = []
    for turns, depth in enumerate((10, 40, 20, 5, 30)):
        lines = []
        for i in range(13):
            latitude = 37 + i / 6
            longitude = 143 - depth / 25 + 0.1 * math.sin((latitude - 37) * 2)
            lines.append(f"{longitude:.4f} {latitude:.4f} {-depth}")
        text += [str(depth), *(reversed(lines) if turns % 2 else lines), "END"]
    return "\n".join(text + [""])


def dem():
    """40 km x 50 km in cells of 1 km, rows from the north."""
    head = ["ncols 41", "nrows 51", "xllcenter -20000", "yllcenter -10000", "cellsize 1000",
            "NODATA_value -9999"]
    body = [" ".join(f"{ground(x, y):.0f}" for x in range(-20000, 20001, 1000))
            for y in range(40000, -10001, -1000)]
    return "\n".join(head + body + [""])


def trace():
    """Walks south, so that the thrust dips to the west."""
    lines = ["# x y dip"]
    for i in range(7):
        y = 25e3 - 20e3 * i / 6
        lines.append(f"{12e3 - 800 * math.sin(math.pi * i / 6):.1f} {y:.1f} {60 - 20 * i / 6:.2f}")
    return "\n".join(lines + [""])


if __name__ == "__main__":
    (FOLDER / "main.ts").write_text(tsurf("main", rows(0, 30e3, main_x)) +
                                    tsurf("splay", rows(5e3 - 300, 20e3, splay_x)))
    (FOLDER / "trace.txt").write_text(trace())
    (FOLDER / "contours.txt").write_text(contours())
    (FOLDER / "dem.asc").write_text(dem())
