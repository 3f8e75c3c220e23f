"""Converts a Model into the arrays of a Problem."""
