"""A damaged checkpoint or mesh is refused in one line, or it makes no difference."""

import os
import pathlib
import random
import resource
import shutil
import subprocess
import unittest

import asperity_run
import faults
import runs
import time_limits
from comparisons import assert_same_results
from mesh_files import mesh_tool

TRIALS = faults.trials(30, 1000)
MEMORY = 4 << 30  # bytes of addresses, most of which MPI asks for
BEFORE_THE_END = runs.settings("Time Stepping/Instants={7.8}")


def damage(data, seed):
    """A copy with a flipped bit, some other bytes, a hole, something moved, or an end too early."""
    chance = random.Random(seed)
    data = bytearray(data)
    place = chance.randrange(len(data))
    kind = chance.choice(("bit", "bit", "bytes", "hole", "moved", "end"))
    if kind == "bit":
        data[place] ^= 1 << chance.randrange(8)
    elif kind == "bytes":
        data[place:place + 8] = chance.randbytes(len(data[place:place + 8]))
    elif kind == "hole":
        data[place:place + 512] = bytes(len(data[place:place + 512]))
    elif kind == "moved":
        other = chance.randrange(len(data))
        data[place:place + 64] = data[other:other + len(data[place:place + 64])]
    else:
        del data[place:]
    return bytes(data)


def little_memory():
    """What subprocess needs for it. AddressSanitizer takes terabytes of addresses for itself; with
    it a single piece of that size ends the program with a finding."""
    if "address" in os.environ.get("ASPERITY_SANITIZER", ""):
        options = f"{os.environ['ASAN_OPTIONS']}:max_allocation_size_mb={MEMORY >> 20}"
        return {"env": {**os.environ, "ASAN_OPTIONS": options}}
    return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))}


def run_with_little_memory(*arguments):
    return subprocess.run(
        asperity_run.command(*arguments), capture_output=True, text=True, check=False,
        timeout=time_limits.seconds(20), errors="surrogateescape", **little_memory())


class Damage(unittest.TestCase):
    def check(self, what, original, run):
        """run(bytes) is a finished run and the function that compares what it leaves."""
        counts = {"refused": 0, "equal": 0}
        for seed in range(TRIALS):
            with self.subTest(f"{what} {seed}"):
                data = damage(original, seed)
                result, compare = run(data)
                if result.returncode == runs.INPUT:
                    runs.assert_one_message(self, result, runs.INPUT)
                    self.assertLessEqual(len(result.stderr.splitlines()), 6, result.stderr)
                    counts["refused"] += 1
                else:
                    self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
                    compare()
                    counts["equal"] += 1
        print(f"{TRIALS} damaged {what}: {counts}")
        self.assertGreater(counts["refused"], TRIALS // 2)

    def test_checkpoints(self):
        deck = [*runs.RUN, *BEFORE_THE_END]
        whole = asperity_run.run_to_end("whole", *deck)
        begun = asperity_run.run_to_end("begun", *deck,
                                        *runs.settings("Time Stepping/Final Time=7.8"))
        self.assertGreater(len(asperity_run.table(whole / "steps.csv")),
                           len(asperity_run.table(begun / "steps.csv")) + 2)

        def run(data):
            folder = runs.fresh("damaged")
            shutil.copytree(begun, folder)
            (folder / "checkpoint.h5").write_bytes(data)
            result = run_with_little_memory(*deck, "--output", folder, "--restart",
                                            folder / "checkpoint.h5")
            # The histories have a row more, where the first run has ended.
            return result, lambda: assert_same_results(whole, folder, series=())

        self.check("checkpoints", (begun / "checkpoint.h5").read_bytes(), run)

    def test_meshes(self):
        mesh = pathlib.Path("wedge.h5")
        mesh.unlink(missing_ok=True)
        mesh_tool("wedge", mesh, "--cell-size", "0.01", "--growth-factor", "1.5")
        original = mesh.read_bytes()
        deck = [*runs.RUN, *runs.settings("Time Stepping/Final Time=0.05", "Mesh/Type=File",
                                          f"Mesh/File/File Name={mesh}")]
        whole = asperity_run.run_to_end("mesh_whole", *deck)

        def run(data):
            folder = runs.fresh("mesh_damaged")
            mesh.write_bytes(data)
            result = run_with_little_memory(*deck, "--output", folder)
            return result, lambda: assert_same_results(whole, folder, series=())

        self.check("meshes", original, run)


if __name__ == "__main__":
    unittest.main()
