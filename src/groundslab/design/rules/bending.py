"""Bending of slabs with a rectangular stress block, per meter of width: what all design codes have in common.

    F_c = f_c a,  a = depth x,  z = d - a / 2,  m = F_c z + A_s2 sigma_s2 (d - d_2),
    A_s f_y = F_c + A_s2 sigma_s2

Plane sections, no tension in the concrete, no normal force, steel with a horizontal top branch. A code gives a `Block`:
stresses that hold its factors already, the strain at which the compressed face fails, and how deep the neutral axis may
lie. Beyond that depth bars in compression take the rest of the moment. Concrete that they displace is not deducted.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.demands.design_moments import DesignMoments
from groundslab.errors import InputError, Issue

#: The formulas of `required`, with moments per width in MN, stresses in MPa and lengths in m.
FORMULAS = {
    "mu": "m / (f_c * d^2)",
    "omega": "2 * mu / (1 + sqrt(1 - 2 * mu))",
    "A_s": "omega * f_c * d / f_y * 10000",
}


@dataclass(frozen=True, slots=True)
class Block:
    """A code's stress block and steel, all with their factors."""

    stress: float  # of the block [Pa]
    depth: float  # of the block over that of the neutral axis, x
    eps_cu: float  # strain of the compressed face at failure
    f_y: float  # [Pa]
    E_s: float  # [Pa]
    xi: float  # the largest x / d
    most: float  # the largest area of a layer over that of the section


@dataclass(frozen=True, slots=True)
class Reinforcement:
    """What sections (n,) need: areas [m2/m], and the neutral axis x / d.

    ``tension`` and ``compression`` balance the moment, ``minimum`` is the least area where there is a moment. Where the
    concrete section is too weak for any reinforcement, ``tension``, ``compression`` and ``neutral_axis`` are inf.
    """

    tension: Array
    compression: Array
    neutral_axis: Array
    minimum: Array

    @property
    def area(self) -> Array:
        """Return the bars on the face in tension (n,) [m2/m]: what the moment needs, not less than the minimum."""
        return np.maximum(self.tension, self.minimum)

    @property
    def fails(self) -> Flags:
        """Return where no reinforcement helps (n,)."""
        return np.isinf(self.tension)


@dataclass(frozen=True, slots=True)
class Axes:
    """Distances [m] of the bars' axes from the face that they lie at: the cover and half a bar, or more."""

    bottom_x: float
    bottom_y: float
    top_x: float
    top_y: float


@dataclass(frozen=True, slots=True)
class SlabReinforcement:
    """Areas (n,) [m2/m] of a slab's four layers of bars; inf in a direction where its concrete section is too weak.

    ``links`` (n,) is true where bars in compression are counted, which links must hold.
    """

    bottom_x: Array
    bottom_y: Array
    top_x: Array
    top_y: Array
    links: Flags


@dataclass(frozen=True, slots=True)
class BendingRule:
    """How a code finds bars: ``required(m, d, d_2=..., thickness=...)``, and ``minimum(d, thickness)`` [m2/m]."""

    required: Callable[..., Reinforcement]
    minimum: Callable[[Array, Array | float | None], Array]


def required(
    block: Block,
    m: Array,
    d: Array | float,
    *,
    d_2: Array | float | None = None,
    thickness: Array | float | None = None,
    minimum: Callable[[Array, Array | float | None], Array],
) -> Reinforcement:
    """Return the required reinforcement for moments m >= 0 (n,) [N m/m] with effective depths d (n,) or one [m].

    d_2 (n,) or one [m] is the distance of bars in compression from the compressed face; without it there are none.
    With the thickness (n,) or one [m] no layer may have more than the block's most. inf where the neutral axis would
    have to pass its limit and there are no bars in compression, or where these lie no higher than the neutral axis, or
    where a layer would have too much. ``minimum`` gives the least areas for depths and thickness.
    """
    m, d = np.broadcast_arrays(np.asarray(m, dtype=float), np.asarray(d, dtype=float))
    _check(m, d, d_2)
    m_lim = _moment(block.depth * block.xi) * block.stress * d**2
    beyond = m > m_lim
    # mu = omega (1 - omega / 2) with omega = a / d, solved without loss of digits for small mu
    mu = np.minimum(m, m_lim) / (block.stress * d**2)
    omega = 2 * mu / (1 + np.sqrt(1 - 2 * mu))
    axis = np.where(beyond, block.xi, np.minimum(omega / block.depth, block.xi))
    tension = omega * block.stress * d / block.f_y
    compression = np.zeros(m.shape)
    fails = beyond.copy()
    if d_2 is not None:
        strain = block.eps_cu * (1 - np.asarray(d_2, dtype=float) / (block.xi * d))
        stress = np.minimum(strain * block.E_s, block.f_y)
        fails = beyond & (stress <= 0)
        force = np.where(beyond & ~fails, (m - m_lim) / (d - d_2), 0.0)
        compression = np.divide(force, stress, out=np.zeros(m.shape), where=force > 0)
        tension = tension + force / block.f_y
    if thickness is not None:
        fails = fails | (np.maximum(tension, compression) > block.most * np.asarray(thickness, dtype=float))
    tension, compression, axis = (np.where(fails, np.inf, values) for values in (tension, compression, axis))
    return Reinforcement(tension, compression, axis, np.where(m > 0, minimum(d, thickness), 0.0))


def slab(
    moments: DesignMoments, thickness: Array | float, axes: Axes, find: Callable[..., Reinforcement]
) -> SlabReinforcement:
    """Return the four layers for design moments (n,) of a slab of thickness (n,) or one [m], by a code's ``required``.

    Bars of the other face in the same direction serve as bars in compression. A layer has what its own moment needs in
    tension, at least the minimum, or what the other face's moment needs in compression, whichever is more.
    """
    t = np.asarray(thickness, dtype=float)

    def direction(bottom: Array, top: Array, low: float, high: float) -> tuple[Array, Array, Flags]:
        below = find(bottom, t - low, d_2=high, thickness=t)
        above = find(-top, t - high, d_2=low, thickness=t)
        links = (below.compression > 0) | (above.compression > 0)
        return np.maximum(below.area, above.compression), np.maximum(above.area, below.compression), links

    bottom_x, top_x, links_x = direction(moments.bottom_x, moments.top_x, axes.bottom_x, axes.top_x)
    bottom_y, top_y, links_y = direction(moments.bottom_y, moments.top_y, axes.bottom_y, axes.top_y)
    return SlabReinforcement(bottom_x, bottom_y, top_x, top_y, links_x | links_y)


def _moment(omega: float) -> float:
    """Return m / (f_c d^2) of a block of depth omega d."""
    return omega * (1 - omega / 2)


def _check(m: Array, d: Array, d_2: Array | float | None) -> None:
    """Refuse moments and depths that mean nothing."""
    issues: list[Issue] = []
    if not (m >= 0).all() or not np.isfinite(m).all():
        bad = m[~((m >= 0) & np.isfinite(m))].flat[0]
        issues.append(Issue("m", f"{bad:g}", "moments that are not negative, in N m/m"))
    if not (d > 0).all():
        hint = "the slab is thinner than its bars lie deep"
        issues.append(Issue("d", f"{d[~(d > 0)].flat[0]:g}", "positive effective depths, in m", hint))
    elif d_2 is not None:
        depth = np.broadcast_to(d_2, d.shape)
        issues += [
            Issue("d_2", f"{bad:g}", "depths of bars in compression between 0 and d, in m")
            for bad in depth[~((depth > 0) & (depth < d))].flat[:1]
        ]
    if issues:
        raise InputError(issues)
