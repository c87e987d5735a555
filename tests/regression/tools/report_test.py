"""The report of a run by the program itself: what it logs and marks is understood."""

import subprocess
import sys
import unittest

import asperity_run
import h5py

sys.path.insert(0, str(asperity_run.SOURCE / "tests" / "unit" / "python"))
from page_checks import Page  # noqa: E402

REPORT = asperity_run.PROGRAM.with_name("asperity-report")
DECK = asperity_run.SOURCE / "xml" / "wedge_2d.xml"


class Report(unittest.TestCase):
    def test_of_a_short_run(self):
        folder = asperity_run.run_to_end("run", DECK, *asperity_run.settings(
            "Time Stepping/Final Time=50", "Mesh/Wedge/Height=0.3"))
        result = subprocess.run([REPORT, folder], text=True, capture_output=True, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        page = Page((folder / "report.html").read_text())
        self.assertEqual(page.external(), [])
        rows = {row[0]: row[1:] for row in page.rows if row}
        self.assertEqual(rows["Mesh/Wedge/Height"], ["0.3"])
        self.assertEqual(rows["Time Stepping/Final Time"], ["50"])
        self.assertNotIn("Mesh/Wedge/Length", rows)  # the deck gives what is the default
        self.assertNotIn("Mesh/Refinements", rows)
        self.assertEqual(rows["whole run"][2], "100.0 %")
        self.assertEqual(len(rows["the numbered mesh"][0]), 16)
        with h5py.File(folder / "checkpoint.h5") as file:
            whole, = [value for name, value in rows.items() if "a restart compares" in name]
            self.assertEqual(whole, [file.attrs["fingerprint"].decode()])
        text = "".join(page.text)
        version = asperity_run.run("--version").stdout
        for line in version.splitlines():
            self.assertIn(line, text)
        self.assertIn("Built from", text)
        self.assertIn("Machine:", text)
        self.assertIn("energy", {image["id"] for image in page.images})


if __name__ == "__main__":
    unittest.main()
