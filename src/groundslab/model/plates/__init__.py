"""Several plates on one ground: those beside the first one, and what all of them cover."""
