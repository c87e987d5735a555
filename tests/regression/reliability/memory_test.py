"""Memory does not grow with the steps: what the system says that a run has."""

import re
import time
import unittest

import asperity_run
import faults
import runs

FREQUENT = runs.settings("Output/Checkpoint Every n Steps=50")
PLANE = [runs.DECK, *FREQUENT, *runs.settings("Mesh/Wedge/Cell Size=0.02",
                                              "Time Stepping/Final Time=1e5")]
SPACE = [*PLANE, "--overlay",
         asperity_run.SOURCE / "tests" / "regression" / "solid" / "glass_wedge.xml",
         *runs.settings("Mesh/Deep Wedge/Cell Size=0.08", "Time Stepping/Final Time=1e5",
                        "TNNMG/Linear Correction=Multigrid")]


def resident(process):
    """[kB]"""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as file:
        return int(re.search(r"VmRSS:\s+(\d+) kB", file.read())[1])


def number_of_steps(folder):
    """Of those that are on the disk."""
    table = folder / "steps.csv"
    return max(table.read_bytes().count(b"\n") - 1, 0) if table.exists() else 0


class Memory(unittest.TestCase):
    def check(self, name, deck, steps, largest):
        """largest: kB that it may grow by from a third of the steps to the end."""
        folder = runs.fresh(name)
        process = runs.start(*deck, "--output", folder)
        samples = [(0, resident(process))]
        while samples[-1][0] < steps:
            self.assertIsNone(process.poll(), "the run has ended")
            time.sleep(0.2)
            made = number_of_steps(folder)
            if made > samples[-1][0]:
                samples.append((made, resident(process)))
        process.kill()
        process.communicate()
        start = next(sample for sample in samples if sample[0] >= steps / 3)
        grown, made = samples[-1][1] - start[1], samples[-1][0] - start[0]
        print(f"{name}: {grown} kB from step {start[0]} ({start[1]} kB) on in {made} steps, "
              f"{1000 * grown / made:.0f} bytes a step")
        self.assertLess(grown, largest)

    def test_in_two_dimensions(self):
        self.check("plane", PLANE, *((10000, 10000) if faults.is_long() else (600, 3000)))

    def test_in_three_dimensions(self):
        self.check("space", SPACE, *((10000, 10000) if faults.is_long() else (600, 3000)))


if __name__ == "__main__":
    unittest.main()
