"""What quickstart.sh asks of the system, with stand-ins for apt-get, cmake and our own programs."""

import os
import pathlib
import shutil
import subprocess
import unittest

QUICKSTART = pathlib.Path(__file__).resolve().parents[3] / "cmake" / "quickstart.sh"
CALLS = pathlib.Path("calls.txt").absolute()

# Each one notes its name and its arguments.
STAND_IN = f"""#!/bin/sh
printf '%s\\n' "${{0##*/}} $*" >> "{CALLS}"
"""

# As apt-cache of a release that has all packages but those in `lacking`.
APT_CACHE = """#!/bin/sh
shift
for name; do
  case " {lacking} " in *" $name "*) ;; *)
    case $name in libtrilinos-epet*) version={epetra} ;; *) version=17.0-1 ;; esac
    printf '%s:\\n  Installed: (none)\\n  Candidate: %s\\n' "$name" "$version" ;;
  esac
done
"""


class QuickStart(unittest.TestCase):
    def setUp(self):
        shutil.rmtree("system", ignore_errors=True)
        self.system = pathlib.Path("system").absolute()
        self.system.mkdir()
        for name in ("apt-get", "dpkg-query", "cmake", "ctest", "ninja"):
            self.stand_in(self.system / name)
        self.stand_in(self.system / "sudo", '#!/bin/sh\nexec "$@"\n')
        for name in ("asperity", "asperity-plot"):
            self.stand_in(self.system / "build" / "drivers" / name)
        self.release_without()

    def release_without(self, *names, epetra="17.0-1"):
        self.stand_in(self.system / "apt-cache",
                      APT_CACHE.format(lacking=" ".join(names), epetra=epetra))

    @staticmethod
    def stand_in(path, text=STAND_IN):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)

    def run_with(self, *words, status=0, script=QUICKSTART, **environment):
        """What is printed, and the calls."""
        CALLS.write_text("")
        own = {name: value for name, value in os.environ.items()
               if name not in ("Trilinos_ROOT", "Trilinos_DIR", "CMAKE_PREFIX_PATH")}
        own.update(environment, PATH=f"{self.system}:{os.environ['PATH']}")
        done = subprocess.run(["bash", str(script), *words, "--build",
                               str(self.system / "build")], env=own, capture_output=True,
                              text=True, check=False, timeout=60)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr, CALLS.read_text().splitlines()

    @staticmethod
    def programs(calls):
        return [call.split()[0] for call in calls]

    @staticmethod
    def installs(calls):
        """The packages that apt-get is told to install."""
        words = next(call for call in calls if " install -y " in call).split()
        return words[words.index("--no-install-recommends") + 1:]

    def test_a_mode_installs_what_it_needs(self):
        _, calls = self.run_with("run")
        for_run = self.installs(calls)
        self.assertIn("libgmsh-dev", for_run)
        for package in for_run:
            self.assertNotRegex(package, "clang-format|gtest|ccache|pip|venv|setuptools|wheel|"
                                         "sphinx|chromium")
        _, calls = self.run_with("test")
        more = set(self.installs(calls)) - set(for_run)
        self.assertEqual(more, {"clang-format-14", "libgtest-dev", "ccache", "python3-pip",
                                "libproj-dev",
                                "python3-venv", "python3-setuptools", "python3-wheel",
                                "python3-sphinx", "python3-myst-parser", "python3-breathe", "furo",
                                "doxygen", "chromium", "libproj-dev", "libcgal-dev"})

    def test_run_builds_no_tests(self):
        _, calls = self.run_with("run", "--no-install")
        self.assertIn("-DASPERITY_ENABLE_TESTS=OFF", calls[0])
        (self.system / "build" / "CMakeCache.txt").touch()
        _, calls = self.run_with("run", "--no-install")
        self.assertNotIn("ASPERITY_ENABLE_TESTS", calls[0])

    def test_a_release_without_clang_format_14(self):
        self.release_without("clang-format-14", "python3-wheel")
        printed, calls = self.run_with("test")
        self.assertNotIn("clang-format", printed)
        self.assertNotRegex(" ".join(self.installs(calls)), r"clang-format|python3-wheel|[|]| - ")
        self.assertIn("libgtest-dev", self.installs(calls))

    def test_a_release_without_epetra(self):
        """As with Trilinos 17, also beside another release that has Epetra of Trilinos 16."""
        for lacking, version in (["libtrilinos-epetra-dev", "libtrilinos-epetraext-dev"],
                                 "17.0-1"), ([], "16.1-5"):
            self.release_without(*lacking, epetra=version)
            names = self.installs(self.run_with("run")[1])
            self.assertNotIn("epetra", " ".join(names))
            self.assertIn("libtrilinos-tpetra-dev", names)

    def test_a_fallback_has_the_other_name(self):
        script = self.system / "other" / "cmake" / "quickstart.sh"
        script.parent.mkdir(parents=True)
        for path in QUICKSTART.parent.glob("quickstart*.sh"):
            text = path.read_text().replace("libcli11-dev", "libcli11-dev|libcli12-dev")
            (script.parent / path.name).write_text(text)
        for lacking, found in (("libcli11-dev", "libcli12-dev"), ("libcli12-dev", "libcli11-dev")):
            self.release_without(lacking)
            names = self.installs(self.run_with("run", script=script)[1])
            self.assertIn(found, names)
            self.assertNotIn(lacking, names)

    def test_a_release_without_what_is_needed(self):
        self.release_without("libmuparser-dev", "libgmsh-dev")
        printed, calls = self.run_with("run", status=1)
        self.assertRegex(printed, "this release does not have these packages, which the build "
                         "needs:\n *expressions in decks: libmuparser-dev\n")
        self.assertNotIn("cmake", self.programs(calls))
        self.assertFalse([call for call in calls if " install " in call])

    def test_lists_that_were_never_fetched(self):
        """Then names stand for themselves, and apt-get says what it does not find."""
        self.stand_in(self.system / "apt-cache", "#!/bin/sh\n")
        names = self.installs(self.run_with("test")[1])
        self.assertIn("clang-format-14", names)
        self.assertNotIn("|", " ".join(names))

    def test_installs_what_is_missing(self):
        printed, calls = self.run_with("run", "--jobs", "3", "--output", "here")
        installs = [call for call in calls if " install -y " in call]
        self.assertEqual(len(installs), 1)
        for package in ("g++", "libtrilinos-muelu-dev", "libhdf5-openmpi-dev", "python3-h5py"):
            self.assertIn(f" {package} ", installs[0] + " ")
            self.assertIn(package, printed)
        self.assertEqual(self.programs(calls)[-4:], ["cmake", "cmake", "asperity", "asperity-plot"])
        self.assertIn("--parallel 3 --target asperity-programs", calls[-3])
        self.assertEqual(calls[-2].split(), [
            "asperity", str(QUICKSTART.parents[1] / "xml" / "wedge_2d.xml"), "--output",
            str(pathlib.Path("here").absolute()), "--overwrite"])

    def test_installs_nothing_when_told(self):
        printed, calls = self.run_with("run", "--no-install")
        self.assertEqual(self.programs(calls), ["cmake", "cmake", "asperity", "asperity-plot"])
        self.assertIn("No package is installed, because of --no-install.", printed)

    def test_installs_nothing_that_is_there(self):
        names = self.installs(self.run_with("run")[1])
        listing = "".join(f"echo 'installed {name}'\n" for name in names)
        self.stand_in(self.system / "dpkg-query", STAND_IN + listing)
        printed, calls = self.run_with("run")
        self.assertNotIn("apt-get", self.programs(calls))
        self.assertIn("All packages are installed.", printed)

    def test_does_without_trilinos_of_debian(self):
        cmake_file = self.system / "own" / "lib" / "cmake" / "Trilinos" / "TrilinosConfig.cmake"
        cmake_file.parent.mkdir(parents=True)
        cmake_file.touch()
        _, calls = self.run_with("run", Trilinos_ROOT=str(self.system / "own"))
        install = next(call for call in calls if " install -y " in call)
        self.assertNotIn("libtrilinos", install)
        self.assertIn(" libmetis-dev ", install)

    def test_a_failing_apt_is_reported(self):
        self.stand_in(self.system / "apt-get", STAND_IN + "echo 'E: no such thing'\nexit 100\n")
        printed, calls = self.run_with("run", status=1)
        self.assertIn("E: no such thing", printed)
        self.assertIn("apt-get could not install the packages", printed)
        self.assertNotIn("cmake", self.programs(calls))

    def test_runs_the_suite(self):
        _, calls = self.run_with("test", "--no-install")
        self.assertEqual(self.programs(calls), ["cmake", "cmake", "ctest"])
        self.assertIn("-DASPERITY_ENABLE_TESTS=ON", calls[0])
        self.assertIn("--label-exclude ^benchmark$", calls[2])

    def test_strict_has_a_second_build(self):
        _, calls = self.run_with("test", "--no-install", "--strict")
        self.assertEqual(self.programs(calls), ["cmake"] * 4 + ["ctest"] * 2)
        self.assertIn("-DASPERITY_WARNINGS_AS_ERRORS=ON", calls[0])
        self.assertIn("--preset debug", calls[2])

    def test_refuses_what_it_does_not_know(self):
        for words, piece in ((["run", "--jobs", "0"], "--jobs 0 is not a positive number"),
                             (["run", "--strict"], "--strict belongs to `test`"),
                             (["run", "--fast"], "unknown argument '--fast'")):
            printed, calls = self.run_with(*words, status=1)
            self.assertIn(piece, printed)
            self.assertEqual(calls, [])


if __name__ == "__main__":
    unittest.main()
