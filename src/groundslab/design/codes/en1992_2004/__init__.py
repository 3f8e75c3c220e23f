"""Concrete slabs by EN 1992-1-1 and its national annexes: materials, resistances, checks, its entry as a code."""
