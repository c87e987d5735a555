"""One module per rule of style; each has check(root), which returns the breaches as lines."""
