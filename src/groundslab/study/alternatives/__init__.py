"""Alternatives to a design: other thicknesses, drop panels and bars, with utilizations and quantities."""
