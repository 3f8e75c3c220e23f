"""Demands and checks of a slab's results by ACI 318-19."""
