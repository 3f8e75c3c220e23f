"""Extrapolation of fixed-point iterations."""

from __future__ import annotations

from collections import deque

import numpy as np

from groundslab.arrays import Array

#: How many earlier steps the next one is extrapolated from (Anderson 1965).
DEPTH = 5


class Extrapolation:
    """Extrapolates a fixed-point iteration from its latest steps (Anderson 1965)."""

    def __init__(self) -> None:
        self.steps: deque[tuple[Array, Array]] = deque(maxlen=DEPTH)  # what came out, and by how much it changed

    def next(self, x: Array, outcome: Array) -> Array:
        """Return what to try after x, of which `outcome` came out."""
        change = (outcome - x).ravel()
        self.steps.append((outcome.ravel(), change))
        if len(self.steps) < 2:
            return outcome
        outcomes, changes = (np.diff(np.array(steps), axis=0) for steps in zip(*self.steps, strict=True))
        weights = np.linalg.lstsq(changes.T, change, rcond=1e-8)[0]
        tried: Array = (outcome.ravel() - weights @ outcomes).reshape(x.shape)
        return tried
