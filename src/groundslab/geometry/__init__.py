"""Plane geometry: closed curves of straight edges and arcs, where they cross, and whether a plan can be meshed."""
