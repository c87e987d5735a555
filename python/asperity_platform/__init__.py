"""Writes, checks and packs the files that the platforms for code comparisons take."""
