"""Concrete slabs by ACI 318-19, strength design, in SI units: materials, resistances, checks, its entry as a code."""
