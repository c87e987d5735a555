"""Figures from what a run of Asperity leaves on disk."""
