"""Many runs of one deck: which values, side by side, one table."""
