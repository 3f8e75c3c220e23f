"""EN 1997-1: bearing resistance and sliding of spread foundations, and their checks."""
