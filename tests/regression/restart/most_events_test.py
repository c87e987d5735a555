"""A run that ends with a number of events goes on as if it had not ended."""

import pathlib
import shutil
import unittest

import asperity_run
from asperity_run import settings

DECK = asperity_run.SOURCE / "xml" / "spring_slider.xml"
# Two events, and rows of one table at the ends alone.
SETTINGS = ["Time Stepping/Final Time=2500", "Output/Global/Every n Steps=1000000"]


def run(most, folder, *arguments):
    most_events = f"Output/Event Catalogue/Most Events={most}"
    return asperity_run.run(DECK, *settings(*SETTINGS, most_events), *arguments,
                            "--output", folder)


class MostEvents(unittest.TestCase):
    def test_ends_and_goes_on(self):
        whole, parts = pathlib.Path("whole"), pathlib.Path("parts")
        for folder in whole, parts:
            shutil.rmtree(folder, ignore_errors=True)
        self.assertEqual(run(0, whole).returncode, 0)
        one = run(1, parts)
        self.assertEqual((one.returncode, one.stderr), (0, ""))
        self.assertIn("Most Events", one.stdout)
        events = (whole / "events.csv").read_text().splitlines()
        self.assertEqual(len(events), 3)
        self.assertEqual((parts / "events.csv").read_text().splitlines(), events[:2])
        last_time = asperity_run.table(parts / "steps.csv")[-1]["time"]
        self.assertLess(last_time, 2500)
        self.assertEqual(asperity_run.table(parts / "global.csv")[-1]["time"], last_time)
        self.assertEqual(run(0, parts, "--restart", parts / "checkpoint.h5").returncode, 0)
        self.assertEqual((parts / "events.csv").read_text().splitlines(), events)


if __name__ == "__main__":
    unittest.main()
