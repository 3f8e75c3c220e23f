"""Thick plates on layered, two-parameter, tensionless ground."""

__version__ = "0.1.0"
