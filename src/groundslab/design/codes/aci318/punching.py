"""Two-way shear by ACI 318-19 22.6 and the transfer of moments by shear, 8.4.4.2; stresses, f'c in MPa.

    v_c = min(0.33, 0.166 (1 + 2 / beta), 0.083 (2 + alpha_s d / b_o)) lambda_s (f'c)^(1/2)           Table 22.6.5.2
    v_c = 0.166 lambda_s (f'c)^(1/2), v_u <= phi 0.498 (f'c)^(1/2)           with stirrups, 22.6.6.1, 22.6.6.3
    A_v / s = (v_u / phi - v_c) b_o / f_yt                                               22.6.7.2
    v_u = V_u / (b_o d) + gamma_v M_sc c / J_c,  gamma_v = 1 - 1 / (1 + 2/3 (b_1 / b_2)^(1/2))     8.4.4.2, 8.4.2.2.2

on the critical section at d / 2 from the column, of straight sides around a rectangular one (22.6.4.1), without the
part between the tangents to openings (22.6.4.3). Centroid and J_c are those of what is left. J_c is that of the sides,
d int e^2 dl + d^3 / 12 int cos^2 dl, as in the commentary R8.4.4.2.3, about principal axes, on which it has no mixed
term; moments about both count at once. b_1, along the eccentricity, and b_2 are extents of the whole section.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.aci318.materials import PHI_SHEAR, Concrete, Steel
from groundslab.design.demands.line_properties import centroid, directions, second_moments, total_length

#: The formulas of the functions here, with forces in MN, stresses in MPa and lengths in m.
FORMULAS = {
    "gamma_v1": "1 - 1 / (1 + 2 / 3 * sqrt(b_1 / b_2))",
    "gamma_v2": "1 - 1 / (1 + 2 / 3 * sqrt(b_2 / b_1))",
    "v_u": "V_u / (b_o * d) + gamma_v1 * M_1 * c_1 / J_1 + gamma_v2 * M_2 * c_2 / J_2",
    "J_n": "d * I_n + d^3 / 12 * l_n",
    "v_c": "min(0.33, 0.166 * (1 + 2 / beta), 0.083 * (2 + alpha_s * d / b_o)) * lambda_s * r",
    "v_max": "0.498 * r",
    "v_cs (s)": "min(0.25, 0.166 * (1 + 2 / beta), 0.083 * (2 + alpha_s * d / b_o)) * lambda_s * r",
    "v_max (s)": "0.66 * r",
    "v_s": "A_v / 10000 * f_yt / (b_o * s)",
    "v_n": "min(v_cs + v_s, v_max)",
    "v_cs": "0.166 * lambda_s * r",
    "A_v / s": "(v_u / phi - v_cs) * b_o / f_yt * 10000",
}
#: alpha_s of columns inside, at an edge and at a corner (22.6.5.3), by how the critical section runs.
ALPHA_S = {"closed": 40.0, "edge": 30.0, "corner": 20.0}
#: A slab with stirrups as shear reinforcement is at least so deep [m] (22.6.7.1).
LEAST_DEPTH = 0.1524
#: Stirrups of a slab are no farther apart, and from the face, than this over the effective depth (8.7.6.3).
STIRRUP_SPACING = 0.5
#: A mixed term of J_c is none below this share of the whole.
MIXED = 1e-9


def without_links(concrete: Concrete, d: float, b_o: float, beta: float, alpha_s: float) -> float:
    """Return v_c [Pa] of a critical section b_o [m] long and d [m] deep.

    beta is the long side of the column over the short one, of a round column 1.
    """
    factor = min(0.33, 0.166 * (1 + 2 / beta), 0.083 * (2 + alpha_s * d / b_o))
    return factor * concrete.lambda_s(d) * concrete.root


def most_with_links(concrete: Concrete) -> float:
    """Return the largest nominal stress [Pa] that stirrups can make of it, 22.6.6.3."""
    return 0.498 * concrete.root


def with_links(concrete: Concrete, d: float) -> float:
    """Return v_c [Pa] where there are stirrups, and at the section beyond them (Table 22.6.6.1)."""
    return 0.166 * concrete.lambda_s(d) * concrete.root


def with_studs(concrete: Concrete, d: float, b_o: float, beta: float, alpha_s: float) -> float:
    """Return v_c [Pa] where there are headed studs (Table 22.6.6.1)."""
    factor = min(0.25, 0.166 * (1 + 2 / beta), 0.083 * (2 + alpha_s * d / b_o))
    return factor * concrete.lambda_s(d) * concrete.root


def most_with_studs(concrete: Concrete) -> float:
    """Return the largest nominal stress [Pa] that headed studs can make of it, 22.6.6.3."""
    return 0.66 * concrete.root


def least_studs(s: float, b_o: float, concrete: Concrete, steel: Steel) -> float:
    """Return the least area [m2] of headed studs on each perimeter, s apart [m], 22.6.8.3."""
    return 0.17 * concrete.root * b_o * s / steel.f_yt


def of_links(A_v: float, s: float, b_o: float, steel: Steel) -> float:
    """Return v_s [Pa] of perimeters of links or studs s apart [m], A_v [m2] each (22.6.7.2, 22.6.8.2)."""
    return A_v * steel.f_yt / (b_o * s)


def links(v_u: float, d: float, b_o: float, concrete: Concrete, steel: Steel) -> float:
    """Return A_v / s [m2/m] of stirrups on all sides of the critical section for a factored stress v_u [Pa]."""
    return max(0.0, (v_u / PHI_SHEAR - with_links(concrete, d)) * b_o / steel.f_yt)


def gamma_v(b_1: float, b_2: float) -> float:
    """Return the share of a moment that shear transfers, of a section b_1 along its eccentricity, b_2 across."""
    return 1 - 1 / (1 + 2 / 3 * math.sqrt(b_1 / b_2))


def polar_moments(legs: Array, center: Array, d: float) -> Array:
    """Return J_c (2, 2) [m4] of the sides (l, 2, 2) of a critical section about a center (2,) [m].

    On its diagonal are those for e along x and along y, beside it the mixed term, which principal axes do not have.
    """
    return d * second_moments(legs, center) + d**3 / 12 * directions(legs)


def principal_axes(J: Array, axes: Array) -> Array:
    """Return the principal axes (2, 2) of J_c (2, 2), a unit vector in each row; given axes (2, 2) if they are."""
    if abs(axes[0] @ J @ axes[1]) <= MIXED * np.trace(J):
        return axes
    return np.asarray(np.linalg.eigh(J)[1].T)


@dataclass(frozen=True, slots=True)
class Transfer:
    """What makes the largest v_u on a critical section, about its principal axes."""

    V_u: float  # [N]
    area: float  # b_o d [m2]
    extents: Array  # (2,): b along both axes, of the whole section [m]
    shares: Array  # (2,): gamma_v of the moments of forces along both
    moments: Array  # (2,) [N m]
    J: Array  # (2,) [m4]
    places: Array  # (2,): where v_u is largest, from the centroid [m]
    axes: Array  # (2, 2): unit vectors of both
    second: Array  # (2,): int e^2 dl of the sides [m3]
    lengths: Array  # (2,): int cos^2 dl of the sides [m]
    mixed: tuple[float, float] = (0.0, 0.0)  # int e_1 e_2 dl [m3] and int cos_1 cos_2 dl [m] of the sides
    turned: bool = False  # whether the axes are the principal ones, and not those of the column

    @property
    def v_u(self) -> float:
        """Return v_u [Pa]."""
        return float(self.V_u / self.area + (self.shares * self.moments * self.places / self.J).sum())


def stress(V_u: float, moments: Array, legs: Array, d: float, whole: Array | None = None) -> float:
    """Return the largest v_u [Pa] on the sides of a critical section, see `transfer`."""
    return transfer(V_u, moments, legs, d, whole).v_u


def transfer(
    V_u: float, moments: Array, legs: Array, d: float, whole: Array | None = None, axes: Array | None = None
) -> Transfer:
    """Return the shear force and the moments that shear transfers where v_u is largest on a critical section.

    Parameters
    ----------
    V_u : float
        Shear force [N].
    moments : (2,) array of float
        Its moments of forces along x and along y about the sides' centroid [N m].
    legs : (l, 2, 2) array of float
        The sides that count [m].
    d : float
        Effective depth [m].
    whole : (k, 2, 2) array of float, optional
        All sides, those that openings take off, too [m]; by default those that count.
    axes : (2, 2) array of float, optional
        Unit vectors of the column's own axes; by default x and y.
    """
    center = centroid(legs)
    J = polar_moments(legs, center, d)
    column_axes = np.eye(2) if axes is None else axes
    axes = principal_axes(J, column_axes)
    b_1, b_2 = np.ptp((legs if whole is None else whole).reshape(-1, 2) @ axes.T, axis=0)
    shares = np.array([gamma_v(b_1, b_2), gamma_v(b_2, b_1)])
    places = (legs.reshape(-1, 2) - center) @ axes.T
    along, J_c = axes @ moments, np.diag(axes @ J @ axes.T)
    worst = places[np.argmax(places @ (shares * along / J_c))]
    second, lengths = (axes @ tensor @ axes.T for tensor in (second_moments(legs, center), directions(legs)))
    extents, mixed = np.array([b_1, b_2]), (float(second[0, 1]), float(lengths[0, 1]))
    diagonals = np.diag(second), np.diag(lengths)
    area = total_length(legs) * d
    return Transfer(V_u, area, extents, shares, along, J_c, worst, axes, *diagonals, mixed, axes is not column_axes)
