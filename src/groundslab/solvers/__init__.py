"""Solves one Problem: factorizations, contact, equilibrium, warm starts."""
