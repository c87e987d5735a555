"""What is wrong with a result is said once on standard error, with exit status 2."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import h5py

import synthetic_run
from asperity_plot import cli
from asperity_plot.figures import FIGURES
from folders import SharedFolderCase, told


class BadInput(SharedFolderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        synthetic_run.write_run(cls.folder / "sound", 2, nodes=20)

    def setUp(self):
        shared = self.folder
        self.folder = shared / self.id().rsplit(".", maxsplit=1)[-1] / "run"
        shutil.copytree(shared / "sound", self.folder)

    def plot(self, *arguments: str):
        """Exit status, standard output and error."""
        return told(cli.main, *arguments, "--dpi", "40")

    def expect(self, *words: str, figures: str = "", folder: Path = None) -> None:
        """One message with `words`, and exit status 2."""
        arguments = ["--figures", figures] if figures else []
        status, _, err = self.plot(str(folder or self.folder), *arguments)
        self.assertEqual(status, 2, err)
        self.assertEqual(err.count("asperity-plot: "), 1, err)
        for word in words:
            self.assertIn(word, err)

    def start(self, *arguments: str, module: str = "asperity_plot",
              **environment: str) -> subprocess.CompletedProcess:
        """A program in a process of its own."""
        return subprocess.run([sys.executable, "-m", module, *arguments], text=True,
                              capture_output=True, env={**os.environ, **environment}, check=False)

    def expect_one_line(self, result: subprocess.CompletedProcess, *words: str) -> None:
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def expect_of_report(self, *words: str) -> None:
        (self.folder / "run.log").write_text("Asperity 0.1.0 on Serial, 1 rank.\n")
        self.expect_one_line(self.start(str(self.folder), module="asperity_report"),
                             "asperity-report: ", *words)

    def test_help_says_what_each_figure_needs(self):
        text = " ".join(self.start("--help").stdout.split())
        for name, (meaning, file) in FIGURES.items():
            self.assertIn(f"{name} {meaning} [{file}]", text)

    def test_no_such_directory(self):
        self.expect("/nowhere/at/all", "not a directory", folder=Path("/nowhere/at/all"))

    def test_no_result_in_it(self):
        self.expect("holds no result", folder=self.folder.parent)

    def test_damaged_history(self):
        data = (self.folder / "fault.h5").read_bytes()
        (self.folder / "fault.h5").write_bytes(data[:600])
        self.expect("fault.h5", "cannot be opened", figures="slip_rate,slip")

    def test_a_history_of_very_many_rows(self):
        with h5py.File(self.folder / "fault.h5", "a") as file:
            del file["time"]
            file.create_dataset("time", shape=(2**40,), chunks=(1024,), dtype="f8")
        words = ("fault.h5", "'/time' has 1.1e+12 numbers", "damaged")
        self.expect(*words, figures="slip_rate")
        self.expect_of_report(*words)

    def test_links_in_a_loop(self):
        with h5py.File(self.folder / "fault.h5", "a") as file:
            del file["time"]
            file["time"], file["other"] = h5py.SoftLink("/other"), h5py.SoftLink("/time")
        self.expect("fault.h5", "'time' cannot be opened", figures="slip_rate")
        self.expect_of_report("fault.h5", "'time' cannot be opened", "damaged")

    def test_a_name_that_is_not_utf8(self):
        folder = os.fsdecode(os.fsencode(self.folder.parent) + b"/caf\xe9")
        shutil.move(self.folder, folder)
        self.expect("caf\\udce9", "not UTF-8", folder=Path(folder))
        for module in ("asperity_plot", "asperity_report"):
            self.expect_one_line(self.start(folder, module=module))

    def test_damaged_segment(self):
        path = self.folder / "segments" / "surface_000001.h5"
        path.write_bytes(path.read_bytes()[:600])
        self.expect("surface_000001.h5", figures="surface")

    def test_missing_field_spares_the_other_figures(self):
        with h5py.File(self.folder / "fault.h5", "a") as file:
            del file["fields/slip"]
        self.expect("no dataset 'fields/slip'", "slip_rate", figures="slip,energy")
        self.assertTrue((self.folder / "figures" / "energy.png").exists())

    def test_damaged_table(self):
        with open(self.folder / "steps.csv", "a", encoding="utf-8") as file:
            file.write("17,not a number\n")
        self.expect("steps.csv is damaged", figures="iterations,energy")

    def test_missing_column(self):
        text = (self.folder / "steps.csv").read_text()
        (self.folder / "steps.csv").write_text(text.replace("fixed_point_iterations", "sweeps"))
        self.expect("no column 'fixed_point_iterations'", figures="iterations")

    def test_empty_and_cut_files_of_a_full_disk(self):
        """What there is is drawn, and why the run failed is said."""
        (self.folder / "run.log").write_text("The run has ended: no space. Is the disk full?\n")
        (self.folder / "events.csv").write_text("")
        (self.folder / "surface.h5").write_bytes(b"")
        (self.folder / "steps.csv").write_text("step,time [s],step_si")
        status, out, err = self.plot(str(self.folder))
        self.assertEqual((status, err), (0, ""))
        self.assertIn("The run has failed: no space. Is the disk full?", out)
        for words in ("'events': events.csv is empty", "'surface': surface.h5 is empty",
                      "'energy': steps.csv has no complete line"):
            self.assertIn(words, out)
        self.assertTrue((self.folder / "figures" / "slip_rate.png").exists())

    def test_damaged_events_spare_the_figures_that_need_none(self):
        with open(self.folder / "events.csv", "a", encoding="utf-8") as file:
            file.write("17,not a number\n")
        self.expect("events.csv is damaged", figures="slip_rate")
        self.assertTrue((self.folder / "figures" / "slip_rate.png").exists())

    def test_damaged_parameters(self):
        (self.folder / "parameters.xml").write_text("<ParameterList")
        self.expect("parameters.xml cannot be read as XML", figures="slip_rate")

    def test_output_that_cannot_be_made(self):
        folder = self.folder / "steps.csv" / "figures"
        status, _, err = self.plot(str(self.folder), "--output", str(folder))
        self.assertEqual(status, 2)
        self.assertIn("Choose another place with --output", err)

    def test_dots_out_of_range(self):
        status, _, err = told(cli.main, self.folder, "--dpi", "5")
        self.assertEqual(status, 2)
        self.assertIn("--dpi 5 is outside [30, 1200]", err)

    def test_file_asked_for_but_absent(self):
        (self.folder / "surface.h5").unlink()
        self.expect("surface.h5 does not exist", figures="surface")

    def test_result_files_of_receivers_and_ruptures(self):
        for figure, name in (("receivers", "receivers.h5"), ("rupture_times", "rupture.h5"),
                             ("moment_rate", "global.csv")):
            self.expect(f"{name} does not exist. Is this output enabled", figures=figure)
            (self.folder / name).write_bytes(b"no such thing")
            self.expect(name, figures=figure)

    def test_receivers_of_another_length(self):
        with h5py.File(self.folder / "receivers.h5", "w") as file:
            file["time"] = [0.0, 1.0]
            file["on_fault/names"] = ["one", "two"]
            file["on_fault/fields/slip"] = [[0.0], [1.0]]
        self.expect("'on_fault/fields/slip' has shape (2, 1), expected (2, 2)",
                    figures="receivers")

    def test_intervals_that_are_none(self):
        status, _, err = self.plot(str(self.folder), "--every", "5yr", "0s")
        self.assertEqual(status, 2)
        self.assertIn("--every needs two times above 0", err)

    def test_file_not_asked_for_and_absent(self):
        for name in ("fault.h5", "surface.h5", "steps.csv"):
            (self.folder / name).unlink()
        self.expect("holds no time step yet")

    def test_tables_alone_have_their_figures(self):
        for name in ("fault.h5", "surface.h5"):
            (self.folder / name).unlink()
        status, out, err = self.plot(str(self.folder))
        self.assertEqual((status, err), (0, ""))
        self.assertIn("No figure 'surface': the run has no surface.h5.", out)
        self.assertTrue((self.folder / "figures" / "iterations.png").exists())

    def test_unknown_figure(self):
        result = self.start(str(self.folder), "--figures", "slip_rat")
        self.assertEqual(result.returncode, 2)
        self.assertIn("no figure 'slip_rat'; the figures are slip_rate, surface", result.stderr)

    def test_words_for_numbers(self):
        for option, words in ((("--window", "now", "5yr"), "'now' is no time"),
                              (("--every", "5yr", "1x"), "'1x' is no time"),
                              (("--at", "5km"), "'5km' is no list of lengths")):
            result = self.start(str(self.folder), *option)
            self.assertEqual(result.returncode, 2)
            self.assertIn(words, result.stderr)

    def path_without(self, module: str) -> str:
        """A PYTHONPATH on which `module` cannot be imported."""
        broken = self.folder / "modules" / f"{module}.py"
        broken.parent.mkdir(exist_ok=True)
        broken.write_text(f"raise ModuleNotFoundError('not here', name='{module}')\n")
        return os.pathsep.join([str(broken.parent), os.environ["PYTHONPATH"]])

    def test_missing_modules(self):
        result = self.start(str(self.folder), PYTHONPATH=self.path_without("h5py"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("has no module h5py", result.stderr)
        self.assertIn("apt-get install python3-numpy python3-h5py", result.stderr)
        self.assertNotIn("Traceback", result.stderr)

    def test_missing_numpy(self):
        path = self.path_without("numpy")
        for program in ("plot", "status", "report", "study"):
            result = self.start(str(self.folder), module=f"asperity_{program}", PYTHONPATH=path)
            self.expect_one_line(result, f"asperity-{program}: ", sys.executable,
                                 "apt-get install python3-numpy")

    def test_modules_that_the_module_misses(self):
        for module in ("numpy", "h5py"):
            path = self.path_without(module)
            for statement, status in (("asperity.__version__", 0), ("asperity.Run('.')", 1)):
                result = subprocess.run([sys.executable, "-c", f"import asperity; {statement}"],
                                        env={**os.environ, "PYTHONPATH": path}, text=True,
                                        capture_output=True, check=False)
                self.assertEqual(result.returncode, status, result.stderr)
                self.assertEqual(result.stderr.count("Traceback"), status, result.stderr)
            self.assertRegex(result.stderr.splitlines()[-1],
                             f"^ImportError: {sys.executable} has no module {module}.*"
                             "apt-get install python3-numpy python3-h5py")
            (self.folder / "modules" / f"{module}.py").unlink()
