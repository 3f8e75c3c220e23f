"""Bending stiffness of reinforced concrete slabs, uncracked, cracked and between, by EN 1992-1-1 7.4.3.

    alpha = zeta alpha_II + (1 - zeta) alpha_I                                                     7.18
    zeta = 1 - beta (M_cr / M)^2, 0 of an uncracked section                                        7.19
    E_c,eff = E_cm / (1 + phi)                                                                     7.20
    1 / r_cs = eps_cs alpha_e S / I                                                                7.21

A section has bars along x and y at both faces. In either direction it bends as a beam with the stiffness B = E_c,eff I:
B_I of concrete and bars, uncracked; B_II of bars and compressed concrete. Between the directions act Poisson's ratio,
by the compliance of the uncracked slab, and the twisting stiffness of orthotropic slabs, which follows the geometric
mean of both directions (Timoshenko and Woinowsky-Krieger 1959, after Huber). See docs/theory.md, cracked stiffness.

Axes of arrays: sections or elements, then the direction (x, y), then the face in tension (bottom, top). Sagging moments
and curvatures are positive.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array

#: Newton's steps to the moment at a curvature: far more than digits need.
NEWTON_STEPS = 25


@dataclass(frozen=True, slots=True)
class CrackedSections:
    """How sections (k,), of elements for one, bend in each direction with tension at either face."""

    B_I: Array  # (k, 2) [N m2/m]: uncracked
    B_II: Array  # (k, 2, 2) [N m2/m]: cracked
    M_cr: Array  # (k, 2, 2) [N m/m]: moment that cracks the face
    shrinkage_I: Array  # (k, 2) [1/m]: sagging that shrinkage causes, uncracked
    shrinkage: Array  # (k, 2, 2) [1/m]: how much more it bends the cracked section towards its face in tension, >= 0
    nu: Array  # (k,): Poisson's ratio, uncracked
    shear: Array  # (k,) [N/m]: shear rigidity
    beta: Array  # (k,): duration of the loads in 7.19

    @property
    def least(self) -> Array:
        """Return a stiffness that no section falls below, (k, 2) [N m2/m]."""
        by_face = 1 / (1 / self.B_II + self.shrinkage / self.M_cr)
        least: Array = np.minimum(by_face.min(axis=2), self.B_I)
        return least

    @property
    def curve(self) -> tuple[Array, ...]:
        """Return B_I, B_II, M_cr, beta and the curvature by shrinkage, as arrays of both directions and faces."""
        return self.B_I[..., None], self.B_II, self.M_cr, self.beta[:, None, None], self.shrinkage


@dataclass(frozen=True, slots=True)
class Bars:
    """Bars at the bottom and at the top of sections, in one direction."""

    area: tuple[Array | float, Array | float]  # [m2/m]: (k,), or of all sections
    distance: tuple[float, float]  # [m]: from the face at which they lie


def uncracked_section(h: Array, bars: Bars, n: Array) -> tuple[Array, Array, Array]:
    """Return centroid z [m] from the top, second moment of area I [m3] and that of first order S [m2] of the bars.

    h (k,) [m] is the thickness, n (k,) the modular ratio E_s / E_c,eff: area is that of concrete, bars count n times.
    S is that of the bars alone, about z, positive where they weigh at the bottom.
    """
    below, above = bars.area
    low, high = h - bars.distance[0], bars.distance[1]
    z = (h**2 / 2 + (n - 1) * (below * low + above * high)) / (h + (n - 1) * (below + above))
    second = h**3 / 12 + h * (h / 2 - z) ** 2 + (n - 1) * (below * (low - z) ** 2 + above * (z - high) ** 2)
    return z, second, below * (low - z) - above * (z - high)


def cracked_section(h: Array, bars: Bars, n: Array, top: bool) -> tuple[Array, Array, Array]:
    """Return the compressed depth x [m], I [m3] and S [m2] with tension at one face, which concrete does not resist.

    x solves x^2 / 2 + m A_s2 (x - d_2) = n A_s (d - x); bars at the other face count m = n - 1 times where they lie in
    compressed concrete, else n times. S is positive towards the face in tension.
    """
    area, other = bars.area[::-1] if top else bars.area
    near, far = bars.distance[::-1] if top else bars.distance
    d = h - near

    def depth(m: Array) -> Array:
        both = n * area + m * other
        return np.sqrt(both**2 + 2 * (n * area * d + m * other * far)) - both

    compressed = depth(n - 1) > far
    m = np.where(compressed, n - 1, n)
    x = depth(m)
    second = x**3 / 3 + n * area * (d - x) ** 2 + m * other * (x - far) ** 2
    return x, second, area * (d - x) - other * (x - far)


def effective_stiffness(M: Array, B_I: Array, B_II: Array, M_cr: Array, beta: Array, shrinkage: Array) -> Array:
    """Return the stiffness B under moments M >= 0, by 7.18 and 7.19.

    M / B is the curvature beyond that by shrinkage of the uncracked section; the cracked one has more by shrinkage.
    """
    above = np.maximum(M, M_cr)
    zeta = np.where(M_cr < M, 1 - beta * (M_cr / above) ** 2, 0.0)
    return 1 / (zeta * (1 / B_II + shrinkage / above) + (1 - zeta) / B_I)


def resisted_moment(chi: Array, B_I: Array, B_II: Array, M_cr: Array, beta: Array, shrinkage: Array) -> Array:
    """Return the moment M at a curvature chi >= 0: the inverse of 7.18 and 7.19, which exists as chi grows with M.

    Where beta is below 1 the curvature jumps as the section cracks; between, it bends under M_cr.
    """
    c = beta * M_cr**2
    linear = c * (1 / B_II - 1 / B_I)
    # chi = M / B_II + shrinkage - linear / M - c shrinkage / M^2 is concave in M: Newton's steps rise to its root
    M = np.maximum(M_cr, B_II * (chi - shrinkage))
    for _ in range(NEWTON_STEPS):
        off = M / B_II + shrinkage - linear / M - c * shrinkage / M**2 - chi
        M = np.maximum(M - off / (1 / B_II + linear / M**2 + 2 * c * shrinkage / M**3), M_cr)
    return np.where(B_I * chi <= M_cr, B_I * chi, M)


def decisive_moments(m: Array) -> Array:
    """Return the moments M >= 0 (k, 2, 2) that crack sections, from m_x, m_y and m_xy (k, 3).

    For bars along x it is m_x + |m_xy| at the bottom and |m_xy| - m_x at the top (Wood 1968), yet no more than the
    larger principal moment there: no direction of the concrete is stressed by more.
    """
    x, y, xy = m.T
    middle, radius, twist = (x + y) / 2, np.hypot((x - y) / 2, xy), np.abs(xy)
    bottom = np.minimum(np.stack([x + twist, y + twist]), middle + radius)
    top = np.minimum(np.stack([twist - x, twist - y]), radius - middle)
    M: Array = np.maximum(np.stack([bottom, top]), 0.0).transpose(2, 1, 0)
    return M


def secant_stiffness(law: CrackedSections, B: Array, m: Array) -> tuple[Array, Array]:
    """Return the stiffness (k, 2) by the law at the curvatures M / B of moments m (k, 3), and M (k, 2).

    B (k, 2) is the stiffness with which the moments were found; where both agree it satisfies the law. Of both faces
    the softer one counts, and its moment.
    """
    M = decisive_moments(m)
    chi = M / B[..., None]
    resisted = resisted_moment(chi, *law.curve)
    secant = np.divide(resisted, chi, out=np.broadcast_to(law.B_I[..., None], M.shape).copy(), where=chi > 0)
    face = np.argmin(secant, axis=2)[..., None]
    secant, M = (np.take_along_axis(values, face, axis=2)[..., 0] for values in (secant, M))
    return secant, M


def law_error(secant: Array, M: Array, B: Array) -> float:
    """Return by how much moments (k, 2) are off those that the law gives for their curvatures, over the largest."""
    largest = float(M.max(initial=0.0))
    return float((np.abs(secant / B - 1) * M).max() / largest) if largest else 0.0


def orthotropic_rigidity(B: Array, B_I: Array, nu: Array) -> Array:
    """Return the rigidities (k, 3, 3) [N m] of slabs with the stiffnesses B (k, 2), uncracked B_I (k, 2).

    Their inverse is 1 / B_x, 1 / B_y, -nu / B_0 between both, and 2 / sqrt(B_x B_y) + 2 nu / B_0 of twisting, with
    B_0 = sqrt(B_Ix B_Iy): an isotropic slab where both directions are alike, of D = B / (1 - nu^2) if uncracked.
    Poisson's ratio is thus nu sqrt(B_x B_y) / B_0 and falls with cracking.
    """
    across = nu / np.sqrt(B_I.prod(axis=1))
    (x, y), determinant = 1 / B.T, 1 / B.prod(axis=1) - across**2
    D = np.zeros((len(B), 3, 3))
    D[:, 0, 0], D[:, 1, 1] = y / determinant, x / determinant
    D[:, 0, 1] = D[:, 1, 0] = across / determinant
    D[:, 2, 2] = 1 / (2 * (np.sqrt(x * y) + across))
    return D


#: Modulus of reinforcing steel [Pa], EN 1992-1-1 3.2.7(4).
STEEL_MODULUS = 200e9


def mean_tensile_strength(f_ck: float) -> float:
    """Return f_ctm [Pa] of concrete with the characteristic strength f_ck [Pa], EN 1992-1-1 Table 3.1."""
    f = f_ck / 1e6
    return (0.30 * f ** (2 / 3) if f <= 50 else 2.12 * math.log(1 + (f + 8) / 10)) * 1e6
