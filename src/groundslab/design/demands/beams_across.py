"""What beams and walls with a height carry across straight cuts through the plate."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import FLAT
from groundslab.results.results import CombinationResult


def carried_across(results: CombinationResult, starts: Array, ends: Array) -> Array:
    """Return moments [N m] and shear forces [N] of beams across cuts (k,), (k, 2).

    A cut goes from start to end (k, 2) [m], and the strip that it cuts to the left. A beam along t carries M t + T n
    there, n to its left, of which the part along the strip bends it; where its forces jump at the cut, the mean of both
    sides. Beams that end at a cut or run along it carry nothing across.
    """
    found = np.zeros((len(starts), 2))
    chord = FLAT * max(results.model.sides)
    for beam, result in zip(results.model.members, results.beams, strict=True):
        axis = np.array(beam.to_shapely(chord).coords)
        steps = np.diff(axis, axis=0)
        lengths = np.linalg.norm(steps, axis=1)
        ways = np.concatenate([[0.0], np.cumsum(lengths)]) * (result.way[-1] / lengths.sum())
        for number, (start, end) in enumerate(zip(starts, ends, strict=True)):
            cut = end - start
            forth = np.array([-cut[1], cut[0]]) / np.linalg.norm(cut)  # the strip's direction
            side = (axis - start) @ forth
            for piece in np.flatnonzero((side[:-1] < 0) != (side[1:] < 0)):
                part = side[piece] / (side[piece] - side[piece + 1])
                place = axis[piece] + part * steps[piece]
                along = (place - start) @ cut / (cut @ cut)
                way = ways[piece] + part * (ways[piece + 1] - ways[piece])
                if not (0 <= along <= 1 and 0 < way < ways[-1]):
                    continue
                t = steps[piece] / lengths[piece]
                here = result.at(np.array([way, way]))  # where they jump, on both sides
                M, V, T = (float(each.mean()) for each in (here.moment, here.own_shear, here.torsion))
                onwards = np.sign(t @ forth)
                found[number] += onwards * np.array([M * (t @ forth) + T * (np.array([-t[1], t[0]]) @ forth), V])
    return found
