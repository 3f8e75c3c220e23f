"""Drawings of the ground: its layers in section, stresses in its depth."""
