"""One-way shear: where it is read, what begins at d from walls and columns, and whether it needs links."""
