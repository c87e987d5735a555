"""No vector or matrix that is larger than the coarsest level crosses to the host within a step, on
one rank and on two. host-access, which traps what the host does with views of more than two pages,
is the first argument.

A coarsest level has about 200 rows, so that vectors on it are less than that."""

import json
import os
import subprocess
import sys
import unittest

import asperity_run
import time_limits

PROGRAM = sys.argv.pop(1)
DECKS = asperity_run.SOURCE / "xml"
# MPI must not read another process's pages past the trap.
ENVIRONMENT = {**os.environ, "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "OMPI_MCA_smsc": "^cma,knem,xpmem"}
SET_UP = "set-up of step sizes"  # of matrices and levels, on the host, once for each size
# What crosses, by a function that it is in.
CROSSES = {
    "multigrid::CoarsestSolver::": "the coarsest level's matrix, for Eigen's factor",
    "fem::addTraction(": "the deck's traction on the fault, a function of time",
}
BETWEEN_RANKS = {
    "Tpetra::Details::Distributor": "ghosts, and with them the vector where MPI puts them",
    "multigrid::AddedBlocks::": "blocks of the fault's nodes",
}


def accesses(deck, steps, *changes, ranks=1):
    """What host-access prints of the deck, for each rank."""
    words = [] if ranks == 1 else [*asperity_run.MPIEXEC, str(ranks)]
    words += [PROGRAM, str(steps), str(DECKS / deck),
              *asperity_run.settings("TNNMG/Linear Correction=Multigrid", *changes)]
    result = subprocess.run(words, capture_output=True, text=True, env=ENVIRONMENT,
                            timeout=time_limits.seconds(600), check=False)
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    return json.loads(result.stdout)


def told(access):
    kind = "copy of" if access["is_copy"] else "access to"
    return "\n    ".join([f"{access['count']} times, {access['work'] or 'no work'}: {kind} "
                          f"{access['view']}, {access['bytes']} bytes", *access["stack"][:12]])


@unittest.skipUnless(sys.platform == "linux", "the trap is for Linux")
class HostAccess(unittest.TestCase):
    def check(self, deck, steps, *changes, ranks=1):
        allowed = [*CROSSES, *(BETWEEN_RANKS if ranks > 1 else [])]
        found = accesses(deck, steps, *changes, ranks=ranks)
        if not found:
            self.skipTest("kernels run on a device")
        for of_rank in found:
            if of_rank["vector"] < 10 * of_rank["guarded"]:
                self.skipTest("the pages of this machine are too large for this model")
            known = [(access["view"], access["is_copy"]) for access in of_rank["known"]]
            self.assertEqual(known, [("MV::DualView", False), ("MV::DualView", True)])
            for access in of_rank["steps"]:
                stack = "\n".join(access["stack"])
                if access["work"] != SET_UP:
                    self.assertTrue(any(name in stack for name in allowed), told(access))

    def test_quasi_dynamic(self):
        self.check("bp5_qd.xml", 6)

    def test_with_inertia(self):
        self.check("tpv101_3d.xml", 6)

    def test_with_a_normal_stress_that_is_coupled(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.check("megathrust_3d.xml", 6, "Friction/Normal Stress Change=Coupled",
                           ranks=ranks)


if __name__ == "__main__":
    unittest.main()
