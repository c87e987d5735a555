"""A tiny wedge whose motion two unrelated codes have computed, through a deck and a mesh file."""

import json
import pathlib
import re
import shutil
import unittest

import numpy

import asperity_run
import mesh_files
from comparisons import largest_difference

HERE = pathlib.Path(__file__).parent
ANSWER = json.loads((HERE / "answer.json").read_text())
NODES = numpy.array(ANSWER["nodes"], dtype=float)
TRIANGLES = numpy.array(ANSWER["triangles"])
MESH = pathlib.Path("tiny_wedge.h5").resolve()


def facets(nodes):
    """Edges of a single triangle between the given nodes, the body on their left."""
    edges = [(t[k], t[(k + 1) % 3]) for t in TRIANGLES.tolist() for k in range(3)]
    return [e for e in edges if set(e) <= set(nodes) and e[::-1] not in edges]


def write_mesh():
    """The wedge as a mesh file; no centroid lies in the viscous region of the thesis."""
    boundaries = {name: facets(ANSWER[f"{name}_nodes"]) for name in ("base", "right")}
    mesh_files.write(MESH, NODES, TRIANGLES, boundaries, regions=[b"upper"])


class TinyWedge(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        write_mesh()

    def check(self, correction, ranks):
        changes = asperity_run.settings(f"Mesh/File/File Name={MESH}",
                                        f"TNNMG/Linear Correction={correction}")
        folder = asperity_run.run_to_end(f"{correction}_{ranks}", HERE / "tiny_wedge.xml",
                                         *changes, ranks=ranks)
        fault = asperity_run.series(folder / "fault.h5")
        volume = asperity_run.series(folder / "volume.h5")
        self.assert_close(fault["fields/normal_stress"][0], ANSWER["sigma_n"], "normal stress")
        for answer in ANSWER["steps"]:
            step = answer["step"]
            self.assertEqual((fault["step"][step], volume["step"][step]), (step, step))
            self.assert_close(fault["fields/alpha"][step], answer["alpha"], f"alpha {step}")
            for name in ("velocity", "displacement", "acceleration"):
                self.assert_close(volume["fields/" + name][step],
                                  numpy.reshape(answer[name], (-1, 2)), f"{name} {step}")
        rows = asperity_run.table(folder / "steps.csv")
        self.assertEqual(len(rows), 10)
        self.assertEqual(sum(row["energy_increases"] for row in rows), 0)

    def test_the_mesh_lies_beside_the_deck(self):
        """Then in the working directory; a name on the command line counts from there alone."""
        folder = pathlib.Path("elsewhere")
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        deck = folder / "deck.xml"
        deck.write_text((HERE / "tiny_wedge.xml").read_text())
        shutil.copy(MESH, folder / "beside.h5")
        named = ["--set", "Mesh/File/File Name=beside.h5"]
        self.assertEqual(asperity_run.run(deck, "--validate", *named).returncode, 2)
        text = re.sub(r'(name="File Name"[^>]*value=")[^"]*', r"\1beside.h5", deck.read_text())
        deck.write_text(text)
        self.assertIn("beside.h5", text)
        for words in ([deck, "--validate"], [deck.resolve(), "--validate"]):
            result = asperity_run.run(*words)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        run = asperity_run.run_to_end("beside", deck)
        written = (run / "parameters.xml").read_text()
        self.assertIn(f'value="{(folder / "beside.h5").resolve()}"', written)
        (folder / "beside.h5").rename("beside.h5")
        self.assertEqual(asperity_run.run(deck, "--validate").returncode, 0)
        pathlib.Path("beside.h5").unlink()
        self.assertEqual(asperity_run.run(deck, "--validate").returncode, 2)

    def assert_close(self, field, answer, name):
        self.assertLess(largest_difference(field, numpy.array(answer)), 1e-9, name)

    def test_direct(self):
        self.check("Direct", 1)

    def test_multigrid(self):
        self.check("Multigrid", 1)

    def test_multigrid_on_two_ranks(self):
        self.check("Multigrid", 2)


if __name__ == "__main__":
    unittest.main()
