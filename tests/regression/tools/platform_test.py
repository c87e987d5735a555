"""asperity-platform writes files of decks of benchmarks, takes them, and refuses damaged ones."""

import pathlib
import re
import shutil
import signal
import subprocess
import unittest
import zipfile

import asperity_run
import deck_meshes
import numpy
import platform_damages
import runs

PLATFORM = asperity_run.PROGRAM.with_name("asperity-platform")
XML = asperity_run.SOURCE / "xml"
# The header of each deck of a benchmark has the command.
COMMAND = re.compile(r"^  Files:      asperity-platform write DIR (\S+)(?: with (\S+) = (\S+))?$",
                     re.MULTILINE)
DECKS = {deck.stem: deck for deck in sorted(XML.glob("*.xml"))
         if COMMAND.search(deck.read_text())}
COARSE = {"Mesh/Rectangle/Cell Size Factor": 8}
IN_SPACE = {"Mesh/Box/Cell Size Factor": 4}
# Final times. On cells of 4 km slip of bp5_fd is negative in the first milliseconds, which the
# check of signs refuses: it has 16 s.
CASES = {
    "bp1_qd": (COARSE, 1e6), "bp1_fd": (COARSE, 1e6), "bp1_qd_two_sided": (COARSE, 1e6),
    "bp2_qd": (COARSE, 1e6), "bp3_qd": ({}, 1e5), "bp5_qd": (IN_SPACE, 1.0),
    "bp5_fd": (IN_SPACE, 16.0), "bp6": (COARSE, 1e6), "bp7": (IN_SPACE, 2.0),
    "bp8": (IN_SPACE, 3600.0), "tpv101_2d": (COARSE, 0.5),
    "tpv101_3d": (IN_SPACE, 0.2), "tpv101_two_sided": (COARSE, 0.5), "tpv103_2d": (COARSE, 0.5),
    "tpv104_3d": (IN_SPACE, 0.2), "tpv105_3d": (IN_SPACE, 0.2), "tpv205_3d": (IN_SPACE, 0.2),
    "tpv5_2d": (COARSE, 0.5)}


def platform(*arguments):
    result = subprocess.run([PLATFORM, *arguments], text=True, capture_output=True, check=False)
    return result.returncode, result.stdout, result.stderr


def deck_of(name, *more):
    """As arguments of the program."""
    changes, final_time = CASES[name]
    return [DECKS[name], *asperity_run.settings(
        changes, {"Time Stepping/Final Time": final_time}, *more)]


def write(name, folder, problem=None):
    """The folder of the platform's files of a run, by the command in the deck."""
    of_deck, option, value = COMMAND.search(DECKS[name].read_text()).groups()
    more = [f"--{option}", value] if option else []
    code, told, errors = platform("write", folder, problem or of_deck, *more, "--date",
                                  "2024/05/31")
    if (code, errors) != (0, ""):
        raise AssertionError(f"exit status {code}\n{told}{errors}")
    return folder / ("seas" if name.startswith("bp") else "scec")


def run(name, *more):
    """The folder of the platform's files."""
    return write(name, asperity_run.run_to_end(f"run_{name}", *deck_of(name, *more)))


def parts(path):
    """The header, the names of the fields, and the numbers."""
    lines = path.read_text().splitlines()
    return ([line for line in lines if not platform_damages.is_row(line)],
            [line for line in lines if platform_damages.is_row(line)])


class Written(unittest.TestCase):
    FREQUENT = {"Output/Checkpoint Every n Steps": 40}
    CYCLES = {**FREQUENT, "Time Stepping/Final Time": 3e9}  # some 600 steps
    RUPTURE = {**FREQUENT, "Time Stepping/Final Time": 3}

    def check(self, name, changes, wholes):
        """Of a run that is killed the files are those of its last checkpoint, and complete once it
        has gone on; `wholes` are files that are written as a whole, not row by row."""
        deck = deck_of(name, changes)
        whole = write(name, asperity_run.run_to_end(f"whole_{name}", *deck))
        folder = runs.fresh(f"killed_{name}")
        runs.stop(self, runs.begin(folder, *deck), signal.SIGKILL)
        runs.wait_for_lock(folder)
        partial = write(name, folder)
        names = sorted(path.name for path in whole.iterdir())
        self.assertEqual(sorted(path.name for path in partial.iterdir()), names)
        for each in set(names) - set(wholes):
            (_, rows), (_, all_rows) = parts(partial / each), parts(whole / each)
            self.assertEqual(rows, all_rows[:len(rows)], each)
            self.assertGreater(len(rows), 1, each)
            self.assertLess(len(rows), len(all_rows), each)
        asperity_run.go_on(folder, *deck)
        write(name, folder)
        for each in names:
            self.assertEqual((partial / each).read_bytes(), (whole / each).read_bytes(), each)

    def test_of_cycles_that_are_killed_and_go_on(self):
        self.check("bp1_qd", self.CYCLES, ["rupture.dat"])

    def test_of_a_rupture_that_is_killed_and_goes_on(self):
        self.check("tpv101_2d", self.RUPTURE, ["cplot"])

    def test_the_header_of_a_killed_run_counts_its_rows(self):
        folder = runs.fresh("killed_count")
        runs.stop(self, runs.begin(folder, *deck_of("bp1_qd", self.CYCLES)), signal.SIGKILL)
        runs.wait_for_lock(folder)
        header, rows = parts(write("bp1_qd", folder) / "fltst_dp075")
        count = next(int(line.split("=")[1]) for line in header if "num_time_steps" in line)
        self.assertEqual(count, len(rows) - 1)  # the initial state is no step
        self.assertEqual(count % 40, 0)

    def test_of_two_ranks(self):
        for name in ("bp1_qd", "tpv101_2d"):
            one, two = (write(name, asperity_run.run_to_end(
                f"{name}_{ranks}_ranks", *deck_of(name), ranks=ranks)) for ranks in (1, 2))
            names = sorted(path.name for path in one.iterdir())
            self.assertEqual(sorted(path.name for path in two.iterdir()), names)
            for each in names:
                (expected, rows), (header, of_two) = parts(one / each), parts(two / each)
                self.assertEqual(header, expected, each)
                values, found = (numpy.array([line.split() for line in lines], dtype=float)
                                 for lines in (rows, of_two))
                numpy.testing.assert_allclose(found, values, rtol=1e-5, atol=1e-6, err_msg=each)


class Accepted(unittest.TestCase):
    def test_every_deck_of_a_benchmark_is_tried(self):
        self.assertEqual(sorted(CASES), sorted(DECKS))

    def test_files_of_decks(self):
        for name in CASES:
            with self.subTest(name):
                if name == "bp3_qd":
                    if not asperity_run.PROGRAM.with_name("asperity-mesh").exists():
                        continue
                    deck_meshes.make_meshes(DECKS[name], "--set", "h=2000")
                code, told, errors = platform("check", run(name))
                self.assertEqual((code, errors), (0, ""), told)
                self.assertIn(": accepted.\n", told)

    def test_thermal_pressurisation_as_in_tpv105(self):
        heat = "Friction/Thermal Pressurisation"
        folder = asperity_run.run_to_end("run_hot", *deck_of("tpv103_2d", {
            f"{heat}/Enabled": "true"}))
        folder = write("tpv103_2d", folder, "TPV105")
        station = platform_damages.read(folder, "faultst000")
        names = next(line for line in station if line.startswith("t "))
        self.assertEqual(names.split()[-3:], ["psi", "temperature", "pressure"])
        for path in folder.iterdir():  # at places of the platform's
            if path.name.startswith(("fault", "body")):
                path.rename(path.with_name(path.name + "dp075"))
        told = platform("check", folder)[1]
        self.assertIn("faultst180dp075: is missing.", told)
        self.assertNotIn("line", told)

    def test_a_rupture_may_come_after_centuries(self):
        folder = run("bp1_qd")
        platform_damages.rows("rupture.dat", platform_damages.word(0, 2, "6.18E+09"))(folder)
        code, told, _ = platform("check", folder)
        self.assertEqual(code, 0, told)


class Refused(unittest.TestCase):
    def check(self, good, damages):
        code, before, _ = platform("check", good)
        self.assertEqual(code, 0, before)
        for what, (damage, message) in damages.items():
            with self.subTest(what):
                folder = pathlib.Path("damaged")
                shutil.rmtree(folder, ignore_errors=True)
                shutil.copytree(good, folder)
                damage(folder)
                code, told, errors = platform("check", folder)
                self.assertEqual((code, errors), (1, ""), told)
                self.assertIn(message, told)
                self.assertIn(": refused.\n", told)
                new = set(told.splitlines()) - set(before.splitlines())
                self.assertLessEqual(len(new), 3, told)  # a second file at most, and the verdict

    def test_damaged_files_for_seas(self):
        self.assertGreaterEqual(len(platform_damages.SEAS), 20)
        self.check(run("bp1_qd"), platform_damages.SEAS)

    def test_damaged_files_for_scec(self):
        self.check(run("tpv101_3d"), platform_damages.SCEC)


class Archive(unittest.TestCase):
    def test_has_what_the_platform_takes(self):
        folder, archive = run("bp5_qd"), pathlib.Path("bp5.zip")
        archive.unlink(missing_ok=True)
        code, told, _ = platform("zip", folder.parent, archive)  # that of the run will do
        self.assertEqual(code, 0, told)
        self.assertIn("fltst_strk-24dp+00: BP5-QD has no such station", told)
        with zipfile.ZipFile(archive) as file:
            self.assertIsNone(file.testzip())
            names = sorted(path.name for path in folder.iterdir())
            names.remove("fltst_strk-24dp+00")
            self.assertEqual(sorted(file.namelist()), names)
            self.assertEqual(file.read("global.dat"), (folder / "global.dat").read_bytes())
        self.assertEqual(platform("zip", folder, archive)[0], 2)
        (folder / "global.dat").unlink()
        self.assertEqual(platform("zip", folder, "never.zip")[0], 1)
        self.assertFalse(pathlib.Path("never.zip").exists())

    def test_files_of_an_earlier_state_of_the_run(self):
        folder = run("bp1_qd").parent
        self.assertEqual(platform("check", folder)[2], "")
        (folder / "run.jsonl").touch()
        code, _, errors = platform("check", folder)
        self.assertEqual(code, 0)
        self.assertIn("has gone on since these files were written", errors)

    def test_wrong_use(self):
        pathlib.Path("nothing").mkdir(exist_ok=True)
        for arguments in ((), ("write", "nothing"), ("write", "nothing", "BP1-QD"),
                          ("check",), ("check", "nowhere"), ("check", "nothing"),
                          ("check", "nothing", "a.zip"), ("zip", "nothing"), ("pack", "nothing")):
            code, told, errors = platform(*arguments)
            self.assertEqual((code, told), (2, ""), arguments)
            self.assertTrue(errors.splitlines()[-1].startswith("asperity-platform"), errors)


if __name__ == "__main__":
    unittest.main()
