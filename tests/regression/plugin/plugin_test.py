"""The example of a plugin, built in a project of its own against an installation that was moved."""

import math
import os
import pathlib
import shutil
import subprocess
import unittest

import asperity_run
import numpy
import runs
from comparisons import triangles_at
from exact_solutions import DILATANCY, DISTANCE, DRAINAGE, END, PRESSURE, exact_dilation, exact_slip

EXAMPLE = asperity_run.SOURCE / "examples" / "plugin"
DECK = EXAMPLE / "viscous.xml"
CMAKE = os.environ["ASPERITY_CMAKE"]
COMPILER = os.environ["ASPERITY_COMPILER"]
BUILD = os.environ["ASPERITY_BUILD_DIR"]
PREFIX = pathlib.Path("moved").absolute()
PLUGIN = pathlib.Path("build/libviscous.so")
# Entries that the manual does not have, since the plugin adds them.
OF_PLUGIN = ("Time Stepping/Growing Steps/Steps of a Size", "Bulk/Elastic Range",
             "Bulk/Hardening Modulus", "Friction/Dilating Gouge/Enabled",
             "Friction/Dilating Gouge/Dilatancy", "Friction/Dilating Gouge/Drainage Time",
             "Boundary Conditions/Base/Normal Stiffness", "Boundary Conditions/Base/Turning Rate",
             "Boundary Conditions/Base/Turning Centre", "Boundary Conditions/Lake/Water Level",
             "Boundary Conditions/Lake/Specific Weight")


def settings(*changes):
    return runs.settings(*changes, of_plugin=OF_PLUGIN)


def call(*words):
    result = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise AssertionError(f"{words}\n{result.stdout}{result.stderr}")
    return result.stdout


def setUpModule():
    for folder in ("first", "moved", "build"):
        shutil.rmtree(folder, ignore_errors=True)
    call(CMAKE, "--install", BUILD, "--prefix", pathlib.Path("first").absolute())
    pathlib.Path("first").rename("moved")
    call(CMAKE, "-S", EXAMPLE, "-B", "build", f"-DCMAKE_PREFIX_PATH={PREFIX}",
         f"-DCMAKE_CXX_COMPILER={COMPILER}", "-DCMAKE_BUILD_TYPE=Debug")
    call(CMAKE, "--build", "build", "--parallel", "2")
    asperity_run.PROGRAM = PREFIX / "bin" / "asperity"


class Installation(unittest.TestCase):
    def test_has_what_a_user_needs(self):
        for name in ("bin/asperity", "bin/asperity-plot", "bin/asperity-status",
                     "bin/asperity-report", "bin/asperity-study",
                     "share/asperity/examples/study/thesis.xml",
                     "include/asperity/io/Output.hpp",
                     "include/asperity/friction/Registration.hpp",
                     "share/asperity/decks/wedge_2d.xml",
                     "share/asperity/python/asperity/run.py",
                     "share/asperity/python/pyproject.toml",
                     "share/asperity/examples/plugin/README.md",
                     "share/doc/asperity/packages/io/README.md"):
            self.assertTrue((PREFIX / name).is_file(), name)
        self.assertEqual(list((PREFIX / "include").rglob("*.cpp")), [])

    def test_programs_run_where_they_were_moved_to(self):
        result = asperity_run.run(PREFIX / "share/asperity/decks/spring_slider.xml", "--validate")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for tool in (PREFIX / "bin").glob("asperity-*"):
            self.assertIn(tool.name, call(tool, "--help"))
        study = call(PREFIX / "bin/asperity-study",
                     PREFIX / "share/asperity/examples/study/thesis.xml", "--list")
        self.assertEqual(len(study.splitlines()), 18)

    def test_has_what_a_format_of_surfaces_needs(self):
        """tests/unit/mesh/asperity_mesh_plugin_test.py reads files of the format."""
        program, plugin = PREFIX / "bin" / "asperity-mesh", pathlib.Path("build/libgts.so")
        if not program.exists():
            self.skipTest("this build has no asperity-mesh")
        parameters = [program, "build", "--print-parameters"]
        self.assertIn("GTS (.gts)", call(*parameters, "--plugin", plugin))
        self.assertNotIn("GTS", call(*parameters))

    def test_names_no_folder_of_the_build(self):
        for path in (PREFIX / "lib").rglob("*.cmake"):
            self.assertNotIn(BUILD, path.read_text(), path)


class Run(unittest.TestCase):
    def assert_exact_slip(self, folder):
        rows = asperity_run.table(folder / "mean_slip.csv")
        self.assertGreater(len(rows), 20)
        self.assertEqual(rows[-1]["time"], END)
        for row in rows:
            self.assertAlmostEqual(row["mean_slip"], exact_slip(row["time"]),
                                   delta=1e-5 * exact_slip(END))

    def check(self, ranks):
        folder = asperity_run.run_to_end(f"results_{ranks}", DECK, "--plugin", PLUGIN, "--set",
                                         "Output/Fault History/Precision=Double", "--set",
                                         "Output/Fault History/Fields={slip,alpha,pressure}",
                                         ranks=ranks)
        self.assert_exact_slip(folder)
        history = asperity_run.series(folder / "fault.h5")
        for time, pressure in zip(history["time"], history["fields/pressure"]):
            expected = 1e6 * PRESSURE * math.exp(-time / DRAINAGE)
            self.assertAlmostEqual(pressure.max(), expected, delta=1e-9 * 1e6)
        slip, alpha = history["fields/slip"], history["fields/alpha"]
        self.assertEqual(slip.size, alpha.size)
        for one_slip, one_alpha in zip(slip.ravel(), alpha.ravel()):
            self.assertAlmostEqual(one_alpha, math.exp(-one_slip / DISTANCE), delta=1e-12)

    def test_has_the_exact_slip_and_state(self):
        self.check(ranks=1)

    def test_on_two_ranks(self):
        self.check(ranks=2)

    def test_a_control_goes_on_with_its_memory(self):
        """It knows how many steps it has made of the present size."""
        deck = [DECK, "--plugin", PLUGIN, *settings(
            "Time Stepping/Largest Step=1", "Time Stepping/Growing Steps/Steps of a Size=150",
            "Output/Checkpoint Every n Steps=7")]
        whole = asperity_run.run_to_end("grown", *deck)
        sizes = [row["step_size"] for row in asperity_run.table(whole / "steps.csv")]
        self.assertGreater(len(set(sizes)), 3)
        folder = runs.fresh("grown_stopped")
        runs.stop(self, runs.begin(folder, *deck))
        self.assertLess(len(asperity_run.table(folder / "steps.csv")), len(sizes))
        asperity_run.go_on(folder, *deck)
        self.assertEqual([row["step_size"] for row in asperity_run.table(folder / "steps.csv")],
                         sizes)

    def test_a_restart_may_change_what_a_control_allows(self):
        deck = [DECK, "--plugin", PLUGIN, *settings("Time Stepping/Largest Step=1")]
        number = "Time Stepping/Growing Steps/Steps of a Size"
        folder = asperity_run.run_to_end("regrown", *deck, *settings(
            {number: 1000, "Time Stepping/Final Time": 0.25}))
        asperity_run.go_on(folder, *deck, *settings({number: 5}))
        sizes = [row["step_size"] for row in asperity_run.table(folder / "steps.csv")]
        self.assertEqual(sizes[1:257], [2 ** -10] * 256)
        self.assertEqual(max(sizes), 1)

    def test_a_watch_has_entries_of_its_own(self):
        folder = asperity_run.run_to_end("patient", DECK, "--plugin", PLUGIN, "--set",
                                         "Time Stepping/Largest Slip=1e-3")
        self.assertNotIn("which is much for this body", (folder / "run.log").read_text())

    def test_a_process_follows_from_slip(self):
        """viscous.xml with dp/dt = -p / t_d - c V, where p also acts in friction. The step takes V
        as constant, which errs by (tau / t_d)^2 / 12 = 3e-5 of p."""
        deck = [DECK, "--plugin", PLUGIN, *settings({
            "Friction/Dilating Gouge/Enabled": "true",
            "Friction/Dilating Gouge/Dilatancy": DILATANCY,
            "Friction/Dilating Gouge/Drainage Time": DRAINAGE,
            "Output/Fault History/Precision": "Double",
            "Output/Fault History/Fields": "{slip, gouge_pressure}"})]
        for ranks in (1, 2):
            folder = asperity_run.run_to_end(f"gouge_{ranks}", *deck, ranks=ranks)
            history = asperity_run.series(folder / "fault.h5")
            slip, pressure = exact_dilation(END)
            self.assertLess(slip, 0.97 * exact_slip(END))
            self.assertLess(pressure, -5e4)
            found = history["fields/gouge_pressure"][-1].ravel()
            self.assertLess(abs(found - pressure).max(), 1e-4 * abs(pressure))
            self.assertLess(abs(history["fields/slip"][-1].ravel() - slip).max(), 1e-4 * slip)

    def test_a_smoother_solves_the_same_problem(self):
        """Without inertia and friction that depends on the solver, slip is that of the deck."""
        cycles = {}
        for name in ("Block Jacobi", "Two Jacobi Sweeps"):
            for ranks in (1, 2):
                folder = asperity_run.run_to_end(
                    f"smoother_{name.split()[0]}_{ranks}", DECK, "--plugin", PLUGIN,
                    *settings({"TNNMG/Linear Correction": "Multigrid",
                                    "TNNMG/Multigrid/Smoother": name,
                                    "Mesh/Refinements": 3}), ranks=ranks)
                last = asperity_run.table(folder / "mean_slip.csv")[-1]
                self.assertAlmostEqual(last["mean_slip"], exact_slip(END),
                                       delta=1e-5 * exact_slip(END))
                cycles[name, ranks] = sum(row["v_cycles"] for row in
                                          asperity_run.table(folder / "steps.csv"))
        for ranks in (1, 2):
            self.assertLess(cycles["Two Jacobi Sweeps", ranks], cycles["Block Jacobi", ranks])

    def test_a_watch_warns_once(self):
        folder = asperity_run.run_to_end("watched", DECK, "--plugin", PLUGIN)
        self.assertEqual((folder / "run.log").read_text().count("which is much for this body"), 1)
        self.assertIn("'large slip'", (folder / "run.log").read_text())
        self.assertEqual((folder / "run.jsonl").read_text().count('"topic": "large slip"'), 1)

    def test_a_restart_refuses_a_plugin_that_has_changed(self):
        plugin = pathlib.Path(shutil.copy(PLUGIN, "changed.so"))
        # Small steps, so that those which are cut short to end the first half matter less.
        deck = [DECK, "--plugin", plugin, "--set", "Time Stepping/Largest Step=1"]
        folder = asperity_run.run_to_end("changed", *deck, "--set",
                                         f"Time Stepping/Final Time={END / 2}")
        content = plugin.read_bytes()
        plugin.write_bytes(content + b"\0")  # it still loads, and behaves as before
        result = asperity_run.run(*deck, "--output", folder, "--restart", folder / "checkpoint.h5")
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertIn("plugin libraries", result.stderr)
        plugin.write_bytes(content)
        asperity_run.go_on(folder, *deck, ranks=2)
        self.assert_exact_slip(folder)


# A block under cyclic shear, of rock whose elastic range moves with its inelastic strain.
CELL = asperity_run.SOURCE / "tests" / "verification" / "flow" / "cell.xml"
SHEAR, RANGE, HARDENING = 1e6, 1e3, 5e5  # Pa
CYCLES = {"Bulk/Law": "Kinematic Hardening", "Bulk/Elastic Range": RANGE,
          "Bulk/Hardening Modulus": HARDENING, "Mesh/Rectangle/Cells X": 4,
          "Boundary Conditions/Top/Velocity": "t < 4.01 || t > 12.01 && t < 20.01 ? 1e-3 : -1e-3",
          "Time Stepping/Final Time": 28, "Time Stepping/Prescribed/Levels": "{3}",
          "Output/Checkpoint Every n Steps": 5,
          "Output/Receivers/Body Fields": "{stress, strain, back_stress, inelastic_shear}"}


def hysteresis(strain):
    """Stress and back stress [Pa] of the block at each strain gamma of a path [-]: the stress
    follows the elastic line, and the lines b +- k + H gamma_p with slope G H / (G + H)."""
    inelastic, stresses, centres = 0.0, [], []
    for gamma in strain:
        elastic = SHEAR * (gamma - inelastic)
        over = abs(elastic - HARDENING * inelastic) - RANGE
        if over > 0:
            inelastic += math.copysign(over / (SHEAR + HARDENING),
                                       elastic - HARDENING * inelastic)
        stresses.append(SHEAR * (gamma - inelastic))
        centres.append(HARDENING * inelastic)
    return stresses, centres


def corners(volume):
    """Of the elements, (elements, 3, 2)."""
    return volume["geometry/coordinates"][volume["geometry/connectivity"]]


class RockWithHistory(unittest.TestCase):
    def run_cycles(self, name, **options):
        return asperity_run.run_to_end(name, CELL, "--plugin", PLUGIN, *settings(CYCLES),
                                       **options)

    def assert_hysteresis(self, folder):
        history = asperity_run.series(folder / "receivers.h5")
        strain, stress, centre = (history[f"off_fault/fields/{name}"][:, 0, 1]
                                  for name in ("strain", "stress", "back_stress"))
        gamma = 2 * strain
        expected, of_centre = hysteresis(gamma)
        self.assertGreater(max(gamma), 3.5e-3)
        self.assertLess(min(gamma), -3.5e-3)
        for found, exact in ((stress, expected), (centre, of_centre)):
            for one, other in zip(found, exact):
                self.assertAlmostEqual(one, other, delta=1e-9 * SHEAR * max(gamma))
        # Unlike isotropic hardening, a reversed stress yields after 2 k, below its former maximum.
        turn = max(range(len(gamma)), key=lambda i: gamma[i])
        down = [i for i in range(turn, len(gamma)) if gamma[i] < gamma[turn] - 2.1e-3]
        self.assertLess(abs(centre[down[0]]), abs(centre[turn]) - 1e-3 * RANGE)
        # Two and a half cycles: all inelastic shear adds up.
        shear = history["off_fault/fields/inelastic_shear"][-1].ravel()[0]
        path = [0.0, *(value / HARDENING for value in of_centre)]
        self.assertAlmostEqual(shear, sum(abs(b - a) for a, b in zip(path, path[1:])),
                               delta=1e-9)

    def test_the_elastic_range_moves(self):
        self.assert_hysteresis(self.run_cycles("cycles"))

    def test_on_two_ranks(self):
        self.assert_hysteresis(self.run_cycles("cycles_2", ranks=2))

    def test_goes_on_with_its_history(self):
        whole = self.run_cycles("whole")
        half = asperity_run.run_to_end("half", CELL, "--plugin", PLUGIN, *settings(
            CYCLES, {"Time Stepping/Final Time": 16}))
        asperity_run.go_on(half, CELL, "--plugin", PLUGIN, *settings(CYCLES), ranks=2)
        for name in ("stress", "back_stress"):
            one, other = (asperity_run.series(folder / "receivers.h5")[f"off_fault/fields/{name}"]
                          for folder in (whole, half))
            self.assertEqual(one.shape, other.shape)
            self.assertLess(abs(one - other).max(), 1e-12 * abs(one).max())

    def test_goes_to_another_run_with_its_history(self):
        """On the same mesh the variables go on as they are; on a finer one each cell has those of
        the cell at its centroid. The elastic range differs from cell to cell."""
        fields = "{back_stress, inelastic_strain, inelastic_shear}"
        deck = [CELL, "--plugin", PLUGIN, *settings(
            CYCLES, {"Bulk/Elastic Range": f"{RANGE} * (1 + x)",
                     "Output/Volume Snapshots/Enabled": "true",
                     "Output/Volume Snapshots/Precision": "Double",
                     "Output/Volume Snapshots/Fields": fields})]
        half = asperity_run.run_to_end("other_half", *deck, *settings(
            {"Time Stepping/Final Time": 16}))
        before = asperity_run.series(half / "volume.h5")
        of_cells, history = corners(before), before["fields/back_stress"][-1]
        for name, mesh in (("same", {}), ("fine", {"Mesh/Refinements": 1})):
            ours = asperity_run.run_to_end(f"other_{name}", *deck, *settings(mesh),
                                           "--restart-from", half)
            after = asperity_run.series(ours / "volume.h5")
            parents = triangles_at(of_cells, corners(after).mean(axis=1))
            numpy.testing.assert_array_equal(after["fields/back_stress"][0], history[parents], name)
        self.assertGreater(numpy.ptp(history), 0.1 * RANGE)
        of_law = ("Bulk/Elastic Range", "Bulk/Hardening Modulus")
        result = asperity_run.run(CELL, *settings(
            {name: value for name, value in CYCLES.items() if name not in of_law},
            {"Bulk/Law": "Von Mises", "Bulk/Shear Strength": RANGE,
             "Output/Receivers/Body Fields": "{stress}"}),
            "--plugin", PLUGIN, "--restart-from", half, "--output", "other_law")
        runs.assert_one_message(self, result, runs.INPUT,
                                "The internal variables of the rock (Asperity / Bulk / Law) is "
                                "'inelastic_strain, inelastic_shear', but", "back_stress (2)")


# A block between walls that springs hold from below, under a pressure that doubles.
BLOCK = asperity_run.SOURCE / "tests" / "verification" / "traction" / "block.xml"
SPRINGS, PUSH, AREA = 4e5, 300.0, 2.0  # Pa/m, Pa, m
MODULUS = 2e6 * 0.7 / 0.4  # lambda + 2 G, Pa
ON = "Boundary Conditions/"


class Springs(unittest.TestCase):
    def test_hold_a_block(self):
        """u_y = -p / k - p y / (lambda + 2 G): all that the load does is elastic."""
        for ranks in (1, 2):
            folder = asperity_run.run_to_end(
                f"springs_{ranks}", BLOCK, "--plugin", PLUGIN, "--remove", f"{ON}Pull/Traction X",
                *settings({f"{ON}Base/Type": "Elastic Foundation",
                                f"{ON}Base/Normal Stiffness": SPRINGS,
                                f"{ON}Pull/Type": "Sliding Wall",
                                f"{ON}Push/Boundary": "top",
                                f"{ON}Push/Type": "Prescribed Traction",
                                f"{ON}Push/Pressure": f"{PUSH} * (1 + t)"}), ranks=ranks)
            volume = asperity_run.series(folder / "volume.h5")
            y = volume["geometry/coordinates"][:, 1]
            for time, u in zip(volume["time"], volume["fields/displacement"]):
                expected = -PUSH * (1 + time) * (1 / SPRINGS + y / MODULUS)
                self.assertLess(abs(u[:, 1] - expected).max(), 1e-9 * abs(expected).max())
                self.assertLess(abs(u[:, 0]).max(), 1e-9 * abs(expected).max())
            first = 0.5 * AREA * PUSH ** 2 * (1 / SPRINGS + 1 / MODULUS)
            last = asperity_run.table(folder / "steps.csv")[-1]
            # The table has eight digits.
            self.assertAlmostEqual(last["elastic_energy"] / (4 * first), 1, delta=1e-7)
            self.assertAlmostEqual(last["load_work"] / (3 * first), 1, delta=1e-7)
            self.assertLess(abs(last["energy_defect"]), 1e-9 * first)


class Conditions(unittest.TestCase):
    def displacements(self, name, *changes, ranks=1):
        folder = asperity_run.run_to_end(name, BLOCK, "--plugin", PLUGIN, *changes, ranks=ranks)
        volume = asperity_run.series(folder / "volume.h5")
        places = volume["geometry/coordinates"][:, :2]
        return volume, zip(volume["time"], volume["fields/displacement"][..., :2]), places

    def test_a_boundary_turns_the_body(self):
        """A rotation strains nothing: u = omega t e_z x (x - c) everywhere."""
        rate, centre = 1e-3, numpy.array([0.5, -1.0])
        for ranks in (1, 2):
            volume, found, places = self.displacements(
                f"turned_{ranks}", "--remove", f"{ON}Wall", "--remove", f"{ON}Pull",
                *settings({f"{ON}Base/Type": "Turning Boundary",
                                f"{ON}Base/Turning Rate": rate,
                                f"{ON}Base/Turning Centre": "{0.5, -1}"}), ranks=ranks)
            arm = places - centre
            turned = rate * numpy.column_stack((-arm[:, 1], arm[:, 0]))
            for time, u in found:
                self.assertLess(abs(u - time * turned).max(), 1e-9 * abs(turned).max())
            self.assertLess(abs(volume["fields/stress"]).max(), 1e-9 * 1e6 * rate)

    def test_a_boundary_bears_water(self):
        """Between walls u_y = -p y / (lambda + 2 G) under p = w (h - H); a dry boundary is free."""
        weight, above = 1e4, 0.05
        for ranks in (1, 2):
            _, found, places = self.displacements(
                f"water_{ranks}", "--remove", f"{ON}Pull/Traction X",
                *settings({f"{ON}Pull/Type": "Sliding Wall", f"{ON}Lake/Boundary": "top",
                                f"{ON}Lake/Type": "Water Load",
                                f"{ON}Lake/Water Level": f"1 + {above} * (1 + t)",
                                f"{ON}Lake/Specific Weight": weight}), ranks=ranks)
            for time, u in found:
                expected = -weight * above * (1 + time) * places[:, 1] / MODULUS
                self.assertLess(abs(u[:, 1] - expected).max(), 1e-9 * abs(expected).max())
                self.assertLess(abs(u[:, 0]).max(), 1e-9 * abs(expected).max())

    def test_bad_entries_are_refused(self):
        deck = [BLOCK, "--validate", "--plugin", PLUGIN]
        turning = f"{ON}Base/Type=Turning Boundary"
        for changes, pieces in (
                ([turning, f"{ON}Base/Turning Centre={{1}}"], ["Turning Centre has 1 numbers"]),
                ([f"{ON}Base/Turning Rate=1"], ["Turning Rate has no effect", "Turning Boundary"]),
                ([f"{ON}Base/Type=Water Load"], ["Water Level is missing"])):
            result = asperity_run.run(*deck, *settings(*changes))
            runs.assert_one_message(self, result, runs.INPUT, *pieces)


class Parameters(unittest.TestCase):
    def assert_refused(self, arguments, *pieces):
        result = asperity_run.run(*arguments)
        message = runs.assert_one_message(self, result, runs.INPUT, *pieces)
        self.assertEqual((result.stdout, result.stderr), ("", message + "\n"))

    def test_are_printed(self):
        for arguments in ([], ["--format=xml"]):
            text = call(asperity_run.PROGRAM, "--print-parameters", "--plugin", PLUGIN, *arguments)
            for piece in ("with Law = Viscous", "Viscous Slip Rate", "with State Evolution = Wear",
                          "Wear Distance", "with Law = Standard Linear Solid",
                          "Relaxing Share", "Film on Rock", "Draining Pressure", "Growing Steps",
                          "Steps of a Size", "Mean Slip", "Normal Stiffness", "Two Jacobi Sweeps",
                          "Largest Slip", "slip above 'Largest Slip'", "Dilating Gouge",
                          "Turning Rate", "Specific Weight",
                          "at which the coefficient of friction"):
                self.assertTrue(piece in text, piece)
        self.assertFalse("Viscous Slip" in call(asperity_run.PROGRAM, "--print-parameters"))

    def test_are_checked(self):
        deck = [DECK, "--validate", "--plugin", PLUGIN, "--set"]
        self.assert_refused([*deck, "Friction/Viscous Slip Rat=1"],
                            "Friction / Viscous Slip Rat is unknown",
                            "Did you mean 'Viscous Slip Rate'?")
        self.assert_refused([*deck, "Friction/Wear Distance=-1"],
                            "Wear Distance = -1 is outside (0, inf) m")
        self.assert_refused([*deck, "Bulk/Relaxation Time=-1"],
                            "Relaxation Time = -1 is outside (0, inf) s")
        self.assert_refused([*deck, "Bulk/Relaxation Time=1+x", "--set",
                             "Mesh/Rectangle/Cells X=20"], "relaxation times", "at most 8")
        self.assert_refused([*deck, "Bulk/Shear Viscosity=1"], "Bulk / Shear Viscosity is unknown",
                            "or Law = Kelvin-Voigt")
        self.assert_refused([*deck, "Time Stepping/Growing Steps/Steps of a Size=0"],
                            "Steps of a Size = 0 is outside [1, inf)")
        self.assert_refused([*deck, "Output/Mean Slip/Evry n Steps=1"], "'Every n Steps'")
        self.assert_refused([*deck, "Friction/a=0.01"], "Friction / a is unknown here",
                            "parameter of Law =", "Law = Regularised")
        self.assert_refused([*deck, "Output/Fault History/Fields={theta}"], "theta")
        self.assert_refused([DECK, "--validate"], "is not one of", "--plugin")


class Loading(unittest.TestCase):
    def assert_refused(self, plugins, *pieces, ranks=1):
        options = [word for plugin in plugins for word in ("--plugin", plugin)]
        result = asperity_run.run(DECK, "--validate", *options, ranks=ranks)
        runs.assert_one_message(self, result, runs.INPUT, *pieces)

    def test_is_refused_with_one_message(self):
        self.assert_refused(["none.so"], "'none.so' is no file", "--plugin")
        self.assert_refused(["none.so"], "'none.so' is no file", ranks=2)
        pathlib.Path("text.so").write_text("no library")
        self.assert_refused(["text.so"], "'text.so' cannot be loaded")
        self.assert_refused([PLUGIN, PLUGIN], "registers nothing here")


if __name__ == "__main__":
    unittest.main()
