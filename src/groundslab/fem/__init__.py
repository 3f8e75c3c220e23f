"""Finite elements in terms of arrays: meshes, plate, foundation, load vectors, sparse matrices, the system."""
