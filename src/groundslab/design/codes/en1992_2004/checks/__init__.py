"""Demands and checks of a slab's results by EN 1992-1-1."""
