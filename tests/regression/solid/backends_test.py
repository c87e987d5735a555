"""What other backends take by default, run on the backend of this build: MueLu's factories for
threads and devices ("use kokkos refactor"), and sweeps by colours. And other smoothers, and MueLu's
own cycle.

Fields must be those of the defaults to the tolerance of the solver, for about as many V-cycles.
"aggregation: drop tol", which was a default in space, made these factories throw.
"""

import re
import unittest

import asperity_run
import runs
import wedge_runs
from comparisons import largest_errors

CORRECTION = "TNNMG/Multigrid"
RUN = [*wedge_runs.RUPTURE, *wedge_runs.PERIODIC,
       *wedge_runs.settings("Time Stepping/Final Time=0.03", "TNNMG/Linear Correction=Multigrid")]


def run(name, parameters, ranks=1):
    changes = wedge_runs.settings({f"{CORRECTION}/{key}": text for key, text in parameters.items()})
    return wedge_runs.run_deck(f"{name}_{ranks}", *RUN, *changes, ranks=ranks)


def v_cycles(folder):
    return sum(row["v_cycles"] for row in asperity_run.table(folder / "steps.csv"))


def energy_increases(folder):
    return sum(row["energy_increases"] for row in asperity_run.table(folder / "steps.csv"))


def events(folder):
    return asperity_run.table(folder / "events.csv")


class Backends(unittest.TestCase):
    def check(self, name, parameters, most, ranks):
        defaults, found = run("defaults", {}, ranks), run(name, parameters, ranks)
        self.assertGreater(asperity_run.series(defaults / "fault.h5")["fields/slip_rate"].max(),
                           1e-3)
        for field, error in largest_errors(defaults, found).items():
            self.assertLess(error, 1e-8, field)
        print(f"{name}, {ranks} ranks: {v_cycles(found)} V-cycles, {v_cycles(defaults)} by default")
        self.assertGreater(v_cycles(defaults), 0)
        self.assertLess(v_cycles(found), most * v_cycles(defaults))
        return found

    def test_factories_of_threads_and_devices(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.check("parallel", {"MueLu/use kokkos refactor": "true"}, 1.1, ranks)

    def test_sweeps_by_colours(self):
        # 1.25 was set when bp5_qd and tpv101_3d had shown 1.00, and before this deck was run.
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.check("colours", {"Row Order": "Colours"}, 1.25, ranks)

    def test_smoothers(self):
        # Twice as many were allowed before the test first ran.
        for smoother in ("Chebyshev", "Block Jacobi"):
            for ranks in (1, 2):
                with self.subTest(smoother=smoother, ranks=ranks):
                    found = self.check(smoother.split()[0], {"Smoother": smoother}, 2, ranks)
                    self.assertEqual(energy_increases(found), 0)
                    defaults = run("defaults", {}, ranks)
                    for event, other in zip(events(found), events(defaults), strict=True):
                        self.assertAlmostEqual(event["onset"], other["onset"], delta=1e-9)

    def test_cycle_of_muelu(self):
        # Its smoother is not ours, so that V-cycles tell little; twice as many were allowed before
        # the test first ran.
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.check("muelu", {"Cycle": "MueLu"}, 2, ranks)


class Environment(unittest.TestCase):
    VERSION = re.compile(r"Asperity [\d.]+ on \w+( with \d+ threads?| on [^,]+)?, (\d+) ranks?\.\n"
                         r"Kokkos [\d.]+, Trilinos [\d.]+(rc\d+)?, \S.*\.\n"
                         r"Built from \S.*, HDF5 [\d.]+, Eigen [\d.]+\.\n"
                         r"Machine: \S.*\.\n")

    def test_version_is_what_the_log_begins_with(self):
        for ranks in (1, 2):
            told = asperity_run.run("--version", ranks=ranks)
            self.assertEqual(told.returncode, 0, told.stderr)
            match = self.VERSION.fullmatch(told.stdout)
            self.assertTrue(match, told.stdout)
            self.assertEqual(int(match.group(2)), ranks)
            log = (run("defaults", {}, ranks) / "run.log").read_text()
            self.assertTrue(log.startswith(told.stdout), log)

    def test_options_of_kokkos(self):
        good = asperity_run.run("--kokkos-disable-warnings", "--version")
        self.assertEqual(good.returncode, 0, good.stderr)
        for ranks in (1, 2):
            bad = asperity_run.run("--kokkos-treads=2", "--version", ranks=ranks)
            message = runs.assert_one_message(self, bad, runs.INPUT,
                                              "--kokkos-treads is unknown to Kokkos")
            self.assertRegex(message, "Did you mean '--kokkos-(num-)?threads'")


if __name__ == "__main__":
    unittest.main()
