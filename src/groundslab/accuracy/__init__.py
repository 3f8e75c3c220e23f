"""Discretization errors in energy, by element, and of every value that is reported; statistics of the mesh."""
