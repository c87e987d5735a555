"""asperity-mesh build on surfaces as large and as irregular as real ones.

Arguments: asperity-mesh, and the folder with files of other projects, which may be missing.
"""

import math
import pathlib
import re
import subprocess
import sys
import unittest

import time_limits

MESH, INPUTS = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
DEPTH = 18.0  # km, of the faults of the branching system

CASCADIA = f"""<ParameterList name="Asperity">
  <Parameter name="Projection" type="string"
             value="+proj=tmerc +lat_0=45.5231 +lon_0=-122.6765 +datum=WGS84"/>
  <ParameterList name="Faults">
    <ParameterList name="slab">
      <Parameter name="Contours File" type="string" value="{INPUTS}/cas_contours_dep.in.txt.gz"/>
      <Parameter name="Units" type="string" value="degrees"/>
      <Parameter name="Depth Units" type="string" value="km"/>
      <Parameter name="Lower Depth" type="double" value="60e3"/>
      <Parameter name="Spacing" type="double" value="10e3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Ground">
    <Parameter name="Grid File" type="string" value="{INPUTS}/etopo2020_bedrock_local.nc"/>
    <Parameter name="Outside" type="string" value="Clamp"/>
    <Parameter name="Step" type="double" value="15e3"/>
  </ParameterList>
  <ParameterList name="Box">
    <Parameter name="Margin" type="double" value="80e3"/>
    <Parameter name="Depth" type="double" value="150e3"/>
  </ParameterList>
  <Parameter name="Cell Size" type="double" value="12e3"/>
  <Parameter name="Largest" type="double" value="60e3"/>
</ParameterList>
"""


def run(*arguments):
    return subprocess.run([MESH, *arguments], capture_output=True, text=True,
                          timeout=time_limits.seconds(900))


def write_strips(name, traces):
    """Upright surfaces below polylines [km] that have points in common, in one file."""
    numbers, points, faces = {}, [], []
    levels = [1.0, -3.0, -6.0, -9.0, -12.0, -15.0, -DEPTH]
    for trace in traces:
        for place in trace:
            if place not in numbers:
                numbers[place] = len(points)
                points += [f"{place[0]!r} {place[1]!r} {z!r}" for z in levels]
        for start, end in zip(trace, trace[1:]):
            for k in range(len(levels) - 1):
                a, b = numbers[start] + k, numbers[end] + k
                faces += [f"3 {a} {b} {b + 1}", f"3 {a} {b + 1} {a + 1}"]
    text = "\n".join(["OFF", f"{len(points)} {len(faces)} 0", *points, *faces])
    pathlib.Path(name).write_text(text + "\n", encoding="utf-8")


def length(trace):
    return sum(math.dist(a, b) for a, b in zip(trace, trace[1:]))


class LargeSurfaces(unittest.TestCase):
    def build(self, *arguments):
        """The report, of a build that has no warning."""
        result = run("build", "built.h5", "--overwrite", *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        return result.stdout

    def smallest_angle(self, report):
        return float(re.search(r"dihedral angles of cells: (\S+) degrees", report)[1])

    def areas(self, report, fault):
        """[km^2] of the fault in the body, and of its facets."""
        return [float(text) for text in
                re.findall(rf"fault '{re.escape(fault)}': (?:\d+ facets, )?(\S+) km\^2", report)]

    def expect_estimate(self, report):
        expected = float(re.search(r"expected: about (\S+) cells", report)[1])
        cells = float(re.search(r"vertices, (\d+) cells", report)[1])
        self.assertLess(max(expected / cells, cells / expected), 1.5)

    def test_fault_system_of_one_file_that_branches(self):
        # 260 km long, with two branches, as the East Anatolian fault of published models
        def trunk(x):
            return float(x), round(6.0 * math.sin(x / 40.0), 6)

        main = [trunk(x) for x in range(-130, 131, 2)]
        north = [trunk(20)] + [(20.0 + 2.0 * i, trunk(20)[1] + 1.4 * i) for i in range(1, 26)]
        south = [trunk(-60)] + [(-60.0 + 2.0 * i, trunk(-60)[1] - 1.6 * i) for i in range(1, 21)]
        write_strips("system.off", [main, north, south])
        report = self.build("--fault", "eaf=system.off,units=km", "--size", "4km", "--largest",
                            "20km", "--margin", "50km", "--depth", "60km")
        self.assertIn("its sheets become the faults 'eaf.1', 'eaf.2', 'eaf.3'", report)
        for name, trace in (("eaf.1", main), ("eaf.2", north), ("eaf.3", south)):
            exact = length(trace) * DEPTH
            for area in self.areas(report, name):
                self.assertLess(abs(area - exact), 1e-3 * exact, name)
        self.assertGreaterEqual(self.smallest_angle(report), 5.0)
        self.expect_estimate(report)

    def test_slab_from_contours_below_the_sea_floor(self):
        for name in ("cas_contours_dep.in.txt.gz", "etopo2020_bedrock_local.nc"):
            if not (INPUTS / name).exists():
                self.skipTest(f"{INPUTS / name} is not there")
        pathlib.Path("cascadia.xml").write_text(CASCADIA, encoding="utf-8")
        report = self.build("cascadia.xml")
        before, after = self.areas(report, "slab")
        self.assertLess(abs(after - before), 2e-3 * before)
        self.assertGreater(before, 3.2e5)  # 1,280 km long, about 260 km wide
        self.assertLess(before, 3.5e5)
        # The slab meets the sea floor in a wedge, whose angle is the least that cells can have.
        wedge = float(re.search(r"angle between surfaces: (\S+) degrees", report)[1])
        self.assertLess(wedge, 15.0)
        self.assertGreater(self.smallest_angle(report), 1.0)
        self.expect_estimate(report)
        info = run("info", "built.h5").stdout
        box = [float(text) for text in re.findall(r"[-\d.e+]+",
               re.search(r"bounding box +(.*)", info)[1])]
        area = (box[1] - box[0]) * (box[3] - box[2])
        volume = float(re.search(r"volume +(\S+)", info)[1])
        mean_height = volume / area - 150e3
        self.assertGreater(mean_height, -3e3)  # the sea floor is 3 km deep, the land 1 km high
        self.assertLess(mean_height, 1e3)


if __name__ == "__main__":
    unittest.main()
