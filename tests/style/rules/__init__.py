"""One module per house rule; each has check(root), which returns the breaches as lines of text."""
