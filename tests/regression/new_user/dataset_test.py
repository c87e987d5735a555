"""The recipe of docs/first_model/starting_values.md for a field from a file, word by word."""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import textwrap
import unittest

import asperity_run
import numpy

PAGE = (asperity_run.SOURCE / "docs/first_model/starting_values.md").read_text(encoding="utf-8")
BLOCKS = [textwrap.dedent(block).strip()
          for block in re.findall(r"(?:^ {4}.*\n(?:^\n(?= {4}))?)+", PAGE, re.MULTILINE)]


def block(beginning):
    found = [text for text in BLOCKS if text.startswith(beginning)]
    assert len(found) == 1, (beginning, found)
    return found[0]


class Recipe(unittest.TestCase):
    def call(self, text):
        program, *rest = shlex.split(text)
        command = [asperity_run.PROGRAM.parent / program, *rest]
        result = subprocess.run(command, text=True, capture_output=True, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""), text)

    def test_as_written(self):
        for name in ("layer.h5", "stress.h5"):
            pathlib.Path(name).unlink(missing_ok=True)
        if not pathlib.Path("xml").exists():
            os.symlink(asperity_run.SOURCE / "xml", "xml")
        self.call(block("asperity-mesh rectangle layer.h5"))
        subprocess.run([sys.executable, "-c", block("import h5py")], check=True)
        self.call(block("asperity xml/spring_slider.xml") +
                  ' --overwrite --set "Output/Fault History/Fields={normal_stress}"')
        fault = asperity_run.series("results/layer/fault.h5")
        along = fault["geometry/coordinates"][:, 0]
        self.assertEqual(along.size, 5)
        numpy.testing.assert_allclose(fault["fields/normal_stress"][-1],
                                      5e6 * (1 + 0.1 * along / 0.01), rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
