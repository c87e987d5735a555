"""asperity-platform takes what the decks of benchmarks write, and refuses damaged folders."""

import pathlib
import shutil
import subprocess
import unittest
import zipfile

import asperity_run
import deck_meshes
import platform_damages

PLATFORM = asperity_run.PROGRAM.with_name("asperity-platform")
XML = asperity_run.SOURCE / "xml"
DECKS = {deck.stem: deck for deck in sorted(XML.glob("*.xml"))
         if 'name="Text Format"' in deck.read_text()}
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


def run(name, *more):
    """The folder of the platform's files."""
    changes, final_time = CASES[name]
    kind = "SEAS" if name.startswith("bp") else "SCEC"
    folder = asperity_run.run_to_end(f"run_{name}", DECKS[name], *asperity_run.settings(
        changes, {"Time Stepping/Final Time": final_time,
                  f"Output/{kind}/Date": "2024/05/31"}, *more))
    return folder / kind.lower()


class Accepted(unittest.TestCase):
    def test_every_deck_with_a_text_format_is_tried(self):
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
        folder = run("tpv103_2d", {f"{heat}/Enabled": "true", "Output/SCEC/Problem": "TPV105"})
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

    def test_wrong_use(self):
        pathlib.Path("nothing").mkdir(exist_ok=True)
        for arguments in (("check",), ("check", "nowhere"), ("check", "nothing"),
                          ("check", "nothing", "a.zip"), ("zip", "nothing"), ("pack", "nothing")):
            code, told, errors = platform(*arguments)
            self.assertEqual((code, told), (2, ""), arguments)
            self.assertTrue(errors.splitlines()[-1].startswith("asperity-platform: "), errors)


if __name__ == "__main__":
    unittest.main()
