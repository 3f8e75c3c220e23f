"""What a study file says: distributions, outputs, and the case that they apply to."""
