"""Vlasov's ground: one mode psi(z) over the depth, k0 and k1 as its integrals, gamma from the settlement.

    k0 = int Ec psi'^2 dz     k1 = int G psi^2 dz                          # (2.17), (2.18)
    gamma^2 = h^2 (1 - 2 nu) / 2(1 - nu) * int |grad w|^2 / int w^2        # (2.23)

Equation numbers are the paper's; where it misprints a formula, the integral is used (docs/paper.md).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from groundslab.errors import Fault, InputError
from groundslab.ground import Column, Layer, interface_stack, single
from groundslab.shape import Array, lagrange

#: 2 zeta(2n+2) / pi^(2n+2), n = 0, 1, ...: coth g / g - 1/g^2 is their alternating series in g^2.
_COTH = np.array([
    1 / 3, 1 / 45, 2 / 945, 1 / 4725, 2 / 93555, 1382 / 638512875, 4 / 18243225, 3617 / 162820783125,
])  # fmt: skip


def _mode_terms(g: float) -> tuple[float, float, float]:
    """Return a = coth g / g - 1/g^2, b = 1/sinh^2 g - 1/g^2 and (a - b - 2/3) / g^2, without cancellation."""
    n = np.arange(len(_COTH))
    if g < 0.3:
        c = _COTH * (-1.0) ** n
        a = float(c @ g ** (2 * n))
        b = float(-((2 * n + 1) * c) @ g ** (2 * n))
        d = float(((2 * n + 2) * c)[1:] @ g ** (2 * n[:-1]))
        return a, b, d
    a = 1 / (g * np.tanh(g)) - 1 / g**2
    b = _csch2(g) - 1 / g**2
    return a, b, (a - b - 2 / 3) / g**2


def _csch2(g: float) -> float:
    """Return 1 / sinh^2 g without overflow."""
    e = np.exp(-2 * g)
    return float(4 * e / np.expm1(-2 * g) ** 2)


def parameters(layer: Layer, gamma: float) -> tuple[float, float]:
    """Return k0 [Pa/m] and k1 [Pa m] of a layer under psi = sinh(gamma(1 - z/h)) / sinh gamma, E quadratic in z.

    Closed forms of (2.17) and (2.18): for constant E (2.21) and (2.22), for linear E (2.24) and (2.25), for quadratic E
    (2.26) and (2.27), each with its misprint put right (docs/paper.md). gamma >= 0.
    """
    a, b, d = _mode_terms(gamma)
    g2 = gamma**2
    stretch = np.array([1 + g2 * (a + b) / 2, (2 + g2 * b) / 4, (1 + g2 * b) / 6 + (a - b) / 4])
    shear = np.array([(a - b) / 2, -b / 4, d / 4 - b / 6])
    h, c = layer.thickness, np.array(layer.moduli)
    return float(layer.constrained / h * (stretch @ c)), float(layer.shear * h * (shear @ c))


def parameters_as_printed(layer: Layer, gamma: float) -> tuple[float, float]:
    """Return k0 and k1 by (2.21), (2.22), (2.24) - (2.27) exactly as the paper prints them, misprints kept.

    Only to reproduce the paper's tables; they differ from the integrals that they stand for (docs/paper.md).
    """
    g, h, F = gamma, layer.thickness, layer.constrained
    coth, csch2 = 1 / np.tanh(g), _csch2(g)
    E1, c1, c2 = layer.moduli
    if c2 == 0:
        k0 = F / (8 * h) * (E1 * (4 * g * coth + 4 * g**2 * csch2) + c1 * (2 + 4 * g**2 * csch2))
        k1 = layer.shear * h / (8 * g**2) * (E1 * (4 * g * coth - 2 * g**2 * csch2) + c1 * (2 - 2 * g**2 * csch2))
        return float(k0), float(k1)
    E2 = E1 + c2
    sinh2 = 3 * (E2 + E1 * (2 * g**2 - 1)) * 2 * coth
    k0 = F * (sinh2 + (E2 * (4 * g**2 - 3) + E1 * (3 + 2 * g**2)) * 2 * g * csch2) / (24 * h * g)
    k1 = 2 * layer.shear * h * (sinh2 - (E2 * (4 * g**2 + 3) + E1 * (2 * g**2 - 3)) * 2 * g * csch2) / (48 * g**3)
    return float(k0), float(k1)


@dataclass(frozen=True, slots=True)
class Mode:
    """The mode psi of a layered profile at depths z [m], with its k0 [Pa/m] and k1 [Pa m]."""

    z: Array
    psi: Array
    k0: float
    k1: float


def profile(layers: tuple[Layer, ...], decay2: float, points: int = 60) -> Mode:
    """Return the mode that minimises int Ec psi'^2 + decay2 G psi^2 dz with psi = 1 at the top and 0 at the base.

    decay2 [1/m2] is int |grad w|^2 / int w^2. Quadratic finite elements, crowded so that exp(-z/l) is met to 1e-8.
    """
    cuts = [np.zeros(1)]
    for layer in layers:
        local = np.sqrt(decay2 * layer.shear / layer.constrained) * layer.thickness
        n = int(points * (1 + local))
        cuts.append(cuts[-1][-1] + layer.thickness * np.arange(1, n + 1) / n)
    ends = np.concatenate(cuts)
    owner = np.repeat(np.arange(len(layers)), [len(c) for c in cuts[1:]])
    tops = np.cumsum([0.0] + [layer.thickness for layer in layers])

    x, weight = np.polynomial.legendre.leggauss(4)
    N, dN = lagrange(x)
    h = np.diff(ends)
    z = ends[:-1, None] + (x + 1) / 2 * h[:, None]
    Ec, G = np.empty_like(z), np.empty_like(z)
    for i, layer in enumerate(layers):
        E = layer.E((z[owner == i] - tops[i]) / layer.thickness)
        Ec[owner == i], G[owner == i] = layer.constrained * E, layer.shear * E
    stretch = np.einsum("ep,e,pa,pb->eab", Ec * weight, 2 / h, dN, dN)
    shear = np.einsum("ep,e,pa,pb->eab", G * weight, h / 2, N, N)

    psi = _two_point_minimum(stretch + decay2 * shear)
    node = 2 * np.arange(len(h))[:, None] + np.arange(3)
    local_psi = psi[node]
    k0 = float(np.einsum("ea,eab,eb->", local_psi, stretch, local_psi))
    k1 = float(np.einsum("ea,eab,eb->", local_psi, shear, local_psi))
    depth = np.interp(np.arange(len(psi)), 2 * np.arange(len(ends)), ends)
    return Mode(depth, psi, k0, k1)


def _two_point_minimum(K: Array) -> Array:
    """Return the chain of element unknowns (2 m + 1,) of least energy with 1 at the top and 0 at the base.

    The middle nodes are condensed; what is left is a chain of springs and a banded solve.
    """
    from scipy.linalg import solveh_banded

    keep, middle = [0, 2], 1
    to_middle = K[:, keep, middle]
    C = K[:, keep][:, :, keep] - to_middle[:, :, None] * to_middle[:, None] / K[:, middle, middle, None, None]
    diagonal = C[:-1, 1, 1] + C[1:, 0, 0]
    upper = np.concatenate([[0.0], C[1:-1, 0, 1]])
    load = np.zeros_like(diagonal)
    load[0] = -C[0, 1, 0]
    ends = np.concatenate([[1.0], solveh_banded(np.stack([upper, diagonal]), load), [0.0]])
    psi = np.empty(2 * len(K) + 1)
    psi[::2] = ends
    psi[1::2] = -(K[:, 1, 0] * ends[:-1] + K[:, 1, 2] * ends[1:]) / K[:, 1, 1]
    return psi


@dataclass(frozen=True, slots=True)
class Soil:
    """Soil whose k0 and k1 follow from gamma: one sinh mode, a profile's own mode, or interface layers."""

    layers: tuple[Layer, ...]
    way: Literal["sinh", "profile", "interface"]
    as_printed: bool = False
    gamma: float | None = None  # given; None if it is to be found from the settlement

    @property
    def depth(self) -> float:
        """Return the depth of the rigid base [m]."""
        return sum(layer.thickness for layer in self.layers)

    @property
    def _ratio(self) -> float:
        """Return G / Ec = (1 - 2 nu) / 2(1 - nu), the mean over the depth."""
        return sum(layer.thickness * layer.shear / layer.constrained for layer in self.layers) / self.depth

    def gamma_of(self, decay2: float) -> float:
        """Return gamma (2.23) for decay2 = int |grad w|^2 / int w^2 [1/m2]."""
        return float(self.depth * np.sqrt(self._ratio * decay2))

    def layer_parameters(self, gamma: float) -> tuple[Array, Array]:
        """Return k0 [Pa/m] and k1 [Pa m]: one of each, or one for each layer of an interface stack."""
        if self.way == "profile":
            mode = profile(self.layers, gamma**2 / (self.depth**2 * self._ratio))
            return np.array([mode.k0]), np.array([mode.k1])
        formula = parameters_as_printed if self.as_printed else parameters
        k0, k1 = np.array([formula(layer, gamma) for layer in self.layers]).T
        if not ((k0 > 0) & (k1 >= 0) & np.isfinite(k1)).all():
            got = f'"as printed", which gives k0 = {k0} Pa/m and k1 = {k1} Pa m at gamma = {gamma:.4g}'
            raise InputError([Fault("ground.formulas", got, "formulas without misprints", 'use formulas = "exact"')])
        return k0, k1

    def column(self, gamma: float) -> Column:
        """Return the column of the ground for a gamma."""
        k0, k1 = self.layer_parameters(gamma)
        return interface_stack(k0, k1) if self.way == "interface" else single(k0[0], k1[0])
