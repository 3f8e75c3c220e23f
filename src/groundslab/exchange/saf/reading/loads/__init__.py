"""Loads of a slab from files in the Structural Analysis Format."""
