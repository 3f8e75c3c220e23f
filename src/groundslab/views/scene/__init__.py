"""A solved model as a browser draws it: what is described in plan, the mesh, the fields, packed into one block."""
