"""What belongs to serviceability: how the slab cracks, how soft the ground is under loads that last."""
