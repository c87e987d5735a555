"""Where a run is, how fast, and when it ends."""
