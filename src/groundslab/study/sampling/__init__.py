"""Values of the variants: designs of experiments and random fields."""
