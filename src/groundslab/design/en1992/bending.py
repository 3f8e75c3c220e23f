"""Bending reinforcement that a slab needs in the ultimate limit state, per meter of width, by EN 1992-1-1.

    F_c = eta f_cd lambda x,  z = d - lambda x / 2,  m = F_c z + A_s2 sigma_s2 (d - d_2),
    A_s f_yd = F_c + A_s2 sigma_s2

Plane sections and no tension in the concrete (6.1(2)), the rectangular stress block of 3.1.7(3) with eps_cu3 at the
compressed face, steel with a horizontal top branch and no limit of its strain (3.2.7(2)b), no normal force. Concrete
that compressed bars displace is not deducted.

The neutral axis is kept above x / d = 0.45 for f_ck <= 50 MPa and 0.35 beyond (5.6.3(2)), unless another limit is
given: 5.5(4), for one, gives 0.448 without redistribution for f_ck <= 50 MPa. It is never allowed below the depth at
which the bars in tension just yield. Where that is not enough, bars in compression take the rest of the moment; links
must hold them (9.2.1.2(3)).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.design_moments import DesignMoments
from groundslab.design.en1992.materials import Concrete, Steel
from groundslab.errors import InputError, Issue

_MPA = 1e6
#: A_s / A_c that no slab may exceed outside laps (EN 1992-1-1 9.2.1.1(3), by 9.3.1.1(1)).
_MOST = 0.04


@dataclass(frozen=True, slots=True)
class Reinforcement:
    """What sections (n,) need: areas [m2/m], and the neutral axis x / d.

    ``tension`` and ``compression`` balance the moment, ``minimum`` is what 9.2.1.1(1) asks for where there is a
    moment. Where the concrete section is too weak for any reinforcement, ``tension``, ``compression`` and
    ``neutral_axis`` are inf.
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

    ``links`` (n,) is true where bars in compression are counted, which links must hold (EN 1992-1-1 9.2.1.2(3)).
    """

    bottom_x: Array
    bottom_y: Array
    top_x: Array
    top_y: Array
    links: Flags


def deepest_axis(concrete: Concrete, steel: Steel, xi_lim: float | None = None) -> float:
    """Return the largest x / d: xi_lim, by default that of EN 1992-1-1 5.6.3(2), or less, so that the steel yields."""
    if xi_lim is None:
        xi_lim = 0.45 if concrete.f_ck <= 50 * _MPA else 0.35
    yields = concrete.eps_cu3 / (concrete.eps_cu3 + steel.f_yd / steel.E_s)
    return min(xi_lim, yields)


def required(
    m: Array,
    d: Array | float,
    concrete: Concrete,
    steel: Steel,
    *,
    d_2: Array | float | None = None,
    thickness: Array | float | None = None,
    xi_lim: float | None = None,
) -> Reinforcement:
    """Return what sections need for moments m >= 0 (n,) [N m/m] with effective depths d (n,) or one [m].

    d_2 (n,) or one [m] is the distance of bars in compression from the compressed face; without it there are none.
    With the thickness (n,) or one [m] no layer may have more than 0.04 A_c (EN 1992-1-1 9.2.1.1(3)). inf where the
    neutral axis would have to pass its limit and there are no bars in compression, or where these lie no higher than
    the neutral axis, or where a layer would have too much. Sources: EN 1992-1-1 3.1.7(3), 3.2.7(2), 6.1(2), 9.3.1.1.
    """
    m, d = np.broadcast_arrays(np.asarray(m, dtype=float), np.asarray(d, dtype=float))
    _check(m, d, d_2, xi_lim)
    xi = deepest_axis(concrete, steel, xi_lim)
    block, f_yd = concrete.eta * concrete.f_cd, steel.f_yd
    m_lim = _moment(concrete.lam * xi) * block * d**2
    beyond = m > m_lim
    # mu = omega (1 - omega / 2) with omega = lambda x / d, solved without loss of digits for small mu
    mu = np.minimum(m, m_lim) / (block * d**2)
    omega = 2 * mu / (1 + np.sqrt(1 - 2 * mu))
    axis = np.where(beyond, xi, np.minimum(omega / concrete.lam, xi))
    tension, compression = omega * block * d / f_yd, np.zeros(m.shape)
    fails = beyond.copy()
    if d_2 is not None:
        strain = concrete.eps_cu3 * (1 - np.asarray(d_2, dtype=float) / (xi * d))
        stress = np.minimum(strain * steel.E_s, f_yd)
        fails = beyond & (stress <= 0)
        force = np.where(beyond & ~fails, (m - m_lim) / (d - d_2), 0.0)
        compression = np.divide(force, stress, out=np.zeros(m.shape), where=force > 0)
        tension = tension + force / f_yd
    if thickness is not None:
        fails = fails | (np.maximum(tension, compression) > _MOST * np.asarray(thickness, dtype=float))
    tension, compression, axis = (np.where(fails, np.inf, each) for each in (tension, compression, axis))
    return Reinforcement(tension, compression, axis, np.where(m > 0, minimum(d, concrete, steel), 0.0))


def minimum(d: Array, concrete: Concrete, steel: Steel) -> Array:
    """Return the least area of bars in tension (n,) [m2/m] for depths d (n,) [m], by EN 1992-1-1 9.2.1.1(1)."""
    return max(0.26 * concrete.f_ctm / steel.f_yk, 0.0013) * np.asarray(d, dtype=float)


def slab(
    moments: DesignMoments,
    thickness: Array | float,
    axes: Axes,
    concrete: Concrete,
    steel: Steel,
    *,
    xi_lim: float | None = None,
) -> SlabReinforcement:
    """Return the four layers for design moments (n,) of a slab of thickness (n,) or one [m], by ``required``.

    Bars of the other face in the same direction serve as bars in compression. A layer has what its own moment needs in
    tension, at least the minimum, or what the other face's moment needs in compression, whichever is more.
    """
    t = np.asarray(thickness, dtype=float)

    def direction(bottom: Array, top: Array, low: float, high: float) -> tuple[Array, Array, Flags]:
        below = required(bottom, t - low, concrete, steel, d_2=high, thickness=t, xi_lim=xi_lim)
        above = required(-top, t - high, concrete, steel, d_2=low, thickness=t, xi_lim=xi_lim)
        links = (below.compression > 0) | (above.compression > 0)
        return np.maximum(below.area, above.compression), np.maximum(above.area, below.compression), links

    bottom_x, top_x, links_x = direction(moments.bottom_x, moments.top_x, axes.bottom_x, axes.top_x)
    bottom_y, top_y, links_y = direction(moments.bottom_y, moments.top_y, axes.bottom_y, axes.top_y)
    return SlabReinforcement(bottom_x, bottom_y, top_x, top_y, links_x | links_y)


def _moment(omega: float) -> float:
    """Return m / (eta f_cd d^2) of a block of depth omega d."""
    return omega * (1 - omega / 2)


def _check(m: Array, d: Array, d_2: Array | float | None, xi_lim: float | None) -> None:
    """Refuse moments, depths and limits that mean nothing."""
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
    if xi_lim is not None and not 0 < xi_lim < 1:
        issues.append(Issue("xi_lim", f"{xi_lim:g}", "a limit of x / d between 0 and 1"))
    if issues:
        raise InputError(issues)
