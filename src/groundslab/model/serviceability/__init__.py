"""What belongs to serviceability: how the slab cracks, stiffness of the ground under long-term loads."""
