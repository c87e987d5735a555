"""Checks and packs the files that the platforms for code comparisons take."""
