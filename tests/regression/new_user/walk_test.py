"""What a new user does with README and docs alone, step by step, on coarse meshes."""

import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import unittest

import asperity_run
import runs

HERE = pathlib.Path(__file__).parent
BIN = asperity_run.PROGRAM.parent
WEDGE = asperity_run.SOURCE / "xml" / "wedge_2d.xml"
LAST = "Time Stepping/Final Time"


def call(*words, **options):
    """What the command prints; it must succeed, and our programs say nothing on stderr."""
    result = subprocess.run(list(map(str, words)), text=True, capture_output=True, check=False,
                            **options)
    is_ours = pathlib.Path(words[0]).name.startswith("asperity")
    if result.returncode != 0 or (is_ours and result.stderr):
        raise AssertionError(f"{words}\n{result.returncode}\n{result.stdout}{result.stderr}")
    asperity_run.require_no_rise(result.stdout)
    return result.stdout


def value(folder, name):
    """Of a parameter of a run, as its parameters.xml has it."""
    text = (folder / "parameters.xml").read_text()
    return re.search(rf'name="{re.escape(name)}" type="[^"]*" value="([^"]*)"', text)[1]


class Wedge(unittest.TestCase):
    def validate(self, *arguments):
        return call(asperity_run.PROGRAM, WEDGE, "--validate", *arguments)

    def test_what_a_run_will_be(self):
        text = self.validate()
        for piece in ("vertices", "cells have diameters of 0.00202 to", "Memory: ",
                      "cohesive zone", "Nucleation length >= 0.207 m (ageing law",
                      "Cell Size = 0.004 m is the largest diameter"):
            self.assertIn(piece, text)
        self.assertNotIn("ageing law", self.validate("--set", "Friction/State Evolution=Slip"))

    def test_another_dip(self):
        self.assertNotIn("WARNING", self.validate("--set", "Names/slope=0.3"))
        text = self.validate("--set", "Mesh/Wedge/Height=0.3")
        self.assertIn("WARNING: Gravity Direction = {0.27, -1} is not perpendicular", text)
        self.assertIn("it would be {0.3, -1}", text)

    def test_a_patch_needs_cells_of_its_own(self):
        patch = ["--overlay", HERE / "patch.xml", "--set", "Mesh/Wedge/Cell Size=0.004"]
        self.assertNotIn("WARNING", self.validate(*patch))
        text = self.validate(*patch, "--remove", "Mesh/Wedge/Refined Intervals")
        self.assertIn("WARNING: The cohesive zone has fewer than 3 cells", text)

    def test_two_ranks_stopped_then_one_then_figures(self):
        folder = runs.fresh("wedge").absolute()
        process = runs.begin(folder, WEDGE, "--overlay", HERE / "patch.xml", "--set",
                             "Names/slope=0.3", ranks=2)
        runs.stop(self, process, signal.SIGUSR1)
        self.assertEqual(value(folder, "Gravity Direction"), "{0.3, -1}")
        stopped = self.status(folder, runs.STOPPED)
        self.assertEqual(stopped["state"], "stopped")

        # From elsewhere, with nothing said again but a nearer end.
        call(asperity_run.PROGRAM, "--restart", folder, "--set", f"{LAST}={stopped['time'] + 4}",
             cwd="/")
        self.assertEqual(value(folder, "Gravity Direction"), "{0.3, -1}")
        self.assertIn("(0.3)", value(folder, "a"))
        finished = self.status(folder, 0)
        self.assertEqual(finished["state"], "finished")
        self.assertAlmostEqual(finished["time"], stopped["time"] + 4)

        call(BIN / "asperity-plot", folder, "--figures", "slip_rate,surface", "--dpi", "40")
        self.assertTrue((folder / "figures" / "slip_rate.png").exists())
        page = pathlib.Path(call(BIN / "asperity-report", folder).split()[-1])
        self.assertIn("Refined Intervals", (folder / page).read_text())

    def status(self, folder, expected):
        result = subprocess.run([str(BIN / "asperity-status"), str(folder), "--json"], text=True,
                                capture_output=True, check=False)
        self.assertEqual(result.returncode, expected, result.stdout + result.stderr)
        return json.loads(result.stdout)


@unittest.skipUnless((BIN / "asperity-mesh").exists(), "the mesh tool is not built")
class OwnMesh(unittest.TestCase):
    def test_lies_beside_its_deck(self):
        folder = runs.fresh("own_mesh")
        folder.mkdir()
        call(BIN / "asperity-mesh", "convert", HERE / "block.geo", folder / "block.h5",
             "--set", "h=0.2")
        deck = (asperity_run.SOURCE / "xml" / "spring_slider.xml").read_text()
        mesh = re.search(r'<Parameter name="Type" type="string" value="Rectangle"/>.*?'
                         r'</ParameterList>', deck, re.DOTALL)[0]
        (folder / "block.xml").write_text(deck.replace(
            mesh, '<Parameter name="Type" type="string" value="File"/>\n<ParameterList name="File">'
                  '<Parameter name="File Name" type="string" value="block.h5"/></ParameterList>'))
        call(asperity_run.PROGRAM, folder / "block.xml", "--output", folder / "results", "--set",
             f"{LAST}=20 * 2")
        self.assertEqual(value(folder / "results", "Final Time"), "40")
        rows = asperity_run.table(folder / "results" / "steps.csv")
        self.assertEqual(rows[-1]["time"], 40)
        # its parameters.xml is a deck that may be read from anywhere
        call(asperity_run.PROGRAM, (folder / "results" / "parameters.xml").absolute(),
             "--validate", cwd="/")


@unittest.skipUnless("ASPERITY_CMAKE" in os.environ, "needs what is installed")
class OwnLaw(unittest.TestCase):
    """examples/plugin is copied and its law changed to mu = (V / V1) / 2 under another name."""

    def test_is_loaded_and_obeyed(self):
        for name in ("prefix", "law", "law_build"):
            shutil.rmtree(name, ignore_errors=True)
        prefix = pathlib.Path("prefix").absolute()
        cmake = os.environ["ASPERITY_CMAKE"]
        call(cmake, "--install", os.environ["ASPERITY_BUILD_DIR"], "--prefix", prefix)
        shutil.copytree(prefix / "share" / "asperity" / "examples" / "plugin", "law")
        law = pathlib.Path("law/ViscousLaw.cpp")
        text = law.read_text()
        self.assertIn("return {rate};", text)
        law.write_text(text.replace("return {rate};", "return {2 * rate};")
                       .replace('"Viscous"', '"Half Viscous"'))
        deck = pathlib.Path("law/viscous.xml")
        deck.write_text(deck.read_text().replace('value="Viscous"', 'value="Half Viscous"'))
        call(cmake, "-S", "law", "-B", "law_build", f"-DCMAKE_PREFIX_PATH={prefix}",
             f"-DCMAKE_CXX_COMPILER={os.environ['ASPERITY_COMPILER']}", "-DCMAKE_BUILD_TYPE=Debug")
        call(cmake, "--build", "law_build")
        program, plugin = prefix / "bin" / "asperity", "law_build/libviscous.so"
        self.assertIn("with Law = Half Viscous",
                      call(program, "--print-parameters", "--plugin", plugin))
        runs.fresh("own_law")
        call(program, deck, "--plugin", plugin, "--output", "own_law", "--set",
             "Friction/Draining Pressure/Enabled=false", "--set", "Bulk/Relaxing Share=0")
        row = asperity_run.table("own_law/mean_slip.csv")[-1]
        # half of the friction relaxes in half of the 500 s that law/viscous.xml tells of
        self.assertAlmostEqual(row["mean_slip"], 1e-6 * (1000 + 250 * math.expm1(-1000 / 250)),
                               delta=1e-8)
        result = subprocess.run([program, deck, "--validate"], text=True,
                                capture_output=True, check=False)
        self.assertEqual(result.returncode, 2)
        self.assertIn("--plugin", result.stderr)


class Study(unittest.TestCase):
    def test_of_four_runs(self):
        runs.fresh("study")
        call(BIN / "asperity-study", asperity_run.SOURCE / "examples" / "study" / "slider.xml",
             "--output", "study", "--cores", "2")
        lines = pathlib.Path("study/results.csv").read_text().splitlines()
        self.assertEqual(len(lines), 5)


if __name__ == "__main__":
    unittest.main()
