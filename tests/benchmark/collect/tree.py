"""The source tree; once this module is imported, its package `asperity` can be."""

import pathlib
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(SOURCE / "python"))
