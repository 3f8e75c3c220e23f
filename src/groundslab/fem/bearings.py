"""One-sided bearings on single unknowns: the ground under a plate that may lift off, and supports. Links of two nodes.
Measures of what is small.

A bearing on the unknown u_i, with sign s, offset l, stiffness k (infinite if rigid) and limit force F, has the
penetration d = s (l - u_i) and pushes u_i in the direction s with the force clip(k d, 0, F). The ground under a gap g0
is a rigid bearing with s = 1 and l = -g0: u >= l, force >= 0, force times (u - l) = 0; at its limit force it yields.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from groundslab.arrays import Array, Flags, Integers

#: States of a bearing: free, bearing, yielding at its limit force.
OPEN, CLOSED, YIELDING = range(3)
#: What plates do is told from the rounding of what others do down to this share of it.
LEAST = 1e-8


@dataclass(frozen=True, slots=True)
class Bearings:
    """Laws of c bearings on one unknown each, (c,); the unknown's unit is m or rad, the force's N or N m."""

    unknown: Integers  # number of the unknown
    sign: Array  # 1.0 or -1.0: direction of the force
    offset: Array  # value of the unknown at which it begins to bear
    stiffness: Array  # force per penetration; infinite if rigid
    limit_force: Array  # infinite without a limit, 0 if it never bears
    bilateral: Flags  # always closed, whatever the sign of the force

    def __len__(self) -> int:
        """Return the number of bearings."""
        return len(self.unknown)

    def penetration(self, u: Array) -> Array:
        """Return the penetration d (c,) for the unknowns u (size,)."""
        return self.sign * (self.offset - u[self.unknown])

    def admissible(self, state: Integers) -> Integers:
        """Return states (c,) with bilateral bearings closed and those without a limit force above zero open."""
        return np.where(self.bilateral, CLOSED, np.where(self.limit_force == 0, OPEN, state))

    def select(self, which: Integers | Flags) -> Bearings:
        """Return some of the bearings, by number (k,) or mask (c,)."""
        return Bearings(*(getattr(self, field.name)[which] for field in fields(self)))


@dataclass(frozen=True, slots=True)
class Contact:
    """A solution: unknowns u (size,), states of the bearings (c,), and their forces (c,), >= 0 unless bilateral."""

    u: Array
    state: Integers
    force: Array

    @property
    def closed(self) -> Flags:
        """Return which bearings touch (c,), whether they yield or not."""
        touching: Flags = self.state != OPEN
        return touching


def plastic_slip(b: Bearings, c: Contact) -> Array:
    """Return how far each bearing (c,) has slipped at its limit force."""
    elastic = np.isfinite(b.stiffness)
    slip = b.penetration(c.u)
    slip[elastic] -= c.force[elastic] / b.stiffness[elastic]
    return np.where(c.state == YIELDING, np.maximum(slip, 0.0), 0.0)


def make_bearings(
    unknown: Integers,
    sign: float,
    offset: Array | float,
    stiffness: Array | float = np.inf,
    limit_force: Array | float = np.inf,
    bilateral: bool = False,
) -> Bearings:
    """Return bearings on unknowns (c,) from what each has (c,) or all have; rigid and without limits by default."""
    s, start, k, F = (
        np.broadcast_to(value, unknown.shape).astype(float) for value in (sign, offset, stiffness, limit_force)
    )
    return Bearings(unknown, s, start, k, F, np.full(len(unknown), bilateral))


def concatenate(*parts: Bearings) -> Bearings:
    """Return the bearings of several parts as one list."""
    return Bearings(*(np.concatenate([getattr(part, field.name) for part in parts]) for field in fields(Bearings)))


#: What links across joints are of, besides a joint by its number: the ground's surface, or a beam or wall that goes on.
SURFACE, MEMBER = -1, -2


@dataclass(frozen=True, slots=True)
class Links:
    """Links of l pairs of nodes at one place, by the difference of what their fields add up to."""

    nodes: Integers  # (l, 2)
    fields: Flags  # (l, F): which fields of each node add up
    stiffness: Array  # (l,) [N/m]; infinite where the difference must vanish
    joint: Integers  # (l,): number of the joint, or SURFACE or MEMBER
    length: Array  # (l,) [m]: the share of the joint's line, 0 of others

    @property
    def rigid(self) -> Flags:
        """Return across which links (l,) nothing may differ."""
        return np.isinf(self.stiffness)

    @property
    def shared(self) -> Flags:
        """Return which links (l,) are hinges, or of a member, whose nodes share the unknown of one field."""
        mask: Flags = (self.joint != SURFACE) & self.rigid
        return mask

    @property
    def holds(self) -> Flags:
        """Return which links (l,) hold two plates to each other: of joints that carry something, and of members."""
        mask: Flags = (self.joint != SURFACE) & (self.stiffness > 0)
        return mask

    def select(self, which: Flags) -> Links:
        """Return some of the links by a mask (l,)."""
        return Links(*(getattr(self, field.name)[which] for field in fields(self)))

    def difference(self, U: Array) -> Array:
        """Return the difference (l,) [m] of the first node less the second, from the table U (n, F)."""
        first, second = self.nodes.T
        difference: Array = ((U[first] - U[second]) * self.fields).sum(axis=1)
        return difference

    def spread(self, force: Array, nodes: int) -> Array:
        """Return the forces (n, F) at nodes that links resist with, from that of each link (l,) at its first node."""
        forces, by_field = np.zeros((nodes, self.fields.shape[1])), force[:, None] * self.fields
        np.add.at(forces, self.nodes[:, 0], by_field)
        np.add.at(forces, self.nodes[:, 1], -by_field)
        return forces


@dataclass(frozen=True, slots=True)
class Measures:
    """What displacements and forces are measured by, whatever the unit of length and what other plates do."""

    lever: Array  # (size,): what makes a displacement [m] of an unknown: 1, or of a rotation a length [m]
    plate: Integers | None = None  # (size,): of each unknown, -1 beside all plates; None of a single plate

    def displacements(self, u: Array) -> Array:
        """Return the largest displacement of each unknown's plate, (size,) [m]."""
        return largest_of_parts(u * self.lever, self.plate)

    def forces(self, f: Array) -> Array:
        """Return the largest force on each unknown's plate, (size,) [N]."""
        return largest_of_parts(f / self.lever, self.plate)


def largest_of_parts(values: Array, part: Integers | None) -> Array:
    """Return the largest size of values (k,) in the part that each of them belongs to, (k,), -1 beside all.

    None is less than a share LEAST of the largest of all, which is the rounding of that.
    """
    sizes = np.abs(values)
    if part is None or not len(values):
        return np.full(len(values), sizes.max(initial=0.0))
    largest = np.zeros(part.max() + 2)  # the last one of what is beside all plates, whose number is -1
    np.maximum.at(largest, part, sizes)
    bounded: Array = np.maximum(largest, LEAST * largest.max())[part]
    return bounded
