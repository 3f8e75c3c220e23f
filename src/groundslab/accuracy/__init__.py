"""Discretization errors: in energy, element by element, and of every value that is reported."""
