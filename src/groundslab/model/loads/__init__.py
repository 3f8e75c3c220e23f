"""Loads, what of them lies on the plate, load cases, and combinations by EN 1990."""
