"""Line loads and loads beside aisles on a long strip of slab on springs (Hetenyi 1946), as TR34 and PCA have them.

With lambda = (3 k / (E h^3))^(1/4) the moment of a line load P is P / (4 lambda) under it. That of a pressure q on both
sides of an aisle pi / (2 lambda) wide, each pi / lambda wide, is q (B(pi/4) - B(5 pi/4)) / (2 lambda^2) over the
aisle's middle, B(x) = e^-x sin x; no aisle has a larger one. TR34 has 4 lambda M, 3 lambda M at an edge and
5.95 lambda^2 M for the loads.
"""

from __future__ import annotations

import math

#: A line load nearer to an edge than so much over lambda is one at the edge, whose strip does not go on.
NEAR_EDGE = 2.0
#: Moments of a line load inside and at an edge, over P / lambda: 1 / 4, and 1 / 3 as TR34 has it for 0.3224.
INSIDE, AT_EDGE = 1 / 4, 1 / 3
#: The formulas of the functions here, with forces in MN, stresses in MPa and lengths in m.
FORMULAS = {
    "lambda": "(3 * k / (E * h^3))^(1/4)",
    "inside": f"{1 / INSIDE:g} * lambda * M_n",
    "at_edge": f"{1 / AT_EDGE:g} * lambda * M_n",
    "aisle": "2 * lambda^2 * M_n / (sin(pi / 4) / exp(pi / 4) - sin(5 * pi / 4) / exp(5 * pi / 4))",
}


def characteristic(E: float, h: float, k: float) -> float:
    """Return lambda [1/m] of a strip of thickness h [m] on springs k [Pa/m]."""
    return float((3 * k / (E * h**3)) ** 0.25)


def line_load(M: float, lam: float, at_edge: bool) -> float:
    """Return the line load [N/m] with the largest moment M [N m/m]."""
    return M * lam / (AT_EDGE if at_edge else INSIDE)


def aisle_load(M: float, lam: float) -> float:
    """Return the pressure [Pa] beside the worst aisle with the moment M [N m/m] at its top."""
    return 2 * lam**2 * M / (_shape(math.pi / 4) - _shape(5 * math.pi / 4))


def _shape(x: float) -> float:
    """Return Hetenyi's B."""
    return math.exp(-x) * math.sin(x)
