"""What bears the plate and by which conditions: the ground at each depth, supports, the ends of play."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.bearings import Bearings

#: Shares of an element's area that differ by less than this are equal.
TIE = 1e-6


@dataclass(frozen=True, slots=True)
class Bearing:
    """All that bears on single unknowns: first the gap of each plate node; then bottoms of voids; then the supports."""

    law: Bearings  # (c,); levels without settlements of the supports
    node: Integers  # (c,)
    field: Integers  # (c,): W, BETA_X, BETA_Y or TOP
    support: Integers  # (c,): number of the support, -1 for the ground
    length: Array  # (c,) [m]: the share of a line support, 0 for all else
    depth: Integers  # (c,): at which of the depths the ground lies; 0 for supports

    def select(self, which: Flags) -> Bearing:
        """Return some of the bearings by a mask (c,)."""
        others = (getattr(self, field.name)[which] for field in fields(self) if field.name != "law")
        return Bearing(self.law.select(which), *others)


def largest_share(share: Array) -> Integers:
    """Return which depth has the largest of the shares (m, d), of equal ones, but for rounding, the deepest."""
    largest: Integers = np.argmax(share + TIE * np.arange(share.shape[1]), axis=1)
    return largest


@dataclass(frozen=True, slots=True)
class Depths:
    """How deep the ground lies under the plate, by the parts of elements that voids take.

    The gap of a node is that of the least depth among its elements. Ground without shear can lie deeper beside it: that
    part bears by itself. Where it does, an element's mass matrix gives way to one that is diagonal.
    """

    depth: Array  # (d,) [m], ascending: 0 first, infinite for cavities
    area_fraction: Array  # (mp, d): of each plate element
    shallowest: Integers  # (n,): number of the least depth at each node
    area: Array  # (n, d) [m2]: each node's share of the area in each depth
    mass_kinds: Array  # (k, 10): factor on the mass matrix, and share of each node's area on the diagonal
    mass_kind: Integers  # (m,): which of these each element has
    stepped: bool  # whether the ground is without shear, so that depths may differ within an element

    @property
    def dominant(self) -> Integers:
        """Return the number of the depth that takes most of each plate element, (mp,)."""
        return largest_share(self.area_fraction)

    def at_shallowest(self, values: Array, nodes: Integers) -> Array:
        """Return the values (n, d) for the least depth at some nodes (k,)."""
        return values[nodes, self.shallowest[nodes]]


@dataclass(frozen=True, slots=True)
class ContactConditions:
    """By which conditions the plate touches the ground and rests on supports."""

    initial_gap: Array  # (n,) [m]
    depths: Depths
    bearing: Bearing
    tensionless: bool  # whether the ground cannot pull
    limit_pressure: float  # [Pa]; infinite if there is none
