"""asperity-study with the program: side by side, killed and continued, stopped and gone on with."""

import csv
import functools
import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

import asperity_run
import time_limits

STUDY = asperity_run.PROGRAM.with_name("asperity-study")
SLIDER = asperity_run.SOURCE / "examples" / "study" / "slider.xml"
TEXT = """<ParameterList name="Asperity Study">
  <Parameter name="Deck" type="string" value="{deck}"/>
  <Parameter name="Sampling" type="string" value="List"/>
  <ParameterList name="Settings">
    <Parameter name="Time Stepping/Final Time" value="{final}"/>
    <Parameter name="Output/Checkpoint Every n Steps" value="200"/>
  </ParameterList>
  <ParameterList name="Variables">
    <ParameterList name="b">
      <Parameter name="Parameters" value="{parameter}"/>
      <Parameter name="Values" value="{{0.015, 0.0155}}"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
"""
PATIENCE = time_limits.seconds(60)  # [s]


def write(name, final="3000", parameter="Friction/b"):
    path = pathlib.Path(f"{name}.xml")
    deck = asperity_run.SOURCE / "xml" / "spring_slider.xml"
    path.write_text(TEXT.format(deck=deck, final=final, parameter=parameter))
    shutil.rmtree(name, ignore_errors=True)
    return path


def command(study, name, *options):
    return [str(STUDY), str(study), "--output", name, "--cores", "2", *options]


def call(study, name, *options):
    return subprocess.run(command(study, name, *options), text=True, capture_output=True,
                          check=False)


def rows(name):
    with open(pathlib.Path(name) / "results.csv", newline="") as file:
        return list(csv.DictReader(file))


def rows_of_steps(path):
    return path.read_bytes().count(b"\n") if path.exists() else 0


class Study(unittest.TestCase):
    def test_a_grid(self):
        shutil.rmtree("grid", ignore_errors=True)
        result = call(SLIDER, "grid")
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        table = rows("grid")
        self.assertEqual([(row["state law"], row["shear modulus [Pa]"]) for row in table],
                         [(law, size) for law in ("Ageing", "Slip")
                          for size in ("500000000.0", "5000000000.0")])
        for row in table:
            soft = row["shear modulus [Pa]"] == "500000000.0"
            self.assertEqual(int(row["events"]) > 0, soft, row)
            events = asperity_run.table(f"grid/runs/{int(row['run']):04d}/events.csv")
            self.assertEqual(len(events), int(row["events"]))
            self.assertEqual(row["state"], "finished")
            self.assertGreater(float(row["wall_time [s]"]), 0)
        for name in ("study.png", "results.h5"):
            self.assertGreater((pathlib.Path("grid") / name).stat().st_size, 1000)
        before = asperity_run.checksums("grid/runs")
        again = call(SLIDER, "grid")
        self.assertEqual(again.returncode, 0)
        self.assertNotIn("started", again.stdout)
        self.assertEqual(asperity_run.checksums("grid/runs"), before)

    def wait_for(self, path, number, process):
        begin = time.time()
        checkpoint = path.with_name("checkpoint.h5")
        while rows_of_steps(path) < number or not checkpoint.exists():
            self.assertIsNone(process.poll())
            self.assertLess(time.time() - begin, PATIENCE)
            time.sleep(0.02)

    def begin(self, study, name):
        process = subprocess.Popen(command(study, name), text=True, stdout=subprocess.PIPE)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    @staticmethod
    @functools.lru_cache
    def reference():
        result = call(write("whole"), "whole")
        if result.returncode != 0:
            raise AssertionError(result.stdout + result.stderr)
        return {name: asperity_run.content(pathlib.Path("whole/runs") / name)
                for name in ("0001/steps.csv", "0002/steps.csv", "0002/events.csv")}

    def test_what_was_killed_is_continued(self):
        expected = self.reference()
        process = self.begin(write("killed"), "killed")
        self.wait_for(pathlib.Path("killed/runs/0002/steps.csv"), 200, process)
        found = subprocess.run(["pgrep", "-P", str(process.pid), "-f", "runs/0002"], text=True,
                               capture_output=True, check=True).stdout.split()
        os.kill(int(found[0]), signal.SIGKILL)
        out = process.communicate(timeout=PATIENCE)[0]
        self.assertEqual(process.returncode, 0, out)
        self.assertIn("run 2: killed (status -9), to be continued", out)
        self.assertIn("run 2: continued", out)
        for name, content in expected.items():
            self.assertEqual(asperity_run.content(f"killed/runs/{name}"), content, name)
        self.assertEqual([row["starts"] for row in rows("killed")], ["1", "2"])

    def test_stopped_and_gone_on_with(self):
        expected = self.reference()
        for number in (signal.SIGTERM, signal.SIGUSR2):  # of a user, of a queue
            name = f"stopped_{number.name}"
            study = write(name)
            process = self.begin(study, name)
            self.wait_for(pathlib.Path(f"{name}/runs/0001/steps.csv"), 200, process)
            process.send_signal(number)
            process.communicate(timeout=PATIENCE)
            self.assertEqual(process.returncode, 4)
            self.assertIn("waiting", [row["state"] for row in rows(name)])
            result = call(study, name)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn("continued", result.stdout)
            for file, content in expected.items():
                self.assertEqual(asperity_run.content(f"{name}/runs/{file}"), content, file)

    def assert_refused(self, result, *words):
        self.assertEqual((result.returncode, result.stderr.count("\n")), (2, 1), result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def test_is_refused_before_anything_is_computed(self):
        self.assert_refused(call(write("typo", parameter="Friction/bb"), "typo"),
                            "Run 1 is refused", "Friction / bb is unknown")
        self.assertFalse(pathlib.Path("typo").exists())
        self.assert_refused(call("none.xml", "none"), "none.xml cannot be read")

    def test_another_study_in_the_same_folder_is_refused(self):
        study = write("same", final="10")
        self.assertEqual(call(study, "same").returncode, 0)
        study.write_text(study.read_text().replace("0.0155", "0.016"))
        self.assert_refused(call(study, "same"), "another study")

    def test_a_run_that_fails_leaves_the_others(self):
        study = write("half", final="10")
        folder = pathlib.Path("half/runs/0001")
        folder.mkdir(parents=True)
        (folder / "checkpoint.h5").write_text("no checkpoint")
        result = call(study, "half")
        self.assertEqual(result.returncode, 3, result.stdout + result.stderr)
        self.assertEqual([row["state"] for row in rows("half")], ["failed", "finished"])
        self.assertIn("run 1: failed (status 2): asperity: ", result.stdout)

    def test_list_computes_nothing(self):
        result = call(SLIDER, "listed", "--list")
        self.assertEqual(result.stdout.splitlines()[0],
                         "1 state law=Ageing shear modulus=0.5e9")
        self.assertEqual(len(result.stdout.splitlines()), 4)
        self.assertFalse(pathlib.Path("listed").exists())


if __name__ == "__main__":
    unittest.main()
