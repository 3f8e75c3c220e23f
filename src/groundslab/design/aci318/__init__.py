"""Concrete slabs by ACI 318-19, strength design: materials, bending, one-way and two-way shear, in SI units."""
