"""Bad input ends with one clear message and exit status 2, and no file is made or touched.

Every case runs in a folder of its own, of which each file is compared afterwards.
"""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

import h5py
import numpy

import asperity_run
import mesh_files
import runs
from asperity_run import settings

# After a status that is not 0 mpirun waits a second before it kills ranks, also those that have
# ended.
os.environ["OMPI_MCA_odls_base_sigkill_timeout"] = "0"

HERE = pathlib.Path(__file__).parent
DECK = HERE / "square.xml"
TEXT = DECK.read_text()

CORNERS = numpy.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
SIDES = {"bottom": [[0, 1]], "right": [[1, 2]], "top": [[2, 3]], "left": [[3, 0]]}


def write_mesh(name, cells=((0, 1, 2), (0, 2, 3)), sides=tuple(SIDES), vertices=CORNERS):
    mesh_files.write(name, vertices, cells, {side: SIDES[side] for side in sides})


class Case(unittest.TestCase):
    def setUp(self):
        self.home = pathlib.Path.cwd()
        folder = self.home / self.id().rpartition(".")[2]
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        os.chdir(folder)

    def tearDown(self):
        os.chdir(self.home)

    def assert_refused(self, arguments, *pieces, ranks=1):
        """One paragraph on stderr that contains the pieces; nothing else happens."""
        before = asperity_run.checksums(".")
        result = asperity_run.run(*arguments, ranks=ranks, timeout=60)
        message = runs.assert_one_message(self, result, runs.INPUT, *pieces)
        if ranks == 1:
            self.assertEqual((result.stdout.strip(), result.stderr), ("", message + "\n"))
        self.assertEqual(asperity_run.checksums("."), before)

    def assert_setting_refused(self, change, *pieces, ranks=1):
        with self.subTest(change):
            self.assert_refused([DECK, *settings(change)], *pieces, ranks=ranks)

    def assert_deck_refused(self, text, *pieces):
        pathlib.Path("bad.xml").write_text(text)
        self.assert_refused(["bad.xml"], *pieces)

    def assert_done(self, *arguments, ranks=1):
        result = asperity_run.run(*arguments, ranks=ranks)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


class Pieces(Case):
    """A body that does not hang together runs with a warning."""

    ON_FILE = settings("Mesh/Type=File", "Mesh/File/File Name=mesh.h5")

    def log_of(self, cells, vertices, ranks):
        write_mesh("mesh.h5", cells, vertices=vertices)
        self.assert_done(DECK, *self.ON_FILE, "--output", "out", "--overwrite", ranks=ranks)
        return pathlib.Path("out/run.log").read_text()

    def test_pieces_that_do_not_touch_and_bow_ties(self):
        square = ((0, 1, 2), (0, 2, 3))
        apart = (square + ((4, 5, 6), (4, 6, 7)), numpy.vstack((CORNERS, CORNERS + [3, 0])))
        beyond = numpy.vstack((CORNERS, [[2, 1], [2, 2], [1, 2]]))
        bow_tie = (square + ((2, 4, 5), (2, 5, 6)), beyond)
        for ranks in (1, 2):
            with self.subTest(ranks):
                log = self.log_of(*apart, ranks)
                self.assertIn("WARNING: the body consists of 2 pieces", log)
                self.assertNotIn("bow tie", log)
                log = self.log_of(*bow_tie, ranks)
                self.assertIn("WARNING: at 1 vertex cells meet that share no edge", log)
                self.assertIn("the first is vertex 2 at (1, 1) m", log)
                self.assertIn("WARNING: the body consists of 2 pieces", log)
                self.assertNotIn("WARNING: the body", self.log_of(square, CORNERS, ranks))


class Decks(Case):
    def test_the_deck_itself_is_good(self):
        self.assert_done(DECK)
        self.assertTrue(pathlib.Path("results/square/fault.h5").exists())

    def test_missing(self):
        self.assert_refused(["none.xml"], "'none.xml'", "There is no deck")
        self.assert_refused([], "No deck is given")
        self.assert_refused([DECK, DECK], "Two decks")
        pathlib.Path("folder").mkdir()
        self.assert_refused(["folder"], "'folder'", "directory")
        self.assert_refused(["none.xml"], "'none.xml'", ranks=2)

    def test_malformed(self):
        self.assert_deck_refused("", "'bad.xml'")
        self.assert_deck_refused("Density = 3", "'bad.xml'")
        self.assert_deck_refused(TEXT[:len(TEXT) // 2], "'bad.xml'")
        self.assert_deck_refused(TEXT.replace('"Asperity"', '"Granite"'), "'bad.xml'", "Granite")
        self.assert_deck_refused(TEXT.replace('value="1e-5"', 'value="1 < 2"'), "'bad.xml'")

    def test_encodings(self):
        pathlib.Path("bad.xml").write_text(TEXT, encoding="utf-16")
        self.assert_refused(["bad.xml"], "bad.xml", "UTF-16", "UTF-8")
        pathlib.Path("marked.xml").write_text(TEXT, encoding="utf-8-sig")
        self.assert_done("marked.xml", "--output", "out")

    def test_unknown_names(self):
        self.assert_deck_refused(TEXT.replace('"Largest Step"', '"Largets Step"'),
                                 "Asperity / Time Stepping / Largets Step",
                                 "Did you mean 'Largest Step'?")
        self.assert_deck_refused(TEXT.replace('"Friction">', '"Fricton">', 1),
                                 "Asperity / Fricton", "Did you mean 'Friction'?")
        pathlib.Path("bad.xml").write_text(TEXT.replace('"Largest Step"', '"Largets Step"'))
        self.assert_refused(["bad.xml"], "Asperity / Time Stepping / Largets Step", ranks=2)

    def test_missing_parameter(self):
        without = re.sub(r'.*name="L" .*\n', "", TEXT)
        self.assert_deck_refused(without, "Asperity / Friction / L is missing")

    def test_wrong_type(self):
        self.assert_deck_refused(
            TEXT.replace('type="double" value="0.1"/>\n    <Parameter name="Smallest',
                         'type="string" value="fast"/>\n    <Parameter name="Smallest'),
            "Asperity / Time Stepping / Largest Step", "'fast'")
        self.assert_deck_refused(
            TEXT.replace('type="double" value="0.1"/>\n    <Parameter name="Smallest',
                         'type="double" value="fast"/>\n    <Parameter name="Smallest'),
            "Asperity / Time Stepping / Largest Step", "'fast'")
        self.assert_deck_refused(TEXT.replace('type="int" value="4"', 'type="int" value="four"', 1),
                                 "bad.xml", "Cells X", "'four'")

    def test_out_of_range(self):
        self.assert_setting_refused(
            "Friction/a=-0.01", "Asperity / Friction / a = -0.01 is outside (0, inf)")
        self.assert_setting_refused(
            "Bulk/Density=x - 0.5", "Asperity / Bulk / Density", "outside (0, inf)", "(x, y, z)")
        self.assert_setting_refused("Coupling/Tolerance=-1", "Asperity / Coupling / Tolerance = -1")
        self.assert_setting_refused(
            "Friction/Normal Stress=-1", "Asperity / Friction / Normal Stress = -1", "[0, inf)")
        self.assert_setting_refused("Friction/a=-0.01", "Asperity / Friction / a = -0.01", ranks=2)
        self.assert_setting_refused("Bulk/Density=x - 0.5", "Asperity / Bulk / Density", ranks=2)

    def test_expressions(self):
        self.assert_setting_refused("Bulk/Density=1000 +", "Asperity / Bulk / Density")
        self.assert_setting_refused("Bulk/Density=1000 * q", "Asperity / Bulk / Density", "q")
        self.assert_setting_refused("Friction/b=fields.h5:/b", "fields.h5")
        self.assert_setting_refused("Friction/Normal Stress=x=0 ? 5e6 : 4e6",
                                    "Asperity / Friction / Normal Stress", "==")
        self.assert_setting_refused("Bulk/Density=1000" + 20000 * "+", "Asperity / Bulk / Density",
                                    "20000 characters")

    def test_names_beside_the_type_of_a_number(self):
        names = '<ParameterList name="Names">\n    <Parameter name="rho" type="double" value="{}"/>'
        named = TEXT.replace('<ParameterList name="Mesh">',
                             names + '\n  </ParameterList>\n  <ParameterList name="Mesh">', 1)
        named = named.replace('type="double" value="1000"', 'type="double" value="2 * rho"')
        pathlib.Path("named.xml").write_text(named.replace("{}", "500"))
        self.assert_done("named.xml", "--output", "named")
        written = pathlib.Path("named/parameters.xml").read_text()
        self.assertIn('value="2 * (500)"', written)
        self.assert_deck_refused(named.replace("{}", "=500"), "Asperity / Names / rho", "==")

    def test_datasets_where_there_is_no_vertex(self):
        with h5py.File("fields.h5", "w") as file:
            file["values"] = numpy.full(25, 1000.0)
        for name in ("Boundary Conditions/Drive/Velocity", "Mesh/Regions/core"):
            self.assert_setting_refused(f"{name}=fields.h5:/values",
                                        f"Asperity / {name.replace('/', ' / ')} is a dataset")

    def test_choices(self):
        self.assert_setting_refused("Friction/Law=Regularized", "Asperity / Friction / Law",
                                    "Did you mean 'Regularised'?")
        self.assert_setting_refused("Mesh/Type=Rectangel", "Asperity / Mesh / Type", "Rectangle")
        self.assert_setting_refused("Output/Fault History/Fields={slip_rat}", "slip_rat",
                                    "slip_rate")


class CommandLine(Case):
    def test_settings(self):
        for change, pieces in (("Friction/Lenght=1", ("Friction", "Lenght")),
                               ("Frictoin/L=1", ("Frictoin", "Did you mean 'Friction'?")),
                               ("Friction/L", ("Friction/L",))):
            with self.subTest(change):
                self.assert_refused([DECK, "--set", change], *pieces)
        self.assert_setting_refused("Friction/L=long", "Asperity / Friction / L", "long")

    def test_options(self):
        self.assert_refused([DECK, "--ouput", "x"], "--ouput", "Did you mean '--output'?")
        self.assert_refused([DECK, "--output"], "--output")
        self.assert_refused([DECK, "--overlay", "none.xml"], "'none.xml'")

    def test_output_that_cannot_be_written(self):
        pathlib.Path("file").write_text("mine")
        self.assert_refused([DECK, "--output", "file/results"], "file/results", "--output")
        self.assert_refused([DECK, "--output", "file"], "file")
        self.assert_refused([DECK, "--output", "file/results"], "file/results", ranks=2)

    def test_paths_with_a_part_that_is_too_long(self):
        part = 256 * "x"
        dataset = settings(f"Friction/a={part}.h5:/a")
        for arguments in ([DECK, "--output", part], [DECK, "--output", f"{part}/results"],
                          [f"{part}.xml"], [DECK, "--overlay", part], [DECK, "--restart", part],
                          [DECK, "--restart-from", part], [DECK, "--plugin", part],
                          [DECK, *settings("Mesh/Type=File", f"Mesh/File/File Name={part}")],
                          [DECK, *dataset]):
            with self.subTest(arguments):
                self.assert_refused(arguments, part)

    def test_existing_result(self):
        self.assert_done(DECK, "--output", "results")
        pathlib.Path("results/notes.txt").write_text("mine")
        self.assert_refused([DECK, "--output", "results"], "results", "--overwrite")
        self.assert_refused([DECK, "--output", "results"], "results", "--overwrite", ranks=2)
        # Overwriting is no licence to lose a result to a deck that is refused.
        for change in ("Friction/a=-1", "Boundary Conditions/Fault/Boundary=botom",
                       "Output/Fault History/Fields={slip_rat}"):
            with self.subTest(change):
                self.assert_refused(
                    [DECK, "--output", "results", "--overwrite", *settings(change)])
        self.assert_done(DECK, "--output", "results", "--overwrite")
        self.assertEqual(pathlib.Path("results/notes.txt").read_text(), "mine")

    def test_restart(self):
        self.assert_done(DECK, "--output", "results")
        checkpoint = pathlib.Path("results/checkpoint.h5")
        restart = [DECK, "--output", "results", "--restart"]
        self.assert_refused([*restart, "results/none.h5"], "results/none.h5", "no checkpoint")
        content = checkpoint.read_bytes()
        for name, damaged in (
                ("truncated", content[:len(content) // 2]), ("empty", b""), ("text", b"mine"),
                ("flipped", self.with_another_number(content))):
            with self.subTest(name):
                pathlib.Path("damaged.h5").write_bytes(damaged)
                self.assert_refused([*restart, "damaged.h5"], "damaged.h5")
        self.assert_refused([*restart, "results/fault.h5"], "results/fault.h5")
        self.assert_refused([*restart, checkpoint, *settings("Friction/a=0.016")], "another deck")

    @staticmethod
    def with_another_number(content):
        """The bytes of a checkpoint of which one velocity is another one."""
        pathlib.Path("damaged.h5").write_bytes(content)
        with h5py.File("damaged.h5", "r+") as file:
            velocity = file["values/state/v"]
            velocity[3] = velocity[3] + 1e-9
        return pathlib.Path("damaged.h5").read_bytes()


class Meshes(Case):
    def setUp(self):
        super().setUp()
        self.deck = [DECK, *settings("Mesh/Type=File", "Mesh/File/File Name=mesh.h5")]

    def test_a_good_file(self):
        write_mesh("mesh.h5")
        self.assert_done(*self.deck, "--output", "results")

    def test_missing_boundary(self):
        write_mesh("mesh.h5", sides=("top", "left", "right"))
        for ranks in (1, 2):
            self.assert_refused(self.deck, "'bottom'", "boundary", ranks=ranks)

    def test_inverted_cell(self):
        write_mesh("mesh.h5", cells=((0, 1, 2), (0, 3, 2)))
        for ranks in (1, 2):
            self.assert_refused(self.deck, "mesh.h5", "cell 1", ranks=ranks)

    def test_a_hanging_vertex(self):
        """Beside an undivided edge; asperity-mesh says it, too."""
        cells = ((0, 1, 2), (0, 4, 3), (4, 2, 3))
        write_mesh("mesh.h5", cells, vertices=[*CORNERS, (0.5, 0.5)])
        message = "vertex 4 at (0.5, 0.5) m lies inside the edge with the corners"
        for ranks in (1, 2):
            self.assert_refused(self.deck, "mesh.h5", message, "does not conform", ranks=ranks)
        tool = subprocess.run([mesh_files.MESH_TOOL, "info", "mesh.h5"], capture_output=True,
                              text=True)
        self.assertEqual(tool.returncode, 2)
        self.assertIn(message, tool.stderr)

    def test_a_moved_vertex(self):
        """Where no cell turns over it is another mesh, and as good as any."""
        cells = ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))
        for place in ((0.5, 0.5), (0.51, 0.48), (0.999, 0.5)):
            write_mesh("mesh.h5", cells, vertices=[*CORNERS, place])
            self.assert_done(*self.deck, "--output", f"results_{place[0]}")
        for place, cell in (((1.5, 0.5), 1), ((0.5, -30), 0)):
            write_mesh("mesh.h5", cells, vertices=[*CORNERS, place])
            for ranks in (1, 2):
                self.assert_refused(self.deck, "mesh.h5", f"cell {cell} ", "is inverted",
                                    ranks=ranks)
        write_mesh("mesh.h5", cells, vertices=[*CORNERS, (1, 0.5)])
        self.assert_refused(self.deck, "mesh.h5", "cell 1 ", "is degenerate")
        self.assert_moved_corners(cells)

    def assert_moved_corners(self, cells):
        far, inside = CORNERS.copy(), CORNERS.copy()
        far[2], inside[2] = (3, 2), (0.2, 0.3)
        write_mesh("mesh.h5", cells, vertices=[*far, (0.5, 0.5)])
        self.assert_done(*self.deck, "--output", "results_far")
        write_mesh("mesh.h5", cells, vertices=[*inside, (0.5, 0.5)])
        self.assert_refused(self.deck, "mesh.h5", "cell 1 ", "is inverted")

    def test_broken_numbers(self):
        write_mesh("mesh.h5", cells=((0, 1, 2), (0, 2, 9)))
        self.assert_refused(self.deck, "mesh.h5", "cell 1", "9")
        vertices = CORNERS.copy()
        vertices[1, 0] = numpy.nan
        write_mesh("mesh.h5", vertices=vertices)
        self.assert_refused(self.deck, "mesh.h5", "vertex 1")

    def test_damaged_files(self):
        self.assert_refused(self.deck, "mesh.h5", "not exist")
        write_mesh("mesh.h5")
        content = pathlib.Path("mesh.h5").read_bytes()
        for name, damaged in (("truncated", content[:len(content) // 2]), ("text", b"mine")):
            with self.subTest(name):
                pathlib.Path("mesh.h5").write_bytes(damaged)
                self.assert_refused(self.deck, "mesh.h5")
                self.assert_refused(self.deck, "mesh.h5", ranks=2)


class Faults(Case):
    """Inside the body; conditions on them come later."""

    def refuse(self, pieces, **faults):
        changes = [f"Mesh/Faults/{name}={condition}" for name, condition in faults.items()]
        for ranks in (1, 2):
            with self.subTest(faults, ranks=ranks):
                self.assert_refused([DECK, *settings(*changes)], *pieces, ranks=ranks)

    def test_a_fault_that_is_not_along_the_cells(self):
        self.refuse(["Asperity / Mesh / Faults / main: the fault has no facet"],
                    main="abs(x - 0.3) < 1e-6")
        self.refuse(["Asperity / Mesh / Faults / main: the fault has no facet"],
                    main="abs(y - 0.5 - 0.2 * (x - 0.5)) < 1e-6")

    def test_three_faults_that_cross(self):
        self.refuse(["Asperity / Mesh: faults 'dyke', 'main' and 'third' cross at (0.5, 0.5)"],
                    dyke="abs(x - 0.5) < 1e-6", main="abs(y - 0.5) < 1e-6",
                    third="abs(x - y) < 1e-6")

    def test_a_fault_without_a_node_that_slips(self):
        self.refuse(["Asperity / Mesh: fault 'main' has no node that could slip; refine the mesh"],
                    main="abs(y - 0.5) < 1e-6 && x > 0.2 && x < 0.6")

    def test_names(self):
        self.refuse(["Asperity / Mesh / Faults / top: a boundary on the surface"],
                    top="abs(y - 0.5) < 1e-6")
        self.refuse(["Asperity / Mesh / Faults / main depends on t"], main="y > t")


class Failures(Case):
    """What fails in mid-run leaves a checkpoint, on every number of ranks."""

    STRESS = "Friction/Normal Stress=x > 0.5 && t > 0.25 ? sqrt(0 - 1) : 1e4"

    def fail_in_mid_run(self, *arguments, ranks):
        result = asperity_run.run(DECK, *settings(self.STRESS), *arguments, "--output", "out",
                                  ranks=ranks)
        runs.assert_one_message(self, result, runs.INPUT, "Asperity / Friction / Normal Stress",
                                "t = 0.3")
        self.assertIn("Stopped at t = 0.2", pathlib.Path("out/run.log").read_text())
        self.assertEqual(len(asperity_run.table("out/steps.csv")), 2)

    def test_an_expression_that_becomes_no_number(self):
        for ranks in (1, 2):
            with self.subTest(ranks):
                shutil.rmtree("out", ignore_errors=True)
                self.fail_in_mid_run(ranks=ranks)
                self.fail_in_mid_run("--restart", "out/checkpoint.h5", ranks=ranks)


class Physics(Case):
    def test_z_in_the_plane(self):
        """It would be 0 everywhere."""
        for change, path in (("Friction/a=0.015 + 1e-3 * min(1, abs(z))", "Friction / a"),
                             ("Bulk/Density=z < -1 ? 2e3 : 1e3", "Bulk / Density"),
                             ("Mesh/Boundaries/base=z < 1e-6", "Mesh / Boundaries / base"),
                             ("Boundary Conditions/Drive/Velocity=mean(z)",
                              "Boundary Conditions / Drive / Velocity")):
            self.assert_setting_refused(change, f"Asperity / {path} = ", "depends on z, but a mesh "
                                        "in the plane has x and y")
        self.assert_setting_refused({"Names/depth": "-z", "Friction/b": "depth < 1 ? 0.01 : 0"},
                                    "Asperity / Friction / b = '(-z) < 1 ? 0.01 : 0'")
        self.assert_done(DECK, *settings("Bulk/Shear Viscosity=x - x + 1"), "--validate")

    def test_contradicting_conditions(self):
        side = '"Boundary" type="string" value="left"/>'
        self.assert_deck_refused(TEXT.replace(side, side.replace("left", "bottom")),
                                 "Asperity / Boundary Conditions / Side", "contradicts",
                                 "Asperity / Boundary Conditions / Fault", "'bottom'")
        # Two velocities in one direction, at the corner that two boundaries share.
        condition = TEXT[TEXT.index('    <ParameterList name="Side">'):]
        condition = condition[:condition.index("</ParameterList>")]
        changed = (condition.replace("Free Surface", "Prescribed Velocity") +
                   '  <Parameter name="Velocity" type="double" value="3e-6"/>\n    ')
        self.assert_deck_refused(TEXT.replace(condition, changed),
                                 "Asperity / Boundary Conditions / Side", "contradicts",
                                 "Asperity / Boundary Conditions / Drive")

    def test_a_fault_whose_motion_is_prescribed(self):
        for ranks in (1, 2):
            self.assert_setting_refused("Boundary Conditions/Drive/Boundary=bottom",
                                        "Asperity / Boundary Conditions / Drive",
                                        "prescribes the velocity along the fault 'bottom'",
                                        "Prescribed Slip Rate", ranks=ranks)

    def test_a_body_that_may_move_freely(self):
        """Whatever solver would meet it: without inertia nothing stops y, or turns."""
        massless = ("Bulk/Dynamics=Quasi-dynamic", "Time Stepping/Scheme=Backward Euler",
                    "Boundary Conditions/Fault/Type=Antisymmetric Fault")
        for correction in ("Direct", "Multigrid"):
            with self.subTest(correction):
                self.assert_refused(
                    [DECK, *settings(*massless, f"TNNMG/Linear Correction={correction}")],
                    "Asperity / Boundary Conditions", "moves along y", "Sliding Wall")

    def test_a_scheme_that_needs_mass(self):
        """Also where the deck names what the default would be with inertia."""
        self.assert_refused([DECK, *settings("Bulk/Dynamics=Quasi-dynamic",
                                             "Time Stepping/Scheme=Newmark")],
                            "Asperity / Time Stepping / Scheme", "'Newmark' needs inertia")

    def test_questionable_units(self):
        for change, topic in (("Bulk/Density=1", "Bulk / Density is 1 kg/m^3"),
                              ("Bulk/Shear Modulus=32", "The shear modulus is 32 Pa"),
                              ("Friction/Normal Stress=0.05", "normal stress at the start, 0.05"),
                              ("Friction/Reference Friction Coefficient=35",
                               "Reference Friction Coefficient is 35 or more")):
            with self.subTest(change):
                result = asperity_run.run(DECK, *settings(change), "--validate")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn("WARNING: ", result.stdout)
                self.assertIn(topic, result.stdout)
        for modulus, is_asked in (("32e3", True), ("8e4", False)):
            rock = settings("Bulk/Density=2700", f"Bulk/Shear Modulus={modulus}")
            result = asperity_run.run(DECK, *rock, "--validate")
            self.assertEqual("Shear waves travel" in result.stdout, is_asked, result.stdout)
        result = asperity_run.run(DECK, "--validate")
        self.assertIn("c_s = 31.6228 m/s", result.stdout)
        self.assertNotIn("WARNING", result.stdout)
        self.assert_setting_refused("Coupling/Tolerance=10", "Asperity / Coupling / Tolerance",
                                    "[0, 1)")

    def test_no_fault(self):
        self.assert_setting_refused("Boundary Conditions/Fault/Type=Fixed",
                                    "Asperity / Boundary Conditions", "Bilateral Contact")

    def test_solvers_that_cannot_be(self):
        self.assert_setting_refused("TNNMG/Linear Correction=Direct",
                                    "Asperity / TNNMG / Linear Correction = Direct", ranks=2)

    def test_time(self):
        self.assert_setting_refused("Time Stepping/Newmark/beta=0.2",
                                    "Asperity / Time Stepping / Newmark / beta = 0.2",
                                    "Stability Limit")
        self.assert_refused([DECK, "--remove", "Time Stepping/Largest Step"],
                            "Asperity / Time Stepping / Largest Step is missing")
        self.assert_setting_refused("Time Stepping/Smallest Step=1",
                                    "Asperity / Time Stepping / Smallest Step = 1")
        self.assert_setting_refused("Time Stepping/Prescribed/Levels={0, 40}",
                                    "Asperity / Time Stepping / Prescribed / Levels")

    def test_moduli(self):
        self.assert_setting_refused("Bulk/Bulk Modulus=1e6", "Asperity / Bulk", "exactly two")


if __name__ == "__main__":
    unittest.main()
