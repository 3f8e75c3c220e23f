"""Sparse matrices, and the order in which their unknowns are eliminated."""
