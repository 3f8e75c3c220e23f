"""Piles under a plate: what they settle by their own loads, by each other's and by the pressure between them.

A pile settles by its load over its stiffness (Randolph and Wroth 1978). Around it the soil settles by its shaft's share
as ln(r_m / s) / ln(r_m / r_0), and by its base's as beside a rigid disc; the mean of both piles' factors is what two
piles do to each other (Randolph and Wroth 1979, for piles that are alike). What a pile does to the surface at a place,
pressure there does to the pile (Maxwell).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.continuum.piles import Pile, base_interaction, shaft_interaction


@dataclass(frozen=True, slots=True)
class PileGroup:
    """p piles, each with a bearing of its own on the plate."""

    piles: tuple[Pile, ...]
    place: Array  # (p, 2) [m]
    bearing: Integers  # (p,): number of each one's bearing
    own: Array  # (p, p) [m/N]: settlement of each by a unit load on each
    on_cells: Array  # (p, c) [m/N]: of each cell by a unit load on each, and of each by a unit force on each cell
    lower: Array  # (p,) [N]: minus the limit in tension
    upper: Array  # (p,) [N]: the limit in compression

    def settle(self, load: Array, force: Array) -> Array:
        """Return the settlement (p,) [m] of the piles by their loads (p,) and by forces on cells (c,) [N]."""
        settlement: Array = self.own @ load + self.on_cells @ force
        return settlement

    def settle_at(self, load: Array, places: Array) -> Array:
        """Return the settlement (k,) [m] of the surface at places (k, 2) [m] by loads on the piles (p,) [N]."""
        settlement: Array = load @ field_of_piles(self.piles, self.place, places)
        return settlement


def make_pile_group(
    piles: tuple[Pile, ...], place: Array, bearing: Integers, centers: Array, lower: Array, upper: Array
) -> PileGroup:
    """Return piles at places (p, 2) [m] with what they do to each other and to cells with centers (c, 2) [m]."""
    distance = np.hypot(*(place[:, None] - place).transpose(2, 0, 1))
    factors = np.stack([_beside(pile, s, s) for pile, s in zip(piles, distance, strict=True)])
    single = np.array([1 / pile.head_stiffness for pile in piles])
    flexibility = (factors + factors.T) / 2 * np.sqrt(np.outer(single, single))
    np.fill_diagonal(flexibility, single)
    return PileGroup(piles, place, bearing, flexibility, field_of_piles(piles, place, centers), lower, upper)


def field_of_piles(piles: tuple[Pile, ...], place: Array, places: Array) -> Array:
    """Return the settlement (p, k) [m/N] of the surface at places (k, 2) [m] by a unit load on each of the piles."""
    settlements = []
    for pile, at in zip(piles, place, strict=True):
        s = np.hypot(*(places - at).T)
        settlements.append(_beside(pile, s, np.hypot(s, pile.length)) / pile.head_stiffness)
    return np.stack(settlements)


def _beside(pile: Pile, s: Array, from_base: Array) -> Array:
    """Return the settlement over that of the pile at distances s from its shaft and from its base [m]."""
    base = pile.base_share
    ratio: Array = (1 - base) * shaft_interaction(pile, s) + base * base_interaction(pile, from_base)
    return ratio
