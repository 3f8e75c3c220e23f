"""National parameters of EN 1992-1-1, one file per annex."""
