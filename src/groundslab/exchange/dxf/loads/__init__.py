"""Loads in a drawing: at points, along lines, on areas, with the values that are written beside them."""
