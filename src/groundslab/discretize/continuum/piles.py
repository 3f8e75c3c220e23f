"""Piles in the layers of a model: their stiffness from the shear moduli along them, their limits."""

from __future__ import annotations

import math

import numpy as np

from groundslab.discretize.ground import layer_of
from groundslab.fem.continuum.cells import Cells
from groundslab.fem.continuum.pile_group import PileGroup, make_pile_group
from groundslab.fem.continuum.piles import Pile
from groundslab.fem.parts.contact import Bearing
from groundslab.model import supports
from groundslab.model.ground import ContinuousGround, Continuum
from groundslab.model.model import Model

#: Slices along a pile in which the soil's shear modulus is taken.
SLICES = 200


def pile_group(model: Model, bearing: Bearing, cells: Cells) -> PileGroup | None:
    """Return the piles of a model, None if it has none."""
    numbers = [n for n, pile in enumerate(model.supports) if isinstance(pile, supports.Pile)]
    if not numbers:
        return None
    described = [pile for pile in model.supports if isinstance(pile, supports.Pile)]
    assert isinstance(model.ground, ContinuousGround)
    piles = tuple(pile_in_soil(pile, model.ground) for pile in described)
    of = np.array([int(np.flatnonzero(bearing.support == n)[0]) for n in numbers])
    place = np.array([(pile.x, pile.y) for pile in described])
    lower = np.array([-math.inf if pile.limit_tension is None else -pile.limit_tension for pile in described])
    upper = np.array([math.inf if pile.limit is None else pile.limit for pile in described])
    return make_pile_group(piles, place, of, cells.center, lower, upper)


def pile_in_soil(described: supports.Pile, ground: ContinuousGround) -> Pile:
    """Return a pile with the soil along it: G at its base and below, the mean of G over that, and the mean of nu."""
    z = described.length * (np.arange(SLICES) + 0.5) / SLICES
    G, nu = np.array([_soil(ground, depth) for depth in z]).T
    below = _soil(ground, described.length * (1 + 0.5 / SLICES))[0]
    return Pile(
        length=described.length,
        radius=described.diameter / 2,
        E=described.E,
        G_l=float(G[-1]),
        nu=float(nu.mean()),
        rho=float(G.mean() / G[-1]),
        xi=float(G[-1] / below),
    )


def _soil(ground: ContinuousGround, z: float) -> tuple[float, float]:
    """Return shear modulus [Pa] and Poisson's ratio at a depth [m]."""
    top = 0.0
    for layer in map(layer_of, ground.layers):
        bottom = top + float(layer.thickness)
        if z < bottom:
            return float(layer.E(np.array((z - top) / (bottom - top))) * layer.shear), float(layer.nu)
        top = bottom
    last = ground.half_space if isinstance(ground, Continuum) and ground.half_space is not None else ground.layers[-1]
    return last.E / (2 * (1 + last.nu)), last.nu
