"""Concrete slabs by EN 1992-1-1, with the recommended national parameters: materials and resistances."""
