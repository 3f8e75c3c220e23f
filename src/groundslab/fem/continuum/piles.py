"""A single pile in elastic soil: its stiffness (Randolph and Wroth 1978), and the settlement around it.

Round the shaft the soil shears in concentric cylinders, out to the radius r_m, where it no longer settles; the base is
a rigid disc on a half-space. With l and r_0 the pile's length and radius, G the soil's shear modulus, G_l at the
base's depth (above it), mean rho G_l along the shaft, G_b = G_l / xi below the base, and eta = r_b / r_0:

    r_m = (1/4 + xi (5/2 rho (1 - nu) - 1/4)) l,  zeta = ln(r_m / r_0),  lambda = E_p / G_l
    mu l = sqrt(2 / (zeta lambda)) l / r_0,       B = 4 eta / ((1 - nu) xi),  t = tanh(mu l) / (mu l) l / r_0

    P / (G_l r_0 w) = (B + 2 pi rho t / zeta) / (1 + B t / (pi lambda))

With xi = 1 it is r_m = 5/2 rho (1 - nu) l. The formula is exact for a bar on such springs where rho = 1; for soil that
stiffens with depth mu is that of G_l, as the authors propose. Formulas from memory, that of the stiffness compared with
a public program (PileResponse.jl, for eta = xi = 1); their paper was not at hand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from groundslab.arrays import Array


@dataclass(frozen=True, slots=True)
class Pile:
    """A pile of round section in soil whose shear modulus grows linearly with depth; r_m must exceed r_0."""

    length: float  # l [m]
    radius: float  # r_0 [m]
    E: float  # E_p [Pa]: axial stiffness over pi r_0^2, infinite if rigid
    G_l: float  # [Pa]: shear modulus of the soil at the base's depth
    nu: float  # Poisson's ratio of the soil
    rho: float = 1.0  # mean of G along the shaft over G_l: 1 of homogeneous soil, 1/2 where G is 0 on the surface
    eta: float = 1.0  # radius of the base over that of the shaft
    xi: float = 1.0  # G_l over the shear modulus below the base: less than 1 for end-bearing piles

    @property
    def r_m(self) -> float:
        """Return the radius beyond which the shaft's load causes no settlement [m]."""
        return (0.25 + self.xi * (2.5 * self.rho * (1 - self.nu) - 0.25)) * self.length

    @property
    def zeta(self) -> float:
        """Return ln(r_m / r_0)."""
        return math.log(self.r_m / self.radius)

    @property
    def mu_l(self) -> float:
        """Return how compressible the pile is against the soil: 0 if rigid."""
        return math.sqrt(2 * self.G_l / (self.zeta * self.E)) * self.length / self.radius

    @property
    def base(self) -> float:
        """Return the base's stiffness over G_l r_0, that of a rigid disc."""
        return 4 * self.eta / ((1 - self.nu) * self.xi)

    @property
    def shaft(self) -> float:
        """Return the shaft's stiffness over G_l r_0, less than that of a rigid shaft by tanh(mu l) / (mu l)."""
        return 2 * math.pi * self.rho / self.zeta * self.effective_slenderness

    @property
    def effective_slenderness(self) -> float:
        """Return l / r_0 tanh(mu l) / (mu l)."""
        shortening = math.tanh(self.mu_l) / self.mu_l if self.mu_l > 0 else 1.0
        return shortening * self.length / self.radius

    @property
    def head_stiffness(self) -> float:
        """Return the load on the head over its settlement [N/m]."""
        softening = 1 + self.base * self.effective_slenderness * self.G_l / (math.pi * self.E)
        return self.G_l * self.radius * (self.base + self.shaft) / softening

    @property
    def base_share(self) -> float:
        """Return the part of the load that reaches the base."""
        return self.base / ((self.base + self.shaft) * math.cosh(self.mu_l))


def shaft_interaction(pile: Pile, s: ArrayLike) -> Array:
    """Return the soil's settlement beside the shaft over the shaft's own, by its load alone.

    Parameters
    ----------
    pile : Pile
        The loaded pile.
    s : array_like
        Distances from its axis [m].

    Returns
    -------
    ndarray
        ln(r_m / s) / ln(r_m / r_0), 1 within the pile and 0 beyond r_m (Randolph and Wroth 1978).
    """
    inside: Array = np.log(pile.r_m / np.clip(s, pile.radius, pile.r_m)) / pile.zeta
    return inside


def base_interaction(pile: Pile, s: ArrayLike) -> Array:
    """Return the soil's settlement at the base's level over the base's own, by the base's load alone.

    Parameters
    ----------
    pile : Pile
        The loaded pile.
    s : array_like
        Distances from its axis [m].

    Returns
    -------
    ndarray
        2 / pi arcsin(r_b / s) beside a rigid disc on the half-space (Sneddon 1951), 2 r_b / (pi s) far away; 1 within.
    """
    r_b = pile.eta * pile.radius
    ratio: Array = 2 / math.pi * np.arcsin(r_b / np.maximum(s, r_b))
    return ratio
