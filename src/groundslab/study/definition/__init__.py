"""The study file: distributions, variables, outputs, limit states, and the case that they apply to."""
