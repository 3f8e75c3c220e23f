"""Axes of a building, and what is attached to their crossings."""
