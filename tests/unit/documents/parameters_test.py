"""docs/reference/parameters.md has every parameter of the program, as the program says it."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["ASPERITY_SOURCE_DIR"])
PROGRAM = pathlib.Path(os.environ["ASPERITY_BUILD_DIR"]) / "drivers" / "asperity"
SCRIPT = SOURCE / "docs" / "parameters.py"

_spec = importlib.util.spec_from_file_location("parameters", SCRIPT)
parameters = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(parameters)


class Page(unittest.TestCase):
    def test_is_up_to_date(self):
        result = subprocess.run([sys.executable, str(SCRIPT), "--check", str(PROGRAM)], text=True,
                                capture_output=True, check=False)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_has_every_parameter_with_default_and_unit(self):
        text = (SOURCE / "docs" / "reference" / "parameters.md").read_text()
        printed = subprocess.run([PROGRAM, "--print-parameters"], text=True, capture_output=True,
                                 check=True).stdout
        names = re.findall(r"^  (\S.*)$", printed, re.MULTILINE)
        names = [name for name in names if not name.startswith(" ")]
        self.assertGreater(len(names), 150)
        self.assertEqual(len(re.findall(r"^\| `", text, re.MULTILINE)), len(names))
        self.assertIn("| `Density` | field, in (0, inf) | required | kg/m^3 | The material has "
                      "this mass density. |", text)
        self.assertIn("| `Refinements` | an integer in [0, inf) | `0` |  | Every cell", text)

    def test_a_change_is_noticed(self):
        with tempfile.TemporaryDirectory() as name:
            copy = pathlib.Path(name) / "parameters.md"
            text = (SOURCE / "docs" / "reference" / "parameters.md").read_text()
            for changed in (text.replace("`0.27`", "`0.28`", 1), text + "| more |\n",
                            text[:-200]):
                copy.write_text(changed)
                page, parameters.PAGE = parameters.PAGE, copy
                try:
                    self.assertEqual(parameters.main(["--check", str(PROGRAM)]), 1)
                finally:
                    parameters.PAGE = page

    def test_an_unknown_form_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "'x'"):
            parameters.row("x", "something else")


if __name__ == "__main__":
    unittest.main()
