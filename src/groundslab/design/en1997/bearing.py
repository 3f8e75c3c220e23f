"""Bearing resistance and sliding of spread foundations by EN 1997-1, annex D and 6.5.

Vertical resistance over the effective area, which is the largest part of the base that the resultant is in the middle
of. For a base that is no rectangle it is the part that turns into itself about the resultant, and its sides are those
of a rectangle of the same area and the same slenderness.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon


@dataclass(frozen=True, slots=True)
class EffectiveArea:
    """The effective area A' [m2] with its sides B' <= L' [m]."""

    area: float
    width: float
    length: float


@dataclass(frozen=True, slots=True)
class Soil:
    """Design values of the soil below the base.

    Attributes
    ----------
    phi : float
        Angle of shearing resistance [rad], drained.
    c : float
        Effective cohesion, drained [Pa].
    c_u : float or None
        Undrained shear strength [Pa]; None if the soil is drained.
    unit_weight : float
        Effective unit weight below the base [N/m3].
    overburden : float
        Pressure beside the base at its level [Pa], effective if drained, total if undrained.
    """

    phi: float
    c: float
    c_u: float | None
    unit_weight: float
    overburden: float


def effective_area(outline: Polygon | MultiPolygon, x: float, y: float) -> EffectiveArea | None:
    """Return the effective area of a base for a resultant at x, y [m], None if that lies beside it (annex D.2)."""
    from shapely import affinity

    common = outline.intersection(affinity.rotate(outline, 180, origin=(x, y)))
    if common.area <= 0:
        return None
    corners = list(common.minimum_rotated_rectangle.exterior.coords)
    sides = sorted(math.dist(corners[i], corners[i + 1]) for i in range(2))
    slenderness = sides[1] / sides[0]
    width = math.sqrt(common.area / slenderness)
    return EffectiveArea(common.area, width, width * slenderness)


def bearing_resistance(base: EffectiveArea, soil: Soil, V: float, H: float) -> float:
    """Return the resistance R [N] of a horizontal base under V and H [N] (annex D.3 and D.4).

    H acts along the shorter side, which is the less favourable one. Zero if the base slides before.
    """
    if soil.c_u is not None:
        return _undrained(base, soil.c_u, soil.overburden, H)
    ratio = base.width / base.length
    tan = math.tan(soil.phi)
    N_q = math.exp(math.pi * tan) * math.tan(math.pi / 4 + soil.phi / 2) ** 2
    N_gamma = 2 * (N_q - 1) * tan
    s_q, s_gamma = 1 + ratio * math.sin(soil.phi), 1 - 0.3 * ratio
    s_c = (s_q * N_q - 1) / (N_q - 1)
    N_c = (N_q - 1) / tan
    held = V + base.area * soil.c / tan
    if held <= H:
        return 0.0
    m = (2 + ratio) / (1 + ratio)
    i_q, i_gamma = (1 - H / held) ** m, (1 - H / held) ** (m + 1)
    i_c = i_q - (1 - i_q) / (N_c * tan)
    pressure = (
        soil.c * N_c * s_c * i_c
        + soil.overburden * N_q * s_q * i_q
        + 0.5 * soil.unit_weight * base.width * N_gamma * s_gamma * i_gamma
    )
    return float(base.area * pressure)


def _undrained(base: EffectiveArea, c_u: float, overburden: float, H: float) -> float:
    """Return the resistance [N] of an undrained soil (annex D.3)."""
    if base.area * c_u < H:
        return 0.0
    i_c = (1 + math.sqrt(1 - H / (base.area * c_u))) / 2
    return base.area * ((math.pi + 2) * c_u * (1 + 0.2 * base.width / base.length) * i_c + overburden)


def sliding_resistance(base: EffectiveArea, c_u: float | None, delta: float, V: float) -> float:
    """Return the resistance [N] against sliding: V tan delta drained, A' c_u undrained (6.3a, 6.4a of 6.5.3)."""
    return V * math.tan(delta) if c_u is None else base.area * c_u
