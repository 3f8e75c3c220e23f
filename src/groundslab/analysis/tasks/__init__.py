"""The combinations of a model as tasks: what is solved once, and how many at the same time."""
