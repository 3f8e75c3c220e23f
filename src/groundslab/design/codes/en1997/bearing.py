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
    from shapely.geometry.base import BaseGeometry


#: The most that resists sliding of an undrained soil, over the vertical force (6.5 of 6.5.3(12)).
MOST_UNDRAINED = 0.4
#: The largest eccentricity without special precautions, over the way from the center to the edge (6.5.4(1)).
MOST_ECCENTRIC = {"rectangle": 2 / 3, "other": 0.6}
#: An eccentricity below this share of the base's size is none; areas whose shares differ by less are the same.
NO_ECCENTRICITY, SAME_AREA = 1e-9, 1e-6
#: The formulas of the functions here, with forces in MN, stresses in MPa, lengths in m and angles in radians.
FORMULAS = {
    "N_q": "exp(pi * tan(phi)) * tan(pi / 4 + phi / 2)^2",
    "N_c": "(N_q - 1) / tan(phi)",
    "N_gamma": "2 * (N_q - 1) * tan(phi)",
    "s_q": "1 + B' / L' * sin(phi)",
    "s_c": "(s_q * N_q - 1) / (N_q - 1)",
    "s_gamma": "1 - 0.3 * B' / L'",
    "m": "(2 + B' / L') / (1 + B' / L')",
    "i_q": "(1 - H / (V + A' * c / tan(phi)))^m",
    "i_c": "i_q - (1 - i_q) / (N_c * tan(phi))",
    "i_gamma": "(1 - H / (V + A' * c / tan(phi)))^(m + 1)",
    "R": "A' * (c * N_c * s_c * i_c + q * N_q * s_q * i_q + 0.5 * gamma * B' * N_gamma * s_gamma * i_gamma)",
    "s_c undrained": "1 + 0.2 * B' / L'",
    "i_c undrained": "(1 + sqrt(1 - H / (A' * c_u))) / 2",
    "R undrained": "A' * ((pi + 2) * c_u * s_c * i_c + q)",
    "sliding": "V * tan(delta) / gamma_Rh",
    "sliding undrained": f"min(A' * c_u / gamma_Rh, {MOST_UNDRAINED:g} * V)",
}


@dataclass(frozen=True, slots=True)
class EffectiveArea:
    """The effective area A' [m2] with its sides B' <= L' [m], and the openings that it is without [m2].

    An opening takes off itself and its image about the resultant, as far as both lie inside.
    """

    area: float
    width: float
    length: float
    openings: float = 0.0


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
    common = _turned_into_itself(outline, x, y)
    if common.area <= 0:
        return None
    corners = list(common.minimum_rotated_rectangle.exterior.coords)
    sides = sorted(math.dist(corners[i], corners[i + 1]) for i in range(2))
    slenderness = sides[1] / sides[0]
    width = math.sqrt(common.area / slenderness)
    openings = _turned_into_itself(_filled(outline), x, y).area - common.area
    counts = openings > SAME_AREA * common.area
    return EffectiveArea(common.area, width, width * slenderness, openings if counts else 0.0)


def _turned_into_itself(outline: Polygon | MultiPolygon, x: float, y: float) -> BaseGeometry:
    """Return the part of a base that half a turn about x, y [m] turns into itself."""
    from shapely import affinity

    return outline.intersection(affinity.rotate(outline, 180, origin=(x, y)))


def _filled(outline: Polygon | MultiPolygon) -> BaseGeometry:
    """Return a base without its openings."""
    from shapely import Polygon, get_parts, union_all

    return union_all([Polygon(part.exterior) for part in get_parts(outline)])


@dataclass(frozen=True, slots=True)
class DrainedFactors:
    """Factors of bearing capacity N, of the base's shape s and of the load's inclination i (annex D.4).

    The second letters are q for the overburden, c for cohesion and gamma for the soil's weight.
    """

    N_q: float
    N_c: float
    N_gamma: float
    s_q: float
    s_c: float
    s_gamma: float
    m: float  # exponent of the inclination, for a force along the shorter side
    i_q: float
    i_c: float
    i_gamma: float


def drained_factors(base: EffectiveArea, soil: Soil, V: float, H: float) -> DrainedFactors | None:
    """Return the factors of a drained soil under V and H [N], None if the base slides before (annex D.4)."""
    ratio = base.width / base.length
    tan = math.tan(soil.phi)
    N_q = math.exp(math.pi * tan) * math.tan(math.pi / 4 + soil.phi / 2) ** 2
    N_c = (N_q - 1) / tan
    s_q = 1 + ratio * math.sin(soil.phi)
    held = V + base.area * soil.c / tan
    if held <= H:
        return None
    m = (2 + ratio) / (1 + ratio)
    i_q = (1 - H / held) ** m
    return DrainedFactors(
        N_q=N_q,
        N_c=N_c,
        N_gamma=2 * (N_q - 1) * tan,
        s_q=s_q,
        s_c=(s_q * N_q - 1) / (N_q - 1),
        s_gamma=1 - 0.3 * ratio,
        m=m,
        i_q=i_q,
        i_c=i_q - (1 - i_q) / (N_c * tan),
        i_gamma=(1 - H / held) ** (m + 1),
    )


def eccentricity(base: Polygon | MultiPolygon, x: float, y: float) -> tuple[float, float, float]:
    """Return the eccentricity of a resultant at x, y [m], the base's edge in its direction [m], and what share may be.

    The share is that of a rectangle, 1/3 of its width being 2/3 of the way from its center, else that of a circle, 0.6
    of its radius (EN 1997-1 6.5.4(1)). The edge is that of the base without its notches.
    """
    from shapely import LineString, Point

    center, hull = base.centroid, base.convex_hull
    most = MOST_ECCENTRIC["rectangle" if _is_rectangle(base) else "other"]
    e = math.hypot(x - center.x, y - center.y)
    far = 2 * hull.length
    if e <= far * NO_ECCENTRICITY:
        return 0.0, hull.exterior.distance(center), most
    end = center.x + (x - center.x) / e * far, center.y + (y - center.y) / e * far
    edge = hull.exterior.intersection(LineString([(center.x, center.y), end]))
    return e, float(edge.distance(Point(center.x, center.y))), most


def _is_rectangle(base: Polygon | MultiPolygon) -> bool:
    """Return whether a base is a rectangle."""
    around = base.minimum_rotated_rectangle.area
    return bool(around - base.area <= SAME_AREA * around)


def bearing_resistance(base: EffectiveArea, soil: Soil, V: float, H: float) -> float:
    """Return the resistance R [N] of a horizontal base under V and H [N] (annex D.3 and D.4).

    H acts along the shorter side, which is the less favourable one. Zero if the base slides before.
    """
    if soil.c_u is not None:
        return _undrained(base, soil.c_u, soil.overburden, H)
    f = drained_factors(base, soil, V, H)
    if f is None:
        return 0.0
    pressure = (
        soil.c * f.N_c * f.s_c * f.i_c
        + soil.overburden * f.N_q * f.s_q * f.i_q
        + 0.5 * soil.unit_weight * base.width * f.N_gamma * f.s_gamma * f.i_gamma
    )
    return float(base.area * pressure)


def _undrained(base: EffectiveArea, c_u: float, overburden: float, H: float) -> float:
    """Return the resistance [N] of an undrained soil (annex D.3)."""
    if base.area * c_u < H:
        return 0.0
    s_c, i_c = undrained_factors(base, c_u, H)
    return base.area * ((math.pi + 2) * c_u * s_c * i_c + overburden)


def undrained_factors(base: EffectiveArea, c_u: float, H: float) -> tuple[float, float]:
    """Return s_c and i_c of an undrained soil under H [N], at most A' c_u (annex D.3)."""
    return 1 + 0.2 * base.width / base.length, (1 + math.sqrt(1 - H / (base.area * c_u))) / 2


def sliding_resistance(base: EffectiveArea, c_u: float | None, delta: float, V: float, gamma_Rh: float = 1.0) -> float:
    """Return the design resistance [N] against sliding, V tan delta drained, A' c_u undrained, over gamma_R;h.

    In an undrained soil it is at most 0.4 V, as a gap between base and soil is not known to be prevented by suction
    (EN 1997-1 6.3a, 6.4a, 6.5 of 6.5.3).
    """
    if c_u is None:
        return V * math.tan(delta) / gamma_Rh
    return min(base.area * c_u / gamma_Rh, MOST_UNDRAINED * V)
