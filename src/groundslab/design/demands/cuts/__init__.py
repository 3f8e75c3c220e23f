"""Cuts through the plate along lines and across strips: fields along them, forces across them, their equilibrium."""
