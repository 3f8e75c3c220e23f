"""Loads on columns, on walls and on parts of the plate, case by case, with what the building above adds."""
