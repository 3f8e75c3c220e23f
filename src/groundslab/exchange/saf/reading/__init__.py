"""Slabs from files in the Structural Analysis Format."""
