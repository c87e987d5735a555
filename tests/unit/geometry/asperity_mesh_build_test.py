"""asperity-mesh build, from files of surfaces to a mesh that the main program takes.

Arguments: asperity-mesh and asperity.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import time_limits

MESH, MAIN = sys.argv.pop(1), sys.argv.pop(1)
OPTIONS = ["--size", "3km", "--largest", "10km", "--margin", "15km", "--depth", "25000"]

DECK = """<ParameterList name="Asperity">
  <ParameterList name="Faults">
    <ParameterList name="main">
      <Parameter name="Surface File" type="string" value="main.off"/>
      <Parameter name="Units" type="string" value="km"/>
    </ParameterList>
    <ParameterList name="branch">
      <Parameter name="Surface File" type="string" value="branch.off"/>
      <Parameter name="Units" type="string" value="km"/>
      <Parameter name="Cell Size" type="string" value="3000 + 0 * z"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Box">
    <Parameter name="Margin" type="double" value="15e3"/>
    <Parameter name="Depth" type="double" value="25e3"/>
    <Parameter name="Ground" type="string" value="surface"/>
  </ParameterList>
  <Parameter name="Cell Size" type="double" value="3000"/>
  <Parameter name="Largest" type="double" value="10e3"/>
</ParameterList>
"""

RUN = """<ParameterList name="Asperity">
  <ParameterList name="Mesh">
    <Parameter name="Type" type="string" value="File"/>
    <ParameterList name="File">
      <Parameter name="File Name" type="string" value="built.h5"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bulk">
    <Parameter name="Model" type="string" value="Solid"/>
    <Parameter name="Density" type="double" value="2670"/>
    <Parameter name="Shear Modulus" type="double" value="32e9"/>
    <Parameter name="Poisson's Ratio" type="double" value="0.25"/>
  </ParameterList>
  <ParameterList name="Friction">
    <Parameter name="Law" type="string" value="Regularised"/>
    <Parameter name="State Evolution" type="string" value="Ageing"/>
    <Parameter name="a" type="double" value="0.02"/>
    <Parameter name="b" type="double" value="0.03"/>
    <Parameter name="L" type="double" value="3.0"/>
    <Parameter name="Reference Slip Rate" type="double" value="1e-6"/>
    <Parameter name="Reference Friction Coefficient" type="double" value="0.6"/>
    <Parameter name="Normal Stress" type="double" value="25e6"/>
  </ParameterList>
  <ParameterList name="Boundary Conditions">
CONDITIONS  </ParameterList>
  <ParameterList name="Initial State">
    <Parameter name="Slip Rate" type="double" value="1e-9"/>
  </ParameterList>
  <ParameterList name="Time Stepping">
    <Parameter name="Final Time" type="double" value="10"/>
  </ParameterList>
</ParameterList>
"""


def condition(boundary, kind):
    return (f'    <ParameterList name="At {boundary}">\n'
            f'      <Parameter name="Boundary" type="string" value="{boundary}"/>\n'
            f'      <Parameter name="Type" type="string" value="{kind}"/>\n'
            "    </ParameterList>\n")


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True,
                          timeout=time_limits.seconds(300))


def write_rectangle(name, origin, along, down):
    corners = [[o + s * a + t * d for o, a, d in zip(origin, along, down)]
               for s, t in ((0, 0), (1, 0), (1, 1), (0, 1))]
    lines = ["OFF", "4 2 0", *(" ".join(map(repr, corner)) for corner in corners), "3 0 1 2",
             "3 0 2 3"]
    pathlib.Path(name).write_text("\n".join(lines) + "\n", encoding="utf-8")


class Build(unittest.TestCase):
    def setUp(self):
        for path in pathlib.Path(".").glob("*.h5*"):
            path.unlink()
        # km; the branch ends at the main fault but for 20 m, and goes beyond the ground
        write_rectangle("main.off", (-10.0, 0.0, 1.0), (20.0, 0, 0), (0, 0, -11.0))
        write_rectangle("branch.off", (0.0, 0.02, 1.0), (6.0, 6.0, 0), (0, 0, -11.0))
        write_rectangle("far.off", (-10.0, 900.0, 1.0), (20.0, 0, 0), (0, 0, -11.0))
        write_rectangle("across.off", (-2.0, -6.0, 1.0), (4.0, 12.0, 0), (0, 0, -11.0))

    def assert_refused(self, arguments, *pieces):
        result = run(MESH, "build", *arguments)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        message = result.stderr.splitlines()[-1]
        self.assertTrue(message.startswith("asperity-mesh: "), message)
        for piece in pieces:
            self.assertIn(piece, message)
        self.assertFalse(list(pathlib.Path(".").glob("*.h5*")))

    def test_deck_to_a_mesh_that_runs(self):
        pathlib.Path("model.xml").write_text(DECK, encoding="utf-8")
        result = run(MESH, "build", "model.xml", "built.h5")
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        # 20 km times 10 km below the ground, and 6.02 sqrt(2) km times 10 km
        self.assertRegex(result.stdout, r"fault 'main': \d+ facets, 200 km\^2")
        self.assertRegex(result.stdout, r"fault 'branch': \d+ facets, 85\.13\d* km\^2")
        self.assertIn("faults 'main' and 'branch' meet along", result.stdout)
        self.compare_edges(result.stdout)
        info = run(MESH, "info", "built.h5").stdout
        for name in ("west", "east", "south", "north", "bottom", "surface"):
            self.assertIn(f"boundary         {name}: ", info)
        for name in ("main", "branch"):
            self.assertIn(f"fault            {name}: ", info)
        faults = [condition(name, "Two-Sided Fault") for name in ("main", "branch")]
        sides = [condition(name, "Fixed") for name in ("west", "east", "south", "north", "bottom")]
        conditions = "".join([*faults, *sides, condition("surface", "Free Surface")])
        pathlib.Path("run.xml").write_text(RUN.replace("CONDITIONS", conditions), encoding="utf-8")
        result = run(MAIN, "run.xml", "--validate")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("run.xml is valid.", result.stdout)
        self.compare_with_forecast(result.stdout)

    def compare_edges(self, printed):
        """The report of edges with that of `info`, and with `Largest`."""
        shortest = re.search(r"^shortest edge: (\S+) m at ", printed, re.MULTILINE)[1]
        self.assertIn(f"shortest edge    {shortest} m at (", run(MESH, "info", "built.h5").stdout)
        longest = float(re.search(r"^longest edge: (\S+) m at ", printed, re.MULTILINE)[1])
        longer = re.search(r"^(\d+) of (\d+) edges are longer than Largest = 10000 m, by up to "
                           r"(\d+) %$", printed, re.MULTILINE)
        self.assertEqual(longest > 10e3, longer is not None)
        if longer:
            self.assertLess(0, int(longer[1]))
            self.assertLess(int(longer[1]), int(longer[2]))
            self.assertAlmostEqual(int(longer[3]), 100 * (longest / 10e3 - 1), delta=0.51)

    def compare_with_forecast(self, validated):
        """What --deck says before the mesh is made with what the main program says of it."""
        result = run(MESH, "build", "model.xml", "--dry", "--deck", "run.xml")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        # G L / (b sigma_n) = 32e9 * 3 / (0.03 * 25e6); the deck's constants are everywhere the same
        zone = "cohesive zone G' L / (b sigma_n) >= 128000 m"
        self.assertIn(zone, result.stdout)
        self.assertIn(zone, validated)
        nucleation = r"Nucleation length >= [0-9.e+]+ m"
        self.assertEqual(re.search(nucleation, result.stdout)[0],
                         re.search(nucleation, validated)[0])
        expected = float(re.search(r"about (\S+) unknowns", result.stdout)[1])
        unknowns = float(re.search(r"(\d+) unknowns", validated)[1])
        self.assertLess(max(expected / unknowns, unknowns / expected), 1.5)
        pathlib.Path("long.xml").write_text(  # L: 6 m instead of 3 m
            '<ParameterList name="Asperity"><ParameterList name="Friction">'
            '<Parameter name="L" type="double" value="6"/></ParameterList></ParameterList>')
        words = [MESH, "build", "model.xml", "--dry", "--overlay", "long.xml"]
        self.assertIn(zone.replace("128000", "256000"), run(*words, "--deck", "run.xml").stdout)
        result = run(*words)
        self.assertEqual(result.returncode, 2)
        self.assertIn("Option --overlay long.xml: there is no deck", result.stderr)
        text = pathlib.Path("run.xml").read_text(encoding="utf-8")
        pathlib.Path("wrong.xml").write_text(text.replace('"surface"', '"surfaces"'),
                                             encoding="utf-8")
        result = run(MESH, "build", "model.xml", "--dry", "--deck", "wrong.xml")
        self.assertEqual(result.returncode, 2)
        for word in ("'surfaces'", "Did you mean 'surface'?"):
            self.assertIn(word, result.stderr)
        pathlib.Path("wrong.xml").write_text(text.replace("Final Time", "Last Time"),
                                             encoding="utf-8")
        result = run(MESH, "build", "model.xml", "--dry", "--deck", "wrong.xml")
        self.assertEqual(result.returncode, 2)
        self.assertIn("wrong.xml': Asperity / Time Stepping", result.stderr)

    def test_parts(self):
        arguments = ["--fault", "main=main.off", "--units", "km", *OPTIONS]
        self.assert_refused(["out.h5", *arguments, "--boundary", "main"], "--parts is missing")
        self.assert_refused(["out.h5", *arguments, "--parts", "0"], "--parts = 0")
        result = run(MESH, "build", "parts.h5", *arguments, "--parts", "2", "--boundary", "main")
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        self.assertRegex(result.stdout, r"parts.h5: 2 parts of \d+ vertices, \d+ cells")
        self.assertIn("those of boundary main", result.stdout)
        whole = run(MESH, "build", "whole.h5", *arguments)
        self.assertEqual(whole.returncode, 0)
        divided = run(MESH, "partition", "whole.h5", "--parts", "2", "--boundary", "main",
                      "--output", "divided.h5")
        self.assertEqual(divided.stdout.replace("divided.h5", "parts.h5"),
                         "\n".join(result.stdout.splitlines()[-2:]) + "\n")
        self.assertEqual(run(MESH, "info", "parts.h5").stdout,
                         run(MESH, "info", "divided.h5").stdout)

    def test_options_say_the_same(self):
        pathlib.Path("model.xml").write_text(DECK, encoding="utf-8")
        by_deck = run(MESH, "build", "model.xml", "--dry").stdout
        result = run(MESH, "build", "--dry", "--fault", "main=main.off", "--fault",
                     "branch=branch.off,size=3000", "--units", "km", *OPTIONS)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        times = re.compile(r"^ *[0-9.]+ s ", re.MULTILINE)
        self.assertEqual(times.sub("", result.stdout), times.sub("", by_deck))
        self.assertFalse(list(pathlib.Path(".").glob("*.h5")))

    def test_files_of_a_deck_in_another_folder(self):
        """They are relative to the deck, those of options to where the program runs."""
        pathlib.Path("model.xml").write_text(DECK, encoding="utf-8")
        expected = run(MESH, "build", "model.xml", "--dry").stdout
        folder = pathlib.Path("deck")
        folder.mkdir(exist_ok=True)
        only_main = re.sub(r'    <ParameterList name="branch">.*?</ParameterList>\n', "", DECK,
                           flags=re.DOTALL)
        self.assertNotIn("branch", only_main)
        (folder / "model.xml").write_text(only_main, encoding="utf-8")
        shutil.copy("main.off", folder / "main.off")
        result = run(MESH, "build", "deck/model.xml", "--dry", "--fault",
                     "branch=branch.off,size=3000,units=km")
        shutil.rmtree(folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        times = re.compile(r"^ *[0-9.]+ s ", re.MULTILINE)
        self.assertEqual(times.sub("", result.stdout), times.sub("", expected))

    def test_entries_of_a_trace_alone_say_that_it_is_one(self):
        pathlib.Path("dips.txt").write_text("0 0 90\n0 10 90\n", encoding="utf-8")
        pathlib.Path("line.txt").write_text("0 0\n0 10\n", encoding="utf-8")
        for fault in ("dips.txt,trace-columns=x y dip,depth=12km",
                      "line.txt,dip=90,depth=12km,upper-depth=0"):
            result = run(MESH, "build", "--dry", "--fault", f"t={fault}", "--units", "km",
                         *OPTIONS)
            self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
            self.assertRegex(result.stdout, r"fault 't': 120 km\^2")

    def test_vertical_axis(self):
        # The fault has x from 0 to 6 km, y to the north from 0.02 to 6.02 km. In the mesh y is up
        # and z points to the south.
        result = run(MESH, "build", "built.h5", "--fault", "branch=branch.off", "--units", "km",
                     *OPTIONS, "--set", "Vertical Axis=y")
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        info = run(MESH, "info", "built.h5").stdout
        self.assertIn("[-15000, 21000] x [-25000, 0] x [-21020, 14980] m", info)
        self.assertRegex(info, r"volume +3\.24e\+13 m\^3")

    def test_sheets_of_a_fault_that_branches(self):
        # The north branch goes on along x, the other one leaves at x = 0, y = 0 by 45 degrees.
        corners = [(-10, 0), (0, 0), (10, 0), (6, 6)]
        points = [f"{x} {y} {z}" for x, y in corners for z in (1.0, -10.0)]
        faces = [face for i, j in ((0, 1), (1, 2), (1, 3))
                 for face in (f"3 {2 * i} {2 * j} {2 * j + 1}",
                              f"3 {2 * i} {2 * j + 1} {2 * i + 1}")]
        text = "\n".join(["OFF", f"{len(points)} {len(faces)} 0", *points, *faces])
        pathlib.Path("tree.off").write_text(text + "\n", encoding="utf-8")
        arguments = ["--fault", "tree=tree.off,size=3000", "--units", "km", *OPTIONS]
        result = run(MESH, "build", "built.h5", *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        self.assertIn("fault 'tree' branches; its sheets become the faults 'tree.1', 'tree.2'",
                      result.stdout)
        self.assertRegex(result.stdout, r"fault 'tree.1': \d+ facets, 200 km\^2")
        self.assertRegex(result.stdout, r"fault 'tree.2': \d+ facets, 84\.85\d* km\^2")
        info = run(MESH, "info", "built.h5").stdout
        for name in ("tree.1", "tree.2"):
            self.assertIn(f"fault            {name}: ", info)
        pathlib.Path("built.h5").unlink()
        self.assert_refused(["out.h5", "--fault", "tree.2=far.off", *arguments],
                            "Faults / tree branches", "'tree.2'", "another name")

    def test_other_options_say_the_same(self):
        pathlib.Path("trace.txt").write_text("9.9 45\n10.1 45\n", encoding="utf-8")
        heights = "\n".join(["ncols 3", "nrows 3", "xllcorner -60", "yllcorner -60", "cellsize 40",
                             "NODATA_value -9999", *["0.5 0.5 0.5"] * 3])
        pathlib.Path("dem.asc").write_text(heights + "\n", encoding="utf-8")
        projection = "+proj=tmerc +lat_0=45 +lon_0=10 +datum=WGS84"
        words = ["--dry", "--fault", "t=trace.txt,dip=90,depth=10km,units=degrees,depth-units=km",
                 "--ground", "dem.asc,units=km,depth-units=km", *OPTIONS[:4], "--margin", "20km",
                 "--depth", "30km"]
        short = run(MESH, "build", *words, "--growth", "0.5", "--snap", "20m", "--projection",
                    projection)
        long = run(MESH, "build", *words,
                   *(word for entry in ("Growth=0.5", "Snap=20", f"Projection={projection}")
                     for word in ("--set", entry)))
        self.assertEqual((short.returncode, short.stderr), (0, ""), short.stdout)
        times = re.compile(r"^ *[0-9.]+ s ", re.MULTILINE)
        self.assertEqual(times.sub("", short.stdout), times.sub("", long.stdout))
        # 0.2 degrees of longitude at 45 degrees are 15.77 km; 10.5 km from the ground down
        self.assertRegex(short.stdout, r"fault 't': 165\.[5-7]\d* km\^2")

    def test_units_are_not_guessed(self):
        self.assert_refused(["out.h5", "--fault", "main=main.off", *OPTIONS], "Faults / main",
                            "Units")

    def test_wrong_units(self):
        # In metres the fault is 20 m long.
        self.assert_refused(["out.h5", "--fault", "main=main.off", "--fault", "far=far.off",
                             "--units", "km", *OPTIONS[:4], "--set", "Box/Lower={-3e4,-3e4,-3e4}",
                             "--set", "Box/Upper={3e4,3e4,0}"], "'far'", "Units", "900")

    def test_crossing_faults(self):
        """Two may cross; three that do in one point are named with advice."""
        two = ("--fault", "main=main.off", "--fault", "across=across.off", "--units", "km",
               *OPTIONS)
        result = run(MESH, "build", "two.h5", *two)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(run(MESH, "info", "two.h5").stdout,
                         r"crossing         across and main at \d+ vertices from \(.* to \(")
        pathlib.Path("two.h5").unlink()
        write_rectangle("level.off", (-3.0, -3.0, -5.0), (6.0, 0, 0), (0, 6.0, 0))
        self.assert_refused(["out.h5", "--fault", "level=level.off", *two],
                            "'across', 'level' and 'main' cross", "end at the other",
                            "Nothing is written")

    def test_tolerance(self):
        # A sharp ridge that cells of this size cannot follow is rounded off.
        rows = [(x / 2, abs((x % 4) - 2) * 0.4) for x in range(0, 25)]
        points = [f"{x} {y} {z}" for x, y in rows for z in (-1.0, -9.0)]
        faces = []
        for i in range(len(rows) - 1):
            faces += [f"3 {2 * i} {2 * i + 2} {2 * i + 3}", f"3 {2 * i} {2 * i + 3} {2 * i + 1}"]
        text = "\n".join(["OFF", f"{len(points)} {len(faces)} 0", *points, *faces])
        pathlib.Path("ridge.off").write_text(text + "\n", encoding="utf-8")
        self.assert_refused(["out.h5", "--fault", "ridge=ridge.off", "--units", "km", *OPTIONS,
                             "--set", "Tolerance=10"], "'ridge'", "Tolerance = 10", "Cell Size")

    def test_forms_of_options(self):
        self.assert_refused(["--fault", "main=main.off", *OPTIONS], "OUT.h5")
        self.assert_refused(["out.h5", "--fault", "main.off", *OPTIONS], "NAME=FILE")
        self.assert_refused(["out.h5", "--fault", "main=main.off,units=miles", *OPTIONS],
                            "Faults / main / Units", "'km'")
        self.assert_refused(["out.h5", "--fault", "main=main.off,colour=red", "--units", "km",
                             *OPTIONS], "Colour")
        self.assert_refused(["out.h5", *OPTIONS], "Faults")

    def test_parameters_are_printed(self):
        result = run(MESH, "build", "--print-parameters")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for name in ("Surface File", "Margin", "Trim Stubs", "Projection"):
            self.assertIn(name, result.stdout)


if __name__ == "__main__":
    unittest.main()
