"""`pip install` of the tree without a network gives the module and the programs."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import synthetic_run

TREE = Path(os.environ["ASPERITY_SOURCE_DIR"]) / "python"
READ = """
import asperity
run = asperity.Run({folder!r})
print(asperity.__file__, len(run.events), float(run.fault["slip_rate"].max()) > 0)
"""


def missing():
    """Why pip cannot be tried; None if it can."""
    for module in ("pip", "setuptools", "wheel", "ensurepip"):
        if subprocess.run([sys.executable, "-c", f"import {module}"], check=False,
                          capture_output=True).returncode != 0:
            return f"{sys.executable} has no {module}"
    return None


@unittest.skipIf(missing(), missing())
class Install(unittest.TestCase):
    def call(self, *words):
        environment = {key: value for key, value in os.environ.items()
                       if key != "PYTHONPATH" and not key.startswith("PIP_")}
        environment["PIP_CONFIG_FILE"] = os.devnull
        result = subprocess.run([str(word) for word in words], env=environment, text=True,
                                capture_output=True, check=False, cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def test_without_a_network(self):
        with tempfile.TemporaryDirectory() as name:
            self.folder = Path(name)
            # setuptools leaves its files in the tree that it builds from
            shutil.copytree(TREE, self.folder / "python", ignore=shutil.ignore_patterns(
                "__pycache__", "build", "*.egg-info"))
            self.call(sys.executable, "-m", "venv", "--system-site-packages", "own")
            python = self.folder / "own" / "bin" / "python"
            self.call(python, "-m", "pip", "install", "--no-index", "--no-build-isolation",
                      "--disable-pip-version-check", "./python")
            synthetic_run.write_run(self.folder / "run", 2, nodes=20)
            words = self.call(python, "-c", READ.format(folder=str(self.folder / "run"))).split()
            self.assertIn(str(self.folder / "own"), words[0])
            self.assertEqual(words[1:], ["2", "True"])
            programs = self.folder / "own" / "bin"
            for program in sorted(path.name for path in programs.glob("asperity-*")):
                self.assertIn(f"usage: {program}", self.call(programs / program, "--help"))
            self.call(programs / "asperity-plot", self.folder / "run", "--figures", "energy",
                      "--dpi", "40")
            self.assertTrue((self.folder / "run" / "figures" / "energy.png").exists())
