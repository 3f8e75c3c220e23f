"""What bears on single unknowns and pushes one way only: the ground under a plate, supports.

A bearing on the unknown u_i, with sign s, level l, stiffness k (infinite if rigid) and capacity F, is driven in by
d = s (l - u_i) and pushes u_i in the direction s with the force clip(k d, 0, F). The ground under a gap g0 is a rigid
bearing with s = 1 and l = -g0: u >= l, force >= 0, force times (u - l) = 0, and with a capacity the force that yields.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers

#: States of a bearing: it touches nothing, it bears, it has reached its capacity.
OPEN, CLOSED, YIELDING = range(3)


@dataclass(frozen=True, slots=True)
class Bearings:
    """What bears on one unknown each, (c,); the unknown's unit is m or rad, the force's N or N m."""

    at: Integers  # number of the unknown
    sign: Array  # 1.0 or -1.0: the direction of the force
    level: Array  # value of the unknown at which it begins to bear
    stiffness: Array  # force per way; infinite if rigid
    capacity: Array  # largest force; infinite if there is none, 0 if it never bears
    both_ways: Flags  # closed for ever, whatever the sign of the force

    def __len__(self) -> int:
        """Return the number of bearings."""
        return len(self.at)

    def driven(self, u: Array) -> Array:
        """Return how far each is driven in, d (c,)."""
        d: Array = self.sign * (self.level - u[self.at])
        return d

    def lasting(self, state: Integers) -> Integers:
        """Return states (c,) in which those that act both ways are closed, and those without capacity open."""
        return np.where(self.both_ways, CLOSED, np.where(self.capacity == 0, OPEN, state))


@dataclass(frozen=True, slots=True)
class Contact:
    """A solution: unknowns u (size,), states of the bearings (c,), and their forces (c,), >= 0 unless both ways."""

    u: Array
    state: Integers
    force: Array

    @property
    def closed(self) -> Flags:
        """Return which bearings touch (c,), be it that they yield."""
        touching: Flags = self.state != OPEN
        return touching


def slipped(b: Bearings, c: Contact) -> Array:
    """Return how far each bearing (c,) has slipped at its capacity."""
    elastic = np.isfinite(b.stiffness)
    way = b.driven(c.u)
    way[elastic] -= c.force[elastic] / b.stiffness[elastic]
    return np.where(c.state == YIELDING, np.maximum(way, 0.0), 0.0)


#: All that is known of a bearing but the unknown on which it bears.
LAWS = ("sign", "level", "stiffness", "capacity", "both_ways")


def gaps(at: Integers, initial: Array) -> Bearings:
    """Return the bearings of gaps, initially `initial` (c,) wide: unknowns that are pushed up from -initial."""
    one, without_end = np.ones(len(at)), np.full(len(at), np.inf)
    return Bearings(at, one, -initial, without_end, without_end, np.zeros(len(at), dtype=bool))


def joined(*parts: Bearings) -> Bearings:
    """Return the bearings of several parts as one list."""
    return Bearings(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("at", *LAWS)))


def total(at: Integers, values: Array, size: int) -> Array:
    """Return the sum of values (c,) at each unknown, (size,)."""
    sums = np.zeros(size)
    np.add.at(sums, at, values)
    return sums
