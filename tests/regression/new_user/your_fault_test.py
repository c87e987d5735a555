"""The chapter "Bring your fault": every command of its pages, word by word, in their order; the
earthquakes are those that the pages tell of, and files of the examples are what they say."""

import filecmp
import math
import re
import shlex
import shutil
import subprocess
import sys
import unittest

import asperity_run
import numpy
import runs
import time_limits

PAGES = asperity_run.SOURCE / "docs" / "first_model"
EXAMPLES = asperity_run.SOURCE / "examples" / "your_fault"


def commands(page):
    """The lines of a page that call a program of ours; those that end in \\ go on."""
    text = re.sub(r"\\\n +", "", page)
    return re.findall(r"^ {4}(asperity.*)", text, re.MULTILINE)


class Chapter(unittest.TestCase):
    def setUp(self):
        self.folder = runs.fresh(self.id().split(".")[-1]).absolute()
        self.folder.mkdir()
        (self.folder / "examples").symlink_to(asperity_run.SOURCE / "examples")

    def follow(self, name):
        """Runs the commands of a page; returns it and what they print, one text."""
        page = (PAGES / f"{name}.md").read_text(encoding="utf-8")
        printed = []
        for command in commands(page):
            program, *rest = shlex.split(command)
            result = subprocess.run([asperity_run.PROGRAM.with_name(program), *rest], text=True,
                                    capture_output=True, check=False, cwd=self.folder,
                                    timeout=time_limits.seconds(300))
            self.assertEqual((result.returncode, result.stderr), (0, ""), command)
            asperity_run.require_no_rise(result.stdout)
            self.assertNotIn("WARNING", result.stdout, command)
            printed.append(result.stdout)
        self.assertGreater(len(printed), 3)
        return page, "\n".join(printed)

    def assert_one_event(self, results, page):
        """Its magnitude is that of the page."""
        events = asperity_run.table(self.folder / "results" / results / "events.csv")
        self.assertEqual(len(events), 1)
        told = re.search(r"magnitude\s+(\d\.\d)", page)[1]
        self.assertEqual(f"{events[0]['magnitude']:.1f}", told)
        self.assertTrue((self.folder / "results" / results / "figures/fault_maps.png").exists())
        return events[0]

    def test_your_fault(self):
        page, printed = self.follow("your_fault")
        event = self.assert_one_event("your_fault", page)
        self.assertIn(f"lasts {event['duration']:.0f} s", page)
        self.assertRegex(printed, r"Fault 'main':.* a positive Shear Traction .*right lateral\.")
        self.assertIn("faults 'main' and 'thrust' meet along", printed)

    def test_your_slab(self):
        page, printed = self.follow("your_slab")
        event = self.assert_one_event("your_slab", page)
        self.assertAlmostEqual(event["onset"] / 31557600, float(re.search(
            r"(\d+) years", page)[1]), delta=3)
        self.assertRegex(printed, r"The plates slip along it .*: rake .*a thrust")

    def test_your_network(self):
        page, printed = self.follow("your_network")
        self.assert_one_event("network", page)
        self.assertIn("faults 'main' and 'splay' meet along", printed)
        crossing = subprocess.run(
            [asperity_run.PROGRAM.with_name("asperity-mesh"), "build",
             "examples/your_fault/network.xml", "crossing.h5", "--set", "Trim Stubs=0.05"],
            text=True, capture_output=True, cwd=self.folder, check=False)
        self.assertEqual(crossing.returncode, 0, crossing.stderr)
        self.assertIn("'main' and 'splay' cross along", crossing.stdout)

    def test_your_mesh(self):
        page, printed = self.follow("your_mesh")
        self.assert_one_event("others", page)
        self.assertRegex(printed, r"Fault 'main':.* a positive Shear Traction .*left lateral\.")
        meshes = [asperity_run.series(self.folder / name) for name in ("others.h5", "puml.h5")]
        for key in ("vertices", "cells"):
            self.assertEqual(meshes[0][key].tolist(), meshes[1][key].tolist())


def write_own_files(folder):
    """A wavy sheet of triangles and a trace in km, and hills in km and m."""
    dip = math.radians(70)
    x, down = numpy.meshgrid(numpy.linspace(-20, 20, 41), numpy.linspace(0, 16, 21), indexing="ij")
    y = 0.8 * numpy.sin(x / 4) * numpy.cos(down / 6) - down * math.cos(dip)
    p = numpy.stack((x, y, 1 - down * math.sin(dip)), axis=-1)
    corners = [p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]]
    halves = [numpy.stack([corners[i] for i in three], axis=2) for three in ((0, 1, 2), (0, 2, 3))]
    triangles = numpy.concatenate([half.reshape(-1, 3, 3) for half in halves])
    facets = [f"facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n" for vertices in (
        "".join("vertex {:.5f} {:.5f} {:.5f}\n".format(*v) for v in t) for t in triangles)]
    (folder / "sheet.stl").write_text("solid mine\n" + "".join(facets) + "endsolid mine\n")
    heights = [f"{a:g} {b:g} {300 * math.cos(a / 15) * math.sin(b / 12):.1f}\n"
               for b in range(-60, 61, 2) for a in range(-60, 61, 2)]
    (folder / "dem.xyz").write_text("".join(heights))
    # walks west, so that the fault dips north, away from the sheet
    (folder / "trace.txt").write_text("".join(
        f"{a:.3f} {12 + 0.5 * math.sin(a / 5):.3f}\n" for a in numpy.linspace(12, -10, 8)))


class OwnFiles(unittest.TestCase):
    """Triangles, a trace with dip and heights that are in no example, to a rupture."""

    def call(self, folder, program, *arguments):
        result = subprocess.run([asperity_run.PROGRAM.with_name(program), *arguments], text=True,
                                capture_output=True, check=False, cwd=folder,
                                timeout=time_limits.seconds(300))
        self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)
        return result.stdout

    def test_thrust(self):
        folder = runs.fresh("own_files")
        folder.mkdir()
        write_own_files(folder)
        built = self.call(folder, "asperity-mesh", "build", "mine.h5",
                          "--fault", "sheet=sheet.stl,units=km",
                          "--fault", "back=trace.txt,units=km,dip=60,depth=9km",
                          "--ground", "dem.xyz,units=km,depth-units=m", "--size", "1500m",
                          "--largest", "6km", "--margin", "15km", "--depth", "35km",
                          "--set", "Vertical Axis=y")
        self.assertRegex(built, r"fault 'back': .* dip 60 degrees")
        self.assertRegex(built, r"fault 'sheet': .* strike 90, dip 70 degrees")
        page = (PAGES / "your_fault.md").read_text(encoding="utf-8")
        snippet = re.search(r"^```xml\n(.*?)^```", page, re.MULTILINE | re.DOTALL)[1]
        overlay = (EXAMPLES / "on_model.xml").read_text(encoding="utf-8")
        for mine, theirs in (("mine.h5", "your_fault.h5"), ("sheet", "main"), ("back", "thrust")):
            overlay = overlay.replace(f'"{theirs}"', f'"{mine}"')
        overlay = overlay.replace("{main, thrust}", "{sheet, back}")
        head, mesh, rest = overlay.partition('  <ParameterList name="Mesh">')
        (folder / "on_mine.xml").write_text(head + snippet + mesh + rest, encoding="utf-8")
        told = self.call(folder, "asperity", EXAMPLES / "rupture.xml", "--overlay", "on_mine.xml",
                         "--output", "results")
        self.assertNotIn("WARNING", told)
        self.assertRegex(told, r"Fault 'sheet': .* a positive Shear Traction .*90, a thrust\.")
        event, = asperity_run.table(folder / "results" / "events.csv")
        # most of the part that weakens, 30 km long and 11 km deep at 70 degrees
        self.assertGreater(event["area"], 0.8 * 30e3 * 11e3 / math.sin(math.radians(70)))


class Files(unittest.TestCase):
    def test_are_what_the_scripts_write(self):
        folder = runs.fresh("files")
        folder.mkdir()
        for script in ("make_files.py", "make_meshes.py"):
            shutil.copy(EXAMPLES / script, folder)
            subprocess.run([sys.executable, folder / script], check=True)
        for name in ("main.ts", "trace.txt", "contours.txt", "dem.asc", "others.msh"):
            self.assertTrue(filecmp.cmp(EXAMPLES / name, folder / name, shallow=False), name)
        written, kept = (asperity_run.series(where / "others.puml.h5")
                         for where in (folder, EXAMPLES))
        self.assertEqual({name: values.tolist() for name, values in written.items()},
                         {name: values.tolist() for name, values in kept.items()})


if __name__ == "__main__":
    unittest.main()
