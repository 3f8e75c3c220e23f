"""Drives an analysis: meshes from coarse to fine, load steps, gamma iteration, many models at once."""
