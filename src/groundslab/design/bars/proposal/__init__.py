"""Bars proposed for a slab: a base in each layer and zones of additional bars, from what is required at points."""
