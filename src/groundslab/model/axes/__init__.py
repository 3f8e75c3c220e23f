"""Axes of a building, and what hangs on their crossings."""
