"""Vlasov's ground: one mode psi(z) over the depth, k0 and k1 as its integrals, gamma from the settlement.

    k0 = int Ec psi'^2 dz     k1 = int G psi^2 dz                          # (2.17), (2.18)
    gamma^2 = h^2 (1 - 2 nu) / 2(1 - nu) * int |grad w|^2 / int w^2        # (2.23)

Equation numbers are the paper's; where it misprints a formula, the integral is used (docs/paper.md). Where the ground
varies over the plan there are c columns of layers, each with k0 and k1 of its own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from groundslab.arrays import Array
from groundslab.errors import InputError, Issue
from groundslab.fem.foundation import Column, Layer, Parts, Values, interface_stack, single
from groundslab.fem.shape_functions import lagrange

#: 2 zeta(2n+2) / pi^(2n+2), n = 0, 1, ...: coth g / g - 1/g^2 is their alternating series in g^2.
_COTH = np.array([
    1 / 3, 1 / 45, 2 / 945, 1 / 4725, 2 / 93555, 1382 / 638512875, 4 / 18243225, 3617 / 162820783125,
])  # fmt: skip

#: Modes are integrated in so many steps over a layer whose modulus changes by a factor of e, more where they die out in
#: it; of so many columns at a time, to spare memory.
STEPS, CHUNK = 32, 1024
#: A table of k0 and k1 over gamma has polynomials through so many points on each octave, good to 5e-9, in so many below
#: and above 1; outside these they are computed anew.
NODES, OCTAVES = 14, 10

#: What the iteration of gamma begins with.
GAMMA_START = 1.0


def _mode_terms(gamma: Values) -> tuple[Array, Array, Array]:
    """Return a = coth g / g - 1/g^2, b = 1/sinh^2 g - 1/g^2 and (a - b - 2/3) / g^2, without cancellation."""
    gamma = np.asarray(gamma, float)
    n = np.arange(len(_COTH))
    c = _COTH * (-1.0) ** n
    small = gamma < 0.3
    g = np.where(small, gamma, 0.0)[..., None]
    near = g ** (2 * n) @ c, -(g ** (2 * n) @ ((2 * n + 1) * c)), g ** (2 * n[:-1]) @ ((2 * n + 2) * c)[1:]
    g = np.where(small, 1.0, gamma)
    a = 1 / (g * np.tanh(g)) - 1 / g**2
    b = _csch2(g) - 1 / g**2
    far = a, b, (a - b - 2 / 3) / g**2
    a, b, d = (np.where(small, series, closed) for series, closed in zip(near, far, strict=True))
    return a, b, d


def sinh_mode(s: Array, gamma: float) -> Array:
    """Return psi = sinh(gamma(1 - s)) / sinh gamma at relative depths s = z/h, without overflow; gamma >= 0."""
    return 1 - s if gamma == 0 else np.exp(-gamma * s) * np.expm1(-2 * gamma * (1 - s)) / np.expm1(-2 * gamma)


def _csch2(g: Values) -> Array:
    """Return 1 / sinh^2 g without overflow."""
    e: Array = np.exp(-2 * g)
    csch2: Array = 4 * e / np.expm1(-2 * g) ** 2
    return csch2


def parameters(layer: Layer, gamma: Values) -> tuple[Values, Values]:
    """Return k0 [Pa/m] and k1 [Pa m] of a layer under psi = sinh(gamma(1 - z/h)) / sinh gamma, E quadratic in z.

    Closed forms of (2.17) and (2.18): for constant E (2.21) and (2.22), for linear E (2.24) and (2.25), for quadratic E
    (2.26) and (2.27), each with its misprint put right (docs/paper.md). gamma >= 0. Of a layer over c columns: (c,).
    """
    a, b, d = _mode_terms(gamma)
    g2 = gamma**2
    stretch = np.array([1 + g2 * (a + b) / 2, (2 + g2 * b) / 4, (1 + g2 * b) / 6 + (a - b) / 4])
    shear = np.array([(a - b) / 2, -b / 4, d / 4 - b / 6])
    h, c = layer.thickness, np.array(layer.moduli)
    return layer.oedometric_ratio / h * (stretch * c).sum(axis=0), layer.shear * h * (shear * c).sum(axis=0)


def parameters_as_printed(layer: Layer, gamma: Values) -> tuple[Values, Values]:
    """Return k0 and k1 by (2.21), (2.22), (2.24) - (2.27) exactly as the paper prints them, misprints kept.

    Only to reproduce the paper's tables; they differ from the integrals that they stand for (docs/paper.md).
    """
    g, h, F = gamma, layer.thickness, layer.oedometric_ratio
    coth, csch2 = 1 / np.tanh(g), _csch2(g)
    E1, c1, c2 = layer.moduli
    k0 = F / (8 * h) * (E1 * (4 * g * coth + 4 * g**2 * csch2) + c1 * (2 + 4 * g**2 * csch2))
    k1 = layer.shear * h / (8 * g**2) * (E1 * (4 * g * coth - 2 * g**2 * csch2) + c1 * (2 - 2 * g**2 * csch2))
    linear = k0, k1
    E2 = E1 + c2
    sinh2 = 3 * (E2 + E1 * (2 * g**2 - 1)) * 2 * coth
    k0 = F * (sinh2 + (E2 * (4 * g**2 - 3) + E1 * (3 + 2 * g**2)) * 2 * g * csch2) / (24 * h * g)
    k1 = 2 * layer.shear * h * (sinh2 - (E2 * (4 * g**2 + 3) + E1 * (2 * g**2 - 3)) * 2 * g * csch2) / (48 * g**3)
    curved = np.asarray(c2) != 0
    return np.where(curved, k0, linear[0]), np.where(curved, k1, linear[1])


@dataclass(frozen=True, slots=True)
class Mode:
    """The mode psi of a layered profile at depths z [m], with its k0 [Pa/m] and k1 [Pa m]."""

    z: Array
    psi: Array
    k0: float
    k1: float


def profile(layers: tuple[Layer, ...], decay2: float, points: int = 60) -> Mode:
    """Return the mode that minimizes int Ec psi'^2 + decay2 G psi^2 dz with psi = 1 at the top and 0 at the base.

    decay2 [1/m2] is int |grad w|^2 / int w^2. Quadratic finite elements, crowded so that exp(-z/l) is met to 1e-8.
    """
    ends, stretch, shear = _over_the_depth(layers, decay2, points)
    psi = _two_point_minimum(stretch + decay2 * shear)
    k0 = float(np.einsum("ea,eab,eb->", psi, stretch, psi))
    k1 = float(np.einsum("ea,eab,eb->", psi, shear, psi))
    nodes = np.append(psi[:, :2].ravel(), psi[-1, 2])
    depths = np.append(ends[:, 0], ends[-1, 1])
    return Mode(np.interp(np.arange(len(nodes)), 2 * np.arange(len(depths)), depths), nodes, k0, k1)


def profiles(layers: tuple[Layer, ...], decay2: Array) -> tuple[Array, Array]:
    """Return k0 [Pa/m] and k1 [Pa m], each (c,), under each column's own mode; decay2 (c,) [1/m2] as in `profile`.

    The least energy k0 + decay2 k1 is the stiffness Z = Ec psi' / psi of the top, upwards, and k1 its derivative by
    decay2: psi' = (Ec psi') / Ec and (Ec psi')' = decay2 G psi from the base, where psi = 0.
    """
    k0, k1 = np.empty(len(decay2)), np.empty(len(decay2))
    for start in range(0, len(decay2), CHUNK):
        part = slice(start, start + CHUNK)
        Z, k1[part] = _stiffness_of_top([layer.at(part) for layer in layers], decay2[part])
        k0[part] = Z - decay2[part] * k1[part]
    return k0, k1


def _stiffness_of_top(layers: list[Layer], decay2: Array) -> tuple[Array, Array]:
    """Return Z [Pa/m] and its derivative by decay2 [Pa m], (c,) each, see `profiles`."""
    steps = [_steps(layer, decay2) for layer in reversed(layers)]
    M, dM = (np.concatenate(parts, axis=2) for parts in zip(*steps, strict=True))
    while M.shape[2] > 1:
        # the product of two steps, the upper one times the lower one; a single one at the top waits
        pairs = M.shape[2] // 2 * 2
        (low, high), (d_low, d_high) = ((part[..., :pairs:2, :], part[..., 1:pairs:2, :]) for part in (M, dM))
        merged, d_merged = _times(high, low), _times(d_high, low) + _times(high, d_low)
        merged, d_merged = merged / merged[1, 1], d_merged / merged[1, 1]  # a factor of both changes nothing
        M, dM = (np.concatenate([new, old[..., pairs:, :]], axis=2) for new, old in ((merged, M), (d_merged, dM)))
    (_, psi), (_, force) = M[:, :, 0]
    (_, d_psi), (_, d_force) = dM[:, :, 0]
    return force / psi, (d_force - force / psi * d_psi) / psi


def _times(left: Array, right: Array) -> Array:
    """Return the products of two by two matrices, whose rows and columns come first."""
    product: Array = np.einsum("ij...,jk...->ik...", left, right)
    return product


def _steps(layer: Layer, decay2: Array) -> tuple[Array, Array]:
    """Return what takes (psi, Ec psi') upwards over each step through a layer, and its derivative by decay2.

    Both (2, 2, n, c), from the bottom to the top, with a common factor left out. exp(W) = cosh m + sinh m / m W with
    m^2 = -det W is Magnus' rule of fourth order, exact for one modulus: W is the mean of the matrices at two Gauss
    points times the step, and the commutator of both times step^2 sqrt(3) / 12 (Blanes, Casas, Oteo and Ros 2009).
    """
    E = layer.E(np.linspace(0, 1, 5)[:, None])
    varies = np.log(E.max(axis=0) / E.min(axis=0))
    dying_out = np.sqrt(decay2 * layer.shear / layer.oedometric_ratio) * layer.thickness
    n = math.ceil(max(np.where(varies > 0, STEPS * (varies + dying_out / 4), 1.0)))
    h, offset = layer.thickness / n, np.array([-1, 1]) / math.sqrt(12)
    E_1, E_2 = (layer.E(1 - (np.arange(n)[:, None] + 0.5 + share) / n) for share in offset)
    compliance = h / 2 / layer.oedometric_ratio * (1 / E_1 + 1 / E_2)
    shear = h / 2 * layer.shear * (E_1 + E_2)
    commutator = h**2 * math.sqrt(3) / 12 * layer.shear / layer.oedometric_ratio * (E_1 / E_2 - E_2 / E_1)
    f, slope = _tanh_share(decay2**2 * commutator**2 + decay2 * compliance * shear)
    d_f = slope * (2 * decay2 * commutator**2 + compliance * shear)
    none = np.zeros_like(shear)
    W = np.array([[decay2 * commutator, compliance], [decay2 * shear, -decay2 * commutator]])
    dW = np.array([[commutator, none], [shear, -commutator]])
    return np.eye(2)[:, :, None, None] + f * W, d_f * W + f * dW


def _tanh_share(x: Array) -> tuple[Array, Array]:
    """Return tanh(m) / m for m^2 = x, and its derivative by x."""
    small = x < 3e-3
    near = np.where(small, x, 0.0)
    series = 1 - near / 3 + 2 * near**2 / 15 - 17 * near**3 / 315, -1 / 3 + 4 * near / 15 - 17 * near**2 / 105
    far = np.where(small, 1.0, x)
    T = np.tanh(np.sqrt(far))
    closed = T / np.sqrt(far), (1 - T**2 - T / np.sqrt(far)) / (2 * far)
    f, slope = (np.where(small, *pair) for pair in zip(series, closed, strict=True))
    return f, slope


def _over_the_depth(layers: tuple[Layer, ...], decay2: float, points: int) -> tuple[Array, Array, Array]:
    """Return finite elements over the depth: their ends (e, 2) [m], and the matrices of energy.

    These are int Ec psi'^2 dz and int G psi^2 dz, (e, 3, 3) each.
    """
    x, weight = np.polynomial.legendre.leggauss(4)
    N, dN = lagrange(x)
    ends, stretch, shear, top = [], [], [], 0.0
    for layer in layers:
        local = np.sqrt(decay2 * layer.shear / layer.oedometric_ratio) * layer.thickness
        number = np.arange(int(points * (1 + local)))[:, None]
        h = layer.thickness / len(number)
        E = weight * layer.E((number + (x + 1) / 2) / len(number))
        ends.append(top + h * (number + np.arange(2)))
        stretch.append(layer.oedometric_ratio * 2 / h * np.einsum("ep,pa,pb->eab", E, dN, dN))
        shear.append(layer.shear * h / 2 * np.einsum("ep,pa,pb->eab", E, N, N))
        top += float(layer.thickness)
    return np.concatenate(ends), np.concatenate(stretch), np.concatenate(shear)


def _two_point_minimum(K: Array) -> Array:
    """Return psi at the nodes of elements (e, 3) with the least energy, 1 at the top, 0 at the base.

    The middle nodes are condensed; what is left is a chain of springs.
    """
    from scipy.linalg import solveh_banded

    keep, middle = [0, 2], 1
    to_middle = K[:, keep, middle]
    C = K[:, keep][:, :, keep] - to_middle[:, :, None] * to_middle[:, None] / K[:, middle, middle, None, None]
    psi = np.zeros((len(K), 3))
    psi[0, 0] = 1.0
    load = np.zeros(len(K) - 1)
    load[0] = -C[0, 1, 0]
    banded = np.stack([np.append(0.0, C[1:-1, 0, 1]), C[:-1, 1, 1] + C[1:, 0, 0]])
    psi[:-1, 2] = psi[1:, 0] = solveh_banded(banded, load)
    psi[:, 1] = -(K[:, 1, 0] * psi[:, 0] + K[:, 1, 2] * psi[:, 2]) / K[:, 1, 1]
    return psi


@dataclass(frozen=True, slots=True)
class Soil:
    """Soil whose k0 and k1 follow from gamma: one sinh mode, a profile's own mode, or interface layers.

    Where the soil varies over the plan its layers hold c columns, and gamma is their mean, weighted by the plate's area
    on each: a settlement has one decay, from which each column has its own gamma. A given gamma is that of
    every column. See docs/theory.md, ground that varies over the plan.
    """

    layers: tuple[Layer, ...]
    way: Literal["sinh", "profile", "interface"]
    as_printed: bool = False
    gamma: float | None = None  # given; None if it is to be found from the settlement
    parts: Parts | None = None  # which columns the elements have; None if all have the one
    area_fraction: Array | None = None  # (c,): of the plate's area on each column
    table: dict[int, Array] | None = None  # of profiles' k0 and k1, by octaves of gamma, if many are looked up

    @property
    def depth(self) -> Values:
        """Return the depth of the rigid base [m]."""
        return sum(layer.thickness for layer in self.layers)

    @property
    def _ratio(self) -> Values:
        """Return G / Ec = (1 - 2 nu) / 2(1 - nu), the mean over the depth."""
        return sum(layer.thickness * layer.shear / layer.oedometric_ratio for layer in self.layers) / self.depth

    def gamma_of(self, decay2: float) -> float:
        """Return gamma (2.23) for decay2 = int |grad w|^2 / int w^2 [1/m2]."""
        gammas = self.depth * np.sqrt(self._ratio * decay2)
        return float(gammas if self.area_fraction is None else self.area_fraction @ gammas)

    def gammas(self, gamma: float) -> Values:
        """Return the gamma of each column (c,) where the soil varies."""
        if self.area_fraction is None:
            return gamma
        if self.gamma is not None:
            return np.full(len(self.area_fraction), gamma)
        lengths = self.depth * np.sqrt(self._ratio)
        return gamma * (lengths / (self.area_fraction @ lengths))

    def layer_parameters(self, gamma: float) -> tuple[Array, Array]:
        """Return k0 [Pa/m] and k1 [Pa m], (L,) with one of each layer of an interface stack, else one; or (c, L)."""
        gammas = self.gammas(gamma)
        if self.way == "profile":
            decay2 = gammas**2 / (self.depth**2 * self._ratio)
            if self.parts is not None:
                k0, k1 = profiles(self.layers, np.asarray(decay2))
                return k0[:, None], k1[:, None]
            mode = profile(self.layers, float(decay2))
            return np.array([mode.k0]), np.array([mode.k1])
        formula = parameters_as_printed if self.as_printed else parameters
        pairs = [formula(layer, gammas) for layer in self.layers]
        k0, k1 = (np.stack(values, axis=-1) for values in zip(*pairs, strict=True))
        right = (k0 > 0) & (k1 >= 0) & np.isfinite(k1)
        if not right.all():
            worst = np.atleast_2d(right).all(axis=1).argmin()
            k0, k1 = np.atleast_2d(k0)[worst], np.atleast_2d(k1)[worst]
            gamma = float(np.ravel(gammas)[worst if np.ndim(gammas) else 0])
            misprinted = f'"as printed", which gives k0 = {k0} Pa/m and k1 = {k1} Pa m at gamma = {gamma:.4g}'
            raise InputError(
                [Issue("ground.formulas", misprinted, "formulas without misprints", 'use formulas = "exact"')]
            )
        return k0, k1

    def _look_up(self, gamma: float) -> tuple[Array, Array]:
        """Return k0 [Pa/m] and k1 [Pa m] (c, 1) of profiles as `layer_parameters`, by the table: many for a few."""
        place = math.log2(gamma) if gamma > 0 else -math.inf
        if self.table is None or not abs(place) < OCTAVES:
            return self.layer_parameters(gamma)
        octave, at = math.floor(place), np.polynomial.chebyshev.chebpts1(NODES)
        if octave not in self.table:
            constants = [self.layer_parameters(2 ** (octave + (x + 1) / 2)) for x in at]
            polynomials = np.polynomial.chebyshev.chebvander(at, NODES - 1)
            self.table[octave] = np.asarray(np.linalg.solve(polynomials, np.log(constants).reshape(NODES, -1)))
        terms = np.polynomial.chebyshev.chebvander(2 * (place - octave) - 1, NODES - 1)
        k0, k1 = np.exp(terms @ self.table[octave]).reshape(2, -1, 1)
        return k0, k1

    def mode(self, gamma: float, points: int = 60) -> Mode | None:
        """Return the mode of soil that is the same everywhere; None for interface layers, each of which has its own."""
        if self.way == "interface":
            return None
        if self.way == "profile":
            return profile(self.layers, (gamma / self.gamma_of(1.0)) ** 2, points)
        k0, k1 = self.layer_parameters(gamma)
        s = np.linspace(0.0, 1.0, points + 1)
        return Mode(s * self.depth, sinh_mode(s, gamma), float(k0[0]), float(k1[0]))

    def column(self, gamma: float, by_table: bool = False) -> Column:
        """Return the column of the ground for a gamma, by element where the soil varies.

        Many gammas of the same octave, or nearly, take less time `by_table`.
        """
        k0, k1 = self._look_up(gamma) if by_table else self.layer_parameters(gamma)
        column = interface_stack(k0, k1) if self.way == "interface" else single(k0[..., 0], k1[..., 0])
        return column if self.parts is None else column.mix(self.parts)

    def first_column(self) -> Column:
        """Return the column of the ground for the gamma that is given, or from which it is iterated."""
        return self.column(self.gamma or GAMMA_START)
