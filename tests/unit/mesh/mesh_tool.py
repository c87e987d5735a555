"""For the tests of asperity-mesh, which is their first argument."""

import pathlib
import subprocess
import sys
import unittest

import time_limits

PROGRAM = sys.argv.pop(1)


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True,
                          timeout=time_limits.seconds(60))


class Case(unittest.TestCase):
    def setUp(self):
        for path in pathlib.Path(".").glob("*.h5*"):
            path.unlink()

    def assert_done(self, *arguments):
        result = run(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        return result.stdout

    def assert_refused(self, arguments, *pieces):
        """Exit status 2 and one paragraph on stderr that contains the pieces. What Gmsh says of a
        geometry may come before it; what is on stdout is returned."""
        result = run(*arguments)
        self.assertEqual(result.returncode, 2, result.stderr)
        *of_gmsh, message = result.stderr.splitlines()
        if not any(str(argument).endswith(".geo") for argument in arguments):
            self.assertEqual((result.stdout, of_gmsh), ("", []))
        for line in of_gmsh:
            self.assertRegex(line, "^(Error|Warning) *: |^asperity-mesh: WARNING: ")
        self.assertTrue(message.startswith("asperity-mesh: "), message)
        for piece in pieces:
            self.assertIn(piece, message)
        return result.stdout
