"""Closed-form solutions of plates on springs: circular plates that lift off, strips that curl.

A Mindlin plate on springs k obeys D lap lap w - (D k / S) lap w + k w = q - (D / S) lap q. Solutions of the equation
without load grow as exp(zeta s), zeta = z / l, with l = (D / k)^(1/4) and z^4 - 2 sigma z^2 + 1 = 0, sigma =
sqrt(k D) / 2 S. They are the real parts of a complex function f with lap f = zeta^2 f, whose rotation is
beta = -grad f / z^4 and whose shear force is Q = k l^2 grad f / z^2. For the thin plate sigma = 0 and z^2 = i: f is
made of Kelvin's functions (Timoshenko and Woinowsky-Krieger 1959, section 57) or of products of hyperbolic and
circular functions.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

#: Contact radii of so many plates are kept.
KEPT = 32


@dataclass(frozen=True, slots=True)
class OnSprings:
    """A Mindlin plate on springs: D [N m], S [N/m], Poisson's ratio, k [Pa/m]."""

    D: float
    S: float
    nu: float
    k: float

    @classmethod
    def of(cls, t: float, E: float, nu: float, factor: float, k: float) -> OnSprings:
        """Return the plate of thickness t [m] and modulus E [Pa]; factor = inf makes it a thin plate."""
        plate = cls(E * t**3 / (12 * (1 - nu**2)), factor * E / (2 * (1 + nu)) * t, nu, k)
        if plate.sigma >= 1:
            raise ValueError(f"sqrt(k D) / 2 S must be below 1, not {plate.sigma}")
        return plate

    @property
    def length(self) -> float:
        """Return the elastic length l [m]."""
        return float((self.D / self.k) ** 0.25)

    @property
    def sigma(self) -> float:
        """Return the weight of the shear deformation; 0 for a thin plate."""
        return math.sqrt(self.k * self.D) / (2 * self.S)

    @property
    def zz(self) -> complex:
        """Return z^2, of size 1."""
        return complex(self.sigma, math.sqrt(1 - self.sigma**2))

    def rotation(self, slope: complex) -> float:
        """Return beta [1] from the complex slope f'."""
        return (-slope / self.zz**2).real

    def shear(self, slope: complex) -> float:
        """Return Q [N/m] from the complex slope f'."""
        return (self.k * self.length**2 * slope / self.zz).real

    def bend(self, f: complex) -> float:
        """Return div beta [1/m] from f."""
        return (-f / (self.zz * self.length**2)).real


def lifting_circular_plate(
    r: float, radius: float, b: float, P: float, t: float, E: float, nu: float, factor: float, k: float
) -> dict[str, float]:
    """Return settlement [m], radial moment [N m/m] and contact radius [m] of a free circular plate that lifts off.

    The plate lies on springs k [Pa/m] that only press and carries P [N], spread evenly over the disc of radius b [m]
    at its center; b = 0 is a force. On the contact disc r < c Kelvin's functions hold, beyond it w = C1 + C2 r^2 +
    C3 ln r, for no shear force is left; c is where settlement and shear force vanish and slope and moment go over
    into those of a ring with a free edge (Timoshenko and Woinowsky-Krieger 1959, sections 16 and 57; with Mindlin's
    shear, of which the ring has none). ValueError if the edge does not lift off.
    """
    if not 0 <= b < radius or not 0 <= r <= radius:
        raise ValueError(f"0 <= b < radius and 0 <= r <= radius are needed, not b = {b}, r = {r}, radius = {radius}")
    plate = OnSprings.of(t, E, nu, factor, k)
    if r == b == 0 and plate.sigma > 0:
        raise ValueError("a Mindlin plate settles without limit under a force; give b > 0 or factor = inf")
    c = contact_radius(plate, radius, b, P)
    if r > c:
        slope = _at(c, c, b, P, plate)[1]
        C3 = slope / (_eased(nu) * c / radius**2 + 1 / c)
        return {
            "settlement": C3 * (_eased(nu) * (r**2 - c**2) / (2 * radius**2) + math.log(r / c)),
            "moment": plate.D * (1 - nu) * C3 * (1 / r**2 - 1 / radius**2),
            "contact radius": c,
        }
    w, _, moment = _at(r, c, b, P, plate)
    return {"settlement": w, "moment": moment, "contact radius": c}


@lru_cache(KEPT)
def contact_radius(plate: OnSprings, radius: float, b: float, P: float) -> float:
    """Return the radius [m] of the contact disc of `lifting_circular_plate`."""
    from scipy.optimize import brentq

    def misfit(c: float) -> float:
        # m_r of the ring's inner edge, times its slope there over C3, less the same of the disc
        _, slope, moment = _at(c, c, b, P, plate)
        ring = plate.D * (1 - plate.nu) * (1 / c**2 - 1 / radius**2) * slope
        return moment * (_eased(plate.nu) * c / radius**2 + 1 / c) - ring

    tried = np.linspace(max(b, 0.02 * plate.length), radius, 400)
    values = [misfit(c) for c in tried]
    for i in np.nonzero(np.diff(np.sign(values)))[0]:
        c = float(brentq(misfit, tried[i], tried[i + 1], xtol=1e-13 * radius, rtol=1e-13))
        inside = np.linspace(1e-6, 1 - 1e-6, 100) * c
        if _at(c, c, b, P, plate)[1] * P < 0 and all(_at(s, c, b, P, plate)[0] * P > 0 for s in inside):
            return c
    raise ValueError(f"a plate of radius {radius} m does not lift off: it is {radius / plate.length:.3g} l")


def _eased(nu: float) -> float:
    """Return C2 / C3 of a ring with a free edge, times 2 R^2."""
    return (1 - nu) / (1 + nu)


def _at(r: float, c: float, b: float, P: float, plate: OnSprings) -> tuple[float, float, float]:
    """Return settlement [m], rotation [1] and radial moment [N m/m] where the plate has contact and w = Q = 0 at c."""
    from scipy.special import iv

    zeta = cmath.sqrt(plate.zz) / plate.length
    edge_w, edge_slope = _infinite(plate, b, P, max(c, 1e-9 * plate.length))
    # A = real + i imaginary such that w and Q of the infinite plate and of A I0 cancel at c
    f, slope = complex(iv(0, zeta * c)), complex(zeta * iv(1, zeta * c))
    lines = [[(a * f).real for a in (1, 1j)], [plate.shear(a * slope) for a in (1, 1j)]]
    real, imaginary = np.linalg.solve(lines, [-edge_w.real, -plate.shear(edge_slope)])
    A = complex(real, imaginary)

    free, free_slope = _infinite(plate, b, P, max(r, 1e-9 * plate.length))
    f, slope = free + A * complex(iv(0, zeta * r)), free_slope + A * complex(zeta * iv(1, zeta * r))
    even = P / (math.pi * b**2 * plate.k) if r < b else 0.0  # settles alike everywhere, without bending
    bend, beta = plate.bend(f - even), plate.rotation(slope)
    beta_over_r = beta / r if r > 1e-6 * plate.length else bend / 2
    return f.real, beta, -plate.D * (bend - (1 - plate.nu) * beta_over_r)


def _infinite(plate: OnSprings, b: float, P: float, r: float) -> tuple[complex, complex]:
    """Return f [m] and its slope [1] of an infinite plate under P [N] on a disc of radius b [m]; w is the real part.

    A force makes f = a K0(zeta r) with r Q -> -P / 2 pi and r beta -> 0 at the center; over the disc its mean is taken
    by the addition theorem of K0.
    """
    from scipy.special import iv, kv

    zeta, force = cmath.sqrt(plate.zz) / plate.length, P / (plate.k * plate.length**2)
    a = -1j * plate.zz**2 * force / (2 * math.pi * plate.zz.imag)
    if b == 0:
        return complex(a * kv(0, zeta * r)), complex(-a * zeta * kv(1, zeta * r))
    a *= 2 / (zeta * b)
    if r >= b:
        a *= iv(1, zeta * b)
        return complex(a * kv(0, zeta * r)), complex(-a * zeta * kv(1, zeta * r))
    a *= -kv(1, zeta * b)
    return complex(P / (math.pi * b**2 * plate.k) + a * iv(0, zeta * r)), complex(a * zeta * iv(1, zeta * r))


def curling_strip(
    y: float, b: float, t: float, E: float, nu: float, factor: float, k: float, alpha: float, dT: float
) -> dict[str, float]:
    """Return settlement [m] and moments [N m/m] across and along an endless strip that curls, y [m] from its middle.

    The strip of width b [m] is glued to springs k [Pa/m]; its bottom is warmer than its top by dT [K], it expands by
    alpha [1/K] and would take the curvature beta' = -alpha dT / t if it were free. Across: m = -D (beta' + (1 + nu)
    alpha dT / t), along: m = -D (nu beta' + (1 + nu) alpha dT / t), no moment and no shear force at y = +-b/2
    (Westergaard 1927; with Mindlin's shear).
    """
    plate = OnSprings.of(t, E, nu, factor, k)
    zeta, free_bend = cmath.sqrt(plate.zz) / plate.length, (1 + nu) * alpha * dT / t
    f, slope = cmath.cosh(zeta * b / 2), zeta * cmath.sinh(zeta * b / 2)
    lines = np.array([[plate.bend(a * f) for a in (1, 1j)], [plate.shear(a * slope) / plate.D for a in (1, 1j)]])
    real, imaginary = np.linalg.solve(lines, [-free_bend, 0.0])
    f = complex(real, imaginary) * cmath.cosh(zeta * y)
    bend = plate.bend(f)
    return {
        "settlement": f.real,
        "moment across": -plate.D * (bend + free_bend),
        "moment along": -plate.D * (nu * bend + free_bend),
    }
