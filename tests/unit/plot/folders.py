"""Test cases with a folder for the files of a run, and what programs print about it."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path


def _folder(add_cleanup) -> Path:
    temporary = tempfile.TemporaryDirectory()
    add_cleanup(temporary.cleanup)
    return Path(temporary.name)


class FolderCase(unittest.TestCase):
    """Each test has a `folder` of its own, which is empty."""

    def setUp(self):
        self.folder = _folder(self.addCleanup)


class SharedFolderCase(unittest.TestCase):
    """All tests of the class have the same `folder`."""

    @classmethod
    def setUpClass(cls):
        cls.folder = _folder(cls.addClassCleanup)


def told(main, *arguments):
    """Exit status, standard output and error of main(arguments) of a program."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = main([str(word) for word in arguments])
    return status, out.getvalue(), err.getvalue()
