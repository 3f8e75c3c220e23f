"""Direct solvers of libraries, behind one interface."""
