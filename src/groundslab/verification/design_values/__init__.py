"""What rows of cases on design codes may ask for: a value by name, from the numbers that the row gives, all SI."""

from groundslab.verification.design_values.values import VALUES

__all__ = ["VALUES"]
