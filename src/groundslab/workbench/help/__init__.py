"""Help at hand, without a network: the examples to open and the documentation to read."""
